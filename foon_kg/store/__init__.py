"""Where a FOON is kept: in memory, in Neo4j, and the local server."""
