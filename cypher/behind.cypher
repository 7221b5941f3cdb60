// Every unit that may take part in making the asked nodes, or any node of the asked foods in the asked states: their
// producers, the producers of what those take in, and so on. Where the kitchen has a node, nobody needs to make it.
// param: nodes LIST<STRING>
// param: foods LIST<MAP>
// column: key
// column: verb
// column: accepts_any
// column: inputs
// column: outputs
// column: sightings
// mode: read
CALL () {
  UNWIND $nodes AS key
  MATCH (o:Object {key: key})
  RETURN o
  UNION
  UNWIND $foods AS food
  MATCH (o:Object {label: food.label})
  WHERE food.state IN o.states OR (food.state = '' AND size(o.states) = 0)
  RETURN o
}
MATCH (o)<-[:OUTPUTS]-(last:Motion)
WITH DISTINCT last
MATCH path = (last)<-[:INPUT_OF|OUTPUTS*0..]-(m)
WHERE all(n IN nodes(path) WHERE n.start IS NULL)
WITH DISTINCT m
WHERE m:Motion
RETURN m.key AS key, m.verb AS verb, m.accepts_any AS accepts_any,
  COLLECT { MATCH (o)-[:INPUT_OF]->(m) RETURN [o.label, o.states, o.ingredients, o.relation, o.container] } AS inputs,
  COLLECT { MATCH (m)-[:OUTPUTS]->(o) RETURN [o.label, o.states, o.ingredients, o.relation, o.container] } AS outputs,
  COLLECT { MATCH (m)-[s:SEEN_IN]->(v) RETURN [v.name, v.sources, properties(s)] } AS sightings
ORDER BY key
