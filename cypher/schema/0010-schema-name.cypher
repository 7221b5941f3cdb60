// There is one record of the schema, and it cannot be doubled by two first loads at once.
// mode: write
CREATE CONSTRAINT schema_name IF NOT EXISTS FOR (s:Schema) REQUIRE s.name IS UNIQUE
