"""What is no part of a batter or dough: frosting, glaze, crumble and toppings, made apart and put on it in time."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Tables, singular, words
from foon_kg.food.lists import says, word_list
from foon_kg.integration.composing.techniques import stage_of
from foon_kg.integration.joining.batters import is_of_batter, is_of_dough
from foon_kg.integration.joining.spots import UNNATURAL, Join, Spot, StageType, any_is, only_carries
from foon_kg.integration.preparing.preparation import SECOND, Want
from foon_kg.integration.teaching.frames import ADDED, Line, Slot, Stage


@dataclass(frozen=True)
class Part:
    """Foods that are put on a dish by ``motion``, ``mixed`` before if need be, at the stage of the name ``mixes``.

    ``baked``: before it is baked; ``under``: in its tin, before all else.
    """

    wants: tuple[Want, ...]
    motion: str
    baked: bool = False
    mixed: bool = True
    under: bool = False
    mixes: str = "mix"


def parts_of(
    wants: Sequence[Want], dish_type: str, title: str, repeated: Collection[str], known: Tables, *, strewn: bool = False
) -> tuple[tuple[Want, ...], tuple[Part, ...]]:
    """Return what is baked of ``wants``, the foods of a recipe, and the parts that are put on it.

    The ``dish_type`` and ``title`` say what parts there are. ``repeated`` are the names that a recipe lists twice: what
    of them belongs to a part is a second portion. ``strewn``: what is strewn on it was found already. ``known`` are the
    tables.
    """
    if not any(dish.tin for dish in known.dishes_named(dish_type, title)):
        return tuple(wants), ()
    found = _parts(wants, words(title), repeated, strewn=strewn)
    taken = {want.number for part in found for want in part.wants}
    rest = tuple(want for want in wants if want.number not in taken)
    return (rest, found) if rest else (tuple(wants), ())


def _parts(wants: Sequence[Want], title: Sequence[str], repeated: Collection[str], *, strewn: bool) -> tuple[Part, ...]:
    """Return what is put on a dough or a batter, by the words of a ``title`` and what a recipe lists twice."""
    dough = is_of_dough(wants)
    if not dough and not is_of_batter(wants):
        return ()
    title_words = frozenset(title) - (word_list("is strewn on") if strewn else frozenset())
    lies = [Part((want,), "", baked=True) for want in _on_dough(wants)] if dough else []
    return (*lies, *_Parted(wants, title_words, repeated).parts())


def _on_dough(wants: Sequence[Want]) -> list[Want]:
    lies = [want for want in wants if want.facts.is_any(word_list("lies on dough"))]
    return [want for want in lies if not want.facts.is_any(word_list("is kneaded in"))]


class _Parted:
    """The foods of one recipe that makes a batter, by what they may be for.

    ``fine`` is sugar ground to powder, ``sweet`` other sugar, ``solid`` the fat that is creamed.
    """

    def __init__(self, wants: Sequence[Want], title_words: frozenset[str], repeated: Collection[str]) -> None:
        self.wants = wants
        self.title_words = title_words
        self.repeated = repeated
        self.fine = self._are("sweetens a cover")
        self.sweet = [want for want in self._are("sweetens a batter") if want not in self.fine]
        self.fats = [want for want in wants if want.facts.is_a("fat")]
        self.solid = self._are("is creamed")
        self.numbers = 2 * SECOND  # those of the components begin at 3 * SECOND, those of opened foods at 5 * SECOND

    def _are(self, words_of: str) -> list[Want]:
        return [want for want in self.wants if want.facts.is_any(word_list(words_of))]

    def _promised(self, words_of: str) -> bool:
        return not self.title_words.isdisjoint(word_list(words_of))

    def parts(self) -> Iterator[Part]:
        """Yield the parts in the order in which they are put on."""
        yield from self._strewn()
        yield from self._base()
        cover = self._cover()
        coat = () if cover else self._coat()
        if cover:
            yield Part(cover, _motion("covers what is baked"), mixes="beat soft")  # stirred, the sugar stays gritty
        elif coat:
            yield Part(coat, "")
        tops = self._are("is put on what is baked")
        if tops:
            yield Part(tuple(tops), _motion("covers what is baked"), mixed=False)
        if not cover and not coat and self.fine and self.sweet:
            yield Part((self.fine[0],), _motion("dusts what is baked"))

    def _strewn(self) -> Iterator[Part]:
        """Yield what is strewn on it before it is baked, where the title promises that."""
        if not self._promised("is strewn on") or not self.solid or not self.sweet:
            return
        dry = [self._second(want) for want in self.wants if want.facts.is_a("flour")][:1]
        sweet = self.sweet[-1] if len(self.sweet) > 1 else self._second(self.sweet[0])
        fat = self.solid[0] if len(self.fats) > 1 else self._second(self.solid[0])
        yield Part((*self._are("is coarse in what is strewn on")[:1], *dry, sweet, fat), "", baked=True)

    def _base(self) -> Iterator[Part]:
        """Yield what is pressed into the tin under all else."""
        base = self._are("is pressed to a base")
        if base and self.solid and self._are("body of a cover"):
            yield Part((base[0], self.solid[0]), "", under=True)

    def _second(self, want: Want) -> Want:
        """Return a second portion of a food."""
        self.numbers += 1
        return replace(want, number=self.numbers)

    def _is_twice(self, want: Want) -> bool:
        return singular(want.label) in self.repeated

    def _cover(self) -> tuple[Want, ...]:
        """Return what is mixed and spread: fine sugar, or a second portion of sugar, with what is soft or creamed.

        Cream cheese is the body of a cover only beside what makes a batter rise: else it is a cheesecake.
        """
        leavened = any(want.facts.is_a("leaven") for want in self.wants)
        soft = self._are("body of a cover")[:1] if leavened else []
        sweet = self._sweet_of_a_cover(soft)
        solid = self._fat_of_a_cover()
        return (*soft, *solid, *sweet) if sweet and (soft or solid) else ()

    def _sweet_of_a_cover(self, soft: Sequence[Want]) -> list[Want]:
        """Return the sugar of a cover: what is fine beside other sugar; in what is ``soft`` sugar to spare, too."""
        again = [self._second(want) for want in self.sweet if self._is_twice(want)][:1]
        if self.fine and self.sweet:
            return self.fine[:1]
        if not again and len(self.sweet) > 1 and any(map(self._is_twice, self.solid[:1])):
            again = self.sweet[-1:]
        return again if soft else []

    def _fat_of_a_cover(self) -> list[Want]:
        """Return the fat that is creamed for a cover: a second portion; none where there is but that of the batter."""
        solid = self.solid[:1]
        if any(map(self._is_twice, solid)):
            return list(map(self._second, solid))
        return solid if len(self.fats) != 1 else []

    def _coat(self) -> tuple[Want, ...]:
        """Return what is stirred to be poured on, where the title promises it: fine sugar with a liquid to spare."""
        if not self.fine or not self.sweet or not self._promised("is glazed"):
            return ()
        sour = [want for want in self._are("thins a coat") if want.squeezed or want.facts.is_a("liquid")]
        wet = sour or self._are("is liquid in a batter")[1:]
        return (*self.fine[:1], *wet[:1]) if wet else ()


def _motion(words_of: str) -> str:
    return min(word_list(words_of))


def with_parts(line: Line, joins: Sequence[Join], parts: Sequence[Part], tin: str) -> tuple[Line, tuple[Join, ...]]:
    """Return a line with a stage for each part, and the joins with those of the parts; ``tin`` is what is baked in."""
    stages, found = list(line.stages), list(joins)
    for part in parts:
        stages, found = _on_base(stages, found, part, tin) if part.under else _put_on(stages, found, part)
    return Line(tuple(stages)), tuple(found)


def _put_on(stages: list[Stage], joins: list[Join], part: Part) -> tuple[list[Stage], list[Join]]:
    """Return stages with a part put on the dish, before it is baked or at its end, and the joins with its foods."""
    mixing = _mixing(part) if part.mixed and len(part.wants) > 1 else None
    adds = (Line((mixing,)),) if mixing is not None else ()
    target = _baked_with(stages, part)
    if target is None:
        stages = [*stages, *_at_the_end(stages[-1], part, adds)]
        target = stages[-1]
    elif adds:
        old, target = target, replace(target, adds=(*target.adds, *adds))
        stages, joins = _replaced(stages, joins, old, target)
    path = (len(stages), 0) if mixing else (len(stages),)
    spot = Spot(path, mixing or target, StageType("top", "before", joins=False), side=False, after=())
    return stages, [*joins, *(Join(want, spot, UNNATURAL, _slot(want, part, mixing)) for want in part.wants)]


def _replaced(stages: Sequence[Stage], joins: Sequence[Join], old: Stage, new: Stage) -> tuple[list[Stage], list[Join]]:
    """Return stages of which one is another by now, and joins that join there."""
    return [new if stage is old else stage for stage in stages], [_moved(join, old, new) for join in joins]


def _baked_with(stages: Sequence[Stage], part: Part) -> Stage | None:
    """Return the stage at which a part is baked with all the rest, if it is."""
    return next((stage for stage in stages if "heat" in stage.does), None) if part.baked else None


def _at_the_end(last: Stage, part: Part, adds: tuple[Line, ...]) -> list[Stage]:
    """Return the stages at which a part comes on what is done after the ``last`` one; on what is hot it would melt."""
    on_it = _stage(part.motion, "plate", adds)
    cooled = last.is_added  # by another part
    return [on_it] if cooled else [_stage("cool down", "plate", ()), on_it]


def _slot(want: Want, part: Part, mixing: Stage | None) -> Slot | None:
    """Return how a food comes on the dish that is not mixed with others before."""
    if mixing is not None or not part.motion:
        return None
    return Slot(singular(want.label), want.facts.kind, want.leaf, (), part.motion)


def _on_base(stages: list[Stage], joins: list[Join], part: Part, tin: str) -> tuple[list[Stage], list[Join]]:
    """Return stages in which the batter comes onto a base that was pressed in the tin."""
    place = next((n for n, stage in enumerate(stages) if "heat" in stage.does), len(stages))
    mixing = _mixing(part)
    pressed = Stage((Line((mixing,)),), "press", frozenset({"shape"}), (), tin, "in", "", "", "", (), ADDED)
    before = (Line(tuple(stages[:place])),) if place else ()
    old = stages[place] if place < len(stages) else _cold("chill")
    new = replace(old, adds=(*before, *old.adds), vessel=tin, relation="in")
    spot = Spot(
        path=(0, 0), stage=mixing, stage_type=StageType("mix", "later", joins=True), side=True, after=(pressed, new)
    )
    moved = [_moved(join, old, new) for join in joins]
    moved += [Join(want, spot, UNNATURAL) for want in part.wants]
    return [pressed, new, *stages[place + 1 :]], moved


def baked_at_last(line: Line, joins: Sequence[Join], title: str) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that ends in the oven, and its ``joins``, with what is browned there on top, if the title asks so.

    What boils in its dish never ends there, whatever else its title names: a baked potato soup is a soup.
    """
    at_last = _is_baked_at_last(title)
    bakes = [stage for stage in line.stages if stage.does >= {"dry", "heat"}]
    if bakes:
        joins = _browned_on(bakes[-1], line.stages, joins) if at_last else joins
        return line, _strewn_on(bakes[-1], line.stages, joins)
    if not at_last or not _is_cooked_in_no_oven(line):
        return line, tuple(joins)
    stages = _without_idle_end(line.stages, joins)
    does = frozenset({"dry", "heat"})
    last = Stage((), "bake", does, (), "baking dish", "in", "oven", "heat", "", ("baked",), ADDED)
    spot = Spot(path=(len(stages),), stage=last, stage_type=StageType("bake", "now", joins=False), side=False, after=())
    tops = [join for join in joins if join.want.facts.is_any(word_list("is browned on top"))]
    return Line((*stages, last)), _laid_at(spot, joins, tops)


