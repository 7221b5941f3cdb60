"""Task trees as text that a cook can read: the notation of the examples in docs/contract.md.

One step a line, nodes as ``str(node)`` writes them, the motion in capitals between two arrows::

    dish: soup
    asked: potato (diced); salt (granulated)
    pot (empty) + stove (off) → PICK-AND-PLACE → pot (empty; on stove) + stove (off; under pot)
      seen in: potato_soup 4

- A line that begins with ``→`` or ``+`` goes on with the line before. ``->`` may be written for ``→``.
- ``bowl#3`` and ``in bowl#3`` are things with numbers. ``nothing`` stands for an empty list or an empty side.
- A name that would be read as something else stands in quotes, as in JSON: ``"off (ready)"``, ``"from faucet"``.
- Of the tree: ``name``, ``dish``, ``asked`` (``food (state; for part)``), ``title``, ``id``, ``goal``, ``kitchen``,
  ``assumed`` (``node: why``), ``substitution`` (``kind (object): required like equivalent (confidence); alternative
  (confidence), …``), ``level``, ``error``. Of the step above: ``seen in``, ``grounding``, ``origin``.
- ``---`` ends a tree and begins the next one.
- ``✗ fatal: why`` says that the step above breaks a rule, ``✗ minor at the end: why`` that the whole tree does.

Not kept are the source and the times of a sighting, the amounts that were asked, and of a unit its phase, its measures,
its star and what moves in it; all else that a :class:`TaskTree` says is. How names and nodes are
written is in :mod:`foon_kg.validation.notation_nodes`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from foon_kg.model import Recipe
from foon_kg.model.errors import ReadError
from foon_kg.model.levels import Level
from foon_kg.model.tree import Step, TaskTree
from foon_kg.validation import notation_nodes as nodes
from foon_kg.validation.notation_line import HINT, NOTHING, Line, written_rest
from foon_kg.world import Mention

SEPARATOR = "---"
MARK = "✗"

_REMARK = re.compile(rf"{MARK}\s*(fatal|minor)( at the end)?:\s*(.+)")
_GOES_ON = (*nodes.ARROWS, "+")


@dataclass(frozen=True)
class Remark:
    """A finding that an example announces: at which step (from 0, ``None`` for the whole tree) and of which level."""

    step: int | None
    minor: bool
    reason: str


def read_tree(text: str, where: str = "tree") -> TaskTree:
    """Return the one tree of a text; ``where`` begins every message, and is the name of a tree that tells none.

    Raises ReadError, with the line, where the text is no tree or more than one.
    """
    trees = read_trees(text, where)
    if len(trees) != 1:
        raise ReadError(f"{where}: expected one tree, found {len(trees)}", hint=HINT)
    return trees[0]


def read_trees(text: str, where: str = "tree") -> tuple[TaskTree, ...]:
    """Return the trees of a text, which stand between lines of ``---``.

    Raises ReadError, with the line, where the text is not of this notation.
    """
    drafts = [_Draft(where)]
    for line in _lines(text, where):
        if line.text == SEPARATOR:
            drafts.append(_Draft(where))
        else:
            drafts[-1].add(line)
    return tuple(draft.tree() for draft in drafts)


def remarks(text: str, where: str = "tree") -> tuple[Remark, ...]:
    """Return the findings that a text announces, in its order.

    Raises ReadError, with the line, where a remark tells no level or stands under no step.
    """
    found, step = [], -1
    for number, line in _numbered(text):
        match = _REMARK.fullmatch(line)
        if match is not None and (match[2] or step >= 0):
            found.append(Remark(None if match[2] else step, match[1] == "minor", match[3]))
        elif line.startswith(MARK):
            raise ReadError(f"{where}:{number}: this remark tells no level, or stands under no step", hint=HINT)
        elif line == SEPARATOR:
            step = -1
        elif not line.startswith(_GOES_ON) and not _KEY.match(line):
            step += 1
    return tuple(found)


def write_tree(tree: TaskTree) -> str:
    """Return a tree as text that :func:`read_tree` reads back as the same tree, but for what the module says."""
    return "\n".join([*_head(tree), *(line for unit in tree.units for line in _unit_lines(unit))]) + "\n"


# --- writing ---


def _head(tree: TaskTree) -> Iterator[str]:
    yield f"name: {written_rest(tree.name)}"
    if tree.recipe is not None:
        yield f"dish: {written_rest(tree.recipe.dish_type)}"
        yield f"asked: {nodes.written_asked(tree.recipe.ingredients)}"
        yield from _optional("title", tree.recipe.title)
        yield from _optional("id", tree.recipe.id)
    if tree.goal is not None:
        yield f"goal: {nodes.written_node(Mention(tree.goal))}"
    if tree.kitchen is not None:
        yield f"kitchen: {nodes.written_kitchen(tree.kitchen)}"
    yield from _listed("substitution", tree.substitutions, nodes.written_substitution)
    yield from _listed("assumed", tree.assumptions, nodes.written_assumption)
    if tree.level is not None:
        yield f"level: {tree.level.value}"
    yield from _optional("error", tree.error)


def _unit_lines(unit: Step) -> Iterator[str]:
    yield nodes.written_step(unit)
    if unit.seen_in is not None:
        yield f"  seen in: {nodes.written_sightings(unit.seen_in)}"
    yield from _optional("  grounding", unit.grounding)
    yield from _optional("  origin", unit.origin)


def _optional(key: str, text: str | None) -> Iterator[str]:
    if text is not None:
        yield f"{key}: {written_rest(text)}"


def _listed(key: str, entries: Sequence[Any] | None, written: Callable[[Any], str]) -> Iterator[str]:
    if entries is not None:
        yield from (f"{key}: {text}" for text in map(written, entries or ()))
        if not entries:
            yield f"{key}: {NOTHING}"


# --- reading ---


def _numbered(text: str) -> Iterator[tuple[int, str]]:
    """Yield the lines that say something with their numbers, from 1."""
    lines = enumerate(map(str.strip, text.split("\n")), start=1)
    return ((number, line) for number, line in lines if line)


def _lines(text: str, where: str) -> list[Line]:
    """Return the lines of trees, each with those that go on with it; remarks are left out."""
    found: list[Line] = []
    for number, line in _numbered(text):
        if line.startswith(_GOES_ON):
            if not found or found[-1].text == SEPARATOR:
                raise ReadError(f"{where}:{number}: this line goes on with nothing", hint=HINT)
            found[-1].text += f" {line}"
        elif not line.startswith(MARK):
            found.append(Line(line, f"{where}:{number}"))
    return found


def _read_level(line: Line) -> Level:
    number = line.whole_number()
    if number not in list(Level):
        line.fail(f"a FOON has no level {number}")
    return Level(number)


@dataclass(frozen=True)
class _Key:
    """What a key tells: of what, in which field, how it is read, and whether it may come again (a part of a list)."""

    of: Literal["tree", "recipe", "step"]
    field: str
    read: Callable[[Line], Any]
    again: bool = False


_KEYS = {
    "name": _Key("tree", "name", Line.rest),
    "dish": _Key("recipe", "dish_type", Line.rest),
    "asked": _Key("recipe", "ingredients", nodes.read_asked),
    "title": _Key("recipe", "title", Line.rest),
    "id": _Key("recipe", "id", Line.rest),
    "goal": _Key("tree", "goal", nodes.read_node),
    "kitchen": _Key("tree", "kitchen", nodes.read_kitchen),
    "substitution": _Key("tree", "substitutions", nodes.read_substitutions, again=True),
    "assumed": _Key("tree", "assumptions", nodes.read_assumptions, again=True),
    "level": _Key("tree", "level", _read_level),
    "error": _Key("tree", "error", Line.rest),
    "seen in": _Key("step", "seen_in", nodes.read_sightings),
    "grounding": _Key("step", "grounding", Line.rest),
    "origin": _Key("step", "origin", Line.rest),
}
_KEY = re.compile(rf"({'|'.join(_KEYS)}):")


@dataclass
class _Draft:
    """A tree of which one line after another is read."""

    where: str
    of_tree: dict[str, Any] = field(default_factory=dict)
    recipe: dict[str, Any] = field(default_factory=dict)
    steps: list[tuple[Step, dict[str, Any]]] = field(default_factory=list)

    def tree(self) -> TaskTree:
        """Return what was read."""
        recipe = Recipe(**{"dish_type": "", "ingredients": (), **self.recipe}) if self.recipe else None
        units = tuple(replace(step, **said) for step, said in self.steps)
        return TaskTree(**{"name": self.where, **self.of_tree, "units": units, "recipe": recipe})

    def add(self, line: Line) -> None:
        """Read a line: a step, or what a key tells."""
        match = _KEY.match(line.text)
        if match is None:
            self.steps.append((nodes.read_step(line), {}))
        else:
            line.at = match.end()
            self._tell(match[1], line)
        line.end()

    def _tell(self, name: str, line: Line) -> None:
        key = _KEYS[name]
        if key.of == "step" and not self.steps:
            line.fail(f"“{name}” stands under no step")
        kept = {"tree": self.of_tree, "recipe": self.recipe, "step": self.steps[-1][1] if self.steps else {}}[key.of]
        if key.again:
            kept[key.field] = (*kept.get(key.field, ()), *key.read(line))
        elif key.field in kept:
            line.fail(f"“{name}” is told twice")
        else:
            kept[key.field] = key.read(line)
