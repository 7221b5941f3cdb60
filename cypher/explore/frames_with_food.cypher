// The dishes that a food joins, and how: in which states, by which motion into what, and what is then done to the whole.
// "Which frames have a slot for milk?"
// param: food STRING
// example: food=milk
// column: dish
// column: dish_type
// column: video
// column: states
// column: joins_by
// column: vessel
// column: then
// mode: read
MATCH (:Food {name: $food})<-[:TAKES]-(slot:Slot)<-[:HAS_SLOT]-(stage:Stage)
MATCH (stage)<-[:HAS_STAGE|JOINED_BY*1..]-(f:Frame)-[:DERIVED_FROM]->(v:Video)
RETURN f.label AS dish, f.dish_type AS dish_type, v.name AS video, slot.states AS states, slot.motion AS joins_by,
  stage.vessel AS vessel, stage.motion AS then
ORDER BY dish, video, stage.step
