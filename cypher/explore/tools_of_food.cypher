// Which utensils one needs for a food: each that takes part in a unit with it, in how many units, and for which motions.
// A utensil is what takes part in units without ever counting as a food.
// param: food STRING
// example: food=potato
// column: utensil
// column: units
// column: motions
// mode: read
MATCH (:Object {label: $food})-[:INPUT_OF]->(m:Motion)<-[:INPUT_OF]-(other:Object)
WHERE NOT EXISTS { MATCH (:Ingredient {name: other.label})-[:SEEN_AS]->() }
WITH DISTINCT other.label AS utensil, m ORDER BY m.verb
RETURN utensil, count(m) AS units, collect(DISTINCT m.verb) AS motions
ORDER BY units DESC, utensil
