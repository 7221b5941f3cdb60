"""A small FOON written for this project."""
