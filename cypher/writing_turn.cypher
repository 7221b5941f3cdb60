// Waits until no other writer is at work, by holding the record of the FOON until the transaction ends; says what it says.
// column: version
// column: kitchen
// column: words
// mode: write
MATCH (f:Foon {name: 'foon-kg'})
SET f.writes = f.writes + 1
RETURN f.version AS version, f.kitchen AS kitchen, f.words AS words
