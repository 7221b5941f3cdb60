// What one knife less costs: each motion that is done with the utensil, in how many units, in how many videos, the first
// ten of these, and the utensils of the units that do the same without it. Where those are none, nobody has shown how
// to do without.
// param: utensil STRING
// example: utensil=knife
// column: motion
// column: units
// column: videos
// column: first
// column: otherwise
// mode: read
MATCH (:Object {label: $utensil})-[:INPUT_OF]->(m:Motion)
WITH DISTINCT m
WITH m.verb AS motion, collect(m) AS lost
CALL (lost) {  // by itself: a COLLECT would keep the list of units beside each name
  UNWIND lost AS m
  MATCH (m)-[:SEEN_IN]->(v:Video)
  WITH DISTINCT v.name AS name ORDER BY name
  WITH collect(name) AS names
  RETURN size(names) AS videos, names[..10] AS first
}
RETURN motion, size(lost) AS units, videos, first,
  COLLECT {
    MATCH (other:Motion {verb: motion})<-[:INPUT_OF]-(o:Object)
    WHERE NOT EXISTS { MATCH (other)<-[:INPUT_OF]-(:Object {label: $utensil}) }
      AND NOT EXISTS { MATCH (:Ingredient {name: o.label})-[:SEEN_AS]->() }
    RETURN DISTINCT o.label ORDER BY o.label
  } AS otherwise
ORDER BY units DESC, motion
