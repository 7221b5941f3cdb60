// The motions that cooking is made of: in how many units, videos and dish types each is, and to how many foods it is done.
// param: most INTEGER
// default: most=15
// column: motion
// column: units
// column: videos
// column: dish_types
// column: foods
// mode: read
// scans: the most of all cannot be known without a look at all
MATCH (m:Motion)
WITH m.verb AS motion, collect(m) AS doing
ORDER BY size(doing) DESC, motion
LIMIT $most
CALL (doing) {  // by itself, as the next one: within an expression the list of units would be kept beside each name
  UNWIND doing AS m
  MATCH (m)-[:SEEN_IN]->(v:Video)
  RETURN collect(DISTINCT v.name) AS videos
}
CALL (doing) {
  UNWIND doing AS m
  MATCH (m)<-[:INPUT_OF]-(o:Object)
  WHERE EXISTS { MATCH (:Ingredient {name: o.label})-[:SEEN_AS]->() }
  RETURN count(DISTINCT o.label) AS foods
}
RETURN motion, size(doing) AS units, size(videos) AS videos,
  COUNT { UNWIND videos AS video MATCH (:Object)-[:IS_A {video: video}]->(d:DishType) RETURN DISTINCT d } AS dish_types,
  foods
ORDER BY units DESC, motion
