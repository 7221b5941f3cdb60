// The foods of the FOON that have no point in the index yet; what only recipes call for gets none, or the nearest of a food
// would be foods that nobody has seen.
// column: name
// mode: read
// scans: foods are few beside units, and after a load most of them have none
MATCH (i:Ingredient)
WHERE i.singular IS NULL AND (EXISTS { (i)-[:SEEN_AS]->() } OR EXISTS { (i)<-[:MADE_OF]-() })
RETURN i.name AS name
