// Takes all points away, and records of which word lists the next ones are made.
// param: words STRING
// mode: write
// scans: all points are made anew
MATCH (f:Foon {name: 'foon-kg'})
SET f.words = $words, f.all_placed = true
WITH f
CALL () {
  MATCH (i:Ingredient)
  REMOVE i.canonical, i.singular, i.vector
}
CALL () {
  MATCH (m:Food)
  REMOVE m.canonical, m.vector
}
