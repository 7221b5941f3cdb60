// The words that the FOON knows: how often each food is made and used in each state, which verb makes which state how
// often, and the dish types that have a goal. States are few and foods are many: each state is answered once, with its
// foods and their counts side by side.
// column: foods
// column: motions
// column: dish_types
// mode: read
// scans: all words are asked for
RETURN
  COLLECT {
    MATCH (s:State)<-[r:SEEN_AS]-(i:Ingredient)
    WITH s, collect(i.name) AS labels, collect(r.made) AS made, collect(r.used) AS used
    RETURN [s.name, labels, made, used]
  } AS foods,
  COLLECT { MATCH (s:State)-[r:MADE_BY]->(v:Verb) RETURN [s.name, v.name, r.count] } AS motions,
  COLLECT { MATCH (d:DishType) WHERE EXISTS { (d)<-[:IS_A]-() } RETURN d.name } AS dish_types
