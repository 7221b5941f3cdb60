// What of the operators matters to who asks for some foods: those done to a food of an equal name, to the foods that are
// near enough in the vector index, and to the kinds of food. For each asked food the names found, how many points were
// looked at, and the cosine of the furthest; for each food and kind that is not known already what operators do to it,
// from where they bring it, and its states. No row where the points were made of other word lists.
// param: words STRING
// param: asked LIST<MAP>
// param: kinds LIST<STRING>
// param: known LIST<STRING>
// param: count INTEGER
// column: near
// column: matters
// mode: read
MATCH (record:Foon {name: 'foon-kg', words: $words})
CALL () {
  UNWIND $asked AS asked
  CALL (asked) {
    CALL db.index.vector.queryNodes('food_vector', $count, asked.point) YIELD node, score
    WITH node, 2 * score - 1 AS cosine
    RETURN count(node) AS size, min(cosine) AS furthest, collect(CASE WHEN cosine >= asked.least THEN node END) AS close
  }
  WITH asked, size, furthest, close, COLLECT {
    MATCH (m:Food {canonical: asked.canonical})
    RETURN m
  } AS equal
  RETURN collect({name: asked.name, size: size, furthest: furthest, foods: close + equal}) AS near
}
CALL (near) {
  CALL (near) {
    UNWIND near AS row
    UNWIND row.foods AS m
    RETURN m
    UNION
    UNWIND $kinds AS name
    MATCH (m:Matter {name: name})
    RETURN m
  }
  WITH m
  WHERE NOT m.name IN $known
  RETURN collect(m) AS found
}
RETURN
  [row IN near | [row.name, row.size, row.furthest, [m IN row.foods | m.name]]] AS near,
  [m IN found | [
    m.name,
    [(m)<-[d:DONE_TO]-(o) | [id(o), [d.units, d.changed, d.seen, d.changes]]],
    [(m)<-[r:BRINGS]-(o) | [id(o), r.out_of, r.count]],
    [(m)-[:FOUND_AS]->(s) | s.name]
  ]] AS matters
