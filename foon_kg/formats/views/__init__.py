"""Results for people: as text in a terminal."""
