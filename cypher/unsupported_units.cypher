// Those of the named units that no video shows any more, with what they do.
// param: keys LIST<STRING>
// column: key
// column: verb
// column: accepts_any
// column: inputs
// column: outputs
// mode: read
UNWIND $keys AS key
MATCH (m:Motion {key: key})
WHERE NOT EXISTS { (m)-[:SEEN_IN]->() }
RETURN m.key AS key, m.verb AS verb, m.accepts_any AS accepts_any,
  COLLECT { MATCH (o)-[:INPUT_OF]->(m) RETURN [o.label, o.states, o.ingredients, o.relation, o.container] } AS inputs,
  COLLECT { MATCH (m)-[:OUTPUTS]->(o) RETURN [o.label, o.states, o.ingredients, o.relation, o.container] } AS outputs
ORDER BY key
