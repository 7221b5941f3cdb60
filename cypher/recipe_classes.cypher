// How many recipes surely belong to each dish type, how many foods they call for, and how many of those uses are of foods
// that no unit of the FOON has. The counts are kept.
// column: dish_type
// column: recipes
// column: ingredients
// column: unseen
// mode: read
// scans: dish types are few
MATCH (d:DishType)
WHERE d.recipes > 0
CALL (d) {
  MATCH (d)<-[used:USED_IN]-(i:Ingredient)
  RETURN sum(used.count) AS ingredients,
    sum(CASE WHEN EXISTS { (i)-[:SEEN_AS]->() } THEN 0 ELSE used.count END) AS unseen
}
RETURN d.name AS dish_type, d.recipes AS recipes, ingredients, unseen
ORDER BY recipes DESC, dish_type
