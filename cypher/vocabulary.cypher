// The words that the FOON knows: how often each food is made and used in each state, which verb makes which state how
// often, how many units each verb has and how many of them take several foods, and the dish types that have a goal. States are few and foods are many: each state is answered once, with its
// foods and their counts side by side.
// column: foods
// column: motions
// column: verbs
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
  COLLECT { MATCH (v:Verb) WHERE v.units > 0 RETURN [v.name, v.units, v.several] } AS verbs,
  COLLECT { MATCH (d:DishType) WHERE EXISTS { (d)<-[:IS_A]-() } RETURN d.name } AS dish_types
