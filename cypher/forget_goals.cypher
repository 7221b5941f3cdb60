// Takes away what the named videos, whose sightings are still there, say about goals: a node that is no goal any more is made
// of nothing any more.
// param: names LIST<STRING>
// mode: write
UNWIND $names AS name
MATCH (:Video {name: name})<-[:SEEN_IN]-(:Motion)-[:OUTPUTS]->(o:Object)
MATCH (o)-[goal:IS_A {video: name}]->(:DishType)
WITH DISTINCT o, goal
DELETE goal
WITH DISTINCT o
WHERE NOT EXISTS { (o)-[:IS_A]->() }
MATCH (o)-[made:MADE_OF]->()
DELETE made
