// Adds to the counts of how many units have a verb, and how many of these take several foods.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MERGE (v:Verb {name: row.motion})
SET v.units = coalesce(v.units, 0) + row.units, v.several = coalesce(v.several, 0) + row.several
