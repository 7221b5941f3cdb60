// Gives what neo4j-admin has imported the lists that an import leaves out: those that are empty, and those that hold one
// empty text. In transactions of its own, so that it can be asked in none.
// mode: write
// scans: everything was just imported
MATCH (v:Video) WHERE v.sources IS NULL
CALL (v) {
  SET v.sources = []
} IN TRANSACTIONS OF 20000 ROWS
WITH count(*) AS videos
MATCH (o:Object) WHERE o.states IS NULL OR o.ingredients IS NULL
CALL (o) {
  SET o.states = coalesce(o.states, []), o.ingredients = coalesce(o.ingredients, [])
} IN TRANSACTIONS OF 20000 ROWS
WITH count(*) AS objects
MATCH (:Motion)-[s:SEEN_IN]->(:Video)
WHERE s.span_starts IS NULL OR s.inputs_dish IS NULL OR s.outputs_dish IS NULL OR s.inputs IS NULL
CALL (s) {
  SET s.span_starts = coalesce(s.span_starts, []), s.span_ends = coalesce(s.span_ends, []),
    s.inputs_dish = coalesce(s.inputs_dish, CASE WHEN s.inputs IS NULL THEN [] ELSE [''] END),
    s.outputs_dish = coalesce(s.outputs_dish, ['']),
    s.inputs_moving = coalesce(s.inputs_moving, []), s.inputs = coalesce(s.inputs, [])
} IN TRANSACTIONS OF 20000 ROWS
WITH count(*) AS sightings
MATCH (o:Operator) WHERE o.tools IS NULL
CALL (o) {
  SET o.tools = []
} IN TRANSACTIONS OF 20000 ROWS
WITH count(*) AS operators
MATCH (:Operator)-[d:DONE_TO|ATTESTED_BY]->() WHERE d.changes IS NULL
CALL (d) {
  SET d.changes = []
} IN TRANSACTIONS OF 20000 ROWS
WITH count(*) AS evidence
MATCH (f:Frame)
CALL (f) {
  SET f.foods = coalesce(f.foods, []), f.kinds = coalesce(f.kinds, []), f.weak = coalesce(f.weak, [])
} IN TRANSACTIONS OF 20000 ROWS
WITH count(*) AS frames
MATCH (s:Stage)
CALL (s) {
  SET s.does = coalesce(s.does, []), s.tools = coalesce(s.tools, []), s.states = coalesce(s.states, [])
} IN TRANSACTIONS OF 20000 ROWS
WITH count(*) AS stages
MATCH (s:Slot)
CALL (s) {
  SET s.states = coalesce(s.states, []), s.cooked = coalesce(s.cooked, []), s.tools = coalesce(s.tools, [])
} IN TRANSACTIONS OF 20000 ROWS
