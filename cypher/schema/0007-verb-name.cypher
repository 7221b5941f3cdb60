// The verb of a motion is known by its name.
// mode: write
CREATE CONSTRAINT verb_name IF NOT EXISTS FOR (v:Verb) REQUIRE v.name IS UNIQUE
