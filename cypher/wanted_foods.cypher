// The foods that no unit of the FOON has, by how many recipes call for them: what to annotate next. The counts are kept, and
// in an index, from which only so many are read as are told.
// param: most INTEGER
// column: food
// column: recipes
// column: states
// mode: read
MATCH (i:Ingredient)
USING INDEX SEEK i:Ingredient(recipes)
WHERE i.recipes > 0 AND NOT EXISTS { (i)-[:SEEN_AS]->() }
WITH i
ORDER BY i.recipes DESC, i.name
LIMIT $most
RETURN i.name AS food, i.recipes AS recipes, COLLECT {
  MATCH (i)-[asked:ASKED_AS]->(s:State)
  RETURN s.name ORDER BY asked.count DESC, s.name LIMIT 3
} AS states
ORDER BY recipes DESC, food
