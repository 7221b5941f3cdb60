// Waits until no other writer is at work, by holding the record of the FOON until the transaction ends; says how many recipes
// are counted, null where those that are there never were.
// column: recipes
// mode: write
MATCH (f:Foon {name: 'foon-kg'})
SET f.writes = f.writes + 1
RETURN f.recipes AS recipes
