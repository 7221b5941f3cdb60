"""The thin layer between the model and Neo4j."""
