"""Makes a question such that a server can end it: each turn of a list expression asks whether there is still time.

Neo4j ends a question between two rows, or where one looks at the graph. A list expression (``reduce``, ``any``, ``[x IN
… | …]``) does neither, however long it takes. So what it does in each turn is put behind a look that costs next to
nothing: how many nodes there are is a number that Neo4j keeps. What the question means stays as it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

from foon_kg.store.graph.patterns import bounded_texts
from foon_kg.store.graph.question_words import CLOSED, OPEN, Around, Token, put_around, too_much

_JUDGING = {"any", "all", "none", "single"}
_REDUCING = {"reduce", "allreduce"}
_LOOK, _LOOKED = "CASE WHEN COUNT { MATCH () } >= 0 THEN ", " END"
_ASIDE = "(:Foon)"
"""The nodes that are counted where some may be made: of these nobody makes any while a FOON is there."""


@dataclass(frozen=True)
class _Bracket:
    """Two brackets and the places of what is in them and in none within."""

    opened: int
    closed: int
    own: tuple[int, ...]


def interruptible(
    pieces: Sequence[Token], parameters: Mapping[str, Any] | None = None, *, writing: bool = False
) -> str:
    """Return the text of a question whose list expressions can be ended at each turn, and which means the same.

    A text that is held against a pattern may not be longer than that pattern bears (:mod:`patterns`). ``pieces`` are
    all its pieces, spaces too, asked with ``parameters``; ``writing`` says that it may make nodes. Raises GraphError
    where a label could be read as what is done in a turn.

    >>> from foon_kg.store.graph.question_words import read_pieces
    >>> interruptible(read_pieces("RETURN [x IN [1, 2] | x + 1]"))
    'RETURN [x IN [1, 2] | CASE WHEN COUNT { MATCH () } >= 0 THEN  x + 1 END]'
    """
    turns = [one for it in _brackets(pieces) for one in (*_turns(pieces, it), *_long_range(pieces, it))]
    if writing:
        turns = [
            replace(one, begins=one.begins.replace("()", _ASIDE), ends=one.ends.replace("()", _ASIDE)) for one in turns
        ]
    return put_around(pieces, (*turns, *bounded_texts(pieces, parameters or {})))


def _brackets(pieces: Sequence[Token]) -> Iterator[_Bracket]:
    """Return the brackets that are closed, those within others first."""
    open_ones: list[tuple[int, list[int]]] = [(-1, [])]
    for place, piece in enumerate(pieces):
        if piece.kind == "space":
            continue
        if piece.text in CLOSED and len(open_ones) > 1:
            opened, own = open_ones.pop()
            yield _Bracket(opened, place, tuple(own))
        open_ones[-1][1].append(place)
        if piece.text in OPEN:
            open_ones.append((place, []))


def _turns(pieces: Sequence[Token], bracket: _Bracket) -> Iterator[Around]:
    """Return what makes the list expression in a bracket one that can be ended; nothing where there is none."""
    caller = _caller(pieces, bracket)
    own = _list_expression(pieces, bracket, caller)
    if not own:
        return
    where = next((place for place in own[2:] if pieces[place].lower == "where"), None)
    bar = _bar(pieces, own)
    if where:
        condition_ends = bracket.closed if caller in _JUDGING or bar is None else bar
        yield _condition(pieces, own, where, condition_ends)
    elif bar:
        yield _result(pieces, own, bar, bracket.closed)


def _result(pieces: Sequence[Token], own: Sequence[int], bar: int, closed: int) -> Around:
    """Return what is put around what stands behind the bar of ``[x IN … | …]``, up to a comma or what is ``closed``."""
    if any(pieces[place].text == ":" and place < bar for place in own):
        raise too_much("a label stands bare in a list expression", hint="Put it into brackets: (n:A|B).")
    return _looked(bar, next((place for place in own if place > bar and pieces[place].text == ","), closed))


def _list_expression(pieces: Sequence[Token], bracket: _Bracket, caller: str) -> Sequence[int]:
    """Return the places of ``x IN …`` in a bracket, without what ``reduce`` has before it; none where it is no such."""
    own = bracket.own
    if caller in _REDUCING:
        comma = next((n for n, place in enumerate(own) if pieces[place].text == ","), len(own))
        own = own[comma + 1 :]
    elif pieces[bracket.opened].text != "[" and caller not in _JUDGING:
        return ()
    if len(own) < 2 or not pieces[own[0]].name or pieces[own[1]].lower != "in":  # noqa: PLR2004 - a name, and IN
        return ()
    return own


def _looked(after: int, until: int) -> Around:
    return Around(after + 1, f" {_LOOK}", until - 1, _LOOKED)


def _condition(pieces: Sequence[Token], own: Sequence[int], where: int, until: int) -> Around:
    """Return what is put around the condition of ``[x IN … WHERE …]`` or ``any(x IN … WHERE …)``, or around its list.

    The list, where a label's bar could be the one after the condition, and where there is a pattern: that may stand in
    no CASE, and looks at the graph by itself.
    """
    said = [piece.text for piece in pieces[where:until] if piece.kind != "space"]
    pattern = any(one == "-" and other in {"-", "[", ">"} for one, other in pairwise(said))
    label = pieces[until].text == "|" and any(pieces[place].text == ":" for place in own if place > where)
    if pattern or label:
        name = pieces[own[0]].text
        return Around(own[1] + 1, f" [{name} IN ", where - 1, f" | {_LOOK}{name}{_LOOKED}] ")
    return _looked(where, until)


def _bar(pieces: Sequence[Token], own: Sequence[int]) -> int | None:
    """Return the place of the first bar that is no half of ``||``."""
    for place in own:
        if pieces[place].text == "|" and "|" not in {pieces[place - 1].text, pieces[place + 1].text}:
            return place
    return None


def _long_range(pieces: Sequence[Token], bracket: _Bracket) -> Iterator[Around]:
    """Return what is put around a range of which nobody knows how long it is: rows it may give, a list is made of it.

    Nothing else bounds it: a range takes no memory, and to look for a number in it any time.
    """
    if _caller(pieces, bracket) != "range" or all(_is_known(pieces[place]) for place in bracket.own):
        return
    word = _before(pieces, bracket.opened)
    if pieces[max(_before(pieces, word), 0)].lower != "unwind":
        yield Around(word, "[i IN ", bracket.closed, f" | {_LOOK}i{_LOOKED}]")


def _is_known(piece: Token) -> bool:
    return piece.kind == "number" or piece.text in {",", "-"}


def _caller(pieces: Sequence[Token], bracket: _Bracket) -> str:
    """Return the word before a round bracket."""
    place = _before(pieces, bracket.opened)
    return pieces[place].lower if place >= 0 and pieces[bracket.opened].text == "(" else ""


def _before(pieces: Sequence[Token], place: int) -> int:
    """Return the place of what stands before, spaces aside; -1 where nothing does."""
    return next((n for n in range(place - 1, -1, -1) if pieces[n].kind != "space"), -1)
