// A state is known by its name; the empty name stands for having none.
// mode: write
CREATE CONSTRAINT state_name IF NOT EXISTS FOR (s:State) REQUIRE s.name IS UNIQUE
