// Takes the whole FOON away, its record apart. What recipes call for stays.
// mode: write
// scans: everything goes
MATCH (n:Object|Label|Motion|Plan|Video|Verb|Frame|Line|Matter|Operator|Slot|Stage|StageType|Utensil)
DETACH DELETE n
WITH count(n) AS gone
CALL () {
  MATCH (:State)<-[seen:SEEN_AS]-() DELETE seen
}
CALL () {
  MATCH (s:State) WHERE NOT EXISTS { (s)--() } DELETE s
  UNION ALL
  MATCH (i:Ingredient) WHERE NOT EXISTS { (i)--() } DELETE i
  UNION ALL
  MATCH (d:DishType) WHERE NOT EXISTS { (d)--() } DELETE d
}
