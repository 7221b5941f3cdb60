"""How well do drafts of recipes hold together? Sentences of MUHAI's recipes are drafted and set beside their networks.

    python benchmarks/drafted_recipes.py ../shared/data/muhai ../shared/data/foon-111/TXT --half development --show
    python benchmarks/drafted_recipes.py ../shared/data/muhai ../shared/data/foon-111/TXT --half figure

Of the recipes in their sorted order the even ones (the first is number 0) are for development and may be read
(``--show``); the odd ones are for the figure alone, and nothing of them is ever printed but figures. Drafts are made
from the instructions, with the FOON of the second path, which holds none of these recipes. ``--with-ingredients`` gives
the lines of ingredients as well, as a recipe in a file has them.

A step is all that one sentence does of one class (mix, cut, bake ...), on both sides. Bringing is a step of its own
only where nothing else in its sentence is done with what was brought. Measured are:

- verbs: F of the steps of a draft against those of the network, sentence by sentence.
- edges: F of the edges between the steps that both sides have; data flow through other steps counts as one edge. Beside
  it stands reading order alone: an edge from each of these steps to the next one. "of all" asks for the edges of the
  network between all of its steps.
- main ingredient: the share of the steps of both sides that are done to the same foods: of the foods that went into
  what is worked on, at least half are the same, and of what is brought, that which is brought. A vessel is the main
  object where there is no food.
- doubted: the share of units that the judge's kitchen cannot execute and that carry no doubt, and all that it cannot.
"""

from __future__ import annotations

import argparse
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import networkx as nx
from muhai_networks import WORDS, Action, Key, Recipe, Steps, steps_of

from foon_kg.food import singular
from foon_kg.language.drafting import Draft, DraftUnit, draft
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.instructions import with_actions
from foon_kg.language.recipe_text import ingredients
from foon_kg.loaders import read_paths
from foon_kg.loaders.draft_tables import thing
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Timing
from foon_kg.model.narration import Narration, Sentence
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.world import Step as Played
from foon_kg.world import World

KITCHEN = Kitchen.default()


def drafted_steps(made: Draft) -> tuple[Steps, Counter]:
    """Return the steps of a draft, and how many of its units cannot be executed, with a doubt and without."""
    actions: list[Action] = []
    makers: dict[ObjectNode, int] = {}
    members: dict[str, set[str]] = {}
    number = 0
    world, judged = World(), Counter()
    for row in made.units:
        unit, timing = row.annotation.unit, row.annotation.timing
        number = int(timing.spans[0][0]) if timing.spans else number
        changed = [node for node in unit.input_nodes if node not in unit.output_nodes]
        worked = [node for node in changed if KITCHEN.is_food(node)]
        kind = None if timing.assumed else class_of(unit.motion)
        going = [based(node, members) for node in unit.input_nodes if KITCHEN.is_food(node)]
        if kind == "bring":
            worked = [node for node in worked if not set(node.ingredients) < added(node, unit)]
        foods = set().union(*(based(node, members) for node in worked))
        vessels = {node.label for node in unit.input_nodes if KITCHEN.is_utensil(node.label)}
        takes = [makers[node] for node in unit.input_nodes if node in makers]
        actions.append(Action(number, kind, list(dict.fromkeys(takes)), foods, vessels))
        for node in unit.output_nodes:
            utensil = KITCHEN.is_utensil(node.label)
            if (node not in unit.input_nodes or (utensil and node.ingredients)) and not (
                utensil and "empty" in node.states
            ):
                makers[node] = len(actions) - 1
            if KITCHEN.is_food(node) and node not in unit.input_nodes and node.label not in members:
                members[node.label] = set().union(*going) if node.ingredients else based(node, members)
        played = Played.of(unit.input_nodes, unit.motion, unit.output_nodes)
        faults = [one for one in world.play(played).mishaps if not one.minor]
        judged["units"] += 1
        judged["not executable"] += bool(faults)
        judged["not executable, no doubt"] += bool(faults) and not row.doubts
        if faults and not row.doubts:
            judged[f"  {faults[0].rule} {faults[0].reason}"[:90]] += 1
    return steps_of(actions), judged


