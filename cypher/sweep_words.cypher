// Takes away the words that nothing in the graph uses any more.
// mode: write
// scans: words are few beside units
CALL () {
  MATCH (l:Label) WHERE NOT EXISTS { (l)<-[:CALLED]-() } DETACH DELETE l
  UNION ALL
  MATCH (i:Ingredient) WHERE NOT EXISTS { (i)--() } DELETE i
  UNION ALL
  MATCH (s:State) WHERE NOT EXISTS { (s)--() } DELETE s
  UNION ALL
  MATCH (v:Verb) WHERE v.units = 0 AND NOT EXISTS { (v)--() } DELETE v
  UNION ALL
  MATCH (d:DishType) WHERE NOT EXISTS { (d)--() } DELETE d
}
