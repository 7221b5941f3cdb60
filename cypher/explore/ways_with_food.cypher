// What is done to a food, and with which tools: how many units do so, how many of them change it, and where that was
// first seen, as video and step. "How is an onion peeled?"
// param: food STRING
// param: motion STRING
// example: food=onion
// default: motion=
// column: motion
// column: tools
// column: units
// column: changing
// column: seen
// mode: read
MATCH (:Food {name: $food})<-[done:DONE_TO]-(o:Operator)
WHERE $motion IN ['', o.motion]
RETURN o.motion AS motion, o.tools AS tools, done.units AS units, done.changed AS changing, COLLECT {
  MATCH (o)-[tie:ATTESTED_BY]->(m:Motion)-[seen:SEEN_IN]->(v:Video)
  WHERE $food IN tie.done_to
  RETURN v.name + ' ' + toString(seen.position) ORDER BY v.name, seen.position LIMIT 3
} AS seen
ORDER BY units DESC, motion, tools
