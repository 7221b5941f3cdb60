// The content hashes of those of the named drafts that the graph has.
// param: names LIST<STRING>
// column: name
// column: content
// mode: read
UNWIND $names AS name
MATCH (d:Draft {name: name})
RETURN d.name AS name, d.content AS content
