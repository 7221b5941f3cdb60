// Adds to the counts of how many units of an operator are done to a matter, and change it, and writes down where that was
// first seen: of each operator, named once, the matters that it is known to be done to, and those that are new with it.
// What no unit does any more is forgotten.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MATCH (o:Operator {key: row.operator})
CALL (o, row) {
  UNWIND row.new AS one
  MATCH (m:Matter {name: one.matter})
  CREATE (o)-[:DONE_TO {units: one.units, changed: one.changed, seen: one.seen, changes: one.changes}]->(m)
}
CALL (o, row) {
  UNWIND row.known AS one
  MATCH (m:Matter {name: one.matter})
  MATCH (o)-[d:DONE_TO]->(m)
  SET d.units = d.units + one.units, d.changed = d.changed + one.changed, d.seen = one.seen, d.changes = one.changes
  WITH d
  WHERE d.units = 0
  DELETE d
}
