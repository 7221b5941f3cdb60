// Of the named foods those of the FOON, and those that operators are done to, that have no point in their index yet; what only
// recipes call for gets none, or the nearest of a food would be foods that nobody has seen.
// param: names LIST<STRING>
// column: name
// mode: read
UNWIND $names AS name
MATCH (i:Ingredient {name: name})
WHERE i.singular IS NULL AND (EXISTS { (i)-[:SEEN_AS]->() } OR EXISTS { (i)<-[:MADE_OF]-() })
RETURN i.name AS name
UNION
UNWIND $names AS name
MATCH (m:Food&Matter {name: name})
WHERE m.canonical IS NULL
RETURN m.name AS name
