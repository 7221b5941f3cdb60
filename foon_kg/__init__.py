"""foon-kg: task trees for cooking, planned from a functional object-oriented network in Neo4j."""

__version__ = "0.1.0"
