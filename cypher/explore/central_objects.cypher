// The things that take part in the most units, foods and utensils alike: what a robot has to know first.
// param: most INTEGER
// default: most=15
// column: object
// column: kind
// column: units
// column: nodes
// mode: read
// scans: the most of all cannot be known without a look at all
MATCH (l:Label)<-[:CALLED]-(o:Object)-[:INPUT_OF|OUTPUTS]-(m:Motion)
WITH l, count(DISTINCT m) AS units, count(DISTINCT o) AS nodes
RETURN l.name AS object,
  CASE WHEN EXISTS { MATCH (:Ingredient {name: l.name})-[:SEEN_AS]->() } THEN 'food' ELSE 'utensil' END AS kind,
  units, nodes
ORDER BY units DESC, object
LIMIT $most
