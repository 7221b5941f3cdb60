// How a food gets into a state: each motion that does it, in how many units, and in which videos.
// param: food STRING
// param: state STRING
// example: food=onion
// example: state=chopped
// column: motion
// column: units
// column: videos
// mode: read
MATCH (l:Label {name: $food})<-[:CALLED]-(o:Object)<-[:OUTPUTS]-(m:Motion)
WHERE $state IN o.states
  AND NOT EXISTS { (l)<-[:CALLED]-(before:Object)-[:INPUT_OF]->(m) WHERE $state IN before.states }
MATCH (m)-[:SEEN_IN]->(v:Video)
WITH m.verb AS motion, count(DISTINCT m) AS units, collect(DISTINCT v.name) AS found
UNWIND found AS name
WITH motion, units, name ORDER BY name
RETURN motion, units, collect(name) AS videos
ORDER BY units DESC, motion
