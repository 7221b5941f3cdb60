// A type of stages, at which foods join dishes, is known by its name.
// mode: write
CREATE CONSTRAINT stage_type_name IF NOT EXISTS FOR (t:StageType) REQUIRE t.name IS UNIQUE
