// The foods of the FOON, and those that operators are done to, that have no point in their index yet; what only recipes
// call for gets none, or the nearest of a food would be foods that nobody has seen.
// column: name
// mode: read
// scans: foods are few beside units, and after a load most of them have none
MATCH (i:Ingredient)
WHERE i.singular IS NULL AND (EXISTS { (i)-[:SEEN_AS]->() } OR EXISTS { (i)<-[:MADE_OF]-() })
RETURN i.name AS name
UNION
MATCH (m:Food)
WHERE m.canonical IS NULL
RETURN m.name AS name
