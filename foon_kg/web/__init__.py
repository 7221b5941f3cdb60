"""A FOON as a service: a page for people, JSON for programs (``foon serve``), tools for agents (``foon mcp``)."""
