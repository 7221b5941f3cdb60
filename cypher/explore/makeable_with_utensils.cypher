// Which dishes were made with these utensils and no others: what can be made in this kitchen as it was shown.
// A utensil is what takes part in units without ever counting as a food.
// param: utensils LIST<STRING>
// example: utensils=faucet, knife, cutting board, spoon, bowl, pitcher, squeezer, drinking glass, bag, jar
// column: dish
// column: dish_type
// column: video
// column: utensils
// mode: read
// scans: every dish is asked for
MATCH (goal:Object)-[is:IS_A]->(d:DishType)
MATCH (v:Video {name: is.video})<-[:SEEN_IN]-(:Motion)<-[:INPUT_OF]-(:Object)-[:CALLED]->(l:Label)
WHERE NOT EXISTS { MATCH (:Ingredient {name: l.name})-[:SEEN_AS]->() }
WITH goal, d, v, l.name AS utensil ORDER BY utensil
WITH goal, d, v, collect(DISTINCT utensil) AS used
WHERE all(utensil IN used WHERE utensil IN $utensils)
RETURN goal.label AS dish, d.name AS dish_type, v.name AS video, used AS utensils
ORDER BY size(used), dish, video
