"""The table of foods: the kind of a food is a function of its name *and* its states."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from foon_kg.food.lists import word_list
from foon_kg.food.rows import Food, Kind, Level, Match
from foon_kg.food.shipped import shipped
from foon_kg.food.words import plain_words, singular
from foon_kg.model.names import without_accents

UNKNOWN = Kind("unknown", "Nothing is known of it.", sold_in="packet")
_NOT_FOUND = (UNKNOWN.name, "", Match.UNKNOWN)
_PACKED, _SLICED = "canned", "sliced"

_WITH_BONES = re.compile(r"\b(?:bone|skin)[- ](?:in|on)\b,? ?| (?:on|off) the bone\b", re.IGNORECASE)

MOST_LOOKED_UP = 1 << 15
"""So many names, states and motions are remembered with what the tables say of them."""

_MORE = frozenset({"for", "with"})
"""After these words a name says no more what the food is."""

_OUT_OF = frozenset({"from", "off"})
"""Before these words stands what came of another food: fat from the roast is no roast."""

_LEFT_OF_COOKING = frozenset({"fat", "water"})
"""Traits of what comes of another food in the heat; meat from a crab is crab, and juice of a lemon is lemon."""

_TELLS_HOW_BOUGHT = word_list("tells by a name how it is bought")
"""So a name says that a food is no raw one, where no table has that name."""

_OF = frozenset({"al", "alla", "au", "aux", "com", "con", "d", "da", "de", "del", "des", "di", "do", "du", "em", "en"})
"""Before these words names of other languages say what the food is: caldo de pollo is no chicken."""


@dataclass(frozen=True, eq=False)
class FoodTable:
    """Kinds by name, the kind of every name, endings (``berry`` of ``*berry``), homonyms, exceptions and plurals."""

    kinds: Mapping[str, Kind]
    kind_of: Mapping[str, str]
    endings: tuple[tuple[str, str], ...]
    homonyms: Mapping[str, tuple[tuple[str, str], ...]]
    exceptions: Mapping[str, Mapping[str, object]]
    plurals: Mapping[str, str] = field(default_factory=dict)
    _known: dict[tuple[str, tuple[str, ...]], Food] = field(default_factory=dict)
    _found: dict[str, tuple[str, str, Match]] = field(default_factory=dict)

    def food(self, label: str, states: Iterable[str] = ()) -> Food:
        """Return what is known of the food ``label`` in ``states``; of the kind ``unknown`` where nothing is."""
        key = (label, tuple(states))
        if key not in self._known:
            make_room(self._known)
            self._known[key] = replace(self._food(self._in_singular(label), key[1]), name=singular(label))
        return self._known[key]

    def as_measured(self, label: str, measures: Iterable[str]) -> str:
        """Return the state that ``measures`` say of ``label``: canned of a can, sliced of slices; else ``""``."""
        said = frozenset(measures)
        for measured, states in (
            ("measures what is canned", {_PACKED}),
            ("measures what is sliced", {_SLICED}),
            ("measures what grows", word_list("grows so")),
        ):
            if said & word_list(measured):
                kind = self.food(label).kind
                return next((state for state in sorted(states) if self.food(label, [state]).kind != kind), "")
        return ""

    def as_spooned(self, label: str, measures: Iterable[str]) -> str:
        """Return "ground" of a spice, ``label``, that a teaspoon ``measures``, as nobody fills one with whole ones.

        ``""`` of any other food or measure.
        """
        spooned = not word_list("measures what is ground").isdisjoint(measures)
        return "ground" if spooned and singular(label) in word_list("is ground in a spoon") else ""

    def find(self, label: str) -> tuple[str, str, Match]:
        """Return the kind of ``label``, the name of the table that it was found as, and how: the longest phrase."""
        name = self._in_singular(label)
        if name not in self._found:
            make_room(self._found)
            self._found[name] = self._find(name)
        return self._found[name]

    def is_listed(self, label: str) -> bool:
        """Return whether the table has ``label`` itself, in the singular or the plural, or as another name."""
        name = singular(label)
        return name in self.kind_of or name in self.called

    @cached_property
    def called(self) -> Mapping[str, str]:
        """The listed food that is meant by each of its other names (fabes, birote): they only add to ``kind_of``."""
        rows: Mapping[str, Sequence[str]] = shipped("names")["names"]
        return {name: meant for meant, names in rows.items() for name in names}

    def broader(self, kind: str) -> frozenset[str]:
        """Return a kind with all kinds that it is of."""
        found, waiting = {kind}, [kind]
        while waiting:
            fresh = [name for name in self.kinds.get(waiting.pop(), UNKNOWN).of if name not in found]
            found.update(fresh)
            waiting += fresh
        return frozenset(found)

    def _food(self, name: str, states: tuple[str, ...]) -> Food:
        told = self._told_by_name(name)
        if told is not None:
            return replace(self._food(told[0], (*states, told[1])), name=name)
        kind, taken_for, match = self.find(self._meant(name, states))
        row = self.kinds.get(kind, UNKNOWN)
        special = self.exceptions.get(taken_for, {})
        when = {**row.when, **_texts(special.get("when"))}
        moved = next((kind for state, kind in when.items() if _is_among(state, states)), None)
        if moved is not None:
            row, special = self.kinds.get(moved, UNKNOWN), {}
        traits = special.get("traits")
        return Food(
            name,
            row.name,
            self.broader(row.name),
            _levels(special["owes"]) if "owes" in special else row.owes,
            frozenset(map(str, traits)) if isinstance(traits, list) else row.traits,
            str(special.get("sold_in", row.sold_in)),
            str(special.get("sold_as", row.sold_as)),
            match,
            taken_for,
            "" if moved is None else _no_more(kind, row),
        )

    def _told_by_name(self, name: str) -> tuple[str, str] | None:
        """Return a ``name`` without the words that say how the food is bought, and that state; ``None`` without any.

        That is tuna in water, peaches in syrup, leftover brisket. Names of the table mean what they say there.
        """
        main, _, packed = name.partition(" in ")
        main = main.removesuffix(" packed")
        if packed and name not in self.kind_of and self.find(main)[2] in {Match.NAME, Match.HEAD}:
            return main, _PACKED
        own = [] if self.is_listed(name) else name.split()
        rest = " ".join(word for word in own if word not in _TELLS_HOW_BOUGHT)
        state = next((said for word in own if self._is_changed(rest, said := _as_bought(word))), "")
        return (rest, state) if state else None

    def _is_changed(self, name: str, state: str) -> bool:
        """Whether the food ``name`` is another one when it is bought in this ``state``."""
        if not name or state not in _TELLS_HOW_BOUGHT:
            return False
        kind, taken_for, _ = self.find(name)
        special = _texts(self.exceptions.get(taken_for, {}).get("when"))
        another = self._meant(name, (state,)) != self._meant(name, ())
        return another or state in self.kinds.get(kind, UNKNOWN).when or state in special

    def _meant(self, name: str, states: Sequence[str]) -> str:
        """Return which of the foods called ``name`` one in these ``states`` is."""
        if name not in self.kind_of:
            name = self.called.get(name, name)
        return next((other for state, other in self.homonyms.get(name, ()) if _is_among(state, states)), name)

    def _in_singular(self, label: str) -> str:
        """Return ``label`` as the table has it: in the singular, unless its plural means another food there."""
        plain = as_in_the_table(label)
        name = singular(plain)
        other = self.plurals.get(plain.lower().rpartition(" ")[2], "")
        if not other or name in self.kind_of or " " not in name:
            return name
        return f"{name.rpartition(' ')[0]} {other}"

    def _find(self, name: str) -> tuple[str, str, Match]:
        # the last words before the ending, and any other words last: English names a food by its last noun
        own = name.split()
        listed = self._listed(name, Match.NAME)
        if listed:
            return listed
        if more := _before(own, _MORE):  # tomatoes with green chilies are tomatoes, pastry for a pie is pastry
            return self._find(" ".join(more))
        if rest := _before(own, _OUT_OF):
            left = self._find(" ".join(rest))
            if not self.kinds.get(left[0], UNKNOWN).traits.isdisjoint(_LEFT_OF_COOKING):
                return left
        found = self._listed_among(_heads(own), Match.HEAD)
        return found or self._by_ending(own) or self._listed_among(_phrases(own), Match.PART) or _NOT_FOUND

    def _listed_among(self, phrases: Iterable[Sequence[str]], match: Match) -> tuple[str, str, Match] | None:
        """Return the kind of the first of ``phrases`` that a kind has among its words."""
        return next((found for phrase in phrases if (found := self._listed(" ".join(phrase), match))), None)

    def _listed(self, name: str, match: Match) -> tuple[str, str, Match] | None:
        """Return the kind of ``name``, and as what it is listed; ``None`` where it is not."""
        kind = self.kind_of.get(name)
        if kind is not None:
            return kind, name, match
        meant = self.called.get(name)
        return None if meant is None else (self.kind_of[meant], meant, match)

    def _by_ending(self, own: Sequence[str]) -> tuple[str, str, Match] | None:
        """Return the kind of foods whose last word ends so (*berry*)."""
        found = ((kind, ending, Match.SUFFIX) for ending, kind in self.endings if own and own[-1].endswith(ending))
        return next(found, None)


def _before(own: Sequence[str], ends: Collection[str]) -> Sequence[str]:
    """Return the words of a name in front of the first of ``ends`` in it; none where none is."""
    return own[: next((place for place, word in enumerate(own) if place and word in ends), 0)]


def _heads(own: Sequence[str]) -> Iterator[Sequence[str]]:
    """Yield the words at the end of a name, the longer phrases first; what stands before an "of" ends a name, too."""
    of = len(_before(own, _OF))
    for start in range(1, of + 1):
        yield own[start:]
    for start in range(of):
        yield own[start:of]
    for start in range(of + 1, len(own)):
        yield own[start:]


def _phrases(own: Sequence[str]) -> Iterator[Sequence[str]]:
    """Yield the words in a row of a name, the longer phrases first, without the whole name."""
    for length in range(len(own) - 1, 0, -1):
        for start in range(len(own) - length):
            yield own[start : start + length]


def _no_more(kind: str, now: Kind) -> str:
    """Return the ``kind`` of a name that a food is no more, in a state in which it is of the kind ``now``."""
    return "" if now.traits.isdisjoint(word_list("is no longer the food it was made of")) else kind


def make_room(kept: dict[Any, Any]) -> None:
    """Empty ``kept`` once too much was looked up: names come from strangers, and never end."""
    if len(kept) >= MOST_LOOKED_UP:
        kept.clear()


def as_in_the_table(label: str) -> str:
    """Return a label as the table has it: without brackets, without accents (pâté), without its bone-in or skin-on."""
    return without_accents(_WITH_BONES.sub("", label.partition(" (")[0]) or label)


def _as_bought(word: str) -> str:
    """Return as what state a ``word`` of a name counts: what is cooked by its name is as good as left over."""
    return "leftover" if word in word_list("is cooked by its name") else word


def _is_state(asked: str, state: str) -> bool:
    return asked == state.lower() or frozenset(asked.split()) <= plain_words(state)


def _is_among(asked: str, states: Iterable[str]) -> bool:
    """Return whether one of ``states`` is the state ``asked`` for, or has all its words."""
    return any(_is_state(asked, state) for state in states)


def _levels(owes: object) -> Mapping[str, Level]:
    return {name: Level(str(level)) for name, level in owes.items()} if isinstance(owes, Mapping) else {}


def _texts(value: object) -> Mapping[str, str]:
    return {str(name): str(text) for name, text in value.items()} if isinstance(value, Mapping) else {}
