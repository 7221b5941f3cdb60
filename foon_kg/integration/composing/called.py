"""A dish whose name says how its parts come together is made so, whatever its video does.

The order of the steps is that of a kitchen, and each finds what those before it have left: what is put on a dish and
what is baked at last are known before its kind is asked, and that before what lies beside it or cooks in its pot.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from foon_kg.food import Tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.named import Named
from foon_kg.food.rows import Dish
from foon_kg.food.techniques import Technique
from foon_kg.integration.composing.attaching import with_sides
from foon_kg.integration.composing.coated import coated_alone
from foon_kg.integration.composing.components import Side
from foon_kg.integration.composing.folded import folded, is_folded
from foon_kg.integration.composing.formed import formed, formed_within, is_formed
from foon_kg.integration.composing.glasses import for_many, garnished, is_heated, stirred
from foon_kg.integration.composing.marinated import marinated
from foon_kg.integration.composing.named import as_named
from foon_kg.integration.composing.parts import Part, baked_at_last, with_parts
from foon_kg.integration.composing.pots import fat_in_the_heat, is_never_heated, unheated, unmixed
from foon_kg.integration.composing.poured_over import dressed_apart
from foon_kg.integration.composing.pureed import blended_when_done, is_stewed, stewed
from foon_kg.integration.composing.stacked import cooked_apart
from foon_kg.integration.composing.swelling import boiled_there, is_eaten_with_its_bath, is_soaked_up
from foon_kg.integration.composing.techniques import as_a_way_says, carried_out
from foon_kg.integration.composing.thickened import sauce_apart
from foon_kg.integration.composing.toppings import strewn_under, wedges_last
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.teaching.frames import Line


@dataclass(frozen=True)
class Called:
    """What a dish is called: the ``dishes`` of that name, ``name_words`` (of type and title), its recorded ``goal``.

    ``tin`` is what its batter or dough is baked in. ``baked``: the words say that it comes out of an oven; ``folded``
    are those by which it may be folded over. ``warms`` and ``blends``: this FOON shows how a drink is heated, and
    blended. ``technique``: how it is made whatever its video does, ``sides`` are its components. ``asks`` is what its
    title asks to be done, with the words that do.
    """

    dishes: Sequence[Dish]
    name_words: frozenset[str]
    goal: str
    title: str
    dish_type: str
    tin: str
    baked: bool
    folded: Collection[str]
    warms: bool
    blends: bool
    technique: Technique | None = None
    sides: Sequence[Side] = ()
    asks: Sequence[tuple[Named, str]] = ()

    @cached_property
    def words(self) -> tuple[str, ...]:
        """The words of its type, and those of its title in their order."""
        title = words(self.title)
        return (*sorted(self.name_words.difference(title)), *title)

    def has(self, name: str) -> bool:
        """Return whether what ``name`` says holds of one of its dishes: a field of :class:`~foon_kg.food.rows.Dish`."""
        return any(getattr(dish, name) for dish in self.dishes)

    @property
    def boils(self) -> bool:
        """Whether it is a soup or the like: all of it boils in one pot, and is eaten with that."""
        return says(self.name_words, "boils in the dish")

    @property
    def in_glass(self) -> bool:
        """Whether it is a drink."""
        return self.dish_type in word_list("is drunk")


class Arranged(NamedTuple):
    """How a dish is made: its line, where the foods join, and whether what is boiled in it is eaten with the rest."""

    line: Line
    joins: tuple[Join, ...]
    one_pot: bool


def arranged(line: Line, joins: Sequence[Join], parts: Sequence[Part], called: Called, known: Tables) -> Arranged:
    """Return how a dish is made: by the technique that it is ``called`` by, else after ``line`` as its name changes it.

    Its components and ``parts`` are made beside that and join it with ``joins``; what its title asks for besides is
    done at a stage of its own. ``known`` are the tables.
    """
    made = _arranged(line, joins, parts, called, known)
    line, joins = marinated(made.line, made.joins, called.technique)
    line, joins = with_sides(line, joins, called.sides, words(called.title), known)
    line, joins = as_named(line, joins, [one for one, _ in called.asks], known)
    if called.in_glass:
        line, joins = for_many(line, joins, words(called.title))
    return Arranged(line, joins, made.one_pot)


def _arranged(line: Line, joins: Sequence[Join], parts: Sequence[Part], called: Called, known: Tables) -> Arranged:
    """Return how a dish is made without its components; see :func:`arranged` for the arguments."""
    if called.technique is not None:
        title_words = words(called.title)
        line, found = carried_out(called.technique, joins, title_words, known)
        return Arranged(line, found, "one pot" in called.technique.plan or is_soaked_up(found, title_words))
    line, joins = with_parts(line, joins, parts, called.tin)
    line, joins = baked_at_last(line, joins, called.title)
    made, found = as_a_way_says(line, joins, called.dishes, called.words, known)
    line, joins = (made, found) if made is not line else as_it_is_called(line, joins, called, known)
    if called.has("laid"):
        joins = strewn_under(line, joins, known)
    if is_folded(joins, called.folded):
        line, joins = folded(joins)
    beside = not any(map(called.has, ("stacked", "baked", "formed")))
    line, joins = (
        _glass_line(line, joins, called, known)
        if called.in_glass
        else wedges_last(line, joins, spooned=called.boils, slices_beside=beside)
    )
    return _in_the_pot(line, joins, called, known)


def _glass_line(line: Line, joins: Sequence[Join], called: Called, known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how a drink is made: heated or blended as it is called, where this FOON shows how, stirred, garnished."""
    if not is_heated(line) and called.warms:
        line, joins = as_a_way_says(line, joins, (), called.words, known, when="warmed")
    if called.blends:
        line, joins = as_a_way_says(line, joins, (), called.words, known, when="blended")
    return garnished(*stirred(line, joins), called.name_words)