def added(node: ObjectNode, unit: FunctionalUnit) -> set[str]:
    """Return what a food has in it after ``unit``, if that covers it: it is not what is brought."""
    after = next((one for one in unit.output_nodes if one.label == node.label), None)
    return set(after.ingredients) if after is not None else set()


def based(node: ObjectNode, members: dict[str, set[str]]) -> set[str]:
    """Return the foods of which a node is made, in the end: a food is in itself, with what came onto it."""
    names = node.ingredients or (node.label,)
    own = members.get(node.label, {node.label})
    found = set().union(*(members.get(name, {name}) if name != node.label else {name} for name in names))
    return found | (own & {node.label}) | (own - {node.label} if not node.ingredients else set())


def class_of(motion: str) -> str:
    first = motion.split(maxsplit=1)[0].lower()
    return next((kind for kind, words in WORDS.items() if first in words), first)


def alike(one: str, other: str) -> bool:
    """Return whether two names are of one food: the same last word, or all words of the one in the other."""
    a, b = (singular(name).split() for name in (one, other))
    return a[-1:] == b[-1:] or set(a) <= set(b) or set(b) <= set(a) or "".join(a) == "".join(b)


def half_the_same(gold: set[str], drafted: set[str]) -> bool:
    pairs = nx.Graph()
    pairs.add_edges_from(((0, a), (1, b)) for a in gold for b in drafted if alike(a, b))
    top = {node for node in pairs if node[0] == 0}
    common = len(nx.bipartite.maximum_matching(pairs, top)) // 2
    return common * 2 >= len(gold) + len(drafted) - common


def matched(gold: Steps, drafted: Steps) -> dict[Key, Key]:
    """Return the drafted step for each step of the network that has one, sentence by sentence."""
    pairs = nx.Graph()
    for sentence, kind in gold.foods:
        for other in drafted.foods:
            if other[0] == sentence and (kind == other[1] or any(class_of(w) == other[1] for w in WORDS.get(kind, ()))):
                pairs.add_edge((0, (sentence, kind)), (1, other), weight=2 if kind == other[1] else 1)
    found = nx.max_weight_matching(pairs, maxcardinality=True)
    return {a[1]: b[1] for one, other in found for a, b in [sorted((one, other))]}


@dataclass
class Share:
    """What was found of what is there, and of what was said."""

    common: int = 0
    there: int = 0
    said: int = 0

    def add(self, there: set, said: set) -> None:
        """Count one recipe."""
        self.common += len(there & said)
        self.there += len(there)
        self.said += len(said)

    def __str__(self) -> str:
        precision, recall = self.common / max(self.said, 1), self.common / max(self.there, 1)
        mean = 2 * precision * recall / max(precision + recall, 1e-9)
        return f"F {mean * 100:.0f}  (precision {precision * 100:.0f}, recall {recall * 100:.0f}; {self.there} there)"


