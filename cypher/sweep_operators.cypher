// Takes away the operators that no unit attests any more, and what nothing speaks of: of the foods those that are named, all
// kinds, forms, appliances, types of stages and utensils, and the matter that stands for anything.
// param: foods LIST<STRING>
// mode: write
// scans: all but foods are few
CALL () {
  MATCH (o:Operator) WHERE NOT EXISTS { (o)-[:ATTESTED_BY]->() } DETACH DELETE o
}
CALL () {
  UNWIND $foods AS food
  MATCH (m:Matter {name: food}) WHERE NOT EXISTS { (m)--() } DELETE m
  UNION ALL
  MATCH (m:Appliance|Kind|Form) WHERE NOT EXISTS { (m)--() } DELETE m
  UNION ALL
  MATCH (t:StageType) WHERE NOT EXISTS { (t)--() } DELETE t
  UNION ALL
  MATCH (u:Utensil) WHERE NOT EXISTS { (u)--() } DELETE u
}
