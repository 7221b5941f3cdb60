"""A small FOON of one salad and one soup, plan results that are their videos, and ways to spoil them in one place."""

from __future__ import annotations

from dataclasses import replace

from kitchen_stories import unit

from foon_kg.model import Annotation, Subgraph
from foon_kg.model.node_json import node_to_json

SALAD = (
    "cutting board(empty); tomato(whole) > pick-and-place > cutting board{tomato}; tomato(whole)@on cutting_board",
    (
        "cutting board{tomato}; tomato(whole)@on cutting_board; knife > chop"
        " > cutting board{tomato}; tomato(chopped)@on cutting_board; knife"
    ),
    (
        "cutting board{tomato}; tomato(chopped)@on cutting_board; bowl(empty) > pour"
        " > bowl{tomato}; tomato(chopped)@bowl; cutting board(empty)"
    ),
    (
        "shaker{salt}; salt(granulated)@shaker; bowl{tomato} > sprinkle"
        " > shaker{salt}; salt(granulated)@bowl; bowl{salt,tomato}"
    ),
    (
        "bowl{salt,tomato}; tomato(chopped)@bowl; salt(granulated)@bowl; spoon(clean) > mix"
        " > tomato salad(mixed){salt,tomato}@bowl; bowl{tomato salad}; spoon"
    ),
)
SOUP = (
    "cutting board(empty); carrot(whole) > pick-and-place > cutting board{carrot}; carrot(whole)@on cutting_board",
    (
        "cutting board{carrot}; carrot(whole)@on cutting_board; peeler > peel"
        " > cutting board{carrot}; carrot(peeled)@on cutting_board; peeler"
    ),
    (
        "cutting board{carrot}; carrot(peeled)@on cutting_board; knife > slice"
        " > cutting board{carrot}; carrot(sliced)@on cutting_board; knife"
    ),
    "pot(empty); stove(off) > pick-and-place > pot(empty)@on stove; stove(off)",
    ("water(liquid)@faucet; pot(empty)@on stove > pour > water(liquid)@pot; pot{water}@on stove"),
    (
        "cutting board{carrot}; carrot(sliced)@on cutting_board; pot{water}@on stove > pour"
        " > carrot(sliced)@pot; pot{carrot,water}@on stove; cutting board(empty)"
    ),
    "stove(off) > turn on > stove(on)",
    (
        "pot{carrot,water}@on stove; carrot(sliced)@pot; water(liquid)@pot; stove(on) > boil"
        " > carrot soup(cooked){carrot,water}@pot; pot{carrot soup}@on stove; stove(on)"
    ),
    "stove(on) > turn off > stove(off)",
)


def video(name, dish_type, lines):
    """A video with one dish, which its last output with ingredients is."""
    units = [unit(line) for line in lines]
    (place, dish) = [(place, p) for place, one in enumerate(units) for p in one.outputs if _is_mixture(p.node)][-1]
    marked = [replace(p, dish_type=dish_type) if p == dish else p for p in units[place].outputs]
    units[place] = replace(units[place], outputs=tuple(marked))
    return Subgraph(name, tuple(map(Annotation, units)))


def _is_mixture(thing):
    return bool(thing.states and thing.ingredients)


SUBGRAPHS = (video("tomato_salad", "salad", SALAD), video("carrot_soup", "soup", SOUP))


def plan(name, lines, *asked, title=None):
    """A plan result: the video ``name`` as it stands, for a recipe that asks for ``asked`` (food and state)."""
    seen = next(one for one in SUBGRAPHS if one.name == name)
    (dish,) = [p for annotation in seen.annotations for p in annotation.unit.outputs if p.dish_type]
    recorded = [annotation.unit for annotation in seen.annotations]
    units = [_step(unit(line), name, recorded) for line in lines]
    ingredients = [dict(zip(("object", "state"), food.rsplit(" ", 1), strict=True)) for food in asked]
    return {
        "recipe": {"id": "r1", "title": title, "dish_type": dish.dish_type, "ingredients": ingredients},
        "reference": {"goal": node_to_json(dish.node), "units": len(units), "overlap": len(asked), "exact": True},
        "goal": node_to_json(dish.node),
        "units": units,
        "kitchen": leaves(units),
        "substitutions": [],
        "assumptions": [],
        "progress_lines": [],
    }


def salad(lines=SALAD):
    """A plan of the tomato salad."""
    return plan("tomato_salad", lines, "tomato chopped", "salt granulated")


def soup(lines=SOUP):
    """A plan of the carrot soup."""
    return plan("carrot_soup", lines, "carrot sliced")


def without(lines, place):
    """``lines`` without the one at ``place``."""
    return (*lines[:place], *lines[place + 1 :])


def leaves(units):
    """The kitchen of some units: what they take before anything has made it."""
    there, found = [], []
    for one in units:
        found += [n for n in one["input_nodes"] if n not in there and n not in found]
        there += one["output_nodes"]
    return found


def _step(made, name, recorded):
    """A step of a plan result, seen where the video makes the same; else in its first unit with that motion."""
    likely = sorted(range(len(recorded)), key=lambda place: recorded[place].output_nodes != made.output_nodes)
    place = next(place for place in likely if recorded[place].motion == made.motion)
    return {
        "input_nodes": [node_to_json(n) for n in made.input_nodes],
        "motion_node": made.motion,
        "output_nodes": [node_to_json(n) for n in made.output_nodes],
        "origin": "foon",
        "grounding": "food",
        "seen_in": [{"video": name, "unit": place, "source": None, "start": None, "end": None}],
    }
