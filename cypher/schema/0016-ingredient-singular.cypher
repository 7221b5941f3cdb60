// Foods are found by the words in their names, each in the singular.
// mode: write
CREATE TEXT INDEX ingredient_singular IF NOT EXISTS FOR (i:Ingredient) ON (i.singular)
