// How many recipes there are, how many with a sure dish type, and how many foods they name.
// column: recipes
// column: sure
// column: foods
// mode: read
// scans: all are counted
RETURN COUNT { (:Recipe) } AS recipes,
  COUNT { MATCH (r:Recipe) WHERE EXISTS { MATCH (r)-[kind:KIND_OF]->() WHERE kind.sure } } AS sure,
  COUNT { MATCH (i:Ingredient) WHERE EXISTS { (i)<-[:CALLS_FOR]-() } } AS foods
