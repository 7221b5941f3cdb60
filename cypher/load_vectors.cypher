// Gives foods their points, the names that they are compared by, and their words, each in the singular. Each food may be
// named once. The record tells where a food has no point, since nothing is known of it.
// param: rows LIST<MAP>
// mode: write
CALL () {
  UNWIND $rows AS row
  MATCH (m:Matter {name: row.name})
  SET m.canonical = row.canonical, m.vector = row.vector
}
CALL () {
  UNWIND $rows AS row
  MATCH (i:Ingredient {name: row.name})
  WHERE EXISTS { (i)-[:SEEN_AS]->() } OR EXISTS { (i)<-[:MADE_OF]-() }
  SET i.canonical = row.canonical, i.singular = row.singular, i.vector = row.vector
  RETURN count(i) > count(i.vector) AS some_are_nowhere
}
WITH some_are_nowhere
WHERE some_are_nowhere
MATCH (f:Foon {name: 'foon-kg'})
SET f.all_placed = false
