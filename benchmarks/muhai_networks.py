"""The steps of MUHAI's recipes: what each sentence does, to which foods, and what flows from step to step.

No program: ``drafted_recipes.py`` sets drafts beside these. A step is all that one sentence does of one class.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import networkx as nx

from foon_kg.food import singular
from foon_kg.loaders.lisp import Form, Symbol, read_lisp

CLASSES = {
    "mix": "mix mingle beat shake / mix stir beat whisk combine toss blend fold cream whip knead",
    "bring": "transfer-contents transfer-items portion-and-arrange spread sprinkle / add pour place put pick-and-place "
    "scoop sprinkle spread drizzle top season insert arrange fill drop move set transfer brush garnish dust divide "
    "separate decorate remove take combine",
    "cut": "cut / cut chop slice dice mince halve quarter shred grate cube",
    "shape": "shape flatten / shape roll flatten form press",
    "bake": "bake / bake roast broil toast",
    "cook": "boil fry cook / boil simmer cook fry saute heat",
    "preheat": "preheat-oven / preheat turn",
    "rest": "bring-to-temperature leave-for-time refrigerate / "
    "cool chill sit leave rest refrigerate freeze stand marinate soften soak",
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
"""For each class the primitives of networks and, behind the stroke, the first words of motions: of the first row in
which they stand, and what else a cook may call it (to combine is to bring together, where nothing is mixed)."""
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
