"""Where each asked food joins a dish: at a slot that such a food has there, else at the stage where its kind joins.

Some dishes are made in a way that says where foods without a slot go: what is drained is dressed, what is rolled out
is laid on, patties are mixed before they are shaped, sandwiches are put together at the end. What one food changes for
others is in :mod:`~foon_kg.integration.joining.rearranging`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from foon_kg.food import Level, Tables
from foon_kg.food.lists import word_list
from foon_kg.food.rows import CHOPPED
from foon_kg.integration.joining.batters import as_batter, is_of_batter, is_of_dough
from foon_kg.integration.joining.joiners import Joiner, Joiners
from foon_kg.integration.joining.joining_counts import JoiningCounts
from foon_kg.integration.joining.layouts import Layout, Place, is_need
from foon_kg.integration.joining.rearranging import in_its_layer, on_ready_dough, where_it_is_stacked, without_lone
from foon_kg.integration.joining.spots import IN_PLACE, NATURAL, UNNATURAL, Join, Spot, only_carries
from foon_kg.integration.preparing.preparation import Want, owed
from foon_kg.integration.teaching.frames import Slot
from foon_kg.similarity.roles import roles_of

_STACKED = word_list("is stacked")
_SHAPED = word_list("dough that is shaped")

_SAME_KIND, _SURE, _OTHER_KIND = 0.6, 0.8, 0.7
"""How well a food fits where one of its kind is; from which confidence on its kind does not matter; what a confidence
is worth where it is of another kind.

So a food of the same kind is always natural (:data:`~.spots.NATURAL`), one of another kind and role only if it is sure
to 0.72."""


_AS_USUAL = 0.75
"""How usual a place must be for a kind, beside its most usual one in that dish, to be taken for a like food."""

_SURELY = 0.99
"""From this fit on the slot is that of the very food, under one of its names."""

_SAME_ROLE = 0.55
"""How well a food fits where another one is that defines the dish as it does: one vegetable for another."""

_UNSEEN, _SEEN = 0.6, 0.4
"""What a place is worth in any case, and what it is worth besides as far as such a food is usual there."""

_UNCOOKED, _COLD, _SLOW, _DRAINED = 0.3, 0.3, 0.3, 0.4
"""How the likelihood of a stage changes for a food without a slot.

It falls if no heat comes any more: for what has to be cooked, and in a hot dish for all that does not join late. For
flesh, which takes long, it rises with the heat to come. It falls where the liquid is poured away later."""

MOST_JOINED = 256
"""For how many dishes it is kept where a food joins: some questions' worth of sixteen frames each."""


def _lies_on(layout: Layout, want: Want, best: Join, known: Tables) -> bool:
    """Whether a food lies on patties though the video mixes it into them."""
    fine = known.state(want.make).fineness
    return best.spot is layout.bound and fine < CHOPPED and want.facts.is_any(word_list("lies on patties"))


def _in_the_pan(layout: Layout, join: Join) -> Join:
    """Let what a video fries by itself and brings to the dish when that is done fry in the dish's own pan."""
    late = join.slot is not None and bool(join.slot.cooked) and join.spot.stage_type.heated == "before"
    due = {"cook", "boil"} & join.want.facts.owes.keys()
    hot = next((spot for spot in layout.spots if not spot.side and "heat" in spot.stage.does), None)
    return replace(join, spot=hot, slot=None) if late and not due and hot is not None else join


def _is_worked_in_or_late(join: Join | None) -> bool:
    """Whether a place is one that a food keeps, though it loses by cooking: in a mass, or when the dish is done."""
    return join is not None and (
        join.spot.stage_type.work in {"shape", "knead"} or join.spot.stage_type.heated in {"before", "never"}
    )


def _weighed(fit: float, layout: Layout, food: Joiner, spot: Spot) -> float:
    """Return how usual a stage is (``fit``), less where no heat comes that a food must or may have."""
    if not spot.heats_later:
        fit -= (_UNCOOKED if food.due else 0.0) + (_COLD if layout.heats and not food.late else 0.0)
    if food.slow:
        fit += _SLOW * spot.heats / layout.hottest
    if id(spot) in layout.drained:
        fit -= _DRAINED
    return fit


