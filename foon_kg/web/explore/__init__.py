"""Wandering through a FOON: what stands next to what, by which way a food becomes what, questions in Cypher."""
