// What is around an object: how many units make it and take it, the keys of some of each, and some of its nodes and of
// the videos that show one of those units. No row where the graph has no such object.
// param: label STRING
// param: most INTEGER
// column: nodes
// column: made
// column: made_count
// column: taken
// column: taken_count
// column: videos
// mode: read
MATCH (l:Label {name: $label})
CALL (l) {
  MATCH (l)<-[:CALLED]-(o)<-[:OUTPUTS]-(m)
  WITH DISTINCT m
  RETURN count(m) AS made_count, collect(m)[..$most] AS makers
}
CALL (l) {
  MATCH (l)<-[:CALLED]-(o)-[:INPUT_OF]->(m)
  WITH DISTINCT m
  RETURN count(m) AS taken_count, collect(m)[..$most] AS takers
}
RETURN
  COLLECT {
    MATCH (l)<-[:CALLED]-(o)
    RETURN [o.label, o.states, o.ingredients, o.relation, o.container]
    LIMIT $most
  } AS nodes,
  [m IN makers | m.key] AS made,
  made_count,
  [m IN takers | m.key] AS taken,
  taken_count,
  COLLECT {
    UNWIND makers + takers AS m
    MATCH (m)-[:SEEN_IN]->(v)
    RETURN DISTINCT v.name
  } AS videos