def _is_baked_at_last(title: str) -> bool:
    title_words = words(title)
    boils = says(title_words, "boils in the dish")
    return not boils and says(title_words, "is baked at last")


def _is_cooked_in_no_oven(line: Line) -> bool:
    hot = [stage for stage in line.stages if "heat" in stage.does]
    return bool(hot) and all(stage.appliance != "oven" for stage in hot)


def _without_idle_end(stages: Sequence[Stage], joins: Sequence[Join]) -> list[Stage]:
    """Return ``stages`` without those at their end that only carry the dish, and at which nothing joins it."""
    kept = list(stages)
    taken = {id(join.spot.stage) for join in joins}
    while only_carries(kept[-1]) and id(kept[-1]) not in taken and not kept[-1].adds:
        kept.pop()
    return kept


def _laid_at(spot: Spot, joins: Sequence[Join], tops: Sequence[Join]) -> tuple[Join, ...]:
    """Return ``joins`` with the ``tops`` at a stage of their own, unless there is nothing below them."""
    if len(tops) == len(joins):
        return tuple(joins)
    return tuple(replace(join, spot=spot, slot=None) if join in tops else join for join in joins)


def _browned_on(bakes: Stage, stages: Sequence[Stage], joins: Sequence[Join]) -> tuple[Join, ...]:
    """Return ``joins`` with cheese and crumbs on what is baked last of all, where there is something below.

    Where flour makes a sauce for pasta, the cheese belongs to that.
    """
    tops = [one for one in joins if one.want.make and one.want.facts.is_any(word_list("is browned on top"))]
    if any_is(joins, "flour") and any_is(joins, *word_list("is eaten with a sauce")):
        tops = [one for one in tops if not one.want.facts.is_any(word_list("melts on top"))]
    return _laid_at(_spot_of(bakes, stages), joins, tops)


