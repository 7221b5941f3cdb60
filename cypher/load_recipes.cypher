// Makes recipes, or gives those that are there their new content, with the foods that they call for, in the order of the
// recipe, and their dish types. Each id may be named once; the ingredients must be there.
// param: recipes LIST<MAP>
// mode: write
UNWIND $recipes AS row
MERGE (r:Recipe {id: row.id})
SET r += row.properties
WITH r, row
CALL (r) {
  MATCH (r)-[old:CALLS_FOR|KIND_OF]->()
  DELETE old
}
CALL (r, row) {
  UNWIND row.classes AS class
  MATCH (d:DishType {name: class.name})
  CREATE (r)-[:KIND_OF {sure: class.sure}]->(d)
}
CALL (r, row) {
  UNWIND row.ingredients AS called
  MATCH (i:Ingredient {name: called.name})
  CREATE (r)-[c:CALLS_FOR]->(i)
  SET c = called.properties
}
