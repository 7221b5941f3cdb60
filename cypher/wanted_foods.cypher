// The foods that no unit of the FOON has, by how many recipes call for them: what to annotate next.
// param: most INTEGER
// column: food
// column: recipes
// column: states
// mode: read
// scans: every food that recipes name is counted
MATCH (i:Ingredient)
WHERE NOT EXISTS { (i)-[:SEEN_AS]->() }
WITH i, COUNT { MATCH (i)<-[:CALLS_FOR]-(r:Recipe) RETURN DISTINCT r } AS recipes
WHERE recipes > 0
ORDER BY recipes DESC, i.name
LIMIT $most
RETURN i.name AS food, recipes, COLLECT {
  MATCH (i)<-[c:CALLS_FOR]-(:Recipe)
  WHERE c.state <> ''
  WITH c.state AS state, count(*) AS times
  ORDER BY times DESC, state
  LIMIT 3
  RETURN state
} AS states
ORDER BY recipes DESC, food
