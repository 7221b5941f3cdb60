// How many recipes there are, how many with a sure dish type, how many foods they name, and whether all are counted: an
// earlier foon-kg kept no counts.
// column: recipes
// column: sure
// column: foods
// column: are_counted
// mode: read
// scans: where nothing was counted, whether there is any recipe
OPTIONAL MATCH (f:Foon {name: 'foon-kg'})
RETURN coalesce(f.recipes, 0) AS recipes, coalesce(f.sure_recipes, 0) AS sure,
  COUNT { MATCH (i:Ingredient) USING INDEX SEEK i:Ingredient(recipes) WHERE i.recipes > 0 } AS foods,
  f.recipes IS NOT NULL OR COUNT { (:Recipe) } = 0 AS are_counted
