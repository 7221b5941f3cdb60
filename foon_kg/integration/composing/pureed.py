"""What is cooked in a liquid is blended when it is done, if it is to be smooth: not raw, nor what stays in pieces."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Dish
from foon_kg.integration.joining.comers import is_strewn
from foon_kg.integration.joining.course import HEATS
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.teaching.frames import Line, Slot, Stage

_JOINED = frozenset({"and", "con", "in", "on", "over", "with"})
"""After these words a title says no more what a dish is."""

_LEAST = 2
"""Of so many foods that run a sauce is made."""

_BLENDED = Stage((), "blend", frozenset({"blend", "mix"}), (), "blender jar", "in", "blender", "power", "", (), 0)
_SERVED = Stage((), "", frozenset(), (), "bowl", "in", "", "", "", (), 0)
_SIMMERED = Stage((), "simmer", frozenset({"heat", "liquid"}), (), "pot", "on", "stove", "heat", "", (), 0)


def blended_when_done(
    line: Line, joins: Sequence[Join], told: Collection[str], *, cold: bool = False
) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish with a liquid is cooked and blended, by the words of its title and its foods.

    One that is never heated (``cold``) is only blended.
    """
    stages = list(line.all_stages())
    blends = [place for place, stage in enumerate(stages) if "blend" in stage.does]
    hot = [place for place, stage in enumerate(stages) if not stage.does.isdisjoint(HEATS)]
    facts = [join.want.facts for join in joins]
    pieces = any(one.is_a(*word_list("stays in pieces")) for one in facts)
    named = not word_list("is blended smooth").isdisjoint(told)
    smooth = not pieces and (named or any(_makes_it_smooth(join, told) for join in joins))
    cold = not word_list("is served cold").isdisjoint(told) and not any(
        {"cook", "boil"} & one.owes.keys() for one in facts
    )
    raw_first = bool(blends) and any(place > blends[-1] for place in hot)
    if cold and not pieces:
        return _with_stages(joins, (replace(_BLENDED),))
    if smooth and (raw_first or not blends):
        return _with_stages(joins, (_boiling(stages, hot), replace(_BLENDED)))
    if raw_first:
        return _with_stages(joins, (_boiling(stages, hot),))
    return line, tuple(joins)


def is_stewed(title: str, dishes: Collection[Dish], joins: Sequence[Join], known: Tables) -> bool:
    """Whether all is cooked together in a pot: a title ends so, or flesh in pieces is asked with a sauce."""
    head = list(itertools.takewhile(lambda word: word not in _JOINED, words(title)))
    other = any(dish.stacked or dish.dressed or dish.laid or dish.baked for dish in dishes)
    named = bool(head) and head[-1] in word_list("is cooked in one pot")
    return not other and (named or _is_in_sauce(joins, words(title), known))


def _is_in_sauce(joins: Sequence[Join], told: Sequence[str], known: Tables) -> bool:
    """Whether flesh that is asked in pieces has a sauce to be cooked in, and nothing says that it is made otherwise."""
    if not told or any(known.state(word).needs_heat for word in told if word in known.states):
        return False
    facts = [join.want.facts for join in joins]
    pieces = any(
        join.want.facts.is_a(*word_list("is flesh")) and (known.state(join.want.make).fine or 0) > 0
        for join in joins
        if join.want.make and "cook" in join.want.facts.owes
    )
    sauce = sum(one.is_of(*word_list("is cooked in for long")) for one in facts) >= _LEAST
    return pieces and sauce and not any(one.is_a(*word_list("is never in a pot so")) for one in facts)


def stewed(joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that cooks all in a pot, each food in its phase, and serves it."""
    return _with_stages(joins, (replace(_SIMMERED),))


def _makes_it_smooth(join: Join, told: Collection[str]) -> bool:
    """Whether a dish is blended for what it is called by, or because there is such a food in it."""
    names = word_list("is blended where a title names it") & set(told)
    return join.want.facts.is_a(*word_list("is blended when it is soft")) or not names.isdisjoint(
        words(join.want.label)
    )


def _boiling(stages: Sequence[Stage], hot: Sequence[int]) -> Stage:
    """Return the stage at which everything is cooked: as the video does it at last, with its water."""
    found = [stages[place] for place in hot if stages[place].source == "heat" and "dry" not in stages[place].does]
    stage = found[-1] if found else _SIMMERED
    return replace(stage, adds=tuple(add for add in stage.adds if isinstance(add, Slot)))


def _with_stages(
    joins: Sequence[Join], works: tuple[Stage, ...], served: Stage = _SERVED
) -> tuple[Line, tuple[Join, ...]]:
    """Return a line of these stages, at the first of which all joins that is not strewn on what is served."""
    stages = (*works, replace(served))
    found = []
    for join in joins:
        late = is_strewn(join) or join.want.facts.is_a(*word_list("floats on top"))
        at = len(works) if late else 0
        spot = replace(join.spot, stage=stages[at], side=False, after=stages[at + 1 :])
        found.append(replace(join, spot=spot, slot=None))
    return Line(stages), tuple(found)
