// What those of the asked recipes that the graph has count for: their dish types, the sure ones marked, and the foods and
// states that they call for.
// param: ids LIST<STRING>
// column: classes
// column: ingredients
// mode: read
UNWIND $ids AS id
MATCH (r:Recipe {id: id})
RETURN
  COLLECT { MATCH (r)-[kind:KIND_OF]->(d:DishType) RETURN [d.name, kind.sure] } AS classes,
  COLLECT { MATCH (r)-[c:CALLS_FOR]->(i:Ingredient) RETURN [i.name, c.state] } AS ingredients
