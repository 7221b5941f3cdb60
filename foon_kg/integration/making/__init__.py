"""Carrying a dish out on the bench: what is brought where, in which vessel, how it is worked on and served."""
