// The named units with every place where they were seen. A node stands in several units: it is answered once, and units
// name it by its number in the store, which is shorter than its key. Besides, how often each food in them is made and
// used in each state: each state once, with its foods and their counts side by side.
// The names are collected first: what groups rows in a subquery that reads all nodes has them in each of its keys.
// param: keys LIST<STRING>
// column: nodes
// column: units
// column: foods
// mode: read
UNWIND $keys AS key
MATCH (m:Motion {key: key})
WITH collect(m) AS motions
CALL (motions) {
  UNWIND motions AS m
  MATCH (m)-[:INPUT_OF|OUTPUTS]-(o)
  WITH DISTINCT o
  RETURN collect([id(o), o.key, o.label, o.states, o.ingredients, o.relation, o.container]) AS nodes
}
CALL (nodes) {
  UNWIND nodes AS node
  UNWIND [node[2]] + node[4] AS name
  RETURN collect(DISTINCT name) AS names
}
RETURN nodes, [m IN motions | [
  m.key, m.verb, m.accepts_any,
  [(o)-[:INPUT_OF]->(m) | id(o)],
  [(m)-[:OUTPUTS]->(o) | id(o)],
  [(m)-[s:SEEN_IN]->(v) | [
    v.name, s.position, v.sources[0], s.start, s.end, [s.amounts, s.seconds, s.celsius],
    s.inputs, s.inputs_moving, s.inputs_dish, s.outputs, s.outputs_moving, s.outputs_dish
  ]]
]] AS units, COLLECT {
  UNWIND names AS name
  MATCH (i:Ingredient {name: name})-[r:SEEN_AS]->(s:State)
  WITH s, collect(i.name) AS labels, collect(r.made) AS made, collect(r.used) AS used
  RETURN [s.name, labels, made, used]
} AS foods
