// Gives every motion node the cost of its verb, and takes it from those whose verb has none any more. The record of the
// FOON keeps the whole table, for motion nodes that come later. Answers each verb of the FOON with its units.
// param: costs LIST<MAP>
// column: verb
// column: units
// column: has_cost
// mode: write
// scans: every motion node has a cost, or none
MATCH (f:Foon {name: 'foon-kg'})
SET f.cost_motions = [row IN $costs | row.motion], f.costs = [row IN $costs | row.cost]
WITH f
MATCH (m:Motion)
WITH m.verb AS verb, collect(m) AS motions
WITH verb, motions, [row IN $costs WHERE row.motion = verb | row.cost][0] AS cost
CALL (motions, cost) {
  UNWIND motions AS m
  WITH m
  WHERE coalesce(m.cost, -1.0) <> coalesce(cost, -1.0)
  SET m.cost = cost
}
RETURN verb, size(motions) AS units, cost IS NOT NULL AS has_cost
ORDER BY verb
