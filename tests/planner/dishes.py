"""Random dishes for the planner: small FOONs that can be executed, and recipes of which they know only a part.

A video prepares some foods on the board (place, peel, chop or slice), brings them into a vessel in some order,
mixes or cooks them there, and marks the dish. Videos that treat a food alike share those units.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from hypothesis import strategies as st
from kitchen_stories import subgraph

from foon_kg.model import ObjectNode, Recipe, RequiredIngredient, Subgraph
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.confidences import Confidences, Neighbour, best

KITCHEN = Kitchen.default()
DISHES = {"salad": "bowl", "soup": "pot", "omelette": "frying pan"}
CUTS = {"chopped": "chop", "sliced": "slice", "diced": "dice"}
SOLD_IN = {"olive oil": ("liquid", "bottle"), "salt": ("granulated", "shaker"), "milk": ("liquid", "carton")}
FRESH = ("carrot", "egg", "onion", "potato", "tomato")
UNKNOWN = ("leek", "kohlrabi", "sesame oil", "dragon fruit")
KINDS = ({"carrot", "potato", "kohlrabi"}, {"onion", "leek"}, {"olive oil", "sesame oil"})


class LikeByKind:
    """A similarity that can be seen through: foods of one kind 0.8, all others 0.1."""

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        return np.array([[_alike(w, k) for k in known] for w in wanted]).reshape(len(wanted), len(known))

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        return best(known, self.matrix([name], known)[0], limit)

    def why(self, name: str, known: str) -> tuple[str, ...]:
        return ("of one kind",) if _alike(name, known) >= 0.8 else ()


def _alike(one: str, other: str) -> float:
    return 1.0 if one == other else 0.8 if any({one, other} <= kind for kind in KINDS) else 0.1


SETTINGS = PlanSettings(KITCHEN, LikeByKind(), time_limit=None)


@dataclass
class Cooking:
    """The lines of a video while it is made up, and what each vessel holds: nodes by food, without their place."""

    lines: list[str] = field(default_factory=list)
    inside: dict[str, dict[str, str]] = field(default_factory=dict)

    def do(self, inputs: Sequence[str], motion: str, outputs: Sequence[str]) -> None:
        self.lines.append(f"{'; '.join(inputs)} > {motion} > {'; '.join(outputs)}")

    def vessel(self, name: str) -> str:
        """The vessel as it is now: empty, or with its foods."""
        foods = ",".join(sorted(self.inside.get(name, {})))
        return f"{name}{{{foods}}}" if foods else f"{name}(empty)"

    def contents(self, vessel: str) -> list[str]:
        """The vessel and every food in it."""
        return [self.vessel(vessel), *(f"{node}@{_word(vessel)}" for node in self.inside[vessel].values())]

    def bring(self, node: str, vessel: str, motion: str, taken: Sequence[str], left: Sequence[str]) -> None:
        """Bring ``node`` into ``vessel``: ``taken`` are the inputs that held it, ``left`` what remains of them."""
        before = self.vessel(vessel)
        self.inside.setdefault(vessel, {})[node.partition("(")[0]] = node
        self.do([*taken, before], motion, [self.vessel(vessel), f"{node}@{_word(vessel)}", *left])

    def pour(self, food: str, vessel: str, motion: str) -> None:
        """Bring a food out of its bottle or shaker."""
        state, storage = SOLD_IN[food]
        self.bring(
            f"{food}({state})", vessel, motion, [f"{storage}{{{food}}}", f"{food}({state})@{_word(storage)}"], []
        )

    def prepare(self, food: str, cut: str | None, *, peeled: bool) -> str:
        """Peel and cut a food on the board; answer its state then."""
        self.do(
            ["cutting board(empty)", f"{food}(whole)"],
            "pick-and-place",
            [f"cutting board{{{food}}}", f"{food}(whole)@on cutting_board"],
        )
        state = "whole"
        for motion, after in (("peel", "peeled" if peeled else None), (CUTS.get(cut or "", ""), cut)):
            if after is not None:
                self.do([f"{food}({state})@on cutting_board", "knife"], motion, [f"{food}({after})@on cutting_board"])
                state = after
        return state

    def dress(self, foods: Sequence[str], vessel: str) -> None:
        """Whisk ``foods`` in a cup, and pour what that makes over the rest."""
        for food in foods:
            self.pour(food, "cup", "pour")
        dressing = f"dressing(mixed){{{','.join(sorted(foods))}}}"
        self.do([*self.contents("cup"), "whisk"], "whisk", ["cup{dressing}", f"{dressing}@cup"])
        self.bring(dressing, vessel, "pour", ["cup{dressing}", f"{dressing}@cup"], ["cup(empty)"])


def _word(vessel: str) -> str:
    return vessel.replace(" ", "_")


@st.composite
def videos(draw: st.DrawFn, name: str) -> Subgraph:
    """One dish of one to five foods, now and then with a dressing whisked apart."""
    dish_type = draw(st.sampled_from(sorted(DISHES)))
    vessel, cooking = DISHES[dish_type], Cooking()
    fresh = draw(st.lists(st.sampled_from(FRESH), min_size=1, max_size=3, unique=True))
    sold = draw(st.lists(st.sampled_from(tuple(SOLD_IN)), max_size=2, unique=True))
    for food in fresh:
        _bring_fresh(draw, cooking, food, vessel)
    if len(sold) > 1 and draw(st.booleans()):
        cooking.dress(sold, vessel)
    else:
        for food in sold:
            cooking.pour(food, vessel, draw(st.sampled_from(("pour", "sprinkle"))))
    _finish(draw, cooking, dish_type, {*fresh, *sold})
    return subgraph(name, dish_type, *cooking.lines)


def _bring_fresh(draw: st.DrawFn, cooking: Cooking, food: str, vessel: str) -> None:
    if not draw(st.booleans()):
        cooking.bring(f"{food}(whole)", vessel, draw(st.sampled_from(("add", "insert"))), [f"{food}(whole)"], [])
        return
    state = cooking.prepare(food, draw(st.sampled_from((None, *CUTS))), peeled=draw(st.booleans()))
    taken = [f"cutting board{{{food}}}", f"{food}({state})@on cutting_board"]
    cooking.bring(
        f"{food}({state})", vessel, draw(st.sampled_from(("pour", "scrape"))), taken, ["cutting board(empty)"]
    )


def _finish(draw: st.DrawFn, cooking: Cooking, dish_type: str, foods: set[str]) -> None:
    vessel = DISHES[dish_type]
    if draw(st.booleans()):
        cooking.do(["stove(off)"], "turn on", ["stove(on)"])
        tool, motion, state = "stove(on)", "cook", "cooked"
    else:
        tool, motion, state = "spoon", draw(st.sampled_from(("mix*", "mix", "stir"))), "mixed"
    dish = f"{dish_type}({state}){{{','.join(sorted(foods))}}}@{_word(vessel)}"
    cooking.do([*cooking.contents(vessel), tool], motion, [f"{vessel}{{{dish_type}}}", dish])


def foons(*, most: int = 3) -> st.SearchStrategy[list[Subgraph]]:
    """One to ``most`` videos."""
    return (
        st.integers(1, most).flatmap(lambda count: st.tuples(*(videos(f"video {n}") for n in range(count)))).map(list)
    )


@st.composite
def questions(draw: st.DrawFn) -> tuple[list[Subgraph], Recipe]:
    """A FOON and a recipe for it: one to five foods, some unknown to it or in states that nobody makes."""
    subgraphs = draw(foons())
    marked = {p.dish_type for s in subgraphs for p in s.annotations[-1].unit.outputs if p.dish_type}
    known = sorted({want for s in subgraphs for want in leaf_foods(s)})
    foods = draw(st.lists(st.one_of(st.sampled_from(known), wants), min_size=1, max_size=5))
    return subgraphs, Recipe(draw(st.sampled_from((*sorted(marked), "pie"))), tuple(foods), "asked")


wants = st.builds(
    RequiredIngredient,
    st.sampled_from((*FRESH, *SOLD_IN, *UNKNOWN)),
    st.sampled_from(("whole", "chopped", "sliced", "peeled", "grated", "raw", "liquid", "granulated", "boiled")),
)


def leaf_foods(dish: Subgraph, kitchen: Kitchen = KITCHEN) -> Iterator[RequiredIngredient]:
    """The foods that a video takes from the kitchen, as a recipe asks for them; free foods apart."""
    made: set[ObjectNode] = set()
    for annotation in dish.annotations:
        for node in annotation.unit.input_nodes:
            if node not in made and kitchen.is_food(node) and not kitchen.is_free(node.label):
                yield RequiredIngredient(node.label, node.states[0] if node.states else "whole")
        made.update(annotation.unit.output_nodes)