class Matcher:
    """Finds where the foods of one recipe, ``wants``, join.

    ``like(food, known)`` is how sure a cook is to accept one for the other (0 to 1). ``joiners`` keeps what is found
    for recipes with the same foods and likes.
    """

    def __init__(
        self,
        counts: JoiningCounts,
        like: Callable[[str, str], float],
        wants: Sequence[Want],
        joiners: Joiners | None = None,
    ) -> None:
        self.joining_counts = counts
        self.known = counts.known
        self.like = like
        self._joiners = (joiners or Joiners()).of(wants, self.known)

    def joins(self, layout: Layout, wants: Sequence[Want], *, stacked: bool = False) -> tuple[Join, ...]:
        """Return where in ``layout`` each food of ``wants`` joins.

        ``stacked``: on bread at the end, unless it has to be cooked.
        """
        found = [self._kept_join(layout, want, stacked=stacked) for want in wants]
        if stacked:
            found = where_it_is_stacked(layout, found)
        found = [in_its_layer(layout, join) for join in on_ready_dough(layout, found)]
        joins = without_lone(layout, found)
        if layout.batter is None or not (is_of_batter(wants) or is_of_dough(wants)):
            return joins
        return tuple(as_batter(layout.batter, joins, self.known))

    def _kept_join(self, layout: Layout, want: Want, *, stacked: bool) -> Join:
        food = self._joiners[want.number]
        found = food.joined.get((layout, stacked))
        if found is None:
            if len(food.joined) >= MOST_JOINED:
                food.joined.clear()
            found = food.joined[layout, stacked] = self._join(layout, food, stacked=stacked)
        return found if found.want is want else Join(want, found.spot, found.fit, found.slot)

    def _join(self, layout: Layout, food: Joiner, *, stacked: bool) -> Join:
        """Return where a food joins a dish: where its like does, if there is such, else where the dish has room for it.

        What is bought ready takes the place of all that makes it, so that comes first; how the dish is made overrules
        the slot of a like food, and is asked again, by other rules, where there is none.
        """
        bought = self._in_place_of(layout, food.want) if food.ready_made else None
        if bought is not None:
            return bought
        best = self._natural(layout, food)
        if best is not None:
            best = _in_the_pan(layout, best)
        spot = self._rather_than(best, layout, food, stacked=stacked)
        if spot is not None:
            return food.at(spot)
        best = self._at_the_end(layout, food, best) or best
        if best is not None:
            return best
        spot = self._by_the_dish(layout, food)
        return self._usual(layout, food) if spot is None else food.at(spot)

    def _rather_than(self, best: Join | None, layout: Layout, food: Joiner, *, stacked: bool) -> Spot | None:
        """Return where a food joins whatever place such a food has in the dish: on bread, at the plate, in the pan.

        ``best`` is that place; ``stacked``: the dish is put together on bread.
        """
        want = food.want
        if stacked and (best is None or _lies_on(layout, want, best, self.known)) and self._is_stacked(layout, want):
            return layout.spots[-1]
        if layout.turned is not None and food.served and (best is None or best.fit < _SURELY):
            return layout.turned
        return layout.pan if food.fat else None

    def _by_the_dish(self, layout: Layout, food: Joiner) -> Spot | None:
        """Return where the way in which a dish is made says that a food joins for which it has no slot."""
        ways = ((layout.laid, not food.worked), (layout.bound, food.binds), (layout.beaten, food.beaten))
        for spot, joins_there in ways:
            if spot is not None and joins_there:
                return spot
        late = food.topping or (food.floats and not layout.dry)
        return layout.spots[-1] if late and only_carries(layout.spots[-1].stage) else None

    def _is_stacked(self, layout: Layout, want: Want) -> bool:
        """Whether a food may come to a dish when it is put together on bread."""
        if not any("heat" in spot.stage.does for spot in layout.spots) and only_carries(layout.spots[-1].stage):
            return True
        uncooked = {"cook", "boil"}.isdisjoint(owed(want, self.known, Level.FATAL)) and not want.cooked
        binds = want.facts.is_any(word_list("binds patties"))
        return uncooked and not binds and want.facts.is_any(_STACKED) and only_carries(layout.spots[-1].stage)

    def _at_the_end(self, layout: Layout, food: Joiner, best: Join | None) -> Join | None:
        """Return where in a hot dish a food joins that loses by cooking: when the dish is done."""
        if not food.fresh or layout.bound is not None or _is_worked_in_or_late(best):
            return None
        done = layout.done
        if not done:
            return None
        spot = next((spot for spot in done if spot.stage.adds), done[-1])
        return food.at(spot) if best is None else Join(food.want, spot, best.fit)

    def _natural(self, layout: Layout, food: Joiner) -> Join | None:
        """Return the slot that such a food has there: the likest, the first of equally like ones."""
        found: Place | None = None
        most = NATURAL - 1e-9  # a fit of just that is natural
        needs = self._needs_of(food, layout.frame.dish_type)
        for place in layout.places:
            fit = self._fit(food, place, needs)
            if fit <= most or (place.slot.kind == "water" and not food.runs):
                continue  # nor does a solid take the place of the water in which a dish is cooked
            if NATURAL <= fit < _SURELY and place.slot.kind != food.want.facts.kind:
                fit *= self._as_usual(layout, food, place)
            if fit > most:
                found, most = place, fit
        return None if found is None else Join(food.want, found.spot, most, found.slot)

    def _fit(self, food: Joiner, place: Place, needs: frozenset[str]) -> float:
        """Return how well a food takes the slot of a place, be it only in its role among the ``needs`` of the dish."""
        fit = food.fits.get(place.key)
        if fit is None:
            fit = food.fits[place.key] = self._fitting(food, place.slot)
        if fit < _SAME_ROLE and needs and food.plays_the_role_at(place, needs):
            return _SAME_ROLE
        return fit

    def _as_usual(self, layout: Layout, food: Joiner, place: Place) -> float:
        """Return what a slot of a like food is worth: 1 where foods of this one's own kind join there, too.

        A like food may join elsewhere than foods of this one's kind do, where these join most: chives late, onions
        early.
        """
        if food.main and place.main and place.spot is layout.bound:
            return 1.0  # patties are made of whatever they are made of
        usual = max(self.joining_counts.likely(food.want, one, layout.frame.dish_type) for one in layout.stage_types)
        ratio = self.joining_counts.likely(food.want, place.spot.stage_type, layout.frame.dish_type) / usual
        return _UNSEEN + _SEEN * ratio if ratio >= _AS_USUAL else 0.0

    def _usual(self, layout: Layout, food: Joiner) -> Join:
        """Return the stage at which foods of its kind join, most likely one that still cooks what must be cooked."""
        want, dish_type = food.want, layout.frame.dish_type
        if layout.past is not None and food.only_boiled:
            return food.at(layout.past)  # what is only boiled and drained is dressed afterwards
        found, most, best = layout.spots[0], 0.0, -1.0
        for spot in layout.apart:
            if spot.stage_type.work == "top" and not food.tops:
                continue
            likely = self.joining_counts.likely(want, spot.stage_type, dish_type)
            company = self.joining_counts.company(want.facts.kind, spot.kinds)
            fit = min(likely * (_UNSEEN + _SEEN * company), UNNATURAL)
            score = _weighed(fit, layout, food, spot)
            if score > best:
                found, most, best = spot, fit, score
        return Join(want, found, most)

    def _in_place_of(self, layout: Layout, want: Want) -> Join | None:
        """Return where a food joins that is bought instead of being made on the way: dough, a dressing."""
        own = frozenset(want.facts.name.split())
        dough = want.facts.is_a("dough")
        found = None
        ready = not _SHAPED.isdisjoint(own)
        for made in layout.made:
            later = made.is_dough and (ready or not made.shaped) and "heat" not in made.taken_at.stage.does
            if (made.words <= own or (dough and made.is_dough)) and (found is None or later):
                found = Join(want, made.taken_at, IN_PLACE, Slot(made.label, want.facts.kind))
        return found

    def _needs_of(self, food: Joiner, dish_type: str) -> frozenset[str]:
        """Return what of the needs of a dish type a food is: it can take the place of another one that is the same."""
        found = food.needs.get(dish_type)
        if found is None:
            needs = {need for dish in self.known.dishes_named(dish_type) for needs in dish.needs for need in needs}
            found = food.needs[dish_type] = frozenset(need for need in needs if is_need(need, food.want.facts))
        return found

    def _fitting(self, food: Joiner, slot: Slot) -> float:
        """Return how well (0 to 1) a food takes the place of that of a ``slot``, whatever the dish."""
        facts = food.want.facts
        if slot.food in {food.name, facts.taken_for}:
            return 1.0
        fit = self.like(food.name, slot.food)
        if slot.kind == facts.kind and slot.kind != "unknown":
            return max(fit, _SAME_KIND)
        if slot.kind in facts.kinds or fit >= _SURE:
            return fit
        same_role = not roles_of(food.name).isdisjoint(roles_of(slot.food))
        return fit if same_role else fit * _OTHER_KIND  # how like they are counts the role already
