// A dish type is known by its name.
// mode: write
CREATE CONSTRAINT dish_type_name IF NOT EXISTS FOR (d:DishType) REQUIRE d.name IS UNIQUE
