// Foods of equal names are found by the name that names are compared by.
// mode: write
CREATE INDEX ingredient_canonical IF NOT EXISTS FOR (i:Ingredient) ON (i.canonical)
