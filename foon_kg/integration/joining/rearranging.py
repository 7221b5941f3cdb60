"""Where foods join because of what else is asked: what was bought already, what lies on what, what is left alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.joining.layouts import Layout
from foon_kg.integration.joining.spots import IN_PLACE, UNNATURAL, Join, Spot, any_is, only_carries

_CHANGES = frozenset({"blend", "knead", "mash", "shape"})
_SLICES = word_list("carries what is stacked")


def on_ready_dough(layout: Layout, joins: Sequence[Join]) -> list[Join]:
    """Return ``joins`` with what the video of ``layout`` works into its dough, or lays on it first, on bought dough."""
    laid = layout.laid
    if laid is None:
        return list(joins)
    if _carries_it_all(laid, joins):
        return [replace(one, spot=laid) if _joins_before(one, laid) else one for one in joins]
    ready = next((join for join in joins if _is_ready_dough(join)), None)
    if ready is None:
        return list(joins)
    return [Join(one.want, laid, UNNATURAL) if _joins_before(one, ready.spot) else one for one in joins]


def _carries_it_all(laid: Spot, joins: Sequence[Join]) -> bool:
    """Whether bread takes the place of the dough of a video, and no flour is there to make one."""
    return any_is([join for join in joins if join.spot is laid], *_SLICES) and not any_is(joins, "flour")


def _is_ready_dough(join: Join) -> bool:
    return join.fit == IN_PLACE and join.want.facts.is_a("dough")


def _joins_before(join: Join, spot: Spot) -> bool:
    return any(stage is spot.stage for stage in join.spot.after)


def in_its_layer(layout: Layout, join: Join) -> Join:
    """Return a join with its place among others that are laid on the dough or bread of ``layout``."""
    if layout.laid is None or join.spot is not layout.laid:
        return join
    is_a = join.want.facts.is_a
    if is_a("dough", *_SLICES):
        layer = 0
    elif is_a(*word_list("lies on dough first")):
        layer = 1
    else:
        layer = 2 if is_a(*word_list("lies on dough next")) else 3
    return replace(join, layer=layer)


def without_lone(layout: Layout, joins: Sequence[Join]) -> tuple[Join, ...]:
    """Return ``joins`` with a food at the dish itself that would be all that is left of a cold line of ``layout``.

    Nobody sets up a blender for some chives because a video made a pesto with it.
    """
    if not layout.cold_lines or not any(join.spot.side for join in joins):
        return tuple(joins)
    found = []
    for join in joins:
        left = [line for line in _lines_around(join.spot) if _is_all_of(line, layout, join, joins)]
        found.append(_at_what_takes(left[-1], layout, join) if left else join)
    return tuple(found)


def _lines_around(spot: Spot) -> Iterator[tuple[int, ...]]:
    """Yield the paths of the side lines in which a stage is, from within; that of the dish itself has one number."""
    for end in range(len(spot.path) - 1, 1, -2):
        yield spot.path[:end]


def _is_all_of(line: tuple[int, ...], layout: Layout, join: Join, joins: Sequence[Join]) -> bool:
    """Whether a food is alone in a side line that is made without heat, and makes no such thing by itself."""
    if line not in layout.cold_lines:
        return False
    if join.slot is not None and layout.cold_lines[line].isdisjoint(_CHANGES):
        return False
    return not any(other is not join and other.spot.path[: len(line)] == line for other in joins)


def _at_what_takes(line: tuple[int, ...], layout: Layout, join: Join) -> Join:
    """Return a food at the stage that a side line joins."""
    spot = next(spot for spot in layout.spots if spot.path == line[:-1])
    return Join(join.want, spot, min(join.fit, UNNATURAL))


def where_it_is_stacked(layout: Layout, joins: Sequence[Join]) -> list[Join]:
    """Return ``joins`` with bread that nobody heats any more below all the rest and on top of it, when that comes.

    ``layout`` is that of the recorded dish.
    """
    last = layout.spots[-1]
    cold = [join for join in joins if join.spot is not last and not join.spot.heats_later]
    if not only_carries(last.stage) or any(not join.want.facts.is_any(_SLICES) for join in cold):
        return list(joins)
    return [replace(join, spot=last) if join in cold else join for join in joins]
