"""Lines and instructions of recipes, and drafts of subgraphs made of them."""
