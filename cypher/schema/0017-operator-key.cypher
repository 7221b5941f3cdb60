// An operator is known by the hash of its motion and tools.
// mode: write
CREATE CONSTRAINT operator_key IF NOT EXISTS FOR (o:Operator) REQUIRE o.key IS UNIQUE
