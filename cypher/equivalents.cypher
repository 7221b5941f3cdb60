// The foods that may stand for each asked one: those of an equal name, and the nearest of the vector index with their
// cosines. The index also holds what is only ever an ingredient of a dish; that is told apart. No row where the points
// were made of other word lists.
// param: words STRING
// param: asked LIST<MAP>
// param: count INTEGER
// column: name
// column: equal
// column: nearest
// mode: read
MATCH (record:Foon {name: 'foon-kg', words: $words})
UNWIND $asked AS asked
CALL (asked) {
  CALL db.index.vector.queryNodes('ingredient_vector', $count, asked.point) YIELD node, score
  RETURN collect([node.name, EXISTS { (node)-[:SEEN_AS]->() }, 2 * score - 1]) AS nearest
}
RETURN asked.name AS name, COLLECT {
  MATCH (i:Ingredient {canonical: asked.canonical})
  WHERE EXISTS { (i)-[:SEEN_AS]->() }
  RETURN i.name
} AS equal, nearest
