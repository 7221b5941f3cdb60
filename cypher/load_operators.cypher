// Makes the operators that are not there yet, and ties to them the units that attest them, which are new. What a unit is
// done to and what it changes stands on its tie. Each operator may be named once.
// param: operators LIST<MAP>
// mode: write
UNWIND $operators AS row
MERGE (o:Operator {key: row.key})
  ON CREATE SET o.motion = row.motion, o.tools = row.tools, o.count = 0
WITH o, row
CALL (o, row) {
  UNWIND row.units AS unit
  MATCH (m:Motion {key: unit.key})
  CREATE (o)-[:ATTESTED_BY {done_to: unit.done_to, changes: unit.changes}]->(m)
}
