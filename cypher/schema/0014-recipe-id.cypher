// A recipe of a collection is there once, whichever file it comes from.
// mode: write
CREATE CONSTRAINT recipe_id IF NOT EXISTS FOR (r:Recipe) REQUIRE r.id IS UNIQUE
