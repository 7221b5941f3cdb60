// Records the schema that was applied, the kitchen with which the graph is written, and what its operators and frames were
// learnt with.
// param: version INTEGER
// param: kitchen STRING
// param: methods STRING
// mode: write
MERGE (f:Foon {name: 'foon-kg'})
  ON CREATE SET f.writes = 0, f.states = [], f.state_objects = [], f.foods = 0
SET f.version = $version, f.kitchen = $kitchen, f.methods = $methods
