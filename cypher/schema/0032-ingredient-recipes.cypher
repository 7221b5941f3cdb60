// The foods that recipes call for are found by how many do so, and none of the others is looked at.
// mode: write
CREATE INDEX ingredient_recipes IF NOT EXISTS FOR (i:Ingredient) ON (i.recipes)
