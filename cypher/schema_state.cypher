// Which schema and which kitchen the graph was written with; no row for a database without a FOON.
// column: version
// column: kitchen
// mode: read
MATCH (f:Foon {name: 'foon-kg'})
RETURN f.version AS version, f.kitchen AS kitchen
