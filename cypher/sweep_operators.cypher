// Takes away the operators that no unit attests any more, and the matters, posts and utensils that nothing speaks of.
// mode: write
// scans: all of them are few beside units
CALL () {
  MATCH (o:Operator) WHERE NOT EXISTS { (o)-[:ATTESTED_BY]->() } DETACH DELETE o
}
CALL () {
  MATCH (m:Matter) WHERE NOT EXISTS { (m)--() } DELETE m
  UNION ALL
  MATCH (p:Post) WHERE NOT EXISTS { (p)--() } DELETE p
  UNION ALL
  MATCH (u:Utensil) WHERE NOT EXISTS { (u)--() } DELETE u
}
