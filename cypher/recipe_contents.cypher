// The content hashes of those of the asked recipes that the graph has.
// param: ids LIST<STRING>
// column: id
// column: content
// mode: read
UNWIND $ids AS id
MATCH (r:Recipe {id: id})
RETURN r.id AS id, r.content AS content
