// What of the vocabulary matters to who asks for some foods: the foods that have one of the names, those that are named
// after an asked one with more words, or that are nearest to one in the vector index, each state with its foods and
// their counts side by side; of the nearest how many they are, and the cosine of the furthest; all states, all verbs
// that make them, how many units each verb has and how many of them take several foods, and the dish types. Where not
// all foods are placed, there are some of which nothing is known. Among the names are also those of mere ingredients of
// a dish. No row where the points were made of other word lists.
// param: words STRING
// param: names LIST<STRING>
// param: asked LIST<MAP>
// param: count INTEGER
// column: nearest
// column: names
// column: all_placed
// column: foods
// column: states
// column: motions
// column: verbs
// column: dish_types
// mode: read
// scans: states, verbs and dish types are few, and all are asked for
MATCH (record:Foon {name: 'foon-kg', words: $words})
CALL () {
  UNWIND $asked AS asked
  CALL db.index.vector.queryNodes('ingredient_vector', $count, asked.point) YIELD node, score
  WITH asked.name AS name, collect(node) AS foods, min(2 * score - 1) AS furthest
  RETURN collect({name: name, foods: foods, furthest: furthest}) AS near
}
CALL (near) {
  CALL (near) {
    UNWIND near AS row
    UNWIND row.foods AS i
    RETURN i
    UNION
    UNWIND $names AS name
    MATCH (i:Ingredient {canonical: name})
    USING INDEX SEEK i:Ingredient(canonical)
    RETURN i
    UNION
    UNWIND $asked AS asked
    MATCH (i:Ingredient)
    USING TEXT INDEX i:Ingredient(singular)
    WHERE i.singular CONTAINS asked.words[0] AND all(word IN asked.words WHERE word IN split(i.singular, ' '))
    RETURN i
  }
  RETURN collect(i) AS found
}
RETURN
  [row IN near | [row.name, size(row.foods), row.furthest]] AS nearest,
  [i IN found | i.name] AS names,
  coalesce(record.all_placed, false) AS all_placed,
  COLLECT {
    UNWIND found AS i
    MATCH (i)-[r:SEEN_AS]->(s:State)
    WITH s, collect(i.name) AS labels, collect(r.made) AS made, collect(r.used) AS used
    RETURN [s.name, labels, made, used]
  } AS foods,
  COLLECT { MATCH (s:State) WHERE EXISTS { (s)<-[:SEEN_AS]-() } RETURN s.name } AS states,
  COLLECT { MATCH (s:State)-[r:MADE_BY]->(v:Verb) RETURN [s.name, v.name, r.count] } AS motions,
  COLLECT { MATCH (v:Verb) WHERE v.units > 0 RETURN [v.name, v.units, v.several] } AS verbs,
  COLLECT { MATCH (d:DishType) WHERE EXISTS { (d)<-[:IS_A]-() } RETURN d.name } AS dish_types
