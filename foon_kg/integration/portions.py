"""Flesh in portions that is the dish: baked with what seasons it, or fried on both sides with what makes its sauce."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.coated import is_portion
from foon_kg.integration.course import HEATS
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.places import NATURAL, Join
from foon_kg.integration.preparation import owed

_MIX = Stage((), "mix", frozenset({"mix"}), ("spoon",), "bowl", "in", "", "", "mixture", (), 0)
_COOK = replace(_MIX, motion="cook", does=frozenset({"heat"}), tools=(), vessel="cooking pan", label="")
_COOK = replace(_COOK, appliance="stove", source="heat")
_STIR = replace(_COOK, motion="cook and stir", does=frozenset({"heat", "mix"}), tools=("spoon",))
_TURN = replace(_COOK, motion="flip", does=frozenset({"turn"}), tools=("turner",))
_SIMMER = replace(_COOK, motion="simmer", does=frozenset({"heat", "liquid"}))
_LAID = replace(_MIX, motion="", does=frozenset(), tools=(), vessel="baking dish", label="")
_BAKE = replace(_COOK, motion="bake", does=frozenset({"dry", "heat"}), vessel="baking dish", appliance="oven")
_TOP = replace(_LAID, vessel="plate", relation="on")


def in_portions(
    line: Line, joins: Sequence[Join], told: Collection[str], known: Tables, *, baked: bool
) -> tuple[Line, tuple[Join, ...]]:
    """Return how flesh is cooked that is the dish and comes in portions; else the line and joins as they are.

    ``told`` are the words of type and title; ``baked``: they say that it comes out of an oven.
    """
    portions = _Portions(joins, told, known)
    if portions.main is None or not word_list("is eaten with a spoon or fork").isdisjoint(told):
        return line, tuple(joins)
    hot = [stage for stage in line.all_stages() if not stage.does.isdisjoint(HEATS)]
    ovens = any(stage.appliance == "oven" for stage in hot)
    fried = not word_list("is fried on both sides").isdisjoint(told) or (portions.bath and not baked)
    fried = fried and word_list("is baked on a sheet").isdisjoint(told)
    return portions.fried() if fried or not (baked or ovens) else portions.baked()


def stirred_in_pieces(line: Line, joins: Sequence[Join], known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how flesh is fried that is asked in pieces, where its video turns over a whole one: stirred with the rest.

    Grain that is boiled by itself is served with it.
    """
    flesh = [
        join for join in joins if join.want.facts.is_a(*word_list("is flesh")) and "cook" in owed(join.want, known)
    ]
    cut = [join for join in flesh if join.want.make and (known.state(join.want.make).fine or 0) > 1]
    turns = any("turn" in stage.does for stage in line.all_stages())
    coated = any(join.want.facts.is_a(*word_list("coats roughly")) for join in joins)
    if not turns or not cut or len(cut) != len(flesh) or coated:
        return line, tuple(joins)
    pan, top = replace(_STIR), replace(_TOP)
    stages = (pan, top)
    found = []
    for join in joins:
        facts = join.want.facts
        beside = facts.is_a(*word_list("is eaten beside what is stewed")) or facts.is_a(*word_list("lies on flesh"))
        stage = top if beside and not join.want.squeezed else pan
        spot = replace(join.spot, stage=stage, after=stages[_place(stages, stage) + 1 :], side=False)
        found.append(Join(join.want, spot, min(join.fit, NATURAL)))
    return Line(stages), tuple(found)


class _Portions:
    def __init__(self, joins: Sequence[Join], told: Collection[str], known: Tables) -> None:
        self.joins = joins
        self.known = known
        seared = not word_list("is fried on both sides").isdisjoint(told)
        flesh = [join for join in joins if self._is_flesh(join)]
        flesh = flesh or [join for join in joins if seared and self._is_all_that_cooks(join)]
        whole = len(flesh) == 1 and (is_portion(flesh[0].want, known) or (seared and self._is_all_that_cooks(flesh[0])))
        self.main = flesh[0] if whole else None
        self.bath = any(join.want.facts.is_a("cooking liquid") for join in joins)

    def _is_flesh(self, join: Join) -> bool:
        raw = "cook" in owed(join.want, self.known) and not (join.want.cooked and join.want.make)
        small = join.want.facts.is_a(*word_list("is fried rather than boiled"))
        return raw and not small and join.want.facts.is_a(*word_list("comes in portions"))

    def _is_all_that_cooks(self, join: Join) -> bool:
        """Whether a food is a mouthful that is turned piece by piece, and nothing else has to be cooked."""
        others = (one for one in self.joins if one is not join and {"cook", "boil"} & owed(one.want, self.known))
        raw = "cook" in owed(join.want, self.known)
        return raw and join.want.facts.is_a(*word_list("is a mouthful")) and not any(others)

    def baked(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that lays all in a dish, pours over it what is mixed for it, and bakes it."""
        mix, bake, top = replace(_MIX), replace(_BAKE), replace(_TOP)
        laid, over = replace(_LAID), replace(_LAID, adds=(Line((mix,)),))
        stages = (laid, over, bake, top)

        def stage_of(join: Join) -> Stage:
            facts = join.want.facts
            if self._is_on_top(join):
                return top
            if join is self.main or not facts.is_a(*word_list("is mixed for flesh")):
                return bake if facts.is_a(*word_list("melts on top")) else laid
            return mix

        return self._line(stages, mix, stage_of)

    def fried(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that fries the flesh on both sides and then cooks the rest with it."""
        first, turn, top = replace(_COOK), replace(_TURN), replace(_TOP)
        second = replace(_SIMMER if self.bath else _COOK)
        stages = (first, turn, second, top)
        fats = [join for join in self.joins if join.want.facts.is_a("fat")]

        def stage_of(join: Join) -> Stage:
            facts = join.want.facts
            if join is self.main or join in fats or facts.is_a(*word_list("is strewn on flesh")):
                return first
            return top if self._is_on_top(join) else second

        return self._line(stages, None, stage_of)

    def _is_on_top(self, join: Join) -> bool:
        lies = join.want.facts.is_a(*word_list("is served with what is fried"), *word_list("lies on flesh"))
        lies = lies and not (join.want.squeezed or not word_list("runs").isdisjoint({join.want.asked}))
        return lies and not join.want.facts.is_a(*word_list("is cooked with flesh"))

    def _line(
        self, stages: tuple[Stage, ...], mix: Stage | None, stage_of: Callable[[Join], Stage]
    ) -> tuple[Line, tuple[Join, ...]]:
        found = []
        for join in self.joins:
            stage = stage_of(join)
            after = stages[1:] if stage is mix else stages[_place(stages, stage) + 1 :]
            spot = replace(join.spot, stage=stage, after=after, side=stage is mix)
            want = replace(join.want, cooked=False) if join is self.main else join.want  # the dish itself cooks it
            found.append(Join(want, spot, min(join.fit, NATURAL)))
        return Line(stages), tuple(found)


def _place(stages: Sequence[Stage], stage: Stage) -> int:
    return next(place for place, one in enumerate(stages) if one is stage)
