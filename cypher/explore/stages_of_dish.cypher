// How the dish of one video is made, as it was learnt: stage by stage what joins, what is then done to the whole, with
// which tools and appliance, and what it is called afterwards. What joins as a line of its own has its stages first.
// param: video STRING
// example: video=garden_omelette
// column: dish
// column: step
// column: joins
// column: motion
// column: tools
// column: vessel
// column: appliance
// column: becomes
// column: states
// mode: read
MATCH (:Video {name: $video})<-[:DERIVED_FROM]-(f:Frame)-[:HAS_STAGE|JOINED_BY*1..]->(stage:Stage)
RETURN f.label AS dish, stage.step AS step, COLLECT {
  MATCH (stage)-[joins:HAS_SLOT|JOINED_BY]->(part)
  WITH joins, CASE WHEN part:Slot THEN part.food ELSE head(COLLECT {
    MATCH (part)-[last:HAS_STAGE]->(end:Stage) RETURN end.label ORDER BY last.place DESC
  }) END AS name
  RETURN name ORDER BY joins.place
} AS joins, stage.motion AS motion, stage.tools AS tools, stage.vessel AS vessel, stage.appliance AS appliance,
  stage.label AS becomes, stage.states AS states
ORDER BY dish, step, becomes
