// Makes the object nodes that are not there yet, ties them to their labels, and names them, all in one row: a row a node costs
// the program more than the node costs the database. Each key may be named once.
// param: objects LIST<MAP>
// column: keys
// mode: write
MATCH (f:Foon {name: 'foon-kg'})
UNWIND $objects AS row
MERGE (o:Object {key: row.key})
  ON CREATE SET o.label = row.label, o.states = row.states, o.ingredients = row.ingredients,
    o.relation = row.relation, o.container = row.container, o.start = row.start, o.utensil = row.utensil
WITH f, o
WHERE NOT EXISTS { (o)-[:CALLED]->() }
WITH f, o.label AS label, collect(o) AS objects
MERGE (l:Label {name: label})
MERGE (l)-[:LABEL_OF]->(f)
WITH l, objects
UNWIND objects AS o
CREATE (o)-[:CALLED]->(l)
RETURN collect(o.key) AS keys
