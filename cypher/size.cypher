// How large the FOON is: its units and videos, how many foods it knows, and the names of its dish types. Foods are counted by
// each load (count_foods).
// column: units
// column: videos
// column: foods
// column: dish_types
// mode: read
// scans: where nobody has counted foods, all are looked at
OPTIONAL MATCH (f:Foon {name: 'foon-kg'})
RETURN
  COUNT { (:Motion) } AS units,
  COUNT { (:Video) } AS videos,
  coalesce(f.foods, 0) + COUNT {
    UNWIND CASE WHEN f.foods IS NULL THEN [0] ELSE [] END AS uncounted
    MATCH (i:Ingredient)
    WHERE EXISTS { (i)-[:SEEN_AS]->() }
    RETURN i
  } AS foods,
  COLLECT { MATCH (d:DishType) WHERE EXISTS { (d)<-[:IS_A]-() } RETURN d.name } AS dish_types
