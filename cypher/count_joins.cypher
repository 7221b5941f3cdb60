// Adds to the counts of how often foods of a kind join at a type of stage, beside which other kinds, and by which motion they are
// cooked before. What reaches nothing is forgotten.
// param: stage_types LIST<MAP>
// param: beside LIST<MAP>
// param: cooked LIST<MAP>
// mode: write
CALL () {
  UNWIND $stage_types AS row
  MATCH (m:Matter {name: row.kind})
  MERGE (t:StageType {name: row.stage_type})
    ON CREATE SET t += row.properties
  MERGE (m)-[r:JOINS_AT {dish_type: row.dish_type}]->(t)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
CALL () {
  UNWIND $beside AS row
  MATCH (m:Matter {name: row.kind})
  MATCH (other:Matter {name: row.other})
  MERGE (m)-[r:JOINS_BESIDE]->(other)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
CALL () {
  UNWIND $cooked AS row
  MATCH (m:Matter {name: row.kind})
  MATCH (v:Verb {name: row.motion})
  MERGE (m)-[r:COOKED_BY]->(v)
  SET r.count = coalesce(r.count, 0) + row.count
  WITH r WHERE r.count = 0
  DELETE r
}
