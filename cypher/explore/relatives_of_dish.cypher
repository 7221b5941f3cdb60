// Which other videos share most units with this one: a dish's nearest relatives by what is done, not by name.
// param: video STRING
// param: most INTEGER
// example: video=greek_salad
// default: most=10
// column: relative
// column: shared
// column: units
// mode: read
MATCH (:Video {name: $video})<-[:SEEN_IN]-(m:Motion)-[:SEEN_IN]->(other:Video)
WHERE other.name <> $video
WITH other, count(DISTINCT m) AS shared
RETURN other.name AS relative, shared, COUNT { MATCH (other)<-[:SEEN_IN]-(u:Motion) RETURN DISTINCT u } AS units
ORDER BY shared DESC, relative
LIMIT $most
