// Waits until every index can be asked; they are made in the background.
// mode: read
CALL db.awaitIndexes(300)
