"""In what foods are baked: batter in the tin of its dish, and nothing that runs on a tray."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Stuff, Vessel, foods_of, is_flat
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.making.consistency import is_wet
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.forms import form_of

_DEEP = "baking dish"
"""In what wet things are baked, whatever the video bakes in: a tray has no rim."""


class Bakeware:
    """Chooses in what is baked for a dish whose batter or dough is baked in ``tin`` (``""`` for none)."""

    def __init__(self, known: Tables, tin: str) -> None:
        self.known = known
        self.tin = tin

    def deep_for(self, label: str, wants: Sequence[Want]) -> str:
        """Return in what ``wants`` are baked that come one by one into a ``label``: nothing runs on a tray."""
        row = self.known.utensil(label)
        bakes = row is not None and "bake" in row.can and is_flat(label)
        runs = any(want.facts.is_a("egg", "liquid") and not want.facts.is_a("fat") for want in wants)
        return _DEEP if bakes and runs else label

    def tin_for(self, label: str, vessel: Vessel, *, in_oven: bool) -> str:
        """Return in what is baked what comes out of ``vessel``: in the dish's tin, and nothing wet on a tray.

        ``label`` is what the video bakes it in, ``in_oven`` whether that stands in an oven. What was baked in the tin
        is not moved to other bakeware.
        """
        if not self._is_for_baking(label, in_oven=in_oven):
            return label
        if vessel.label == self.tin:
            return self.tin
        batter = [stuff for stuff in vessel.contents if self._is_batter(stuff)]
        if batter:
            return self.tin if self._needs_tin(label, batter) else label
        return _DEEP if is_flat(label) and self._runs(vessel) else label

    def _is_for_baking(self, label: str, *, in_oven: bool) -> bool:
        """Whether something is bakeware here: what also goes over the heat is so where the tin goes into the oven."""
        row = self.known.utensil(label)
        if row is None or "bake" not in row.can:
            return False
        return row.can.isdisjoint({"heat", "cook"}) or (bool(self.tin) and in_oven)

    def _needs_tin(self, label: str, batter: Sequence[Stuff]) -> bool:
        """Whether batter comes into the tin of its dish: where a video bakes it in a tin, or it runs.

        So does dough that lies flat in pieces where a video bakes it in one.
        """
        row = self.known.utensil(label)
        in_portions = row is not None and row.group == "tins"
        shaped = is_flat(self.tin) and label in word_list("holds it in one piece")
        return bool(self.tin) and (in_portions or shaped or any(is_wet(stuff, self.known) for stuff in batter))

    def _is_batter(self, stuff: Stuff) -> bool:
        """Whether a mixture sets when it is baked, and is no sauce."""
        return stuff.mixed and self._sets(stuff) and not self._is_sauce(stuff)

    def _sets(self, stuff: Stuff) -> bool:
        """Whether a mixture sets when it is baked: there is flour in it, or there are eggs for what has a tin."""
        eggs = any(self.known.foods.food(food).is_a("egg") for food in stuff.foods)
        return binds(stuff.foods, self.known) or (bool(self.tin) and eggs)

    def _is_sauce(self, stuff: Stuff) -> bool:
        """Whether what flour binds is a sauce with something in it, and no batter."""
        foods = [self.known.foods.food(food) for food in stuff.foods]
        if any(food.is_a("leaven", *word_list("makes no sauce of flour")) for food in foods):
            return False
        thin = any(food.is_of(*word_list("is a bath")) for food in foods)
        return thin or any(f"kind:{food.kind}" in word_list("makes a sauce of flour") for food in foods)

    def _runs(self, vessel: Vessel) -> bool:
        """Whether something in a vessel runs, and not only fat."""
        liquids = (food for food in map(self.known.foods.food, foods_of(vessel)) if food.is_a("liquid", "creamy"))
        if all(food.is_a("fat") for food in liquids):
            return False
        return any(
            is_wet(stuff, self.known) or form_of(self.known, stuff.label, stuff.states) == "liquid"
            for stuff in vessel.contents
        )
