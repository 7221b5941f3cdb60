// The dishes that were made in the fewest steps, with how many foods and utensils. Of a type, or of every one.
// param: dish_type STRING
// param: most INTEGER
// example: dish_type=drinks
// default: most=10
// column: dish
// column: video
// column: steps
// column: foods
// column: utensils
// mode: read
// scans: every dish is asked for
MATCH (goal:Object)-[is:IS_A]->(d:DishType)
WHERE $dish_type IN ['', d.name]
MATCH (v:Video {name: is.video})
RETURN DISTINCT goal.label AS dish, v.name AS video, COUNT { (:Motion)-[:SEEN_IN]->(v) } AS steps,
  size(goal.ingredients) AS foods, COUNT {
    MATCH (v)<-[:SEEN_IN]-(:Motion)<-[:INPUT_OF]-(o:Object)
    WHERE NOT EXISTS { MATCH (:Ingredient {name: o.label})-[:SEEN_AS]->() }
    RETURN DISTINCT o.label
  } AS utensils
ORDER BY steps, dish, video
LIMIT $most
