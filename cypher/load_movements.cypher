// Adds to the counts of how many sightings of a unit show its objects moving. Each unit may be named once; where it is gone,
// nothing is counted, and where nothing moves any more, the edge says nothing.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MATCH (m:Motion {key: row.unit})
CALL (m, row) {
  UNWIND row.inputs AS one
  MATCH (m)<-[r:INPUT_OF]-(:Object {key: one.key})
  WITH r, coalesce(r.moving, 0) + one.count AS moving
  SET r.moving = CASE WHEN moving > 0 THEN moving END
}
CALL (m, row) {
  UNWIND row.outputs AS one
  MATCH (m)-[r:OUTPUTS]->(:Object {key: one.key})
  WITH r, coalesce(r.moving, 0) + one.count AS moving
  SET r.moving = CASE WHEN moving > 0 THEN moving END
}
