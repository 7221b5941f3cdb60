// The names of all videos.
// column: name
// mode: read
// scans: all videos are asked for
MATCH (v:Video)
RETURN v.name AS name
ORDER BY name
