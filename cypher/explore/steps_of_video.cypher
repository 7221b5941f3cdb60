// The steps of one video in the order in which they were annotated, with their times.
// param: video STRING
// example: video=greek_salad
// column: step
// column: start
// column: end
// column: inputs
// column: motion
// column: outputs
// mode: read
MATCH (:Video {name: $video})<-[seen:SEEN_IN]-(m:Motion)
RETURN seen.position AS step, seen.start AS start, seen.end AS end,
  COLLECT { MATCH (o)-[:INPUT_OF]->(m) RETURN DISTINCT o.label ORDER BY o.label } AS inputs, m.verb AS motion,
  COLLECT { MATCH (m)-[:OUTPUTS]->(o) RETURN DISTINCT o.label ORDER BY o.label } AS outputs
ORDER BY step
