"""One line of a FOON text file at a time: what it says, and what is odd about how it says it.

Nothing here knows of files, line numbers or units. The two dialects differ only in the first column, which may
carry an id (``O278``, ``S41``, ``M92``).
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass

from foon_kg.loaders.notices import NoticeKind, Problem, Remark
from foon_kg.loaders.times import is_time
from foon_kg.model import DISH_TYPES, Sighting

RELATIONS = frozenset({"attached", "attached to", "below", "from", "in", "on", "over", "under", "with"})
"""Words that only ever say where something is; beside braces they still do."""

_WITH_COLUMNS = re.compile(r"([OSM])[0-9]*\t(.*)", re.DOTALL)
_SOURCE = re.compile(r"#\s*source:(.*)", re.IGNORECASE | re.DOTALL)
_SEEN_IN = re.compile(r"#\s*seen in:(\t.*)?", re.IGNORECASE | re.DOTALL)
_TAB_MISSING = re.compile(r"([^\[{]*)([\[{].*)")
_PLACE = re.compile(r"\[([^\[\]{}]*)\]")
_NAMES = re.compile(r"\{([^\[\]{}]*)\}")
_SHOWN = 60  # characters of a line that are enough to find it by

Place = tuple[str | None, str | None]
"""A relation and a container: ``("in", "bowl")``."""


@dataclass(frozen=True)
class ObjectLine:
    """``O<TAB>label<TAB>flag[<TAB>class]``."""

    label: str
    moving: bool
    dish_type: str | None
    remarks: tuple[Remark, ...] = ()


@dataclass(frozen=True, eq=False)
class StateLine:
    """``S<TAB>…``: a state, the names in braces (with or without a state), or a place."""

    state: str | None = None
    ingredients: tuple[str, ...] = ()
    place: Place | None = None
    remarks: tuple[Remark, ...] = ()


@dataclass(frozen=True)
class MotionLine:
    """``M<TAB>verb[*]<TAB>times``."""

    motion: str
    accepts_any: bool
    time_columns: tuple[str, ...]


@dataclass(frozen=True)
class SourceLine:
    """``# Source:<TAB>address``."""

    address: str


@dataclass(frozen=True)
class SeenLine:
    """``# Seen in:<TAB>video<TAB>unit<TAB>start<TAB>end<TAB>address``: where a step of a task tree was seen."""

    seen_in: tuple[Sighting, ...]


@dataclass(frozen=True)
class Separator:
    """``//``, the line between two units."""

    remarks: tuple[Remark, ...] = ()


Line = ObjectLine | StateLine | MotionLine | SourceLine | SeenLine | Separator | Problem | None
"""What a line says; ``None`` for comments and blank lines, which say nothing."""


def fold(text: str) -> str:
    """Return ``text`` without white space at its ends and with single blanks inside."""
    return " ".join(text.split())


def read_line(text: str) -> Line:
    """Return what a line says, given as ``text`` without its line end."""
    if match := _WITH_COLUMNS.fullmatch(text):
        columns = [fold(column) for column in match[2].split("\t")]
        return _READERS[match[1]](columns)
    if text.startswith("//"):
        beside = fold(text.removeprefix("//"))
        return Separator(_extra_columns([beside], "text beside a separator"))
    if source := _SOURCE.fullmatch(text):
        return SourceLine(fold(source[1]))
    if seen := _SEEN_IN.fullmatch(text):
        return _seen_line((seen[1] or "").split("\t")[1:])
    if text.startswith("#") or not text.strip():
        return None
    shown = text if len(text) <= _SHOWN else text[:_SHOWN] + "…"
    return Problem(NoticeKind.UNKNOWN_LINE, f"no line of a FOON (columns are separated by tabs): {shown!r}")


def _seen_line(columns: list[str]) -> SeenLine | None:
    """Return what the ``columns``, unfolded, say of one sighting, or of none; ``None`` for other words."""
    if not columns:
        return SeenLine(())
    try:
        video, position, start, end, source = columns
        began, ended = (float(time) if time else None for time in (start, end))
        seen = Sighting(video, int(position), source or None, began, ended)
    except ValueError:
        return None
    return SeenLine((seen,)) if all(time is None or is_time(time) for time in (began, ended)) else None


def _extra_columns(columns: list[str], what: str) -> tuple[Remark, ...]:
    return tuple(Remark(NoticeKind.EXTRA_COLUMN, f"{what}: {column!r}", "left out") for column in columns if column)


