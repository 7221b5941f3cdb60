// Those of the asked labels that the graph has.
// param: names LIST<STRING>
// column: name
// mode: read
UNWIND $names AS name
MATCH (l:Label {name: name})
RETURN l.name AS name
