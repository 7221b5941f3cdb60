// Records the schema that was applied, and the kitchen with which the graph is written.
// param: version INTEGER
// param: kitchen STRING
// mode: write
MERGE (s:Schema {name: 'foon-kg'})
  ON CREATE SET s.loads = 0
SET s.version = $version, s.kitchen = $kitchen