def _object_line(columns: list[str]) -> ObjectLine | Problem:
    label, flag, dish_class, *more = (*columns, "", "")
    if not label:
        return Problem(NoticeKind.MISSING_NAME, "an object without a name")
    moving = flag.strip("0").isdecimal()
    remarks = _extra_columns(more, "a column too many")
    if flag not in {"0", "1"}:
        action = "read as 1, it moves" if moving else "read as 0, it does not move"
        remarks += (Remark(NoticeKind.ODD_FLAG, f"the flag is {flag!r}, neither 0 nor 1", action),)
    dish_type = _DISH_CLASSES.get(dish_class)
    if dish_class and dish_type is None:
        message = f"{dish_class!r} is no dish class, a number from 0 to {len(DISH_TYPES) - 1}"
        remarks += (Remark(NoticeKind.ODD_CLASS, message, "left out"),)
    return ObjectLine(label, moving, dish_type, remarks)


_DISH_CLASSES = {str(number): dish_type for number, dish_type in enumerate(DISH_TYPES)}


def _motion_line(columns: list[str]) -> MotionLine | Problem:
    motion = columns[0].removesuffix("*").rstrip()
    if not motion:
        return Problem(NoticeKind.MISSING_NAME, "a motion without a name")
    return MotionLine(motion, columns[0].endswith("*"), tuple(columns[1:]))


def _state_line(columns: list[str]) -> StateLine | Problem:
    word, bracketed, *more = (*columns, "")
    remarks = _extra_columns(more, "a column too many")
    if not bracketed and (joined := _TAB_MISSING.fullmatch(word)):
        remarks += (Remark(NoticeKind.MISSING_TAB, f"no tab in {word!r}", "read as if it were there"),)
        word, bracketed = joined[1].rstrip(), joined[2]
    if not bracketed:
        return _plain_state(word, remarks, has_third_column=len(columns) > 1)
    if place := _PLACE.fullmatch(bracketed):
        return _place(word, place[1].strip(), remarks)
    if names := _NAMES.fullmatch(bracketed):
        return _braces(word, names[1], remarks)
    return Problem(NoticeKind.BAD_BRACKETS, f"{bracketed!r} is neither [a place] nor {{names}}")


def _plain_state(word: str, remarks: tuple[Remark, ...], *, has_third_column: bool) -> StateLine:
    if not word:
        remarks += (Remark(NoticeKind.EMPTY_STATE, "a state line that says nothing", "left out"),)
    elif has_third_column:
        message = f"a tab and nothing after {word!r}"
        remarks += (Remark(NoticeKind.EMPTY_STATE_COLUMN, message, "read as a plain state"),)
    return StateLine(state=word or None, remarks=remarks)


def _place(word: str, container: str, remarks: tuple[Remark, ...]) -> StateLine:
    if not container:
        remarks += (Remark(NoticeKind.EMPTY_PLACE, f"'{word} []' names no place", "kept without a container"),)
    if word == "contains":
        message = f"'contains [{container}]' where names stand in {{}}"
        remarks += (Remark(NoticeKind.CONTAINS_PLACE, message, "read as a place with the relation 'contains'"),)
    return StateLine(place=(word or None, container or None), remarks=remarks)


def _braces(word: str, inside: str, remarks: tuple[Remark, ...]) -> StateLine:
    if word in RELATIONS:
        message = f"'{word} {{{inside}}}' where a place stands in []"
        remarks += (Remark(NoticeKind.RELATION_WITH_BRACES, message, "read as a place"),)
        return _place(word, inside.strip(), remarks)
    ingredients, odd = _names(inside)
    remarks += odd
    if word == "contains":
        return StateLine(ingredients=ingredients, remarks=remarks)
    if word in {"contain", ""}:
        remarks += (Remark(NoticeKind.CONTAIN, f"{word!r} before {{}}", "read as 'contains'"),)
        return StateLine(ingredients=ingredients, remarks=remarks)
    remarks += (Remark(NoticeKind.STATE_WITH_BRACES, f"{word!r} before {{}}", "read as a state and as 'contains'"),)
    return StateLine(state=word, ingredients=ingredients, remarks=remarks)


def _names(inside: str) -> tuple[tuple[str, ...], tuple[Remark, ...]]:
    """Return the names between two braces, and what is odd about them."""
    remarks: tuple[Remark, ...] = ()
    names = [name.strip() for name in inside.split(",")]
    ingredients = tuple(name for name in names if name)
    if len(ingredients) < len(names):
        remarks += (Remark(NoticeKind.EMPTY_NAME, f"an empty name in {{{inside}}}", "left out"),)
    if twice := [name for name, count in Counter(ingredients).items() if count > 1]:
        remarks += (Remark(NoticeKind.NAME_TWICE, f"more than once in {{}}: {', '.join(twice)}", "read once"),)
    return ingredients, remarks


_READERS = {"O": _object_line, "S": _state_line, "M": _motion_line}
