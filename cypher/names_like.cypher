// Some of the names that a text may become: foods (and whether each is seen in the asked state), objects, goal nodes,
// each with a word that begins so; of foods also those that are compared by a name that begins so. Names that begin so
// themselves come first.
// param: text STRING
// param: folded STRING
// param: state STRING
// param: most INTEGER
// column: foods
// column: objects
// column: goals
// mode: read
// scans: utensils are few, and have no index of words
CALL () {
  CALL () {
    MATCH (i:Ingredient)
    WHERE i.name STARTS WITH $text AND EXISTS { (i)-[:SEEN_AS]->() }
    RETURN i
    LIMIT $most
    UNION
    MATCH (i:Ingredient)
    WHERE i.canonical STARTS WITH $folded AND EXISTS { (i)-[:SEEN_AS]->() }
    RETURN i
    LIMIT $most
    UNION
    MATCH (i:Ingredient)
    USING TEXT INDEX i:Ingredient(singular)
    WHERE i.singular CONTAINS ' ' + $text AND EXISTS { (i)-[:SEEN_AS]->() }
    RETURN i
    LIMIT $most
  }
  RETURN collect([i.name, EXISTS { (i)-[:SEEN_AS]->(:State {name: $state}) }]) AS foods
}
CALL () {
  MATCH (l:Label)
  WHERE l.name STARTS WITH $text
  WITH l
  LIMIT $most
  RETURN collect(l.name) AS labels
}
CALL () {
  MATCH (u:Utensil)
  WHERE u.name CONTAINS ' ' + $text
  RETURN collect(u.name) AS utensils
}
RETURN foods, labels + utensils AS objects, COLLECT {
  UNWIND labels + [food IN foods | food[0]] AS name
  MATCH (l:Label {name: name})
  WHERE EXISTS { (l)<-[:CALLED]-(:Object)-[:IS_A]->() }
  RETURN DISTINCT l.name
} AS goals
