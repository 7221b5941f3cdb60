"""A FOON of one tomato salad, for the tests of form."""

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
