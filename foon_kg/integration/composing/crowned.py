"""What lies on a dish that comes out of a pot or pan: nobody cooks it, whatever its video does."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Food, Tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.course import HEATS, WORKS, Plan
from foon_kg.integration.joining.spots import Join, only_carries, spots_of
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Line, Stage

_MELTS = word_list("melts on what is hot")
_THICKENS = word_list("thickens what is boiled")
_POWDER = 5


def crowned(line: Line, plan: Plan, known: Tables) -> tuple[Line, Plan]:
    """Return how a dish is made whose nuts, wedges and the like come on it when it is done.

    That is so where the last that is done to the dish is to cook it over the heat.
    """
    hot = [place for place, stage in enumerate(line.stages) if not stage.does.isdisjoint(HEATS)]
    if not hot or plan.stacked or plan.cold or plan.laid or plan.in_pieces or plan.tin:
        return line, plan
    last, rest = line.stages[hot[-1]], line.stages[hot[-1] + 1 :]
    if "dry" in last.does or any(not stage.does.isdisjoint(WORKS) for stage in rest):
        return line, plan
    tops = [join for join in plan.joins if not join.spot.side and _lies_on_it(join, plan, known)]
    if not tops or len(tops) == len(plan.joins):
        return line, plan
    if rest:
        top = rest[-1]
    else:
        top = Stage((), "", frozenset(), (), "bowl", "in", "", "", last.label, last.states, last.step)
        line = Line((*line.stages, top))
    joins = [_ending(join, top, on_top=join in tops) for join in plan.joins]
    return line, replace(plan, joins=joins)


def strewn_under(line: Line, joins: Sequence[Join], known: Tables) -> tuple[Join, ...]:
    """Return joins with what is strewn under dough where that comes on what it is baked on, so that it does not stick.

    It is no part of the dough that is made of something else, nor of what lies on it.
    """
    rows = ((stage, known.utensil(stage.vessel) if stage.vessel else None) for stage in line.stages)
    tin = next((stage for stage, row in rows if row is not None and "bake" in row.can), None)
    own = {join.want.number for join in joins if join.want.facts.is_a(*word_list("is strewn under dough"))}
    dough = any(join.want.facts.is_a("dough", "flour") for join in joins if join.want.number not in own)
    if tin is None or not dough:
        return tuple(joins)
    spot = next(spot for spot in spots_of(line) if spot.stage is tin)
    return tuple(replace(join, spot=spot, slot=None) if join.want.number in own else join for join in joins)


def wedges_last(
    line: Line, joins: Sequence[Join], *, spooned: bool, slices_beside: bool
) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish is made beside which wedges are served: nobody cooks them, whatever comes into its place.

    Where all is eaten with the spoon (``spooned``) they lie in its bowl. ``slices_beside``: slices that the
    recorded dish does not cook are served so, too, unless something soaks them. They lie in what the dish is served in.
    """
    slices_beside = slices_beside and not any(
        join.want.facts.is_a(*word_list("is soaked up by slices")) for join in joins
    )
    found = [
        join
        for join in joins
        if join.spot.heats_later and (_is_wedge(join.want) or (slices_beside and _is_slices_beside(join)))
    ]
    if not found or len(found) == len(joins):
        return line, tuple(joins)
    last = line.stages[-1]
    if only_carries(last) and last.vessel and not any(_is_wedge(join.want) for join in found):
        top = last
    else:
        vessel, relation = ("bowl", "in") if spooned else ("plate", "on")
        top = Stage((), "", frozenset(), (), vessel, relation, "", "", "", (), last.step)
        idle = only_carries(last) and not last.adds and not any(join.spot.stage is last for join in joins)
        line = Line((*(line.stages[:-1] if idle else line.stages), top))  # it is brought to one place, and no further
    ending = (_ending(join, top, on_top=join in found) for join in joins)
    return line, tuple(replace(join, slot=None) if join.on_top else join for join in ending)


def _is_wedge(want: Want) -> bool:
    """Whether a fruit is called or asked in wedges, of which everyone presses the juice out."""
    wedge = word_list("is cut so by name") & {want.make, *words(want.label)[-1:]}
    return bool(wedge) and want.facts.is_a(*word_list("is a wedge beside it"))


def _is_slices_beside(join: Join) -> bool:
    """Whether slices would come into a pan in which the recorded dish has none."""
    slices = not join.want.make or join.want.make in word_list("is a slice")
    dry = any("dry" in stage.does for stage in (join.spot.stage, *join.spot.after))
    return join.slot is None and slices and not dry and join.want.facts.kind in word_list("is sliced and served beside")


def _ending(join: Join, top: Stage, *, on_top: bool) -> Join:
    """Return a food that joins before ``top``, or there."""
    spot = join.spot
    if on_top:
        return replace(join, spot=replace(spot, stage=top, after=()), on_top=True)
    there = spot.stage is top or any(stage is top for stage in spot.after)
    return join if there else replace(join, spot=replace(spot, after=(*spot.after, top)))


def _lies_on_it(join: Join, plan: Plan, known: Tables) -> bool:
    """Whether a food is eaten on a dish of these foods, in the form in which it is asked."""
    facts, want = join.want.facts, join.want
    others = [one.want.facts for one in plan.joins if one is not join]
    beside = not plan.spooned and facts.is_a(*word_list("is eaten beside what is stewed")) and _is_apart(want)
    if plan.one_pot and (beside or _floats(facts, others)):
        return True
    wet = any(one.is_of(*word_list("is a bath")) and not one.is_a(*word_list("is no bath")) for one in others)
    boiled = want.make in word_list("is so by boiling")
    if wet and boiled and facts.is_a(*word_list("lies on what is wet when it is boiled")):
        return True
    if want.cooked or want.squeezed or (want.make and (known.state(want.make).fine or 0) >= _POWDER):
        return False
    return _lies_on(facts, others, wet=wet)


def _lies_on(facts: Food, others: Sequence[Food], *, wet: bool) -> bool:
    """Whether a food lies on a dish of ``others`` as it is: on what is cooked, tossed, eaten with a spoon, grated over.

    ``wet`` says that there is a bath among them.
    """
    tossed = any(one.is_a(*word_list("is eaten with a sauce")) for one in others)
    if facts.is_a(*word_list("lies on what is cooked")):
        return True
    if tossed and facts.is_a(*word_list("is strewn on what is tossed")):
        return True
    if facts.is_a(*word_list("lies on what is eaten with a spoon")):
        return wet or tossed
    bound = any(one.is_a(*word_list("binds what is grated over it")) for one in others)
    return wet and not bound and facts.is_a(*word_list("is grated over it"))


def _is_apart(want: Want) -> bool:
    """Whether what is eaten beside a stew is asked cooked, or needs no cooking."""
    return want.cooked or {"boil", "cook"}.isdisjoint(want.facts.owes)


def _floats(facts: Food, others: Sequence[Food]) -> bool:
    """Whether a food floats on what is boiled: bread, what melts on that, and what nothing else thickens."""
    floats = word_list("floats on top")
    if facts.is_a(*floats) or (facts.is_a(*_MELTS) and any(one.is_a(*floats) for one in others)):
        return True
    thick = any(one.is_a("flour", *_THICKENS) for one in others)
    return not thick and facts.is_a(*word_list("is spooned onto it"))
