// The shortest way of a food into a dish: the motions that it passes, and what it is in after each of them. Only nodes
// that are the food, or mix it with others, are on the way: a knife that was used twice is no shortcut.
// param: food STRING
// param: dish STRING
// example: food=cucumber
// example: dish=greek salad
// column: motions
// column: becomes
// mode: read
MATCH (goal:Object {label: $dish})-[:IS_A]->(:DishType)
WITH DISTINCT goal
MATCH (start:Object {label: $food})
WHERE start.start IS NOT NULL
MATCH way = shortestPath((start)-[:INPUT_OF|OUTPUTS*1..60]->(goal))
WHERE all(n IN nodes(way) WHERE n:Motion OR n.label = $food OR $food IN n.ingredients AND size(n.ingredients) > 1)
WITH way, nodes(way) AS passed
ORDER BY length(way), start.key, goal.key
LIMIT 1
RETURN [n IN passed WHERE n:Motion | n.verb] AS motions,
  [n IN passed[1..] WHERE n:Object | n.label + CASE WHEN size(n.states) > 0 THEN ' (' + reduce(
    words = n.states[0], state IN n.states[1..] | words + ', ' + state) + ')' ELSE '' END] AS becomes
