// What operators are done to is known by its name: a food, a kind of food, a form, or anything.
// mode: write
CREATE CONSTRAINT matter_name IF NOT EXISTS FOR (m:Matter) REQUIRE m.name IS UNIQUE
