// Which schema and which kitchen the graph was written with; no row for a database without a FOON.
// column: version
// column: kitchen
// mode: read
MATCH (s:Schema {name: 'foon-kg'})
RETURN s.version AS version, s.kitchen AS kitchen
