// A video is known by its name.
// mode: write
CREATE CONSTRAINT video_name IF NOT EXISTS FOR (v:Video) REQUIRE v.name IS UNIQUE
