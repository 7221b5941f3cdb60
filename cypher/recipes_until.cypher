// How many recipes there are, and how many of them up to one: of those that surely are a dish type or, for '', of all.
// param: last STRING
// param: dish_type STRING
// column: recipes
// column: until
// mode: read
CALL () {
  WITH * WHERE $dish_type = ''
  RETURN COUNT { (:Recipe) } AS recipes, COUNT { MATCH (r:Recipe) WHERE r.id <= $last } AS until
  UNION ALL
  MATCH (:DishType {name: $dish_type})<-[kind:KIND_OF]-(r:Recipe)
  WHERE kind.sure
  RETURN count(r) AS recipes, sum(CASE WHEN r.id <= $last THEN 1 ELSE 0 END) AS until
}
RETURN sum(recipes) AS recipes, sum(until) AS until
