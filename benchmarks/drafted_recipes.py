"""How well do drafts of recipes hold together? Sentences of MUHAI's recipes are drafted and set beside their networks.

    python benchmarks/drafted_recipes.py ../shared/data/muhai ../shared/data/foon-111/TXT --half development --show
    python benchmarks/drafted_recipes.py ../shared/data/muhai ../shared/data/foon-111/TXT --half figure

Of the recipes in their sorted order the even ones (the first is number 0) are for development and may be read
(``--show``); the odd ones are for the figure alone, and nothing of them is ever printed but figures. Drafts are made
from the instructions, with the FOON of the second path, which holds none of these recipes. ``--with-ingredients`` puts
the lines of ingredients before them, as a recipe in a file has them.

A step is all that one sentence does of one class (mix, cut, bake ...), on both sides. Bringing is a step of its own only
where nothing else in its sentence is done with what was brought. Measured are:

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
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import networkx as nx

from foon_kg.food import singular
from foon_kg.language.drafting import Draft, DraftUnit, draft
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.drafting.tables import thing
from foon_kg.language.instructions import with_actions
from foon_kg.loaders import read_paths
from foon_kg.loaders.lisp import Form, Symbol, read_lisp
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Timing
from foon_kg.model.narration import Narration, Sentence
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.world import Step as Played
from foon_kg.world import World

KITCHEN = Kitchen.default()
CLASSES = {
    "bring": "transfer-contents transfer-items portion-and-arrange spread sprinkle / add pour place put pick-and-place scoop "
    "sprinkle spread drizzle top season insert arrange fill drop move set transfer brush garnish dust divide separate decorate remove take",
    "mix": "mix mingle beat shake / mix stir beat whisk combine toss blend fold cream whip knead",
    "cut": "cut / cut chop slice dice mince halve quarter shred grate cube",
    "shape": "shape flatten / shape roll flatten form press",
    "bake": "bake / bake roast broil toast",
    "cook": "boil fry cook / boil simmer cook fry saute heat",
    "preheat": "preheat-oven / preheat turn",
    "rest": "bring-to-temperature leave-for-time refrigerate / cool chill sit leave rest refrigerate freeze stand marinate soften soak",
    "prepare": "grease flour line / grease flour line brush spread oil butter cover wrap place",
    "cover": "cover / cover wrap close",
    "uncover": "uncover / uncover open remove unwrap",
    "peel": "peel / peel remove",
    "seed": "seed / seed core remove pit",
    "mash": "mash / mash smash crush",
    "grind": "grind / grind blend crush",
    "melt": "melt / melt heat",
    "wash": "wash / wash rinse",
    "drain": "drain / drain strain pour-and-strain",
    "crack": "crack / crack break",
    "separate-eggs": "separate-eggs / separate",
    "sift": "sift / sift sieve",
    "dip": "dip / dip coat roll dredge pick-and-place place",
}
"""For each class the primitives of networks and, behind the stroke, the first words of motions."""
PRIMITIVES = {name: kind for kind, row in CLASSES.items() for name in row.split(" / ")[0].split()}
WORDS = {kind: row.split(" / ")[1].split() for kind, row in CLASSES.items()}
NO_STEPS = frozenset({"get-kitchen", "fetch", "fetch-and-proportion"})
SOURCE_IS_SECOND = frozenset({"transfer-contents", "spread", "sprinkle"})
COMMENT = re.compile(r'^\s*;+\s*"(.*)"')

Key = tuple[int, str]
"""The number of a sentence, and a class."""


@dataclass
class Steps:
    """The steps of one side: the foods of each, and the flow between them."""

    foods: dict[Key, set[str]] = field(default_factory=dict)
    vessels: dict[Key, set[str]] = field(default_factory=dict)
    flow: nx.DiGraph = field(default_factory=nx.DiGraph)
    """Between steps and whatever is none (a number)."""

    def edges(self, steps: Iterable[Key]) -> set[tuple[Key, Key]]:
        """Return the edges between ``steps``, those that pass only through others counting as one."""
        wanted = set(steps)
        found: set[tuple[Key, Key]] = set()
        for step in wanted & set(self.flow):
            reached, front = set(), list(self.flow.successors(step))
            while front:
                node = front.pop()
                if node in reached:
                    continue
                reached.add(node)
                if node in wanted:
                    found |= {(step, node)} - {(node, step)} if node != step else set()
                else:
                    front += self.flow.successors(node)
        return found


@dataclass
class Action:
    """One primitive or drafted unit: its sentence and class, which things it takes and makes, the foods worked on."""

    sentence: int
    kind: str | None
    takes: list[int]
    foods: set[str]
    vessels: set[str]


def steps_of(actions: Sequence[Action]) -> Steps:
    """Return the steps of actions, of which bringing for another action in the same sentence is a part of that."""
    flow = nx.DiGraph()
    flow.add_nodes_from(range(len(actions)))
    flow.add_edges_from((before, place) for place, one in enumerate(actions) for before in one.takes)
    keys: dict[int, Key] = {}
    for place in reversed(range(len(actions))):
        action = actions[place]
        if action.kind is None:
            continue
        keys[place] = (action.sentence, action.kind)
        if action.kind == "bring":
            for after in sorted(flow.successors(place)):
                if keys.get(after, (-1, ""))[0] == action.sentence and keys[after][1] != "bring":
                    keys[place] = keys[after]
                    break
    found = Steps()
    for place, action in enumerate(actions):
        key = keys.get(place)
        if key is not None and action.kind == key[1]:
            found.foods.setdefault(key, set()).update(action.foods)
            found.vessels.setdefault(key, set()).update(action.vessels)
    found.flow.add_nodes_from(found.foods)
    found.flow.add_edges_from(
        (keys.get(a, a), keys.get(b, b)) for a, b in flow.edges if keys.get(a, a) != keys.get(b, b)
    )
    return found


@dataclass(frozen=True)
class Recipe:
    """A recipe of MUHAI: its sentences, and the primitives that stand below each."""

    name: str
    ingredients: tuple[str, ...]
    sentences: tuple[str, ...]
    primitives: tuple[tuple[int, Form], ...]

    @classmethod
    def read(cls, path: Path) -> Recipe:
        """Return the recipe in ``path``; its instructions begin below the last line that only fetches."""
        data = path.read_bytes()
        try:
            text = data.decode("utf-8")
        except UnicodeDecodeError:
            text = data.decode("latin-1")
        lines = {number: found[1] for number, line in enumerate(text.splitlines(), 1) if (found := COMMENT.match(line))}
        networks = [inner for form in read_lisp(text).forms for inner in form.forms() if holds_a_kitchen(inner)]
        network = max(networks, key=lambda one: len(one.items))
        under = [(max((line for line in lines if line < form.line), default=0), form) for form in network.forms()]
        first_below = {line: form.head for line, form in reversed(under)}
        instructions = [line for line in sorted(lines) if line > network.line]
        while instructions and is_ingredient(lines[instructions[0]], first_below.get(instructions[0], "")):
            del instructions[0]
        number = {line: place for place, line in enumerate(instructions)}
        before = [lines[line] for line in sorted(lines) if network.line < line and line not in number]
        told = tuple(lines[line].strip() for line in instructions)
        return cls(path.stem, tuple(before), told, tuple((number.get(line, -1), form) for line, form in under))

    @cached_property
    def steps(self) -> Steps:
        """What the network does."""
        kitchens: set[str] = set()
        made_by: dict[str, int] = {}
        foods: dict[str, set[str]] = {}
        vessels: dict[str, str] = {}
        actions: list[Action] = []
        for sentence, form in self.primitives:
            words = [item.text for item in form.items if isinstance(item, Symbol)][1:]
            if form.head == "get-kitchen":
                kitchens.add(words[0])
                continue
            state = next((i for i, word in enumerate(words) if i > 0 and (word in kitchens or is_kitchen(word))), 2)
            state += state + 1 < len(words) and is_kitchen(words[state + 1]) and words[state] not in kitchens
            kitchens.add(words[state - 1])
            outputs, inputs = words[: state - 1], words[state + 1 :]
            known = [word for word in inputs if word in made_by]
            held = [foods[word] for word in known if foods[word]]
            worked = set().union(*held)
            if PRIMITIVES.get(form.head) == "bring" and held:
                worked = held[-1] if form.head in SOURCE_IS_SECOND else held[0]
            if form.head == "fetch":
                vessels[words[0]] = singular(words[state + 1].replace("-", " "))
            going = {words[state + 2].replace("-", " ")} if form.head == "fetch-and-proportion" else set().union(*held)
            kind = None if form.head in NO_STEPS or sentence < 0 else PRIMITIVES.get(form.head, form.head)
            at = {vessels[word] for word in inputs if word in vessels} if kind != "preheat" else {"oven"}
            actions.append(Action(sentence, kind, [made_by[word] for word in known], worked, at))
            for word in outputs:
                made_by[word], foods[word] = len(actions) - 1, set(going)
        return steps_of(actions)


def holds_a_kitchen(form: Form) -> bool:
    return any(inner.head == "get-kitchen" for inner in form.forms())


def is_kitchen(word: str) -> bool:
    return word.startswith("?") and re.search(r"\bks\b|kitchen", word.replace("-", " ")) is not None


def is_ingredient(text: str, head: str) -> bool:
    return text.lstrip()[:1].isdigit() or head in {"fetch-and-proportion", ""}


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
    """Return the foods of which a node is made, in the end."""
    names = node.ingredients or (node.label,)
    return set().union(*(members.get(name, {name}) if name != node.label else {name} for name in names)) | (
        members.get(node.label, set()) - {node.label} if node.label in members and not node.ingredients else set()
    )


def class_of(motion: str) -> str:
    first = motion.split()[0].lower()
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
        order = set(zip(in_order, in_order[1:], strict=False))
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
    parser.add_argument("--with-ingredients", action="store_true", help="put the lines of ingredients before the text")
    parser.add_argument("--show", action="store_true", help="show drafts and faults (of the development half alone)")
    parser.add_argument("--only", default="", help="recipes with this in their names")
    asked = parser.parse_args()
    found = Snapshot.of([one.subgraph for one in read_paths([asked.foon]) if one.subgraph is not None], KITCHEN)
    precedents = FoonPrecedents(found.units, KITCHEN)
    figures = Figures()
    paths = sorted(asked.muhai.glob("*.lisp"))[asked.half == "figure" :: 2]
    for path in (path for path in paths if asked.only in path.stem):
        recipe = Recipe.read(path)
        told = [*enumerate(recipe.sentences)]
        if asked.with_ingredients:
            told = [*((-1, line) for line in recipe.ingredients), *told]
        sentences = tuple(Sentence(text, Timing(((max(n, 0), max(n, 0) + 1),))) for n, text in told)
        made = draft(
            with_actions(Narration(recipe.name, (), sentences), precedents.verbs, precedents.names), precedents
        )
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
