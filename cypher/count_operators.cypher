// Adds to the counts of how many units operators have, what they give, from where they bring what, where they are done,
// and to those of the states in which matters are. What reaches nothing is forgotten.
// param: operators LIST<MAP>
// param: gives LIST<MAP>
// param: brings LIST<MAP>
// param: places LIST<MAP>
// param: states LIST<MAP>
// mode: write
CALL () {
  UNWIND $operators AS row
  MATCH (o:Operator {key: row.operator})
  SET o.count = o.count + row.count
}
CALL () {
  UNWIND $gives AS row
  MATCH (o:Operator {key: row.operator})
  MERGE (s:State {name: row.state})
  MERGE (o)-[r:GIVES]->(s)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
CALL () {
  UNWIND $brings AS row
  MATCH (o:Operator {key: row.operator})
  MATCH (m:Matter {name: row.matter})
  MERGE (o)-[r:BRINGS {out_of: row.role}]->(m)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
CALL () {
  UNWIND $places AS row
  MATCH (o:Operator {key: row.operator})
  MERGE (u:Utensil {name: row.utensil})
  MERGE (o)-[r:DONE_IN]->(u)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
CALL () {
  UNWIND $states AS row
  MATCH (m:Matter {name: row.matter})
  MERGE (s:State {name: row.state})
  MERGE (m)-[r:FOUND_AS]->(s)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
