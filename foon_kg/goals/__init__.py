"""Algorithm 1: which recorded dish a recipe is made like."""
