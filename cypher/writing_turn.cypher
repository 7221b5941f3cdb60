// Waits until no other writer is at work, by holding the schema record until the transaction ends; says what it says.
// column: version
// column: kitchen
// mode: write
MATCH (s:Schema {name: 'foon-kg'})
SET s.loads = s.loads + 1
RETURN s.version AS version, s.kitchen AS kitchen
