// Waits until every index can be asked; they are made in the background, of a million units for minutes.
// mode: read
CALL db.awaitIndexes(86400)
