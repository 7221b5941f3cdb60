// Gives foods their points, the names that they are compared by, and their words, each in the singular. Each food may be named once.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MATCH (i:Ingredient {name: row.name})
SET i.canonical = row.canonical, i.singular = row.singular, i.vector = row.vector
