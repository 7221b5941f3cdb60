"""Batters: dry foods are mixed with dry ones, what runs joins fat and sugar, and pieces are folded in last."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.spots import Join, Spot
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.operators import form_of

_DRY = word_list("is dry in a batter")
_PIECES = word_list("is folded into a batter")
_SWEET = word_list("sweetens a batter")
_WET = ("creamy", "egg", "liquid")
_MIXES = frozenset({"blend", "mix"})


@dataclass(frozen=True)
class Batter:
    """The stages of a frame at which a batter comes together: for dry foods, sugar, fat, what runs, and pieces.

    ``whole`` is where the dry foods join the others (``dry`` itself, where they are not mixed apart).
    """

    dry: Spot
    sweet: Spot
    fat: Spot
    wet: Spot
    last: Spot
    whole: Spot


def batter_of(spots: Sequence[Spot], known: Tables) -> Batter | None:
    """Return where the batter of a frame comes together; ``None`` for a frame that bakes none."""
    mixing = [spot for spot in spots if spot.post[0] in _MIXES and spot.heats_later and "heat" not in spot.stage.does]
    kneaded = any("knead" in spot.stage.does for spot in spots)
    baked = any(spot.stage.appliance == "oven" and "heat" in spot.stage.does for spot in spots)
    if not mixing or kneaded or not baked:
        return None

    def most(*traits: str) -> Spot | None:
        foods = {id(spot): [known.foods.food(slot.food, slot.states) for slot in spot.stage.slots] for spot in mixing}
        counts = {
            spot: sum(food.is_a(*traits) and not food.is_a("water") for food in foods[id(spot)]) for spot in mixing
        }
        best = max(mixing, key=lambda spot: counts[spot])
        return best if counts[best] else None

    dry, sweet, fat, wet = most("flour", "leaven"), most(*_SWEET), most("fat"), most(*_WET)
    if dry is None or sweet is None or fat is None or wet is None:
        return None
    whole = next((spot for spot in spots if dry.side and spot.path == dry.path[:-2]), dry)
    last = mixing[-1]
    return Batter(dry, sweet, fat, wet, last, whole if whole in mixing else wet)


def is_thin(batter: Batter) -> bool:
    """Whether water joins what runs in a batter."""
    return "water" in batter.wet.kinds


def is_of_batter(wants: Iterable[Want]) -> bool:
    """Whether foods make a batter, or a dough that nobody kneads: they set in the oven, and no yeast raises them."""
    facts = [want.facts for want in wants]
    makes = any(one.is_a(*word_list("makes a batter")) for one in facts)
    return makes and not any(one.is_a(*word_list("is no batter")) for one in facts)


def is_of_dough(wants: Sequence[Want]) -> bool:
    """Whether foods make a dough that rises before it is baked."""
    facts = [want.facts for want in wants]
    return any(one.is_a("flour") for one in facts) and any(one.is_a(*word_list("makes dough rise")) for one in facts)


def binds(foods: Iterable[str], known: Tables) -> bool:
    """Whether a mixture of foods sets when it is baked: there is flour, meal or dough in it."""
    return any(known.foods.food(food).is_a(*word_list("sets when it is baked")) for food in foods)


def as_batter(batter: Batter, joins: Sequence[Join], known: Tables) -> list[Join]:
    """Return the joins with every food of a batter where foods of its part join."""
    found = []
    for join in joins:
        spot = _spot(batter, join, known) if join.spot.heats_later and "heat" not in join.spot.stage.does else join.spot
        kept = spot is join.spot
        found.append(join if kept else replace(join, spot=spot, slot=None))
    fats = [join for join in found if join.want.facts.is_a("fat")]
    if fats and all("heat" in join.spot.stage.does for join in fats):  # the tin takes some of it, and not all
        found = [replace(join, spot=batter.fat, slot=None) if join in fats else join for join in found]
    alone = [join for join in found if join.spot is batter.dry]
    if len(alone) == 1 and batter.dry is not batter.whole:
        found[found.index(alone[0])] = replace(alone[0], spot=batter.whole)
    return found


def _spot(batter: Batter, join: Join, known: Tables) -> Spot:
    want = join.want
    form = form_of(known, want.label, (want.make,) if want.make else want.leaf)
    runs = want.squeezed or form == "liquid" or (form == "soft" and not want.facts.is_a("fat"))
    early = join.slot is not None and join.spot is not batter.dry and join.spot.path[:1] <= batter.whole.path[:1]
    wet = join.spot if early else batter.wet
    parts = (
        (want.facts.is_a("fat"), batter.fat),
        (want.facts.is_a(*_SWEET), batter.sweet),
        (runs or want.facts.is_a("egg"), wet),
        (want.facts.is_a(*_DRY), batter.dry),
        (want.facts.is_a(*_PIECES), batter.last),
    )
    return next((spot for holds, spot in parts if holds), join.spot)
