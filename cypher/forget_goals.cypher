// Takes away what the named videos say about goals: a node that is no goal any more is made of nothing any more.
// param: names LIST<STRING>
// param: dish_types LIST<STRING>
// mode: write
UNWIND $dish_types AS dish_type
MATCH (:DishType {name: dish_type})<-[goal:IS_A]-(o:Object)
WHERE goal.video IN $names
DELETE goal
WITH DISTINCT o
WHERE NOT EXISTS { (o)-[:IS_A]->() }
MATCH (o)-[made:MADE_OF]->()
DELETE made
