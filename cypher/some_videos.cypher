// The names of some videos, those that are found first.
// param: most INTEGER
// column: name
// mode: read
// scans: it stops at the number that is asked
MATCH (v:Video)
RETURN v.name AS name
LIMIT $most
