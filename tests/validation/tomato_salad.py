"""A FOON of one tomato salad, and trees of one step, for the tests of form."""

from __future__ import annotations

from validation.judging import ONE_TOMATO

SALTED = """
salt (granulated; in shaker) + tomato (sliced; on plate) + plate ({tomato}) → SPRINKLE
  → tomato salad ({salt, tomato}; on plate) + plate ({tomato salad})
"""
FOON = f"""
name: tomato_salad
dish: salad
goal: tomato salad ({{salt, tomato}}; on plate)
{ONE_TOMATO}{SALTED}"""


def asked(foods, rest=ONE_TOMATO):
    """Return a salad for which ``foods`` were asked, made by the steps of ``rest``."""
    return f"dish: salad\nasked: {foods}\n{rest}"


def taken(leaf, head=""):
    """Return a tree that takes one thing from the kitchen and puts it on the table."""
    return f"{head}{leaf} → PUT → {leaf.split(' (', maxsplit=1)[0]} (on table)"
