// Counts anew how many object nodes are in each state (count_states), and how many foods are in some state (count_foods).
// mode: write
// scans: all object nodes and foods are counted
MATCH (f:Foon {name: 'foon-kg'})
WITH f, COLLECT {
  MATCH (o:Object)
  UNWIND o.states AS state
  WITH state, count(*) AS objects
  RETURN [state, objects]
  ORDER BY state
} AS counts
SET f.states = [one IN counts | one[0]], f.state_objects = [one IN counts | one[1]],
  f.foods = COUNT { MATCH (i:Ingredient) WHERE EXISTS { (i)-[:SEEN_AS]->() } RETURN i }
