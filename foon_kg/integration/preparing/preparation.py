"""One food on its own: what is asked, how the kitchen has it, and what a cook owes it.

A cook's duties to a food (peel it, stone it, shell it, cook it) are data (:mod:`foon_kg.food`). How what is asked is
understood is in :mod:`~foon_kg.integration.preparing.understanding`, how it is done in
:mod:`~foon_kg.integration.preparing.preparer`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, field, replace
from typing import Protocol

from foon_kg.food import Food, Level, Tables, singular, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import POWDER
from foon_kg.integration.bench import Stuff
from foon_kg.integration.teaching.operators import Way
from foon_kg.model.values import made_often

IN_ORDER = ("husk", "shell", "peel", "core", "stone", "choke")
"""What hands do to a food before it is cut, in this order: from the outside in."""

BY_HAND = frozenset(IN_ORDER)
"""The same, to be looked up in."""

_MILLS = frozenset({"grind", "blend", "mash"})
"""What a motion does by which something hard becomes a powder."""

CUTS = frozenset({"cut", "grate", "mash", "grind"})
"""What a motion does that divides a food."""

NOT_BY_HAND = frozenset({"heat", "warm", "blend", "mix", "wait", "coat", "shape", "scatter", "fetch"})
"""What a motion does that hands do not do to one food on a board: heat, machines, time, or others that join it."""

CANNED = "canned"
FROM_A_CAN = frozenset({"drain"})
"""What is done to what comes out of a can."""

RINSED = frozenset({"wash"})
"""What a state says that was only rinsed: washed, cleaned, scrubbed."""

JUICE = "juice"
"""The state of what is squeezed out of a fruit."""

BRINGS = frozenset({"fetch", "move", "scatter"})
"""What a motion does that only brings a food somewhere, whatever state its video notes afterwards."""


SECOND = 1000
"""Above this are the numbers of second portions: below it are those of what is asked, which no recipe has so many of.

