"""Batters: dry foods are mixed with dry ones, what runs joins fat and sugar, and pieces are folded in last."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Food, Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.spots import Join, Spot
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.forms import form_of

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
    """Return where the batter of a frame, with these ``spots``, comes together; ``None`` for a frame that bakes none.

    ``known`` are the tables.
    """
    foods = _mixed(spots, known)
    if not foods or not _is_baked_unkneaded(spots):
        return None
    dry, sweet = _most_of(foods, "flour", "leaven"), _most_of(foods, *_SWEET)
    fat, wet = _most_of(foods, "fat"), _most_of(foods, *_WET)
    if dry is None or sweet is None or fat is None or wet is None:
        return None
    whole = _taken_at(dry, spots)
    return Batter(dry, sweet, fat, wet, [*foods][-1], whole if whole in foods else wet)


def _mixed(spots: Sequence[Spot], known: Tables) -> dict[Spot, list[Food]]:
    """Return the stages at which something is mixed that is heated later, with the foods that join there."""
    mixing = (spot for spot in spots if spot.stage_type.work in _MIXES and _is_before_the_heat(spot))
    return {spot: [known.foods.food(slot.food, slot.states) for slot in spot.stage.slots] for spot in mixing}


def _taken_at(dry: Spot, spots: Sequence[Spot]) -> Spot:
    """Return where what is mixed apart joins the rest; the stage itself where it is not apart."""
    return next((spot for spot in spots if dry.side and spot.path == dry.path[:-2]), dry)


def _is_before_the_heat(spot: Spot) -> bool:
    return spot.heats_later and "heat" not in spot.stage.does


def _is_baked_unkneaded(spots: Sequence[Spot]) -> bool:
    baked = any(spot.stage.appliance == "oven" and "heat" in spot.stage.does for spot in spots)
    return baked and not any("knead" in spot.stage.does for spot in spots)


def _most_of(foods: Mapping[Spot, Sequence[Food]], *traits: str) -> Spot | None:
    """Return the first stage at which most foods of such ``traits`` join; water is none of what runs."""
    counts = {spot: sum(one.is_any(traits) and not one.is_a("water") for one in there) for spot, there in foods.items()}
    best = max(counts, key=lambda spot: counts[spot])
    return best if counts[best] else None


def is_thin(batter: Batter) -> bool:
    """Return whether water joins what runs in ``batter``."""
    return "water" in batter.wet.kinds


def is_of_batter(wants: Iterable[Want]) -> bool:
    """Return whether ``wants`` make a batter, or a dough that nobody kneads: they set in the oven, without yeast."""
    facts = [want.facts for want in wants]
    makes = any(one.is_any(word_list("makes a batter")) for one in facts)
    return makes and not any(one.is_any(word_list("is no batter")) for one in facts)


def is_of_dough(wants: Sequence[Want]) -> bool:
    """Return whether ``wants`` make a dough that rises before it is baked."""
    facts = [want.facts for want in wants]
    return any(one.is_a("flour") for one in facts) and any(one.is_any(word_list("makes dough rise")) for one in facts)


def binds(foods: Iterable[str], known: Tables) -> bool:
    """Return whether a mixture of foods sets when it is baked: it has flour, meal or dough by the tables ``known``."""
    return any(known.foods.food(food).is_any(word_list("sets when it is baked")) for food in foods)


def as_batter(batter: Batter, joins: Sequence[Join], known: Tables) -> list[Join]:
    """Return ``joins`` with every food of ``batter`` where foods of its part join; ``known`` are the tables.

    One dry food alone is not mixed apart in a bowl of its own: it joins where the dry ones meet the rest.
    """
    found = _with_its_fat(batter, [_in_its_part(batter, join, known) for join in joins])
    alone = [join for join in found if join.spot is batter.dry]
    if len(alone) == 1 and batter.dry is not batter.whole:
        found[found.index(alone[0])] = replace(alone[0], spot=batter.whole)
    return found


def _in_its_part(batter: Batter, join: Join, known: Tables) -> Join:
    """Return a food where those of its part join, unless it joins what is hot or baked already."""
    spot = _spot(batter, join, known) if _is_before_the_heat(join.spot) else join.spot
    return join if spot is join.spot else replace(join, spot=spot, slot=None)


def _with_its_fat(batter: Batter, joins: list[Join]) -> list[Join]:
    """Return ``joins`` with some fat in the batter: the tin takes some of it, and not all."""
    fats = [join for join in joins if join.want.facts.is_a("fat")]
    if not fats or any("heat" not in join.spot.stage.does for join in fats):
        return joins
    return [replace(join, spot=batter.fat, slot=None) if join in fats else join for join in joins]


def _spot(batter: Batter, join: Join, known: Tables) -> Spot:
    want = join.want
    early = join.slot is not None and join.spot is not batter.dry and join.spot.path[:1] <= batter.whole.path[:1]
    parts = (
        (want.facts.is_a("fat"), batter.fat),
        (want.facts.is_any(_SWEET), batter.sweet),
        (_runs(want, known) or want.facts.is_a("egg"), join.spot if early else batter.wet),
        (want.facts.is_any(_DRY), batter.dry),
        (want.facts.is_any(_PIECES), batter.last),
    )
    return next((spot for holds, spot in parts if holds), join.spot)


def _runs(want: Want, known: Tables) -> bool:
    """Whether a food is liquid or soft when it joins; soft fat is creamed, and does not run."""
    form = form_of(known, want.label, (want.make,) if want.make else want.leaf)
    return want.squeezed or form == "liquid" or (form == "soft" and not want.facts.is_a("fat"))
