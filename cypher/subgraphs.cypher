// The named videos with all that they say, unit by unit in their order.
// param: names LIST<STRING>
// column: name
// column: sources
// column: units
// mode: read
UNWIND $names AS name
MATCH (v:Video {name: name})
RETURN v.name AS name, v.sources AS sources, COLLECT {
  MATCH (v)<-[s:SEEN_IN]-(m:Motion)
  RETURN [
    m.key, m.verb, m.accepts_any,
    COLLECT { MATCH (o)-[:INPUT_OF]->(m) RETURN [o.label, o.states, o.ingredients, o.relation, o.container] },
    COLLECT { MATCH (m)-[:OUTPUTS]->(o) RETURN [o.label, o.states, o.ingredients, o.relation, o.container] },
    properties(s)
  ] ORDER BY s.position
} AS units
ORDER BY name
