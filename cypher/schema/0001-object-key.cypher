// An object node is known by the hash of its content.
// mode: write
CREATE CONSTRAINT object_key IF NOT EXISTS FOR (o:Object) REQUIRE o.key IS UNIQUE
