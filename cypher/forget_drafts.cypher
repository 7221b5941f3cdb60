// Takes the named drafts away.
// param: names LIST<STRING>
// column: key
// mode: write
UNWIND $names AS name
MATCH (d:Draft {name: name})
DELETE d
RETURN name AS key
