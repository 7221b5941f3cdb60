// How many recipes surely belong to each dish type, how many foods they call for, and how many of those uses are of foods
// that no unit of the FOON has.
// column: dish_type
// column: recipes
// column: ingredients
// column: unseen
// mode: read
// scans: every recipe is counted
MATCH (d:DishType)<-[kind:KIND_OF]-(r:Recipe)
WHERE kind.sure
WITH d, r, COUNT { (r)-[:CALLS_FOR]->() } AS called,
  COUNT { MATCH (r)-[:CALLS_FOR]->(i:Ingredient) WHERE NOT EXISTS { (i)-[:SEEN_AS]->() } } AS unseen
RETURN d.name AS dish_type, count(r) AS recipes, sum(called) AS ingredients, sum(unseen) AS unseen
ORDER BY recipes DESC, dish_type
