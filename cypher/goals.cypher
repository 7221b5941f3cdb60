// The goal nodes of the asked dish types, each with the videos that make it.
// param: dish_types LIST<STRING>
// column: goals
// mode: read
UNWIND $dish_types AS dish_type
MATCH (d:DishType {name: dish_type})<-[goal:IS_A]-(o:Object)
WITH d, o, collect(DISTINCT goal.video) AS videos
RETURN collect([[o.label, o.states, o.ingredients, o.relation, o.container], d.name, videos]) AS goals
