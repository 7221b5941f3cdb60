"""Algorithm 4: the final tree, built of operators and frames in a world that refuses what cannot happen."""
