// A frame is known by the hash of its video, its goal and its dish type.
// mode: write
CREATE CONSTRAINT frame_key IF NOT EXISTS FOR (f:Frame) REQUIRE f.key IS UNIQUE
