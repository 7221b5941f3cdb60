"""A small FOON, a sound and sensible tree from it, and ways to spoil the tree in one place."""

from __future__ import annotations

import copy

from kitchen_stories import node, subgraph
from kitchen_stories import unit as functional_unit

from foon_kg.form import KnownFoon, TaskTree, check
from foon_kg.kitchen import Kitchen
from foon_kg.model_json import node_to_json
from foon_kg.snapshot import Snapshot

GARDEN = (
    "cutting board(empty); tomato(whole) > pick-and-place > cutting board{tomato}; tomato(whole)@on cutting_board",
    "tomato(whole)@on cutting_board; knife > chop > tomato(chopped)@on cutting_board; knife",
    (
        "cutting board{tomato}; tomato(chopped)@on cutting_board; salad bowl(empty) > pour > "
        "salad bowl{tomato}; tomato(chopped)@in salad_bowl; cutting board(empty)"
    ),
    (
        "bottle{olive oil}; olive oil(liquid)@in bottle; salad bowl{tomato} > pour > "
        "bottle{olive oil}; olive oil(liquid)@in salad_bowl; salad bowl{olive oil,tomato}"
    ),
    (
        "shaker{salt}; salt(granulated)@in shaker; salad bowl{olive oil,tomato} > sprinkle > "
        "shaker{salt}; salt(granulated)@in salad_bowl; salad bowl{olive oil,salt,tomato}"
    ),
    (
        "salad bowl{olive oil,salt,tomato}; tomato(chopped)@in salad_bowl; olive oil(liquid)@in salad_bowl; "
        "salt(granulated)@in salad_bowl; spoon > mix > "
        "garden salad(mixed){olive oil,salt,tomato}@in salad_bowl; salad bowl{garden salad}; spoon"
    ),
)
RADISH = (
    "cutting board(empty); radish(whole) > pick-and-place > cutting board{radish}; radish(whole)@on cutting_board",
    "radish(whole)@on cutting_board; knife > dice > radish(diced)@on cutting_board; knife",
    "radish(diced)@on cutting_board; knife > mince > radish(minced)@on cutting_board; knife",
    "radish(minced)@on cutting_board; plate(empty) > pick-and-place > radish plate{radish}@on plate",
)
STALE = (*GARDEN[:5], GARDEN[5].replace("spoon > mix", "salad bowl{tomato}; spoon > mix"))
GARNISHED = (
    *GARDEN[:4],
    (
        "salad bowl{olive oil,tomato}; tomato(chopped)@in salad_bowl; olive oil(liquid)@in salad_bowl; spoon > mix > "
        "garden salad(mixed){olive oil,tomato}@in salad_bowl; salad bowl{garden salad}; spoon"
    ),
    (
        "feta(cube); garden salad(mixed){olive oil,tomato}@in salad_bowl > sprinkle > "
        "garden salad(mixed){feta,olive oil,tomato}@in salad_bowl"
    ),
)
IDLE = ("spoon > polish > spoon", "fork > polish > fork(clean)")
FLUFFY = (
    "stove(off) > turn on > stove(on)",
    "stove(on); cooking pan(empty) > heat > cooking pan(hot)@on stove; stove(on)",
    "egg(whole); bowl(empty) > crack > egg(cracked)@in bowl; bowl{egg}",
    "egg(cracked)@in bowl; bowl{egg}; whisk > beat > egg(beaten)@in bowl; bowl{egg}; whisk",
    (
        "bowl{egg}; egg(beaten)@in bowl; cooking pan(hot)@on stove > pour > "
        "cooking pan(hot){egg}@on stove; egg(beaten)@in cooking_pan; bowl(empty)"
    ),
    (
        "pepper mill{black pepper}; black pepper(peppercorn)@in pepper_mill > grind > pepper mill{black pepper}; "
        "black pepper(ground)@in cooking_pan"
    ),
    (
        "cooking pan(hot){egg}@on stove; egg(beaten)@in cooking_pan; black pepper(ground)@in cooking_pan; "
        "stove(on) > cook > fluffy omelette(cooked){black pepper,egg}@in cooking_pan; stove(on); "
        "cooking pan(hot){fluffy omelette}@on stove"
    ),
)
OMELETTES = {
    "omelette": FLUFFY,
    "potato_omelette": tuple(line.replace("fluffy", "potato") for line in FLUFFY),
    "forgetful_omelette": tuple(line.replace("(cooked){black pepper,egg}", "(cooked){egg}") for line in FLUFFY),
}
POTATO = (
    "potato(whole); knife > slice > potato(sliced); knife",
    "potato(sliced); plate(empty) > pick-and-place > potato plate{potato}@on plate",
)

