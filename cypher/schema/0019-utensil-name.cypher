// What operators work in, on or with is known by its name.
// mode: write
CREATE CONSTRAINT utensil_name IF NOT EXISTS FOR (u:Utensil) REQUIRE u.name IS UNIQUE
