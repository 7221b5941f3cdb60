// The dishes that are made of all these foods, and of what else.
// param: foods LIST<STRING>
// example: foods=onion, tomato
// column: dish
// column: dish_types
// column: others
// mode: read
MATCH (goal:Object)-[:MADE_OF]->(first:Ingredient {name: $foods[0]})
WHERE all(food IN $foods WHERE food IN goal.ingredients)
WITH DISTINCT goal
RETURN goal.label AS dish,
  COLLECT { MATCH (goal)-[:IS_A]->(d:DishType) RETURN DISTINCT d.name ORDER BY d.name } AS dish_types,
  [food IN goal.ingredients WHERE NOT food IN $foods] AS others
ORDER BY size(others), dish, others
