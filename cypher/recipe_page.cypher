// The next recipes of the collection in the order of their ids, with dish types and foods: of those that surely are a
// dish type or, for '', of all.
// param: after STRING
// param: dish_type STRING
// param: most INTEGER
// column: id
// column: title
// column: classes
// column: ingredients
// mode: read
MATCH (r:Recipe)
WHERE r.id > $after
  AND ($dish_type = '' OR EXISTS { MATCH (r)-[kind:KIND_OF]->(:DishType {name: $dish_type}) WHERE kind.sure })
WITH r ORDER BY r.id LIMIT $most
RETURN r.id AS id, r.title AS title,
  COLLECT { MATCH (r)-[kind:KIND_OF]->(d:DishType) RETURN [d.name, kind.sure] } AS classes,
  COLLECT {
    MATCH (r)-[c:CALLS_FOR]->(i:Ingredient)
    RETURN [i.name, c.state, c.text, c.quantity, c.unit] ORDER BY c.position
  } AS ingredients
ORDER BY id
