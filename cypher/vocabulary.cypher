// The words that the FOON knows: how often each food is made and used in each state, which verb makes which state how
// often, and the dish types that have a goal.
// column: foods
// column: motions
// column: dish_types
// mode: read
// scans: all words are asked for
RETURN
  COLLECT { MATCH (i:Ingredient)-[r:SEEN_AS]->(s:State) RETURN [i.name, s.name, r.made, r.used] } AS foods,
  COLLECT { MATCH (s:State)-[r:MADE_BY]->(v:Verb) RETURN [s.name, v.name, r.count] } AS motions,
  COLLECT { MATCH (d:DishType) WHERE EXISTS { (d)<-[:IS_A]-() } RETURN d.name } AS dish_types
