"""Steps in the notation of docs/contract.md of which several tests put trees together."""

from __future__ import annotations

ONION = "onion (whole) + cutting board (empty) + knife → SLICE → onion (sliced; on cutting board)\n"
IN_BOWL = (
    "tomato (sliced; on plate) + plate ({tomato}) + bowl (empty) → POUR → tomato (sliced; in bowl) + bowl ({tomato})\n"
)
ON_STOVE = "pan (empty) + stove (off) → PICK-AND-PLACE → pan (empty; on stove) + stove (off; under pan)\n"


def lines(*steps):
    return "\n".join(step.strip() for step in steps if step)


def recipe(dish, asked, title=""):
    return f"dish: {dish}\nasked: {asked}\n" + (f"title: {title}\n" if title else "")


def served(label, *foods, states=""):
    """One step that makes a dish of some foods on a plate."""
    inputs = " + ".join(f"{food} (liquid; in bottle)" if food in {"milk", "water"} else food for food in foods)
    holds = "{" + ", ".join(sorted(foods)) + "}"
    said = f"{states}; " if states else ""
    return f"{inputs} + plate (empty) + spoon → MIX → {label} ({said}{holds}; on plate) + plate ({{{label}}})"


def heated(label, *foods, motion="BOIL", states="cooked"):
    """Steps that make a dish of some foods in a pot over heat."""
    holds = "{" + ", ".join(sorted(foods)) + "}"
    inputs = " + ".join(f"{food} (whole)" for food in foods)
    outputs = " + ".join(f"{food} (whole; in pot)" for food in foods)
    return f"""
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
{inputs} + pot (empty; on stove) → PUT → {outputs} + pot ({holds}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
{outputs} + pot ({holds}; on stove) + stove (on; under pot) → {motion}
  → {label} ({states}; {holds}; in pot) + pot (hot; {{{label}}}; on stove)
"""


def boiled(food, state="whole", liquid="water", motion="BOIL", ends="cooked"):
    """Steps that put a food into a pot with a liquid, and one that works on it over heat."""
    filled = f"{liquid} (liquid; in pot) + pot ({{{liquid}}}; on stove)" if liquid else "pot (empty; on stove)"
    holds = f"{food}, {liquid}" if liquid else food
    fill = f"{liquid} (liquid; in bottle) + pot (empty; on stove) → POUR → {filled}" if liquid else ""
    return f"""
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
{fill}
{food} ({state}) + {filled.rpartition(" + ")[2]} → PUT → {food} ({state}; in pot) + pot ({{{holds}}}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
{food} ({state}; in pot) + pot ({{{holds}}}; on stove) + stove (on; under pot) → {motion}
  → {food} ({ends}; in pot) + pot ({{{holds}}}; on stove)
"""