Each module that makes some begins at a multiple of its own, so that no two portions have one number."""


@made_often()
class Want:
    """A required food as it is understood.

    ``leaf`` are the states in which the kitchen has it, in ``storage`` (``""``: free). ``make`` is the asked state that
    somebody has to make, ``cooked`` says that it is asked cooked. ``squeezed``: only its juice is used.
    ``bought_so``: no kitchen of this FOON makes what is asked (smoked, pickled). ``at_hand``: somebody has it in the
    asked state. ``stands``: it is in ``storage`` since somebody put it there. ``then`` is what is made of
    it once it is cooked (mashed). ``foamed``: it is a liquid that is whipped. ``roasted``: the title says that it comes
    out of an oven. ``part`` is for what of the dish the recipe says that it is, ``places`` are those at which it lists
    it. ``as_written`` is what the recipe says of its state, where that is several things
    (:func:`~foon_kg.food.told_states.in_turn`). ``of`` is the food that comes apart when it is opened, and of which
    this is a part. ``left_whole``: it is asked in one piece, and stays so in such a dish.
    """

    number: int
    label: str
    asked: str
    facts: Food
    leaf: tuple[str, ...]
    storage: str
    make: str = ""
    cooked: bool = False
    squeezed: bool = False
    bought_so: bool = False
    then: str = ""
    at_hand: bool = False
    stands: bool = False
    foamed: bool = False
    roasted: bool = False
    part: str = ""
    as_written: str = ""
    of: Want | None = None
    left_whole: bool = False
    places: tuple[int, ...] = field(default=(), compare=False)

    @property
    def names(self) -> tuple[str, ...]:
        """The names under which evidence is sought."""
        return (singular(self.label),)

    @property
    def is_headed(self) -> bool:
        """Whether its ``part`` is what a heading says; of a single food a list says only what that is used for."""
        return bool(self.part) and self.part not in word_list("is said in a list without headings")


@dataclass
class Ready:
    """A food that is ready to join, and what had to be assumed for it.

    ``whole_shell``: it is still in its shell, and is opened over the vessel that it joins. ``cut_later`` is the state
    into which it is cut once it is cooked.
    """

    want: Want
    stuff: Stuff
    whole_shell: bool = False
    cut_later: str = ""
    assumptions: list[str] = field(default_factory=list)


class AtHand(Protocol):
    """What a kitchen says of its foods: :class:`~foon_kg.plans.kitchen.Kitchen`."""

    def ready_in(self, food: str, state: str, /) -> str | None:
        """Return in what a food in a state stands ready (``""``: it lies free), ``None`` where it does not."""

    def stands_as(self, food: str, states: Collection[str], /) -> tuple[str, ...]:
        """Return the states in which a food is there that is not there in ``states``, if it needs less to be done."""

    def lies_in(self, food: str, states: Collection[str], /) -> str | None:
        """Return the vessel in which a food in such states is, ``None`` where it lies free or is in storage."""


def as_there(want: Want, kitchen: AtHand) -> Want:
    """Return ``want`` as a named ``kitchen`` has it: in the asked state and in what a person said."""
    storage = kitchen.ready_in(want.label, want.make) if want.make else None
    if storage is None and (there := kitchen.stands_as(want.label, want.leaf)):
        want = replace(want, leaf=there, storage=kitchen.ready_in(want.label, there[0]) or "")
    vessel = kitchen.lies_in(want.label, want.leaf if storage is None else (want.make,))
    if vessel is not None:
        want = replace(want, storage=vessel, stands=True)
    if storage is None:
        return want
    return replace(want, leaf=(want.make,), storage=storage, make="", cooked=False, squeezed=False, at_hand=True)


def package_of(states: Iterable[str]) -> str:
    """Return in what a food comes from a shop that is not sold so, by its ``states``; ``""`` where it lies free."""
    # each of these names a list of states
    packages = ("bag", "bottle", "can", "container", "jar", "packet")
    return next((package for package in packages if says(states, f"comes in a {package}")), "")


def is_mill(way: Way, known: Tables) -> bool:
    """Return whether what is hard is ground in this way, by the tables ``known``."""
    return not _MILLS.isdisjoint(known.motion(way[0]).does)


def wants_a_mill(state: str, facts: Food, known: Tables) -> bool:
    """Return whether a food is asked in a ``state`` so fine that only a mill makes it, or a mortar.

    A knife does it where the food is soft by its ``facts``. ``known`` are the tables.
    """
    row = known.state(state)
    fine = row.fineness >= POWDER and row.earns == {"cut"}
    return fine and not facts.is_any(word_list("is soft enough for a knife"))


def as_mash(want: Want, known: Tables) -> Want:
    """Return ``want``, if it is too hard to be shaped as it is, as one that is cooked and mashed before.

    That is not so where it is asked cut. ``known`` are the tables.
    """
    whole = not want.make or not known.state(want.make).fine
    hard = want.facts.is_any(word_list("is cooked and mashed to be shaped"))
    return replace(want, then=min(word_list("is mashed so"))) if hard and whole and not want.then else want


def as_mixed(want: Want, known: Tables) -> Want:
    """Return ``want`` as it is mixed to be shaped: mashed where it is hard, torn where it is to soak.

    ``known`` are the tables.
    """
    whole = not want.make or known.state(want.make).fineness <= 1
    soaked = want.make in word_list("is so when it has soaked")  # that is asked, and falls apart by itself
    torn = whole and not soaked and want.facts.kind in word_list("is torn to be soaked")
    return replace(want, make=min(word_list("is so when it is torn"))) if torn else as_mash(want, known)


def is_left_whole(want: Want) -> bool:
    """Return whether nobody cuts ``want`` unasked.

    It is to stay whole in such a dish, is small, as its name says (baby potatoes), or is a bay leaf.
    """
    if want.left_whole:
        return True
    small = says(words(want.label), "is left whole by its name")
    small = small and want.facts.is_any(word_list("may be left whole where it is small"))
    return small or want.facts.is_any(word_list("is a leaf by itself"))  # it is lifted out, or left on the plate


def owed(want: Want, known: Tables, level: Level = Level.MINOR) -> set[str]:
    """Return what a cook still has to do to ``want`` as the kitchen has it (peel, cook …), by the tables ``known``.

    ``level``: all of it (``MINOR``), or only that without which it cannot be eaten (``FATAL``).
    """
    levels = {Level.FATAL} if level is Level.FATAL else {Level.FATAL, Level.MINOR}
    return {name for name, how in want.facts.owes.items() if how in levels} - earned(want, known)


def earned(want: Want, known: Tables) -> frozenset[str]:
    """Return what was done to ``want`` before, as its states in the kitchen tell by the tables ``known``."""
    return frozenset().union(*(known.state(state).earns for state in want.leaf))
