// Takes the named videos themselves away.
// param: names LIST<STRING>
// mode: write
UNWIND $names AS name
MATCH (v:Video {name: name})
DELETE v
