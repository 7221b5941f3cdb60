// What step 20 made in a new graph, in one that has taken step 20 when that was of Post.
// mode: write
CREATE CONSTRAINT stage_type_name IF NOT EXISTS FOR (t:StageType) REQUIRE t.name IS UNIQUE
