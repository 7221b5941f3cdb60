"""Read and write FOONs: text in both dialects, and JSON."""
