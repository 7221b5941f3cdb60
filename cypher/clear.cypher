// Takes the whole FOON away, its record apart. What recipes call for stays.
// mode: write
// scans: everything goes
MATCH (n:Object|Label|Motion|Plan|Video|State|Verb|Frame|Line|Matter|Operator|Post|Slot|Stage|Utensil)
DETACH DELETE n
WITH count(n) AS gone
CALL () {
  MATCH (i:Ingredient) WHERE NOT EXISTS { (i)--() } DELETE i
  UNION ALL
  MATCH (d:DishType) WHERE NOT EXISTS { (d)--() } DELETE d
}