def _spot_of(bakes: Stage, stages: Sequence[Stage]) -> Spot:
    place = next(place for place, stage in enumerate(stages) if stage is bakes)
    return Spot((place,), bakes, StageType("bake", "now", joins=False), side=False, after=tuple(stages[place + 1 :]))


def _strewn_on(bakes: Stage, stages: Sequence[Stage], joins: Sequence[Join]) -> tuple[Join, ...]:
    """Let crumbs come on what is baked, where they neither coat nor bind anything."""
    bound = any(
        join.want.facts.is_a("egg", *word_list("is coated")) and "ready" not in join.want.facts.traits for join in joins
    )
    boiled = any(join.want.facts.is_a(*word_list("is eaten with a sauce"), "vegetable") for join in joins)
    if bound or not boiled:
        return tuple(joins)
    spot = _spot_of(bakes, stages)
    strewn = word_list("is strewn on what is baked")
    return tuple(replace(one, spot=spot, slot=None) if one.want.facts.is_any(strewn) else one for one in joins)


def _cold(motion: str) -> Stage:
    return Stage((), motion, frozenset({"wait"}), (), "", "in", "refrigerator", "cold", "", (), ADDED)


def _moved(join: Join, old: Stage, new: Stage) -> Join:
    return replace(join, spot=replace(join.spot, stage=new)) if join.spot.stage is old else join


def _mixing(part: Part) -> Stage:
    """Return the stage at which the foods of a part are mixed."""
    return replace(stage_of(part.mixes), vessel="bowl", label="")


def _stage(motion: str, vessel: str, adds: tuple[Line, ...]) -> Stage:
    does = frozenset({"wait"} if motion in word_list("cools") else {"coat", "move"})
    return Stage(adds, motion, does, (), vessel, "on", "", "", "", (), ADDED)