class Figures:
    """The figures over all recipes."""

    def __init__(self) -> None:
        self.shares: defaultdict[str, Share] = defaultdict(Share)
        self.main, self.judged = Counter(), Counter()

    def add(self, recipe: Recipe, made: Draft) -> Iterator[str]:
        """Count one recipe, and yield what a developer wants to know of it."""
        drafted, judged = drafted_steps(made)
        gold, pairs = recipe.steps, matched(recipe.steps, drafted)
        back = {other: one for one, other in pairs.items()}
        self.judged += judged
        verbs = self.shares["verbs"]
        verbs.common, verbs.there, verbs.said = (
            verbs.common + len(pairs),
            verbs.there + len(gold.foods),
            verbs.said + len(drafted.foods),
        )
        ours = {(back[a], back[b]) for a, b in drafted.edges(pairs.values())}
        true = gold.edges(pairs)
        in_order = [key for key in gold.foods if key in pairs]
        order = set(pairwise(in_order))
        self.shares["edges"].add(true, ours)
        self.shares["edges by reading order"].add(true, order)
        self.shares["edges, of all"].add(
            gold.edges(gold.foods), {(back.get(a, a), back.get(b, b)) for a, b in drafted.edges(drafted.foods)}
        )
        for one, other in pairs.items():
            right = right_object(gold, one, drafted, other)
            self.main[right] += 1
            if not right:
                yield f"  main object of {one}: {sorted(gold.foods[one])} is drafted {sorted(drafted.foods[other])}"
        yield from (f"  not drafted: {key}" for key in gold.foods if key not in pairs)
        yield from (f"  no step of the network: {key}" for key in drafted.foods if key not in back)
        yield from (f"  no such edge: {edge}" for edge in sorted(ours - true))
        yield from (f"  edge missing: {edge}" for edge in sorted(true - ours))

    def show(self) -> None:
        """Print the figures."""
        for name, share in self.shares.items():
            print(f"{name:24} {share}")
        print(
            f"{'main ingredient':24} {self.main[True] / max(self.main.total(), 1) * 100:.0f} % of {self.main.total()}"
        )
        for name, count in self.judged.most_common():
            print(f"{name:60} {count}") if not name.startswith("  ") else None


def right_object(gold: Steps, one: Key, drafted: Steps, other: Key) -> bool:
    if gold.foods[one]:
        return half_the_same(gold.foods[one], drafted.foods[other])
    return not gold.vessels[one] or any(
        alike(a, b) or {a, b} <= TRAYS for a in gold.vessels[one] for b in drafted.vessels[other]
    )


TRAYS = {"baking tray", "cookie sheet", "baking sheet", "pan", "baking pan", "muffin tin", "tray", "loaf pan"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("muhai", type=Path)
    parser.add_argument("foon", type=Path)
    parser.add_argument("--half", choices=("development", "figure"), default="development")
    parser.add_argument("--with-ingredients", action="store_true", help="draft with the lines of ingredients, too")
    parser.add_argument("--show", action="store_true", help="show drafts and faults (of the development half alone)")
    parser.add_argument("--only", default="", help="recipes with this in their names")
    asked = parser.parse_args()
    found = Snapshot.of([one.subgraph for one in read_paths([asked.foon]) if one.subgraph is not None], KITCHEN)
    precedents = FoonPrecedents(found.units, KITCHEN)
    figures = Figures()
    paths = sorted(asked.muhai.glob("*.lisp"))[asked.half == "figure" :: 2]
    for path in (path for path in paths if asked.only in path.stem):
        recipe = Recipe.read(path)
        sentences = tuple(Sentence(text, Timing(((n, n + 1),))) for n, text in enumerate(recipe.sentences))
        listed = ingredients(recipe.ingredients) if asked.with_ingredients else ()
        narration = Narration(recipe.name, (), sentences, ingredients=listed)
        made = draft(with_actions(narration, precedents.verbs, precedents.names), precedents)
        faults = list(figures.add(recipe, made))
        if asked.show and asked.half == "development":
            show(recipe, made, faults)
    figures.show()


def told(one: Annotation) -> str:
    """Return a unit on one line, as a draft writes it."""
    sides = ["; ".join(map(thing, side)) for side in (one.unit.inputs, one.unit.outputs)]
    return f"{'(assumed) ' if one.timing.assumed else ''}{one.unit.motion.upper()}: {sides[0]} → {sides[1]}"


def show(recipe: Recipe, made: Draft, faults: Sequence[str]) -> None:
    print(f"\n=== {recipe.name}")
    said = ""
    for row in made.rows:
        if row.said != said:
            said = row.said
            print(f"“{said}”")
        print(f"    {told(row.annotation) if isinstance(row, DraftUnit) else '- ' + row.reason}")
        for doubt in getattr(row, "doubts", ()):
            print(f"      ? {doubt}")
    print(*faults, sep="\n")


if __name__ == "__main__":
    main()
