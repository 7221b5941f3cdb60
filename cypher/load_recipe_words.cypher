// Makes the ingredients and the dish types that recipes name and that are not there yet. Each name may come once.
// param: ingredients LIST<MAP>
// param: dish_types LIST<STRING>
// mode: write
CALL () {
  UNWIND $ingredients AS row
  MERGE (i:Ingredient {name: row.name})
    ON CREATE SET i.canonical = row.canonical
}
CALL () {
  UNWIND $dish_types AS name
  MERGE (:DishType {name: name})
}
