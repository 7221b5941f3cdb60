// A post, at which foods join dishes, is known by its name.
// mode: write
CREATE CONSTRAINT post_name IF NOT EXISTS FOR (p:Post) REQUIRE p.name IS UNIQUE
