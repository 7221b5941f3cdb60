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
WITH motion, doing, COLLECT { UNWIND doing AS m MATCH (m)-[:SEEN_IN]->(v:Video) RETURN DISTINCT v.name } AS videos
RETURN motion, size(doing) AS units, size(videos) AS videos,
  COUNT { UNWIND videos AS video MATCH (:Object)-[:IS_A {video: video}]->(d:DishType) RETURN DISTINCT d } AS dish_types,
  COUNT {
    UNWIND doing AS m MATCH (m)<-[:INPUT_OF]-(o:Object)
    WHERE EXISTS { MATCH (:Ingredient {name: o.label})-[:SEEN_AS]->() }
    RETURN DISTINCT o.label
  } AS foods
ORDER BY units DESC, motion