def _in_the_pot(line: Line, joins: Sequence[Join], called: Called, known: Tables) -> Arranged:
    """Return how what is heated in one vessel is made: fried in turn, thickened, stewed or blended."""
    line, joins = unmixed(line, joins)
    joins = fat_in_the_heat(joins)
    # in a soup or stew flour is stirred into the fat in its turn; in a tin or a batter it is no sauce's
    if not (called.tin or called.boils or says(called.name_words, "is called battered")):
        line, joins = sauce_apart(line, joins)
    line, joins, one_pot = _stewed_or_smooth(line, joins, called, known)
    if is_formed(called.dishes, joins):
        line, joins = formed_within(line, joins, known)
    return Arranged(line, tuple(joins), one_pot)


def _stewed_or_smooth(line: Line, joins: Sequence[Join], called: Called, known: Tables) -> Arranged:
    """Return how what boils in the dish is done in it, be it blended then; as it is where nothing does."""
    title = words(called.title)
    bathed = is_eaten_with_its_bath(joins, title, called.dish_type)
    stewed_so = is_stewed(called.title, called.dishes, joins, known)
    one_pot = called.boils or bathed or is_soaked_up(joins, title) or stewed_so
    if called.boils and not bathed:
        line, joins = blended_when_done(line, joins, called.name_words)
    elif one_pot:
        line, joins = stewed(boiled_there(joins) if bathed else joins)
    return Arranged(line, tuple(joins), one_pot)


def as_it_is_called(line: Line, joins: Sequence[Join], called: Called, known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` for a dish ``called`` so that its kind says how its parts come together.

    ``known`` are the tables.
    """
    made, found = _shaped(line, tuple(joins), called, known)
    if made is not line:
        return made, found
    joins = tuple(joins)
    if is_never_heated(called.dishes, joins, known):
        line, joins = unheated(line, joins)
    if called.has("stacked"):
        line, joins = cooked_apart(line, joins, called.name_words, known, grilled=called.has("grilled"))
    elif called.has("coated") and not called.has("dressed"):
        line, joins = _coated(line, joins, called, known)
    return dressed_apart(line, joins) if called.has("dressed") else (line, joins)


def _coated(line: Line, joins: tuple[Join, ...], called: Called, known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how flesh is made that is the dish: dipped, coated, or as such flesh is; else as it is."""
    made, found = as_a_way_says(line, joins, (), called.words, known, when="dipped")
    if made is line:
        made, found = coated_alone(line, joins, known, baked=called.baked)
    if made is line:
        made, found = as_a_way_says(line, joins, (), called.words, known, when="flesh", baked=called.baked)
    return made, found


def _shaped(line: Line, joins: tuple[Join, ...], called: Called, known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish is made that is given its form: by dough around it, in a roll, as balls; else as it is."""
    if is_formed(called.dishes, joins):
        return formed(line, joins, called.name_words, known, called.goal, baked=called.baked)
    return line, joins
