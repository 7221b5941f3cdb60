"""What is no part of a batter or dough: frosting, glaze, crumble and toppings, made apart and put on it in time."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Tables, singular, words
from foon_kg.food.lists import word_list
from foon_kg.integration.batters import is_of_batter
from foon_kg.integration.frames import Line, Slot, Stage
from foon_kg.integration.layouts import Spot
from foon_kg.integration.places import NATURAL, Join
from foon_kg.integration.preparation import Want

_LEAST_LIQUIDS = 2
"""Of so many liquids one may be meant for a glaze."""


@dataclass(frozen=True)
class Part:
    """Foods that are put on a dish by ``motion``, ``mixed`` before if need be; ``baked``: before it is baked."""

    wants: tuple[Want, ...]
    motion: str
    baked: bool = False
    mixed: bool = True


def parts_of(
    wants: Sequence[Want], dish_type: str, title: str, repeated: Collection[str], known: Tables
) -> tuple[tuple[Want, ...], tuple[Part, ...]]:
    """Return what is baked of the foods of a recipe, and the parts that are put on it.

    ``repeated`` are the names that a recipe lists twice: what of them belongs to a part is a second portion.
    """
    if not any(dish.tin for dish in known.dishes_named(dish_type)):
        return tuple(wants), ()
    if is_of_batter(wants):
        found = tuple(_Parted(wants, frozenset(words(title)), repeated).parts())
    else:
        found = tuple(Part((want,), "", baked=True) for want in _on_dough(wants))
    taken = {want.number for part in found for want in part.wants}
    rest = tuple(want for want in wants if want.number not in taken)
    return (rest, found) if rest else (tuple(wants), ())


def _on_dough(wants: Sequence[Want]) -> list[Want]:
    yeast = any(want.facts.is_a(*word_list("makes dough rise")) for want in wants)
    meal = any(want.facts.is_a("flour") for want in wants)
    lies = [want for want in wants if want.facts.is_a(*word_list("lies on dough"))]
    return [want for want in lies if not want.facts.is_a(*word_list("is kneaded in"))] if yeast and meal else []


class _Parted:
    """The foods of one recipe that makes a batter, by what they may be for."""

    def __init__(self, wants: Sequence[Want], told: frozenset[str], repeated: Collection[str]) -> None:
        self.wants = wants
        self.told = told
        self.repeated = repeated
        self.icing = self._are("icing sugar")
        self.sugar = [want for want in self._are("sugar", "syrup") if want not in self.icing]
        self.fats = self._are("fat")
        self.butter = self._are("butter")
        self.numbers = max(want.number for want in wants)

    def _are(self, *kinds: str) -> list[Want]:
        return [want for want in self.wants if want.facts.is_a(*kinds)]

    def parts(self) -> Iterator[Part]:
        """Yield the parts in the order in which they are put on."""
        if not self.told.isdisjoint(word_list("is strewn with crumbs")) and len(self.fats) > 1 and self.butter:
            meal = [self._second(want) for want in self._are("flour")[:1]]
            sugar = [self._second(want) for want in self.sugar[:1]]
            yield Part((*self._are("cereal")[:1], *meal, *sugar, self.butter[0]), "sprinkle", baked=True)
        frosting = self._frosting()
        glaze = self._glaze() if not frosting else ()
        if frosting:
            yield Part(frosting, "spread")
        elif glaze:
            yield Part(glaze, "pour")
        elif self.icing and self.sugar:
            yield Part((self.icing[0],), "sprinkle")
        tops = self._are(*word_list("is put on what is baked"))
        if tops:
            yield Part(tuple(tops), "spread", mixed=False)

    def _second(self, want: Want) -> Want:
        """Return a second portion of a food."""
        self.numbers += 1
        return replace(want, number=self.numbers)

    def _twice(self, want: Want) -> bool:
        return singular(want.label) in self.repeated

    def _frosting(self) -> tuple[Want, ...]:
        """Return what is mixed to a frosting: icing sugar, or a second portion of sugar, with soft cheese or butter."""
        cheese = self._are("fresh cheese") if self._are("leaven") else []
        again = [self._second(want) for want in self.sugar if self._twice(want)][:1] if cheese else []
        if cheese and not again and len(self.sugar) > 1 and self.butter and self._twice(self.butter[0]):
            again = [want for want in self.sugar if want.facts.is_a("sugar")][-1:]
        sweet = self.icing[:1] if self.sugar else []
        butter = self.butter[:1]
        if butter and self._twice(butter[0]):
            butter = [self._second(butter[0])]
        elif len(self.fats) < 2:  # noqa: PLR2004 - the one fat is the batter's
            butter = []
        if not (sweet or again) or not (cheese or butter):
            return ()
        return (*cheese[:1], *butter, *(sweet or again))

    def _glaze(self) -> tuple[Want, ...]:
        """Return what is stirred to a glaze, where the title promises one: icing sugar with juice or another liquid."""
        if not self.icing or not self.sugar or self.told.isdisjoint(word_list("is glazed")):
            return ()
        juice = [want for want in self._are("lemon", "sour juice") if want.squeezed or want.facts.is_a("liquid")]
        liquids = [want for want in self._are("juice", "milk") if not want.facts.is_a("fat")]
        wet = juice or (liquids[1:] if len(liquids) >= _LEAST_LIQUIDS else [])
        return (*self.icing[:1], *wet[:1]) if wet else ()


def with_parts(line: Line, joins: Sequence[Join], parts: Sequence[Part]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line with a stage for each part, and the joins with those of the parts."""
    stages, found = list(line.stages), list(joins)
    for part in parts:
        place = next((n for n, stage in enumerate(stages) if "heat" in stage.does), None) if part.baked else None
        mixing = _stage("mix", "bowl", ()) if part.mixed and len(part.wants) > 1 else None
        adds = (Line((mixing,)),) if mixing is not None else ()
        if place is None:
            if stages[-1].step >= 0:
                stages.append(_stage("cool down", "plate", ()))  # on what is hot it would melt
            stages.append(_stage(part.motion, "plate", adds))
            target = stages[-1]
        elif adds:
            old = stages[place]
            target = stages[place] = replace(old, adds=(*old.adds, *adds))
            found = [_moved(join, old, target) for join in found]
        else:
            target = stages[place]
        own = mixing or target
        spot = Spot((len(stages), 0) if mixing else (len(stages),), own, ("top", "before", False), False, ())
        for want in part.wants:
            slot = Slot(singular(want.label), want.facts.kind, want.leaf, (), part.motion) if mixing is None else None
            found.append(Join(want, spot, NATURAL - 0.01, slot if part.motion else None))
    return Line(tuple(stages)), tuple(found)


def _moved(join: Join, old: Stage, new: Stage) -> Join:
    return replace(join, spot=replace(join.spot, stage=new)) if join.spot.stage is old else join


def _stage(motion: str, vessel: str, adds: tuple[Line, ...]) -> Stage:
    mixes = motion == "mix"
    does = frozenset({"mix"} if mixes else {"wait"} if motion in word_list("cools") else {"coat", "move"})
    relation, tools = ("in", ("spoon",)) if mixes else ("on", ())
    return Stage(adds, motion, does, tools, vessel, relation, "", "", "", (), -1)
