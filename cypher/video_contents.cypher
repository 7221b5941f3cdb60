// The content hashes of those of the named videos that the graph has.
// param: names LIST<STRING>
// column: name
// column: content
// mode: read
UNWIND $names AS name
MATCH (v:Video {name: name})
RETURN v.name AS name, v.content AS content
