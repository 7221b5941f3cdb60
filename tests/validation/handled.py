"""A small FOON, and steps that say where they were seen and what stands for what."""

from __future__ import annotations

FOON = """
name: tomatoes
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
stove (off) → TURN ON → stove (on)
salt (granulated; in shaker) + plate ({tomato}) → SPRINKLE → salt (granulated; on plate) + plate ({salt, tomato})
---
name: peppers
bell pepper (whole) + plate (empty) + peeler → DICE → bell pepper (diced; on plate) + plate ({bell pepper})
---
name: breads
bread (loaf) + plate (empty) → TEAR → bread (torn; on plate) + plate ({bread})
"""

LEEK = "object (tomato): tomato like bell pepper (0.9); nothing"


def sliced(food="tomato", motion="SLICE", tool="knife", seen="tomatoes 0", head="", **told):
    """One step with a food, seen somewhere, with what else is told of it."""
    step = f"{food} (whole) + plate (empty) + {tool} → {motion} → {food} (sliced; on plate) + plate ({{{food}}})"
    lines = [head, step, f"seen in: {seen}" if seen else "", *(f"{key}: {value}" for key, value in told.items())]
    return "\n".join(filter(None, lines))


def entries(*told):
    return "\n".join(f"substitution: {one}" for one in told)
