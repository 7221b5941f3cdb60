// Where two videos meet: the units that both show, in the order of the first.
// param: first STRING
// param: second STRING
// example: first=garden_salad
// example: second=greek_salad
// column: step
// column: motion
// column: inputs
// column: outputs
// column: step_of_second
// mode: read
MATCH (a:Video {name: $first}), (b:Video {name: $second})
MATCH (a)<-[one:SEEN_IN]-(m:Motion)-[two:SEEN_IN]->(b)
RETURN one.position AS step, m.verb AS motion,
  COLLECT { MATCH (o)-[:INPUT_OF]->(m) RETURN DISTINCT o.label ORDER BY o.label } AS inputs,
  COLLECT { MATCH (m)-[:OUTPUTS]->(o) RETURN DISTINCT o.label ORDER BY o.label } AS outputs,
  two.position AS step_of_second
ORDER BY step, step_of_second
