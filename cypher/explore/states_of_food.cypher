// The states in which a food is seen: how many units make it so, and how many use it so.
// param: food STRING
// example: food=onion
// column: state
// column: made
// column: used
// mode: read
MATCH (:Ingredient {name: $food})-[seen:SEEN_AS]->(s:State)
RETURN s.name AS state, seen.made AS made, seen.used AS used
ORDER BY made + used DESC, state
