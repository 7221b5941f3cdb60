"""A whole FOON into the local Neo4j offline: staged in tables, written as CSV, imported by ``neo4j-admin``."""
