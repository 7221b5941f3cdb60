// The foods that have no point in the index yet.
// column: name
// mode: read
// scans: foods are few beside units, and after a load most of them have none
MATCH (i:Ingredient)
WHERE i.vector IS NULL
RETURN i.name AS name
