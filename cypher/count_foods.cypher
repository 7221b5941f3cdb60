// Adds to the counts of how often a food is made and used in a state; a pair that reaches nothing is forgotten.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MERGE (i:Ingredient {name: row.label})
MERGE (s:State {name: row.state})
MERGE (i)-[seen:SEEN_AS]->(s)
SET seen.made = coalesce(seen.made, 0) + row.made, seen.used = coalesce(seen.used, 0) + row.used
WITH seen
WHERE seen.made = 0 AND seen.used = 0
DELETE seen
