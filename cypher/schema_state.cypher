// Which schema, kitchen and word lists the graph was written with, and which edition of the FOON it
// is; no row for a database without a FOON.
// column: version
// column: kitchen
// column: words
// column: edition
// column: methods
// mode: read
MATCH (f:Foon {name: 'foon-kg'})
RETURN f.version AS version, f.kitchen AS kitchen, f.words AS words, f.edition AS edition, f.methods AS methods
