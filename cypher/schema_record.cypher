// Records the schema that was applied, and the kitchen with which the graph is written.
// param: version INTEGER
// param: kitchen STRING
// mode: write
MERGE (f:Foon {name: 'foon-kg'})
  ON CREATE SET f.writes = 0
SET f.version = $version, f.kitchen = $kitchen
