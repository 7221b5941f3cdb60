// Takes away some of what was learnt of the FOON, operators and frames with everything that speaks of them: at most so many
// ties of operators, and so many nodes. Answers how many went; where none is left, none.
// `Post` is what an older schema called a type of stage.
// param: most INTEGER
// column: gone
// mode: write
// scans: everything that was learnt goes
CALL () {
  MATCH (:Operator)-[r]->()
  WITH r LIMIT $most
  DELETE r
  RETURN count(r) AS ties
}
CALL (ties) {
  MATCH (n:Frame|Line|Matter|Operator|Post|Slot|Stage|StageType|Utensil)
  WHERE NOT EXISTS { (n)<-[:DONE_TO|BRINGS|DONE_IN]-() } AND NOT EXISTS { (n:Operator)-->() }
  WITH n LIMIT $most
  DETACH DELETE n
  RETURN count(n) AS nodes
}
RETURN ties + nodes AS gone
