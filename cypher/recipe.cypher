// One recipe with its dish types, the sure one marked, and the foods that it calls for in their order.
// param: id STRING
// column: title
// column: classes
// column: ingredients
// mode: read
MATCH (r:Recipe {id: $id})
RETURN r.title AS title,
  COLLECT { MATCH (r)-[kind:KIND_OF]->(d:DishType) RETURN [d.name, kind.sure] } AS classes,
  COLLECT {
    MATCH (r)-[c:CALLS_FOR]->(i:Ingredient)
    RETURN [i.name, c.state, c.text, c.quantity, c.unit] ORDER BY c.position
  } AS ingredients
