// All that was learnt of the FOON: its operators with their evidence and counts, its frames, and how often foods of each
// kind join where. What is asked of many nodes is answered in columns side by side.
// column: operators
// column: evidence
// column: gives
// column: brings
// column: places
// column: states
// column: stage_types
// column: beside
// column: cooked
// column: frames
// mode: read
// scans: all is asked for
CALL () {
  MATCH (o:Operator)
  RETURN collect(o) AS found
}
RETURN
  [o IN found | [o.motion, o.tools]] AS operators,
  [o IN found | [(o)-[d:DONE_TO]->(m) | [m.name, [d.units, d.changed, d.seen, d.changes]]]] AS evidence,
  [o IN found | [(o)-[r:GIVES]->(s) | [s.name, r.count]]] AS gives,
  [o IN found | [(o)-[r:BRINGS]->(m) | [m.name, r.out_of, r.count]]] AS brings,
  [o IN found | [(o)-[r:DONE_IN]->(u) | [u.name, r.count]]] AS places,
  COLLECT { MATCH (m:Matter)-[:FOUND_AS]->(s:State) WITH m, collect(s.name) AS names RETURN [m.name, names] } AS states,
  COLLECT {
    MATCH (k:Kind)-[r:JOINS_AT]->(t:StageType)
    RETURN [k.name, r.dish_type, t.work, t.heated, t.joins, r.count]
  } AS stage_types,
  COLLECT { MATCH (k:Kind)-[r:JOINS_BESIDE]->(other) RETURN [k.name, other.name, r.count] } AS beside,
  COLLECT { MATCH (k:Kind)-[r:COOKED_BY]->(v) RETURN [k.name, v.name, r.count] } AS cooked,
  COLLECT { MATCH (f:Frame) RETURN f.text } AS frames
