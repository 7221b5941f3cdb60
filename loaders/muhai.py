"""MUHAI's recipes: networks of kitchen primitives, played from the first to the last so that each becomes a unit.

A network names the results of its primitives by variables. Here a variable stands for a vessel and what is in it, or
for a tool; a variable that nothing made is a fresh vessel or the tool that the primitive needs. Kitchen states, which
only chain the primitives, are passed over, and so is fetching a tool, which changes nothing.

Here the files are read and the dish is marked. Of the primitives knows :mod:`~foon_kg.loaders.muhai_primitives`, of
variables :mod:`~foon_kg.loaders.muhai_scene`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from foon_kg.food.dish_classes import dish_classes
from foon_kg.loaders.lisp import Form, read_lisp
from foon_kg.loaders.muhai_primitives import play
from foon_kg.loaders.muhai_scene import Scene
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, ReadResult, Remark, Severity, UnreadableFile
from foon_kg.model import Annotation, FunctionalUnit, Participant
from foon_kg.model.errors import ReadError
from foon_kg.model.nodes import name_of_file
from foon_kg.model.regular_files import read_bytes

_ENDING = ".lisp"
_DEFINITIONS = ("defparameter", "defvar", "setf")
_DISHES_BY_WORD = {"tuile": "cookie", "snap": "cookie", "slice": "salad"}
"""Dish types of titles in which no general word of a dish stands: MUHAI calls these cookies and salads."""


def read_muhai(paths: Iterable[Path]) -> Iterator[ReadResult]:
    """Yield one result for every MUHAI recipe (``*.lisp``) that ``paths`` name or hold, by name.

    A primitive that cannot be understood is left out, and told with its line. Raises ``ReadError`` for a path that
    does not exist or holds no such file.
    """
    found: set[Path] = set()
    for path in paths:
        if not path.exists():
            raise ReadError(f"there is no file or folder {path}", hint="Check the path.")
        files = [file for file in path.rglob(f"*{_ENDING}") if file.is_file()] if path.is_dir() else [path]
        if not files or (not path.is_dir() and path.suffix.lower() != _ENDING):
            raise ReadError(f"{path}: no MUHAI recipe there", hint=f"Name a *{_ENDING} file, or a folder of them.")
        found.update(files)
    return (read_muhai_file(file) for file in sorted(found, key=lambda file: (name_of_file(file), str(file))))


def read_muhai_file(path: Path) -> ReadResult:
    """Return the units of the recipe in the file ``path``. Never raises."""
    try:
        data = read_bytes(path)
    except OSError as error:
        return Journal(str(path)).reject_unread(error)
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        text = data.decode("latin-1")  # MUHAI writes its degree signs so, in comments
    return read_muhai_text(text, name_of_file(path), str(path))


def read_muhai_text(text: str, name: str, file: str = "") -> ReadResult:
    """Return the units of the longest network in ``text``, as the video ``name``; ``file`` is told in notices.

    Never raises.
    """
    journal = Journal(file or name)
    try:
        document = read_lisp(text)
    except UnreadableFile as error:
        return journal.reject_file(error.line, error.problem)
    for line in document.unclosed:
        what = "the list that begins here is not closed before the next definition"
        journal.remark(line, Remark(NoticeKind.BAD_BRACKETS, what, "taken to end there"))
    networks = [network for form in document.forms if form.head in _DEFINITIONS for network in _networks(form)]
    if not networks:
        return journal.reject_file(None, Problem(NoticeKind.NO_UNITS, "no network that begins with (get-kitchen …)"))
    scene = Scene(journal)
    for primitive in max(networks, key=lambda network: len(network.items)).forms():
        play(scene, primitive)
    units = _with_goal_if_whole(scene.units, name, journal)
    notes = (Annotation(unit, measures=measures) for unit, measures in zip(units, scene.measures, strict=True))
    return journal.result(name, list(notes), (), scene.lines)


def _with_goal_if_whole(units: Sequence[FunctionalUnit], name: str, journal: Journal) -> Sequence[FunctionalUnit]:
    """Mark the dish; where steps were rejected, note in the ``journal`` that none is marked."""
    if not any(notice.severity is Severity.REJECTED for notice in journal.notices()):
        return _with_goal(units, name)
    what = "steps are missing, so what the last one makes is hardly the dish"
    journal.remark(None, Remark(NoticeKind.ODD_CLASS, what, "no goal marked"))
    return units


def _networks(definition: Form) -> Iterator[Form]:
    return (form for form in definition.forms() if any(inner.head == "get-kitchen" for inner in form.forms()))


def _with_goal(units: Sequence[FunctionalUnit], name: str) -> list[FunctionalUnit]:
    """Mark the dish: the last food that the recipe makes is called by the title and gets its dish type."""
    title = re.sub(r"\s*\d+$", "", name.replace("-", " "))
    dish_type = _dish_type_of(title)
    listed = list(units)
    if dish_type and listed:
        listed[-1] = _making_the_dish(listed[-1], title, dish_type)
    return listed


def _dish_type_of(title: str) -> str | None:
    """Return the dish type of a recipe, by its title; ``None`` where that says none."""
    dish = next(iter(sorted(set(_DISHES_BY_WORD) & {word.rstrip("s") for word in title.split()})), "")
    sure = [one.name for one in dish_classes(title) if one.sure]
    found = sure[0] if sure else _DISHES_BY_WORD.get(dish)
    if found == "bread" and "biscuits" in title and "shortcake" not in title:
        return "cookie"  # what is sweet and baked in spoonfuls
    return found


def _making_the_dish(unit: FunctionalUnit, title: str, dish_type: str) -> FunctionalUnit:
    """Return a unit whose output with most in it is the dish, called by the title."""
    foods = [place for place, one in enumerate(unit.outputs) if one.node.container]
    if not foods:
        return unit
    goal = max(foods, key=lambda place: len(unit.outputs[place].node.ingredients))
    old = unit.outputs[goal].node.label
    outputs = tuple(_named(one, old, title, dish_type if i == goal else None) for i, one in enumerate(unit.outputs))
    return replace(unit, outputs=outputs)


def _named(one: Participant, old: str, title: str, dish: str | None) -> Participant:
    node = one.node
    if node.label == old:
        node = replace(node, label=title)
    names = tuple(title if name == old else name for name in node.ingredients)
    return Participant(replace(node, ingredients=names), one.moving, dish)
