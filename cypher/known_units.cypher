// The named units with every place where they were seen. A node stands in several units: it is answered once, and units
// name it by its key.
// param: keys LIST<STRING>
// column: nodes
// column: units
// mode: read
UNWIND $keys AS key
MATCH (m:Motion {key: key})
WITH collect(m) AS motions
CALL (motions) {
  UNWIND motions AS m
  MATCH (m)-[:INPUT_OF|OUTPUTS]-(o)
  WITH DISTINCT o
  RETURN collect([o.key, o.label, o.states, o.ingredients, o.relation, o.container]) AS nodes
}
RETURN nodes, [m IN motions | [
  m.key, m.verb, m.accepts_any,
  [(o)-[:INPUT_OF]->(m) | o.key],
  [(m)-[:OUTPUTS]->(o) | o.key],
  [(m)-[s:SEEN_IN]->(v) | [
    v.name, s.position, v.sources[0], s.start, s.end,
    s.inputs, s.inputs_moving, s.inputs_dish, s.outputs, s.outputs_moving, s.outputs_dish
  ]]
]] AS units
