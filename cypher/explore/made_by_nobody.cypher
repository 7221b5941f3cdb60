// Foods in a state that units ask for although no unit makes it and no kitchen has it: what to annotate next.
// param: most INTEGER
// default: most=15
// column: food
// column: states
// column: place
// column: wanted_by
// mode: read
// scans: what is missing is found only by a look at every node
MATCH (o:Object)-[:INPUT_OF]->(m:Motion)
WHERE o.start IS NULL
  AND NOT EXISTS { (o)<-[:OUTPUTS]-() }
  AND EXISTS { MATCH (:Ingredient {name: o.label})-[:SEEN_AS]->() }
RETURN o.label AS food, o.states AS states, coalesce(o.relation + ' ' + o.container, o.container, '') AS place,
  count(DISTINCT m) AS wanted_by
ORDER BY wanted_by DESC, food, states, place
LIMIT $most
