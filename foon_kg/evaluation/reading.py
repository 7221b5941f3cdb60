"""Trees for a reading: drawn by a seed, and kept in a key that readers do not see.

:mod:`~foon_kg.evaluation.reading_page` prints them, :mod:`~foon_kg.evaluation.reading_sheet` reads what readers say of
them, and :mod:`~foon_kg.evaluation.reading_figures` counts it.
"""

from __future__ import annotations

import json
import random
from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.evaluation.sampling import drawn
from foon_kg.model import Subgraph, regular_files
from foon_kg.model.errors import ReadError
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.json_text import json_value
from foon_kg.model.nodes import one_spelling
from foon_kg.model.tree import TaskTree
from foon_kg.plans.kitchen import Kitchen
from foon_kg.validation import tree_from_json, tree_from_subgraph

VideoTrees = Mapping[str, TaskTree]
"""Recorded videos by name, each with the recipe that it answers."""

RECORDED = "recorded"
"""Stands where a dish type stands in the draw: recorded videos draw for themselves, over all dish types."""


@dataclass(frozen=True)
class ReadingTree:
    """A tree that readers are given; ``plan`` is the result of a planner, ``None`` for a recorded video."""

    name: str
    dish_type: str
    plan: JsonObject | None = None

    @property
    def recorded(self) -> bool:
        """Whether people recorded it, and no program made it."""
        return self.plan is None

    @property
    def has_steps(self) -> bool:
        """Whether there is anything to read: a planner may have found no tree."""
        return self.plan is None or "error" not in self.plan

    @property
    def drawn_among(self) -> str:
        """The group that it is drawn from: its dish type, or all recorded videos together (``RECORDED``)."""
        return RECORDED if self.recorded else self.dish_type

    def tree(self, videos: VideoTrees) -> TaskTree:
        """Return the task tree; raises ReadError for a video that is not among ``videos``."""
        if self.plan is not None:
            return tree_from_json(self.plan, self.name)
        if self.name not in videos:
            raise ReadError(f"{self.name}: no such video", hint="Name the folder of videos from which it was drawn.")
        return videos[self.name]

    def to_json(self) -> JsonObject:
        """Return the tree as JSON."""
        return {"id": self.name, "dish_type": self.dish_type, "plan": self.plan}


def planned_trees(path: Path) -> tuple[ReadingTree, ...]:
    """Return the plan results (JSON Lines) of the file ``path``.

    Raises ReadError with file and line for what is no plan result of a recipe.
    """
    found = []
    for number, line in enumerate(read_text(path).split("\n"), start=1):
        if line.strip():
            where = f"{path}:{number}"
            plan = _json(line, where)
            tree = tree_from_json(plan, where)
            if tree.recipe is None or not isinstance(plan, dict):
                raise ReadError(f"{where}: it answers no recipe", hint="Give what `foon plan --json` wrote.")
            found.append(ReadingTree(tree.name, tree.recipe.dish_type, plan))
    return tuple(found)


def video_trees(subgraphs: Iterable[Subgraph], kitchen: Kitchen) -> dict[str, TaskTree]:
    """Return those of ``subgraphs`` that mark a dish, each with the recipe that it answers in ``kitchen``, by name."""
    asked = ((subgraph, left_out_video(subgraph, kitchen)) for subgraph in subgraphs)
    return {one.name: tree_from_subgraph(one, video.recipe) for one, video in asked if video is not None}


def draw(
    planned: Sequence[ReadingTree],
    videos: VideoTrees,
    *,
    seed: int,
    each: int,
    recorded: int = 0,
    without: Collection[str] = (),
) -> tuple[ReadingTree, ...]:
    """Draw ``each`` planned trees of every dish type and ``recorded`` videos, shuffled.

    Fewer are drawn where there are no more. Plans without a tree and names in ``without`` are left out. The same trees
    and seed give the same draw, in whatever order the trees are given. Raises ReadError where two trees have one name:
    the names say which trees were read before.
    """
    there = _by_name((*planned, *(_of_video(name, tree) for name, tree in videos.items())))
    names: defaultdict[str, list[str]] = defaultdict(list)
    for tree in there.values():
        if tree.has_steps and tree.name not in without:
            names[tree.drawn_among].append(tree.name)
    chosen: list[ReadingTree] = []
    for group in sorted(names):
        count = recorded if group == RECORDED else each
        chosen.extend(there[name] for name in drawn(names[group], count, seed, group))
    random.Random(f"{seed} order").shuffle(chosen)  # noqa: S311 - an order, no secret
    return tuple(chosen)


def _by_name(trees: Iterable[ReadingTree]) -> dict[str, ReadingTree]:
    """Return the trees by their names; raises ReadError where two have one name."""
    found: dict[str, ReadingTree] = {}
    for tree in trees:
        if found.setdefault(tree.name, tree) is not tree:
            raise ReadError(f"{tree.name}: two trees have this name", hint="Give the results of one run, each once.")
    return found


def key_to_json(seed: int, trees: Sequence[ReadingTree]) -> JsonObject:
    """Return the key of a draw (of this ``seed``): which of ``trees`` has which number.

    It holds the plans, so that the judge sees what was read.
    """
    return {"seed": seed, "trees": [{"number": n, **tree.to_json()} for n, tree in enumerate(trees, start=1)]}


def read_key(path: Path) -> tuple[ReadingTree, ...]:
    """Return the trees of the key in the file ``path``, in the order of their numbers.

    Raises ReadError where it is none.
    """
    fields = Fields(_json(read_text(path), str(path)), str(path))
    return tuple(
        _of_key(value, number, f"{path}: trees[{number - 1}]") for number, value in enumerate(fields.items("trees"), 1)
    )


def names_in(path: Path) -> frozenset[str]:
    """Return the names of the trees in the key at ``path``, or in a plain JSON list: what is not to be drawn again."""
    value = _json(read_text(path), str(path))
    if isinstance(value, list) and all(isinstance(name, str) for name in value):
        return frozenset(map(one_spelling, value))
    return frozenset(tree.name for tree in read_key(path))


def read_text(path: Path) -> str:
    """Return the text of the file ``path``; raises ReadError where it is none."""
    try:
        return regular_files.read_text(path)
    except (OSError, UnicodeDecodeError) as error:
        why = error.strerror if isinstance(error, OSError) else "it is no text in UTF-8"
        raise ReadError(f"{path}: cannot be read: {why}", hint="Name a text file that is there.") from error


def _of_video(name: str, tree: TaskTree) -> ReadingTree:
    return ReadingTree(name, tree.recipe.dish_type if tree.recipe else "")


def _of_key(value: object, number: int, where: str) -> ReadingTree:
    fields = Fields(value, where)
    if fields.whole_number("number") != number:
        raise ReadError(f"{where}: its number should be {number}", hint="Keep the key as it was written.")
    plan = value.get("plan") if isinstance(value, dict) else None
    if plan is not None:
        tree_from_json(plan, f"{where}: plan")
    return ReadingTree(one_spelling(fields.text("id")), fields.text("dish_type"), plan)


def _json(text: str, where: str) -> object:
    try:
        value: object = json_value(text)
    except json.JSONDecodeError as error:
        raise ReadError(f"{where}: no JSON: {error}", hint="Give the file as it was written.") from error
    return value
