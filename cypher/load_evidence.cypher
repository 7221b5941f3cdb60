// Adds to the counts of how many units of an operator are done to a matter, and change it, and writes down where that was
// first seen. What no unit does any more is forgotten.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MATCH (o:Operator {key: row.operator})
MATCH (m:Matter {name: row.matter})
MERGE (o)-[d:DONE_TO]->(m)
  ON CREATE SET d.units = 0, d.changed = 0
SET d.units = d.units + row.units, d.changed = d.changed + row.changed, d.seen = row.seen, d.changes = row.changes
WITH d
WHERE d.units = 0
DELETE d
