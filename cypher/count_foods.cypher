// Adds to the counts of how often a food is made and used in a state; a pair that reaches nothing is forgotten. The record
// keeps how many foods have such a state; where nobody counted them yet, nothing is kept.
// param: rows LIST<MAP>
// mode: write
CALL () {
  UNWIND $rows AS row
  WITH DISTINCT row.label AS name
  MATCH (i:Ingredient {name: name})
  WHERE EXISTS { (i)-[:SEEN_AS]->() }
  RETURN count(i) AS before
}
CALL () {
  UNWIND $rows AS row
  MERGE (i:Ingredient {name: row.label})
  MERGE (s:State {name: row.state})
  MERGE (i)-[seen:SEEN_AS]->(s)
  SET seen.made = coalesce(seen.made, 0) + row.made, seen.used = coalesce(seen.used, 0) + row.used
  WITH seen
  WHERE seen.made = 0 AND seen.used = 0
  DELETE seen
}
CALL () {
  UNWIND $rows AS row
  WITH DISTINCT row.label AS name
  MATCH (i:Ingredient {name: name})
  WHERE EXISTS { (i)-[:SEEN_AS]->() }
  RETURN count(i) AS after
}
MATCH (f:Foon {name: 'foon-kg'})
WHERE f.foods IS NOT NULL
SET f.foods = f.foods + after - before
