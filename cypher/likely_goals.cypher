// The goal nodes of the asked dish types that may be the likest to a recipe, each with the videos that make it: all of
// them where they are no more than count, else those of the greatest gain. That is the sum, over the wanted foods, of the
// greatest gain of an ingredient near to it. Besides, the known foods that the labels of these goals name.
// param: dish_types LIST<STRING>
// param: near LIST<MAP>
// param: count INTEGER
// column: goals
// column: foods_named
// column: are_all
// column: least_gain
// mode: read
CALL () {
  UNWIND $dish_types AS dish_type
  MATCH (d:DishType {name: dish_type})
  RETURN collect(d) AS types, coalesce(sum(COUNT { (d)<-[:IS_A]-() }), 0) <= $count AS are_all
}
CALL (types, are_all) {
  CALL (types, are_all) {
    UNWIND CASE WHEN are_all THEN types ELSE [] END AS d
    MATCH (d)<-[:IS_A]-(o:Object)
    RETURN DISTINCT o, 0.0 AS gain
    UNION
    UNWIND CASE WHEN are_all THEN [] ELSE $near END AS pair
    MATCH (i:Ingredient {name: pair.name})<-[:MADE_OF]-(o:Object)
    WHERE any(d IN types WHERE EXISTS { (o)-[:IS_A]->(d) })
    WITH o, pair.food AS food, max(pair.gain) AS gain
    WITH o, sum(gain) AS gain
    ORDER BY gain DESC, o.key
    LIMIT $count
    RETURN o, gain
  }
  RETURN collect(o) AS found, min(gain) AS least_gain
}
RETURN
  COLLECT {
    UNWIND found AS o
    MATCH (o)-[goal:IS_A]->(d:DishType)
    WHERE d IN types
    WITH o, d, collect(DISTINCT goal.video) AS videos
    RETURN [[o.label, o.states, o.ingredients, o.relation, o.container], d.name, videos]
  } AS goals,
  COLLECT {
    UNWIND found AS o
    MATCH (l:Ingredient {name: o.label})
    WITH DISTINCT split(l.singular, ' ') AS spoken
    UNWIND range(0, size(spoken) - 1) AS start
    UNWIND range(start + 1, size(spoken)) AS end
    WITH DISTINCT reduce(text = spoken[start], word IN spoken[start + 1..end] | text + ' ' + word) AS name
    MATCH (i:Ingredient {singular: name})
    USING TEXT INDEX i:Ingredient(singular)
    WHERE EXISTS { (i)-[:SEEN_AS]->() }
    RETURN DISTINCT name
  } AS foods_named,
  are_all,
  least_gain
