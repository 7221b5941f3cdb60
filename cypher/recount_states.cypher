// Counts anew how many object nodes are in each state (count_states).
// mode: write
// scans: all object nodes are counted
MATCH (f:Foon {name: 'foon-kg'})
WITH f, COLLECT {
  MATCH (o:Object)
  UNWIND o.states AS state
  WITH state, count(*) AS objects
  RETURN [state, objects]
  ORDER BY state
} AS counts
SET f.states = [one IN counts | one[0]], f.state_objects = [one IN counts | one[1]]
