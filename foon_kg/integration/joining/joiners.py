"""The foods of recipes as what joins dishes: what decides where each joins, looked up once for all dishes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Tables, singular
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.layouts import MAIN, Layout, Place
from foon_kg.integration.joining.spots import UNNATURAL, Join, Spot
from foon_kg.integration.preparing.preparation import Want, owed
from foon_kg.model.recent import Recent

_LATE = word_list("joins late")
_FRESH = word_list("joins at the end")
_BOUND = word_list("binds")
_WORKED_IN = word_list("is worked in")
_FLESH = word_list("is flesh")
_SERVED_WITH = word_list("is served with what is fried")
_BATHED = word_list("goes into the water")

MOST_JOINERS = 1024
"""For how many foods it is kept where they join."""


class Joiner:
    """A food, and what of it decides where it joins a dish: looked up once for all dishes and recipes.

    ``fits`` says how well it takes the place of others, ``joined`` where it joins the dishes it was compared with.
    """

    def __init__(self, want: Want, known: Tables) -> None:
        facts, is_a, is_any = want.facts, want.facts.is_a, want.facts.is_any
        self.want = want
        self.name = singular(want.label)
        self.fits: dict[tuple[str, str], float] = {}
        self.needs: dict[str, frozenset[str]] = {}
        self.joined: dict[tuple[Layout, bool], Join] = {}
        self.main = is_any(MAIN)
        self.runs = is_a("liquid", "water", "creamy", "frozen")
        self.fat = is_a("fat")
        self.topping = is_a("topping")
        self.tops = is_a("topping", "herb")
        self.floats = is_any(word_list("floats on top"))
        self.late = is_any(_LATE)
        self.worked = is_any(_WORKED_IN) and not is_a("herb")
        self.binds = is_any(_BOUND) and not self.fat
        self.beaten = is_any(word_list("is beaten with eggs")) and not self.fat
        self.served = is_any(_SERVED_WITH)
        self.ready_made = is_a("made", "dough", "ready")
        self.due = not owed(want, known).isdisjoint({"cook", "boil"})
        self.slow = self.due and self.main and is_any(_FLESH)
        self.only_boiled = not is_any(_BATHED) and "boil" not in facts.owes
        self.fresh = (
            facts.sold_as != "dried"
            and not want.cooked
            and not _FRESH.isdisjoint({f"kind:{facts.kind}", facts.taken_for})
        )

    def plays_the_role_at(self, place: Place, needs: frozenset[str]) -> bool:
        """Return whether it is what the food of a place is to the dish: one of its ``needs``, or its main part."""
        return not needs.isdisjoint(place.needs) or (self.main and place.main)

    def at(self, spot: Spot) -> Join:
        """Return its join at a stage, ``spot``, at which it has no natural place."""
        return Join(self.want, spot, UNNATURAL)


class Joiners:
    """The foods of late recipes: a recipe has few that no other one has.

    It serves recipes whose foods are alike the foods of the dishes in the same way: those that ask one FOON.
    """

    def __init__(self) -> None:
        self._kept: Recent[tuple[Want, frozenset[str]], Joiner] = Recent(MOST_JOINERS)

    def of(self, wants: Sequence[Want], known: Tables) -> dict[int, Joiner]:
        """Return the foods of a recipe, ``wants``, by their numbers. One name with two meanings counts for both.

        ``known`` are the tables that tell the meanings.
        """
        meant: defaultdict[str, set[str]] = defaultdict(set)
        for want in wants:
            meant[singular(want.label)].add(want.facts.taken_for)
        found = {}
        for want in wants:
            key = replace(want, number=0), frozenset(meant[singular(want.label)])
            joiner = self._kept.find(key)
            if joiner is None:
                joiner = self._kept[key] = Joiner(want, known)
            found[want.number] = joiner
        return found
