"""A real local Neo4j without Docker or a system Java."""
