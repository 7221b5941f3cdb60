// Gives foods their points, and the names that they are compared by. Each food may be named once.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MATCH (i:Ingredient {name: row.name})
SET i.canonical = row.canonical, i.vector = row.vector
