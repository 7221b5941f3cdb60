// Takes units away, and the object nodes that no other unit has, with the reference trees that are kept for them. Of each of
// these nodes the states are told.
// param: keys LIST<STRING>
// column: states
// mode: write
UNWIND $keys AS key
MATCH (m:Motion {key: key})
OPTIONAL MATCH (m)-[:INPUT_OF|OUTPUTS]-(o:Object)
WITH collect(DISTINCT m) AS motions, collect(DISTINCT o) AS objects
CALL (motions) {
  UNWIND motions AS m
  DETACH DELETE m
}
UNWIND objects AS o
WITH o
WHERE NOT EXISTS { (o)-[:INPUT_OF|OUTPUTS]-() }
CALL (o) {
  MATCH (o)<-[:ANSWERS]-(p:Plan)
  DETACH DELETE p
}
WITH o, o.states AS states
DETACH DELETE o
RETURN states
