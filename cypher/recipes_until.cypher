// How many recipes there are, and how many of them up to one: of those that surely are a dish type or, for '', of all.
// param: last STRING
// param: dish_type STRING
// column: recipes
// column: until
// mode: read
// scans: all are counted
MATCH (r:Recipe)
WHERE $dish_type = '' OR EXISTS { MATCH (r)-[kind:KIND_OF]->(:DishType {name: $dish_type}) WHERE kind.sure }
RETURN count(r) AS recipes, sum(CASE WHEN r.id <= $last THEN 1 ELSE 0 END) AS until
