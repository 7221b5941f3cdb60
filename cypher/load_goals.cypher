// Marks goal nodes with their dish type, once for each video that says so, and with the foods they are made of.
// param: goals LIST<MAP>
// mode: write
UNWIND $goals AS row
MATCH (o:Object {key: row.key})
MERGE (d:DishType {name: row.dish_type})
MERGE (o)-[:IS_A {video: row.video}]->(d)
WITH DISTINCT o
UNWIND o.ingredients AS name
MERGE (i:Ingredient {name: name})
MERGE (o)-[:MADE_OF]->(i)
