// A draft is kept once.
// mode: write
CREATE CONSTRAINT draft_name IF NOT EXISTS FOR (d:Draft) REQUIRE d.name IS UNIQUE
