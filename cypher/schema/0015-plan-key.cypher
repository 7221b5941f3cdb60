// A reference tree that was retrieved before is known by the hash of its question.
// mode: write
CREATE CONSTRAINT plan_key IF NOT EXISTS FOR (p:Plan) REQUIRE p.key IS UNIQUE
