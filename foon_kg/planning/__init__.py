"""Planning one recipe and many."""
