"""One line of a FOON text file at a time: what an ``O``, an ``S`` and a motion's verb say.

Nothing here knows of files or units. What is odd about a line is answered beside what was read, as remarks.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from foon_kg.loaders.notices import NoticeKind
from foon_kg.model import DISH_TYPES

_BRACKETED = re.compile(r"([^\[{]*)([\[{].*)")
_PLACE = re.compile(r"\[([^\[\]{}]*)\]")
_NAMES = re.compile(r"\{([^\[\]{}]*)\}")
RELATIONS = frozenset({"in", "on", "under", "with", "from", "over", "below", "attached", "attached to"})
"""Words that only ever say where something is; beside braces they still do."""


class BadLine(Exception):  # noqa: N818  # a signal between two modules, not an error that anyone sees
    """The line cannot be understood, so its unit cannot be."""

    def __init__(self, kind: NoticeKind, message: str) -> None:
        super().__init__(message)
        self.kind = kind
        self.message = message


@dataclass(frozen=True)
class Remark:
    """Something odd about a line and how it was read."""

    kind: NoticeKind
    message: str
    action: str


@dataclass(frozen=True)
class ObjectLine:
    """``O<TAB>label<TAB>flag[<TAB>class]``."""

    label: str
    moving: bool
    dish_type: str | None
    remarks: tuple[Remark, ...] = ()


@dataclass(frozen=True)
class StateLine:
    """``S<TAB>…``: at most one state, the names in braces, or a place (relation and container)."""

    state: str | None = None
    ingredients: tuple[str, ...] = ()
    place: tuple[str | None, str | None] | None = None
    remarks: tuple[Remark, ...] = ()


def fold(text: str) -> str:
    """Answer ``text`` without white space at its ends and with single blanks inside."""
    return " ".join(text.split())


def read_object_line(columns: list[str]) -> ObjectLine:
    """Read the columns after the ``O``. Raises ``BadLine`` where the object has no name."""
    label, flag, dish_class, *more = (*map(fold, columns), "", "", "")
    if not label:
        raise BadLine(NoticeKind.MISSING_NAME, "an object without a name")
    remarks = _flag_remarks(flag) + _extra_remarks(more)
    dish_type = None
    if dish_class:
        dish_type = _dish_type(dish_class)
        if dish_type is None:
            remarks.append(Remark(NoticeKind.ODD_CLASS, f"{dish_class!r} is no dish class (0-29)", "read as none"))
    return ObjectLine(label, flag.isdecimal() and flag.strip("0") != "", dish_type, tuple(remarks))


def _flag_remarks(flag: str) -> list[Remark]:
    if flag in {"0", "1"}:
        return []
    moving = flag.isdecimal() and flag.strip("0") != ""
    action = "read as 1, it moves" if moving else "read as 0, it does not move"
    return [Remark(NoticeKind.ODD_FLAG, f"the flag is {flag!r}, neither 0 nor 1", action)]


def _extra_remarks(columns: list[str]) -> list[Remark]:
    extra = [column for column in columns if column]
    if not extra:
        return []
    return [Remark(NoticeKind.EXTRA_COLUMN, f"a column too many: {extra[0]!r}", "left out")]


def _dish_type(number: str) -> str | None:
    known = number.isascii() and number.isdecimal() and len(number) <= 2 and int(number) < len(DISH_TYPES)  # noqa: PLR2004  # 0-29 has two digits
    return DISH_TYPES[int(number)] if known else None


def read_state_line(columns: list[str]) -> StateLine:
    """Read the columns after the ``S``. Raises ``BadLine`` where the brackets cannot be understood."""
    word, bracketed, *more = (*map(fold, columns), "", "")
    remarks = _extra_remarks(more)
    if not bracketed and (joined := _BRACKETED.fullmatch(word)):
        remarks.append(Remark(NoticeKind.MISSING_TAB, f"no tab in {word!r}", "read as if it were there"))
        word, bracketed = fold(joined[1]), joined[2]
    if not bracketed:
        return _bare_state(word, remarks, third_column=len(columns) > 1)
    if place := _PLACE.fullmatch(bracketed):
        return _place(word, fold(place[1]), remarks)
    if names := _NAMES.fullmatch(bracketed):
        return _names(word, names[1].split(","), remarks)
    raise BadLine(NoticeKind.BAD_BRACKETS, f"{bracketed!r} is neither [a place] nor {{names}}")


def _bare_state(word: str, remarks: list[Remark], *, third_column: bool) -> StateLine:
    if not word:
        remarks.append(Remark(NoticeKind.EMPTY_STATE, "a state line that says nothing", "left out"))
    elif third_column:
        remarks.append(
            Remark(NoticeKind.EMPTY_STATE_COLUMN, f"nothing after {word!r} and its tab", "read as a plain state")
        )
    return StateLine(state=word or None, remarks=tuple(remarks))


def _place(word: str, container: str, remarks: list[Remark]) -> StateLine:
    if not container:
        remarks.append(Remark(NoticeKind.EMPTY_PLACE, f"{word or 'a place'} [] names no place", "kept without one"))
    if word == "contains":
        remarks.append(Remark(NoticeKind.CONTAINS_PLACE, f"contains [{container}]", "read as the relation 'contains'"))
    return StateLine(place=(word or None, container or None), remarks=tuple(remarks))


def _names(word: str, names: list[str], remarks: list[Remark]) -> StateLine:
    if word in RELATIONS:
        remarks.append(
            Remark(NoticeKind.RELATION_WITH_BRACES, f"{word} {{{','.join(names)}}}", "read as a place in []")
        )
        return _place(word, fold(" ".join(names)), remarks)
    names = [fold(name) for name in names]
    ingredients = tuple(name for name in names if name)
    if len(ingredients) < len(names):
        remarks.append(Remark(NoticeKind.EMPTY_NAME, "an empty name in {}", "left out"))
    if twice := sorted({name for name in ingredients if ingredients.count(name) > 1}):
        remarks.append(Remark(NoticeKind.NAME_TWICE, f"twice in {{}}: {', '.join(twice)}", "read once"))
    state = _word_beside_braces(word, remarks)
    return StateLine(state=state, ingredients=ingredients, remarks=tuple(remarks))


def _word_beside_braces(word: str, remarks: list[Remark]) -> str | None:
    if word == "contains":
        return None
    if word in {"contain", ""}:
        remarks.append(Remark(NoticeKind.CONTAIN, f"{word!r} beside {{}}", "read as contains"))
        return None
    remarks.append(
        Remark(
            NoticeKind.STATE_WITH_BRACES, f"{word!r} beside {{}}", f"read as the state {word!r} and what it contains"
        )
    )
    return word