SUBGRAPHS = (
    subgraph("garden", "salad", *GARDEN),
    subgraph("stale", "salad", *STALE),
    subgraph("garnished", "salad", *GARNISHED),
    subgraph("idle", "salad", *IDLE),
    subgraph("radish", "vegetables", *RADISH),
    *(subgraph(name, "omelette", *lines) for name, lines in OMELETTES.items()),
    subgraph("potato", "vegetables", *POTATO),
)
SNAPSHOT = Snapshot.of(SUBGRAPHS, Kitchen.default())
FOON = KnownFoon.of(SNAPSHOT.units, SNAPSHOT.goals())


def judge(tree, foon=FOON):
    return check(TaskTree.from_json(tree), foon)


def broken(tree, foon=FOON):
    """The rules that a tree breaks, in their order."""
    return judge(tree, foon).broken


def unit(text, video, place, origin="reference"):
    """A unit of a plan result, written as the units of the FOON are."""
    made = functional_unit(text)
    return {
        "input_nodes": [node_to_json(n) for n in made.input_nodes],
        "motion_node": made.motion,
        "output_nodes": [node_to_json(n) for n in made.output_nodes],
        "origin": origin,
        "seen_in": [{"video": video, "unit": place, "source": None, "start": None, "end": None}],
    }


def nodes(*texts):
    return [node_to_json(node(text)) for text in texts]


def entry(kind, food, required, equivalent, *, confidence=0.8, alternatives=("zucchini",)):
    return {
        "kind": kind,
        "object": food,
        "required": required,
        "equivalent": equivalent,
        "confidence": confidence,
        "alternatives": [{"name": name, "confidence": 0.6} for name in alternatives],
    }


def recipe(dish_type, *wanted):
    pairs = (text.rsplit(" ", 1) for text in wanted)
    return {
        "id": "r1",
        "title": None,
        "dish_type": dish_type,
        "ingredients": [{"object": food, "state": state} for food, state in pairs],
    }


def with_kitchen(tree, *units):
    """The tree with other units, from whatever kitchen they need."""
    return tree | {"units": list(units), "kitchen": leaves(units)}


def leaves(units):
    """The kitchen of some units: what they take before anything has made it."""
    there, found = [], []
    for one in units:
        found += [n for n in one["input_nodes"] if n not in there and n not in found]
        there += one["output_nodes"]
    return found


def salad():
    """Tomato and oil as the video has them, its salt left out, and a cucumber prepared as another video's radish."""
    units = [unit(text, "garden", place) for place, text in enumerate(GARDEN[:4])]
    units += [
        unit(RADISH[0].replace("radish", "cucumber"), "radish", 0, "substituted"),
        unit(
            "cucumber(whole)@on cutting_board; knife > slice > cucumber(sliced)@on cutting_board; knife",
            "radish", 1, "substituted",
        ),
        unit(
            "salad bowl{olive oil,tomato}; tomato(chopped)@in salad_bowl; olive oil(liquid)@in salad_bowl; spoon; "
            "cucumber(sliced)@on cutting_board > mix > "
            "garden salad(mixed){cucumber,olive oil,tomato}@in salad_bowl; salad bowl{garden salad}; spoon",
            "garden", 5,
        ),
    ]  # fmt: skip
    return {
        "recipe": recipe("salad", "tomato chopped", "olive oil liquid", "cucumber sliced"),
        "reference": {
            "goal": node_to_json(node("garden salad(mixed){olive oil,salt,tomato}@in salad_bowl")),
            "units": 6, "overlap": 2, "exact": True,
        },
        "goal": node_to_json(node("garden salad(mixed){cucumber,olive oil,tomato}@in salad_bowl")),
        "units": units,
        "kitchen": leaves(units),
        "substitutions": [
            entry("object", "cucumber", "cucumber", "radish"),
            entry("state", "cucumber", "sliced", "diced"),
            entry("motion", "cucumber", "slice", "dice"),
        ],
        "assumptions": [],
        "progress_lines": [],
    }  # fmt: skip


def as_seen(video, lines, goal, asked):
    """A tree that is a video as it stands."""
    units = [unit(text, video, place) for place, text in enumerate(lines)]
    made = node_to_json(node(goal))
    return {
        "recipe": asked,
        "reference": {"goal": made, "units": len(units), "overlap": len(asked["ingredients"]), "exact": True},
        "goal": copy.deepcopy(made),
        "units": units,
        "kitchen": leaves(units),
        "substitutions": [],
        "assumptions": [],
        "progress_lines": [],
    }


def omelette(video="omelette"):
    goal = OMELETTES[video][-1].split(" > ")[2].split(";")[0]
    return as_seen(video, OMELETTES[video], goal, recipe("omelette", "egg beaten", "black pepper ground"))


def garden(lines=GARDEN, video="garden"):
    goal = "garden salad(mixed){olive oil,salt,tomato}@in salad_bowl"
    asked = recipe("salad", "tomato chopped", "olive oil liquid", "salt granulated")
    return as_seen(video, lines, goal, asked)


def garnished():
    goal = "garden salad(mixed){feta,olive oil,tomato}@in salad_bowl"
    asked = recipe("salad", "tomato chopped", "olive oil liquid", "feta cube")
    return as_seen("garnished", GARNISHED, goal, asked)
