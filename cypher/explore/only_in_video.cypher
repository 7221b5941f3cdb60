// What one video alone teaches: its steps that no other video shows, in their order.
// param: video STRING
// example: video=spanish_omelette
// column: step
// column: motion
// column: inputs
// column: outputs
// mode: read
MATCH (v:Video {name: $video})<-[seen:SEEN_IN]-(m:Motion)
WHERE NOT EXISTS { MATCH (m)-[:SEEN_IN]->(other:Video) WHERE other <> v }
RETURN seen.position AS step, m.verb AS motion,
  COLLECT { MATCH (o)-[:INPUT_OF]->(m) RETURN DISTINCT o.label ORDER BY o.label } AS inputs,
  COLLECT { MATCH (m)-[:OUTPUTS]->(o) RETURN DISTINCT o.label ORDER BY o.label } AS outputs
ORDER BY step
