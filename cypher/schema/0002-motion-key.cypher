// A motion node, and with it its functional unit, is known by the hash of the unit.
// mode: write
CREATE CONSTRAINT motion_key IF NOT EXISTS FOR (m:Motion) REQUIRE m.key IS UNIQUE
