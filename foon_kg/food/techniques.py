"""Techniques: how dishes of a family are put together whatever a video does (:data:`TABLES`).

Ways (``ways.toml``) are of the same form: what one word of a name changes of what a video does.

A technique has lines of stages, written as ``stage as label @ vessel < lines: foods``. What each of these may say
stands at the head of the table.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from foon_kg.food.lists import names_in, word_list
from foon_kg.food.rows import Food
from foon_kg.food.shipped import shipped
from foon_kg.food.words import any_is_told, any_stands_in, singular_word, words
from foon_kg.model.values import made_often

_STEP = re.compile(
    r"(?P<optional>\??)(?P<stage>[^@<:]+?)(?: as (?P<label>[^@<:]+?))?(?: ?@ ?(?P<vessel>[^<:]+?))?"
    r"(?: ?< ?(?P<lines>[^:]+?))?(?: ?: ?(?P<foods>.+))?$"
)
_FOODS = re.compile(r"(?P<again>\+?)(?P<terms>[^=>]+)(?:=(?P<state>[^>]+))?(?:>(?P<made>.+))?$")

TABLES = (
    "steamed", "regional", "vegetables", "eggs", "handheld", "morsels", "cold", "pies", "sauces", "drinks",
    "flesh", "savoury", "techniques", "methods", "grains", "kinds",
)  # fmt: skip
"""The documents with rows of techniques, in the order in which these are tried."""


_MARKS = frozenset("!%#^@*")
"""With what terms begin that are more than a kind, a trait or a name."""


@made_often()
class Around:
    """Among which ``foods`` a food is asked, and by which words of a title (``told``)."""

    foods: Sequence[Food] = ()
    told: Sequence[str] = ()


NOWHERE = Around()
"""A food that is asked by itself: no other is there, and no title."""


@dataclass(frozen=True)
class Foods:
    """Which foods are meant: those for which all of ``terms`` hold, in ``state`` if one is said.

    Several states, or what a food must not be, are written as ``raw&!in pieces``.
    ``again``: a second portion of them, beside the one that joins elsewhere. ``made``: how they are prepared for it.
    """

    terms: tuple[str, ...]
    state: str = ""
    made: str = ""
    again: bool = False

    @classmethod
    def read(cls, text: str) -> Foods:
        """Return the foods that a text of the table means; raises ValueError where it is not of the form."""
        found = _FOODS.fullmatch(text.strip())
        if found is None:
            raise ValueError(f"“{text}” names no foods")
        terms = tuple(map(_term, found["terms"].split("&")))
        return cls(terms, (found["state"] or "").strip(), (found["made"] or "").strip(), bool(found["again"]))

    @property
    def is_rest(self) -> bool:
        """Whether all foods are meant that join nowhere else."""
        return self.terms == ("*",)

    def mean(self, label: str, facts: Food, states: Collection[str], around: Around = NOWHERE) -> bool:
        """Return whether a food is meant: it is called ``label``, and in ``states``, beside what is ``around`` it.

        ``facts`` are what the table of foods says of it.
        """
        return self.names(label, facts, around) and self.suits(states)

    def names(self, label: str, facts: Food, around: Around = NOWHERE) -> bool:
        """Return whether a food is one that is meant, in whatever state: by its ``label``, ``facts`` and ``around``."""
        for term in self.terms:  # asked some hundred times a plan
            if not (_holds(term, label, facts, around) if term[0] in _MARKS else _is_of(term, facts)):
                return False
        return True

    def suits(self, states: Collection[str]) -> bool:
        """Return whether ``states`` are those in which a food is meant."""
        return not self.state or all(is_so(state, states) for state in self.state.split("&"))


def _term(text: str) -> str:
    """Return a term as it is compared: a word of a label (``#``) in the singular, as labels are read."""
    marks, is_word, word = text.strip().partition("#")
    return f"{marks}#{singular_word(word)}" if is_word else marks


def is_so(state: str, states: Collection[str]) -> bool:
    """Return whether what a row asks for is among ``states``; with a ``!`` before it, whether it is not."""
    return state[1:] not in states if state.startswith("!") else state in states


def _holds(term: str, label: str, facts: Food, around: Around) -> bool:
    """Whether a food is what one term means: the marks before it are those of ``techniques.toml``, which says each.

    ``!`` not, ``%`` another food, ``#`` a word of the label, ``^`` the title, ``@`` a list, ``*`` any food; else it is
    a kind, a trait or a name.
    """
    mark, rest = term[0], term[1:]
    if mark == "!":
        return not _holds(rest, label, facts, around)
    if mark == "%":
        return any(one is not facts and _holds(rest, one.name, one, around) for one in around.foods)
    if mark == "#":
        return rest in words(label)
    if term == "^":
        return not set(words(label)).isdisjoint(around.told)
    if mark == "@":
        return facts.is_any(word_list(rest))
    return term == "*" or _is_of(term, facts)


def _is_of(term: str, facts: Food) -> bool:
    """Whether a food is of the kind, the trait or the name of a term without a mark."""
    return facts.is_of(term.removeprefix("kind:")) if term.startswith("kind:") else facts.is_a(term)


@dataclass(frozen=True)
class Part:
    """One stage of a technique: which row of the stages, what the whole is called then, in what, and what joins.

    ``optional``: it is left out where no food joins there.
    """

    stage: str
    label: str
    vessel: str
    lines: tuple[str, ...]
    foods: tuple[Foods, ...]
    optional: bool = False

    @classmethod
    def read(cls, text: str) -> Part:
        """Return the stage that a text of the table means; raises ValueError where it is not of the form."""
        found = _STEP.fullmatch(text)
        if found is None:
            raise ValueError(f"“{text}” is no stage of a technique")
        lines = tuple(line.strip() for line in (found["lines"] or "").split(",") if line.strip())
        foods = tuple(map(Foods.read, found["foods"].split(","))) if found["foods"] else ()
        return cls(
            found["stage"], found["label"] or "", found["vessel"] or "", lines, foods, optional=bool(found["optional"])
        )


@dataclass(frozen=True)
class Work:
    """What is done at a stage: the fields of a stage of a frame.

    ``states`` are what the whole is then, where the FOON shows several for its motion. ``phased``: foods join in the
    order of what they are. ``on_top``: what joins only lies on it. ``bath``: it is done in water that is poured off.
    ``always``: it is done even to one food that needs no work.
    ``lifts``: flesh is lifted out of the rest; ``rejoins``: that comes to it again. ``thins``: what is dry gets water
    there, unless something liquid is asked. ``over`` is in what water boils under the vessel, which stands above it.
    """

    motion: str = ""
    does: frozenset[str] = frozenset()
    tools: tuple[str, ...] = ()
    vessel: str = ""
    relation: str = "in"
    appliance: str = ""
    source: str = ""
    label: str = ""
    states: tuple[str, ...] = ()
    phased: bool = False
    on_top: bool = False
    bath: bool = False
    always: bool = False
    lifts: bool = False
    rejoins: bool = False
    thins: bool = False
    over: str = ""


@dataclass(frozen=True)
class Technique:
    """How dishes are made that are ``called`` so and have, of each of ``needs``, one food, and none of ``without``.

    ``types`` are the dish types that it is for (none: any), ``or_types`` those of which a dish needs no such name.
    Even there ``called`` counts: a video of what is called so teaches it instead, and a row without names takes
    components beside it.
    ``lines`` are stages by the name of their line; the last one makes the dish. ``plan`` are wishes for the whole: one
    pot, cold. Of each of ``one`` exactly one food is there. ``dishes`` and ``video`` are what holds of the dish and of
    what its video does, or with a ``!`` what does not.
    """

    name: str
    called: tuple[tuple[str, ...], ...]
    never: tuple[tuple[str, ...], ...]
    types: frozenset[str]
    needs: tuple[tuple[Foods, ...], ...]
    without: tuple[Foods, ...]
    lines: Mapping[str, tuple[Part, ...]]
    plan: frozenset[str]
    or_types: frozenset[str] = frozenset()
    one: tuple[Foods, ...] = ()
    dishes: frozenset[str] = frozenset()
    video: frozenset[str] = frozenset()

    def is_called(self, dish_type: str, told: Sequence[str]) -> bool:
        """Return whether a dish of ``dish_type``, whose title has the words ``told`` in this order, is called so."""
        if dish_type not in self.or_types:
            if self.types and dish_type not in self.types:
                return False
            if self.called and not any_is_told(self.called, told):
                return False
        return not self.is_never(told)

    def is_never(self, told: Sequence[str]) -> bool:
        """Return whether the words ``told`` of a title have a name in them by which no such dish is called."""
        return any_stands_in(self.never, told)


def techniques() -> tuple[Technique, ...]:
    """Return every technique in the order of the tables: the first that suits a dish is taken."""
    return tuple(map(_technique_at, range(len(_technique_rows()))))


def techniques_called(dish_type: str, told: Iterable[str]) -> Iterator[Technique]:
    """Yield the techniques by whose names a dish of ``dish_type``, whose title has the words ``told``, may be called.

    They are in the order of the tables. A title has the first word of few of their names, so few are read.
    """
    by_word, by_type, nameless = _by_first_words()
    found = {*nameless, *by_type.get(dish_type, ()), *(place for word in told for place in by_word.get(word, ()))}
    return map(_technique_at, sorted(found))


@cache
def _technique_rows() -> tuple[tuple[str, Mapping[str, Any]], ...]:
    """Return the name and the row of every technique, in the order of the tables.

    Raises ValueError for lines that belong to no row.
    """
    rows = tuple(row for table in TABLES for row in shipped(table)["techniques"].items())
    bare = [name for name, row in rows if row.keys() <= {"lines"} or "lines" not in row]
    if bare:  # it would hold of every dish
        raise ValueError(f"{bare[0]!r} has lines and no row, or a row and no lines")
    return rows


@cache
def _technique_at(place: int) -> Technique:
    return technique_of(*_technique_rows()[place])


@cache
def _by_first_words() -> tuple[Mapping[str, list[int]], Mapping[str, list[int]], list[int]]:
    """Return the places of techniques by the first words of names, by types that need no name, and of the rest."""
    by_word: defaultdict[str, list[int]] = defaultdict(list)
    by_type: defaultdict[str, list[int]] = defaultdict(list)
    nameless = []
    for place, (_, row) in enumerate(_technique_rows()):
        called = all_names(row, "called")
        for word in {name[0] for name in called}:
            by_word[word].append(place)
        unnamed = () if called else row.get("types", ())
        for dish_type in (*row.get("or_types", ()), *unnamed):
            by_type[dish_type].append(place)
        if not called and not unnamed:
            nameless.append(place)
    return dict(by_word), dict(by_type), nameless


@cache
def ways(when: str = "ways") -> tuple[Technique, ...]:
    """Return what words of a name change of what a video does, in the order of the table ``when`` of ``ways.toml``."""
    return tuple(technique_of(name, row) for name, row in shipped("ways")[when].items())


@cache
def works() -> Mapping[str, Work]:
    """Return what is done at each stage, by its name."""
    return {name: _work(row) for name, row in shipped("techniques")["stages"].items()}


@cache
def preparations() -> Mapping[str, Mapping[str, Any]]:
    """Return how a food is prepared for a technique, by the word for it."""
    rows: Mapping[str, Mapping[str, Any]] = shipped("techniques")["preparations"]
    return rows


@dataclass(frozen=True)
class Component:
    """A part of a dish with a place of its own: how it is made (``technique``), and where it joins what else is made.

    Its foods are those of which a recipe says that they are for one of ``parts``; else, where the dish is called so and
    the component is ``guessed`` from that, the last of ``body``. With them come those of ``neighbours`` that are listed
    beside them. Else they are listed after all of ``after`` around one of ``again`` that was listed before. None of
    them is one of ``lacks``; ``beside`` are foods of which each list leaves one for the rest. ``at`` is where it joins,
    ``by`` the stage at which it does. ``leaves`` are no part of it, though listed under its heading: pasta behind what
    is for the sauce. ``yields``: it is guessed of no food that the technique of the dish names itself.
    """

    technique: Technique
    parts: frozenset[str]
    body: tuple[Foods, ...]
    neighbours: tuple[Foods, ...]
    beside: tuple[tuple[Foods, ...], ...]
    at: str
    by: str
    guessed: bool
    again: tuple[Foods, ...] = ()
    after: tuple[Foods, ...] = ()
    behind: bool = False
    opens: bool = False
    lacks: tuple[Foods, ...] = ()
    leaves: tuple[Foods, ...] = ()
    yields: bool = False

    @property
    def is_sought(self) -> bool:
        """Whether it may be there though the recipe says of no food that it is for it."""
        return self.guessed or self.behind or bool(self.again)


def components_for(parts: Collection[str]) -> tuple[Component, ...]:
    """Return the components that a recipe may have that names ``parts``: most have to be named."""
    return components() if parts else _components_sought()


@cache
def _components_sought() -> tuple[Component, ...]:
    return tuple(component for component in components() if component.is_sought)


@cache
def components() -> tuple[Component, ...]:
    """Return every component in the order of its table: a food belongs to the first that takes it."""
    return tuple(
        Component(
            technique_of(name, {"lines": {}, **row}),
            frozenset(row.get("parts", ())),
            tuple(map(Foods.read, row.get("body", ()))),
            tuple(map(Foods.read, row.get("neighbours", ()))),
            tuple(tuple(map(Foods.read, need)) for need in row.get("beside", ())),
            row["at"],
            row["by"],
            "called" in row,
            tuple(map(Foods.read, row.get("again", ()))),
            tuple(map(Foods.read, row.get("after", ()))),
            row.get("behind", False),
            row.get("opens", False),
            tuple(map(Foods.read, row.get("lacks", ()))),
            tuple(map(Foods.read, row.get("leaves", ()))),
            row.get("yields", False),
        )
        for name, row in shipped("components")["components"].items()
    )


def _work(row: Mapping[str, Any]) -> Work:
    lists = {"does": frozenset(row.get("does", ())), "tools": tuple(row.get("tools", ()))}
    return Work(**{**row, **lists, "states": tuple(row.get("states", ()))})


def technique_of(name: str, row: Mapping[str, Any]) -> Technique:
    """Return the technique that a ``row`` of a table, called ``name``, says."""
    return Technique(
        name,
        all_names(row, "called"),
        all_names(row, "never"),
        frozenset(row.get("types", ())),
        tuple(tuple(map(Foods.read, need)) for need in row.get("needs", ())),
        tuple(map(Foods.read, row.get("without", ()))),
        {line: tuple(map(Part.read, parts)) for line, parts in row["lines"].items()},
        frozenset(row.get("plan", ())),
        frozenset(row.get("or_types", ())),
        tuple(map(Foods.read, row.get("one", ()))),
        frozenset(row.get("dishes", ())),
        frozenset(row.get("video", ())),
    )


def all_names(row: Mapping[str, Any], field: str) -> tuple[tuple[str, ...], ...]:
    """Return the names in a ``field`` of a ``row`` as their words: "@list" stands for all of a list."""
    return tuple(name for one in row.get(field, ()) for name in _names(one))


def _names(text: str) -> list[tuple[str, ...]]:
    """Return the names that a text of the table stands for: itself, or all of a list."""
    return [tuple(one.split()) for one in sorted(names_in(text[1:]))] if text.startswith("@") else [tuple(words(text))]
