// Adds to the counts of how many units make a state with a verb; a pair that reaches nothing is forgotten.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MERGE (s:State {name: row.state})
MERGE (v:Verb {name: row.motion})
MERGE (s)-[made:MADE_BY]->(v)
SET made.count = coalesce(made.count, 0) + row.count
WITH made
WHERE made.count = 0
DELETE made
