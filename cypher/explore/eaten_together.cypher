// Which foods most often stand beside this one in a dish's list of ingredients.
// param: food STRING
// param: most INTEGER
// example: food=tomato
// default: most=10
// column: food
// column: dishes
// mode: read
MATCH (:Ingredient {name: $food})<-[:MADE_OF]-(goal:Object)-[:MADE_OF]->(other:Ingredient)
RETURN other.name AS food, count(DISTINCT goal) AS dishes
ORDER BY dishes DESC, food
LIMIT $most
