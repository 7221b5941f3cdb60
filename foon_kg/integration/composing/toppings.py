"""What lies on a dish that comes out of a pot or pan: nobody cooks it, whatever its video does."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Food, Tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import POWDER
from foon_kg.integration.bench import fineness
from foon_kg.integration.joining.additions import is_bath
from foon_kg.integration.joining.course import WORKS, Plan
from foon_kg.integration.joining.spots import Join, any_is, is_ladled, only_carries, spots_of
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Line, Stage

_MELTS = word_list("melts on what is hot")
_THICKENS = word_list("thickens what is boiled")


def with_toppings_last(line: Line, plan: Plan, known: Tables) -> tuple[Line, Plan]:
    """Return ``line`` and ``plan`` for a dish whose nuts, wedges and the like come on it when it is done.

    That is so where the last that is done to the dish is to cook it over the heat. ``known`` are the tables.
    """
    if any((plan.stacked, plan.cold, plan.laid, plan.in_pieces, plan.tin)):
        return line, plan  # such a dish does not come out of a pot or pan, or has an order of its own
    place = _cooked_last(line)
    tops = [join for join in plan.joins if _is_loose(join) and _lies_on_it(join, plan, known)]
    if place is None or len(tops) in {0, len(plan.joins)}:
        return line, plan
    last, rest = line.stages[place], line.stages[place + 1 :]
    if rest and not is_ladled(rest[-1]):
        top = rest[-1]
    else:
        top = Stage((), "", frozenset(), (), "bowl", "in", "", "", last.label, last.states, last.step)
        line = Line((*line.stages, top))
    joins = [_ending(join, top, on_top=join in tops) for join in plan.joins]
    return line, replace(plan, joins=joins)


def _is_loose(join: Join) -> bool:
    """Whether a food joins the dish itself, and is nothing in which one of its foods is turned."""
    return not join.spot.side and "coat" not in join.spot.stage.does


def _cooked_last(line: Line) -> int | None:
    """Return the place of the stage that cooks a dish over the heat, if nothing is done to it after that."""
    hot = [place for place, stage in enumerate(line.stages) if stage.heats]
    if not hot or "dry" in line.stages[hot[-1]].does:
        return None
    return hot[-1] if all(stage.does.isdisjoint(WORKS) for stage in line.stages[hot[-1] + 1 :]) else None


def strewn_under(line: Line, joins: Sequence[Join], known: Tables) -> tuple[Join, ...]:
    """Return joins with what is strewn under the dough of ``line`` where it comes on what it is baked on.

    It would stick there otherwise. It is no part of the dough that is made of something else, nor of what lies on it.
    ``known`` are the tables.
    """
    strewn = [join for join in joins if join.want.facts.is_any(word_list("is strewn under dough"))]
    tin = _tin(line, known)
    if tin is None or not any_is([join for join in joins if join not in strewn], "dough", "flour"):
        return tuple(joins)
    spot = {id(spot.stage): spot for spot in spots_of(line)}[id(tin)]
    return tuple(replace(join, spot=spot, slot=None) if join in strewn else join for join in joins)


def _tin(line: Line, known: Tables) -> Stage | None:
    """Return the first stage of a line in something that one bakes in or on."""
    for stage in line.stages:
        row = known.utensil(stage.vessel) if stage.vessel else None
        if row is not None and "bake" in row.can:
            return stage
    return None


def wedges_last(
    line: Line, joins: Sequence[Join], *, spooned: bool, slices_beside: bool
) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` for a dish beside which wedges are served: nobody cooks them, wherever they come.

    Where all is eaten with the spoon (``spooned``) they lie in its bowl. ``slices_beside``: slices that the recorded
    dish does not cook are served so, too, unless something soaks them. They lie in what the dish is served in.
    """
    slices_beside = slices_beside and not any_is(joins, *word_list("is soaked up by slices"))

    def lies_beside(join: Join) -> bool:
        there = _is_wedge(join.want) or (slices_beside and _is_slices_beside(join))
        return there and join.spot.heats_later

    found = [join for join in joins if lies_beside(join)]
    if len(found) in {0, len(joins)}:
        return line, tuple(joins)
    line, top = _served_with(line, joins, found, spooned=spooned)
    ending = (_ending(join, top, on_top=join in found) for join in joins)
    return line, tuple(replace(join, slot=None) if join.on_top else join for join in ending)


