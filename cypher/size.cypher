// How large the FOON is: its units and videos, how many foods it knows, and the names of its dish types.
// column: units
// column: videos
// column: foods
// column: dish_types
// mode: read
// scans: all foods are counted
RETURN
  COUNT { (:Motion) } AS units,
  COUNT { (:Video) } AS videos,
  COUNT { MATCH (i:Ingredient) WHERE EXISTS { (i)-[:SEEN_AS]->() } RETURN i } AS foods,
  COLLECT { MATCH (d:DishType) WHERE EXISTS { (d)<-[:IS_A]-() } RETURN d.name } AS dish_types
