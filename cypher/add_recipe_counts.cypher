// Adds to the counts of recipes: of all and of those with a sure dish type, of each dish type, of each food, of how often a
// food is called for in a dish type and in a state. What reaches nothing is forgotten.
// param: recipes INTEGER
// param: sure INTEGER
// param: dish_types LIST<MAP>
// param: foods LIST<MAP>
// param: uses LIST<MAP>
// param: states LIST<MAP>
// mode: write
CALL () {
  MATCH (f:Foon {name: 'foon-kg'})
  SET f.recipes = coalesce(f.recipes, 0) + $recipes, f.sure_recipes = coalesce(f.sure_recipes, 0) + $sure
}
CALL () {
  UNWIND $dish_types AS row
  MATCH (d:DishType {name: row.dish_type})
  SET d.recipes = nullIf(coalesce(d.recipes, 0) + row.count, 0)
}
CALL () {
  UNWIND $foods AS row
  MATCH (i:Ingredient {name: row.food})
  SET i.recipes = nullIf(coalesce(i.recipes, 0) + row.count, 0)
}
CALL () {
  UNWIND $uses AS row
  MATCH (i:Ingredient {name: row.food})
  MATCH (d:DishType {name: row.dish_type})
  MERGE (i)-[r:USED_IN]->(d)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
CALL () {
  UNWIND $states AS row
  MATCH (i:Ingredient {name: row.food})
  MERGE (s:State {name: row.state})
  MERGE (i)-[r:ASKED_AS]->(s)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