def _served_with(line: Line, joins: Sequence[Join], beside: Sequence[Join], *, spooned: bool) -> tuple[Line, Stage]:
    """Return a line with its last stage, at which what lies ``beside`` it comes: on a plate, or in the bowl."""
    last = line.stages[-1]
    if only_carries(last) and last.vessel and not any(_is_wedge(join.want) for join in beside):
        return line, last
    vessel, relation = ("bowl", "in") if spooned else ("plate", "on")
    top = Stage((), "", frozenset(), (), vessel, relation, "", "", "", (), last.step)
    idle = only_carries(last) and not last.adds and not any(join.spot.stage is last for join in joins)
    return Line((*(line.stages[:-1] if idle else line.stages), top)), top  # it is brought to one place, and no further


def _is_wedge(want: Want) -> bool:
    """Whether a fruit is called or asked in wedges, of which everyone presses the juice out."""
    wedge = word_list("is cut so by name") & {want.make, *words(want.label)[-1:]}
    return bool(wedge) and want.facts.is_any(word_list("is a wedge beside it"))


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
    if plan.one_pot and (_floats(facts, others) or _is_eaten_beside(want, plan)):
        return True
    wet = any(map(is_bath, others))
    if wet and _lies_there_boiled(want):
        return True
    return not _is_changed(want, known) and _lies_on(facts, others, wet=wet)


def _is_changed(want: Want, known: Tables) -> bool:
    """Whether a food is asked cooked, as juice, or ground, and is no more what lies on a dish."""
    return want.cooked or want.squeezed or fineness((want.make,), known) >= POWDER


def _lies_there_boiled(want: Want) -> bool:
    """Whether a food is asked boiled, and lies on what is wet then."""
    boiled = want.make in word_list("is so by boiling")
    return boiled and want.facts.is_any(word_list("lies on what is wet when it is boiled"))


def _lies_on(facts: Food, others: Sequence[Food], *, wet: bool) -> bool:
    """Whether a food lies on a dish of ``others`` as it is: on what is cooked, tossed, eaten with a spoon, grated over.

    ``wet`` says that there is a bath among them.
    """
    tossed = any(one.is_any(word_list("is eaten with a sauce")) for one in others)
    if facts.is_any(word_list("lies on what is cooked")):
        return True
    if tossed and facts.is_any(word_list("is strewn on what is tossed")):
        return True
    if facts.is_any(word_list("lies on what is eaten with a spoon")):
        return wet or tossed
    bound = any(one.is_any(word_list("binds what is grated over it")) for one in others)
    return wet and not bound and facts.is_any(word_list("is grated over it"))


def _is_eaten_beside(want: Want, plan: Plan) -> bool:
    """Whether a food is eaten beside a stew that is not spooned, as it is asked cooked, or needs no cooking."""
    done = want.cooked or {"boil", "cook"}.isdisjoint(want.facts.owes)
    return done and not plan.spooned and want.facts.is_any(word_list("is eaten beside what is stewed"))


def _floats(facts: Food, others: Sequence[Food]) -> bool:
    """Whether a food floats on what is boiled: bread, what melts on that, and what nothing else thickens."""
    floats = word_list("floats on top")
    if facts.is_any(floats) or (facts.is_any(_MELTS) and any(one.is_any(floats) for one in others)):
        return True
    thick = any(one.is_a("flour", *_THICKENS) for one in others)
    melts_in = facts.is_any(word_list("melts into what is boiled"))
    return not thick and not melts_in and facts.is_any(word_list("is spooned onto it"))
