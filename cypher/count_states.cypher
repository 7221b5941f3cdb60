// Adds to the counts of how many object nodes are in each state, which the record keeps in two lists by the names of the
// states. A state in which there is none any more is forgotten. Where nothing was counted yet, nothing is kept.
// param: rows LIST<MAP>
// mode: write
MATCH (f:Foon {name: 'foon-kg'})
WHERE f.states IS NOT NULL
WITH f,
  [place IN range(0, size(f.states) - 1) | [f.states[place], f.state_objects[place]]]
    + [row IN $rows | [row.state, row.count]] AS counted
WITH f, COLLECT {
  UNWIND counted AS one
  WITH one[0] AS state, sum(one[1]) AS objects
  WHERE objects > 0
  RETURN [state, objects]
  ORDER BY state
} AS counts
SET f.states = [one IN counts | one[0]], f.state_objects = [one IN counts | one[1]]
