"""What videos teach of making dishes: operators with their evidence, and frames derived from goals."""
