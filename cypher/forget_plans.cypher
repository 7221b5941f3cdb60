// Throws out the reference trees of every goal that any of the named object nodes may take part in making. A node of its
// own, gone at the end, outputs all that changed: so one search forwards finds the goals, as “behind” finds units
// backwards from one node. It goes on from what the kitchen has not, and nothing is searched where no tree is kept.
// param: keys LIST<STRING>
// mode: write
// scans: whether there is any tree at all
MATCH (some:Plan)
WITH some LIMIT 1
CREATE (change:Change)
WITH change
CALL (change) {
  UNWIND $keys AS key
  MATCH (o:Object {key: key})
  CREATE (change)-[:OUTPUTS]->(o)
}
CALL (change) {
  MATCH path = (change)-[:OUTPUTS|INPUT_OF*1..]->(o)
  WHERE all(r IN relationships(path) WHERE type(r) = 'OUTPUTS' OR startNode(r).start IS NULL)
  WITH DISTINCT o
  MATCH (o)<-[:ANSWERS]-(p:Plan)
  DETACH DELETE p
}
DETACH DELETE change
