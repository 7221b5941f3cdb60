"""The command line: ``foon``."""
