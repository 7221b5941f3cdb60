// Which videos do this to this food, and from which second on: the question "who chops onion?".
// param: food STRING
// param: motion STRING
// example: food=onion
// example: motion=chop
// column: video
// column: step
// column: start
// column: end
// mode: read
MATCH (:Label {name: $food})<-[:CALLED]-(:Object)-[:INPUT_OF]->(m:Motion {verb: $motion})-[seen:SEEN_IN]->(v:Video)
RETURN DISTINCT v.name AS video, seen.position AS step, seen.start AS start, seen.end AS end
ORDER BY video, step
