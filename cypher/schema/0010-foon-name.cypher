// There is one record of the whole FOON, and it cannot be doubled by two first loads at once.
// mode: write
CREATE CONSTRAINT foon_name IF NOT EXISTS FOR (f:Foon) REQUIRE f.name IS UNIQUE
