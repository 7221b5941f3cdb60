// Waits until no other writer is at work, by holding the record of the FOON until the transaction ends; says what it says.
// What the transaction writes is a new edition of the FOON.
// column: version
// column: kitchen
// column: words
// column: edition
// column: methods
// mode: write
MATCH (f:Foon {name: 'foon-kg'})
SET f.writes = f.writes + 1, f.edition = randomUUID()
RETURN f.version AS version, f.kitchen AS kitchen, f.words AS words, f.edition AS edition, f.methods AS methods
