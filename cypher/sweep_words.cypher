// Takes away those of the named words that nothing in the graph uses any more, and such dish types.
// param: words LIST<STRING>
// mode: write
// scans: dish types are few
CALL () {
  UNWIND $words AS word
  MATCH (l:Label {name: word}) WHERE NOT EXISTS { (l)<-[:CALLED]-() } DETACH DELETE l
  UNION ALL
  UNWIND $words AS word
  MATCH (i:Ingredient {name: word}) WHERE NOT EXISTS { (i)--() } DELETE i
  UNION ALL
  UNWIND $words AS word
  MATCH (s:State {name: word}) WHERE NOT EXISTS { (s)--() } DELETE s
  UNION ALL
  UNWIND $words AS word
  MATCH (v:Verb {name: word}) WHERE v.units = 0 AND NOT EXISTS { (v)--() } DELETE v
  UNION ALL
  MATCH (d:DishType) WHERE NOT EXISTS { (d)--() } DELETE d
}
