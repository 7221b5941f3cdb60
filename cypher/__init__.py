"""The catalogue of named Cypher queries."""
