"""Where each asked food joins a dish: at a slot that such a food has there, else at the stage where its kind joins.

How often foods of each kind join at each post (:mod:`foon_kg.integration.joining.layouts`) is counted over all frames,
by dish type. Some dishes are made in a way that says where foods without a slot go: what is drained is dressed, what is
rolled out is laid on, patties are mixed before they are shaped, sandwiches are put together at the end.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from foon_kg.food import Level, Tables, singular, tables
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.batters import as_batter, is_of_batter, is_of_dough
from foon_kg.integration.joining.layouts import MAIN, Layout, Place, is_need
from foon_kg.integration.joining.spots import Join, Post, Spot, only_carries, spots_of
from foon_kg.integration.preparing.preparation import Want, owed
from foon_kg.integration.teaching.frames import Frame, Slot
from foon_kg.model.recent import Recent
from foon_kg.similarity.roles import roles_of

_LATE = word_list("joins late")
_FRESH = word_list("joins at the end")
_STACKED = word_list("is stacked")
_BOUND = word_list("binds")
_WORKED_IN = word_list("is worked in")
_SHAPED = word_list("dough that is shaped")
_CHANGES = frozenset({"blend", "knead", "mash", "shape"})
_FLESH = word_list("is flesh")
_SLICES = word_list("carries what is stacked")
_SERVED_WITH = word_list("is served with what is fried")
_BATHED = word_list("goes into the water")

_SAME_KIND, _SURE, _OTHER_KIND, _IN_PLACE = 0.6, 0.8, 0.7, 0.95
"""How well a food fits where one of its kind is; from which confidence on its kind does not matter; what a confidence
is worth where it is of another kind; how well it fits where a dish makes such a thing itself."""

_SMALL = 3
"""How fine pieces are that are mixed into something rather than laid on it (chopped, grated)."""

_AS_USUAL = 0.75
"""How usual a place must be for a kind, beside its most usual one in that dish, to be taken for a like food."""

_SURELY = 0.99
_SAME_ROLE = 0.55
"""How well a food fits where another one is that defines the dish as it does: one vegetable for another."""

NATURAL = 0.5
"""A slot is natural for a food that its own can stand for with at least this confidence."""


_FACTORS = 3
_SMOOTH = 0.02
"""What a post has in common with those at which no such food was ever seen."""


def _no_counts() -> tuple[Counter[object], ...]:
    return tuple(Counter() for _ in range(_FACTORS))


class Posts:
    """How often foods join at each post and beside which others, counted over frames."""

    def __init__(self, frames: Iterable[Frame], known: Tables | None = None) -> None:
        self.known = known or tables()
        self.counts: defaultdict[tuple[str, str], tuple[Counter[object], ...]] = defaultdict(_no_counts)
        self.beside: defaultdict[str, Counter[str]] = defaultdict(Counter)
        self.cooked: defaultdict[str, Counter[str]] = defaultdict(Counter)
        self._kept: dict[tuple[str, frozenset[str], Post, str], float] = {}
        self._factors: dict[tuple[str, frozenset[str], int, object, str], float] = {}
        self._totals: dict[tuple[str, str, int], int] = {}
        self._together: dict[tuple[str, tuple[str, ...]], float] = {}
        for frame in frames:
            for spot in spots_of(frame.line):
                self._count(frame, spot)

    def _count(self, frame: Frame, spot: Spot) -> None:
        slots = list(spot.stage.slots)
        for slot in slots:
            for name in self.names(slot.kind):
                for dish in (frame.dish_type, ""):
                    for counter, value in zip(self.counts[name, dish], spot.post, strict=True):
                        counter[value] += 1
                for motion in slot.cooked[:1]:
                    self.cooked[name][motion] += 1
            for other in slots:
                if other is not slot:
                    self.beside[slot.kind][other.kind] += 1

    def names(self, kind: str) -> tuple[str, ...]:
        """Return what a kind is counted under: itself, its traits, and any food."""
        row = self.known.foods.kinds.get(kind)
        return (kind, *sorted(f"trait:{trait}" for trait in (row.traits if row else ())), "")

    def likely(self, want: Want, post: Post, dish_type: str) -> float:
        """Return how likely (0 to 1) a food of this kind joins at such a post, in this dish type most of all."""
        key = (want.facts.kind, want.facts.traits, post, dish_type)
        found = self._kept.get(key)
        if found is None:
            found = 1.0
            for factor in range(_FACTORS):
                own = (want.facts.kind, want.facts.traits, factor, post[factor], dish_type)
                if own not in self._factors:
                    self._factors[own] = self._factor(want, factor, post[factor], dish_type)
                found *= self._factors[own]
            found = self._kept[key] = found ** (1 / _FACTORS)
        return found

    def _factor(self, want: Want, factor: int, value: object, dish_type: str) -> float:
        share = _SMOOTH
        traits = sorted(f"trait:{trait}" for trait in want.facts.traits)
        for names in (("",), traits, (want.facts.kind,)):  # from what all foods do to what its kind does
            for dish in ("", dish_type):
                total = times = 0
                for name in names:
                    counts = self.counts.get((name, dish))
                    if counts is not None:
                        total += self._total(name, dish, factor)
                        times += counts[factor][value]
                trust = total / (total + 3.0)
                share = trust * (times / total if total else 0.0) + (1 - trust) * share
        return max(share, _SMOOTH)

    def _total(self, name: str, dish: str, factor: int) -> int:
        found = self._totals.get((name, dish, factor))
        if found is None:
            found = self._totals[name, dish, factor] = self.counts[name, dish][factor].total()
        return found

    def never(self, want: Want, work: str) -> bool:
        """Whether no food of that kind was ever seen where such work is done."""
        counts = self.counts.get((want.facts.kind, ""))
        return counts is None or not counts[0][work]

    def company(self, kind: str, kinds: tuple[str, ...]) -> float:
        """Return how usual (0 to 1) it is that such a food joins together with foods of ``kinds``."""
        found = self._together.get((kind, kinds))
        if found is None:
            mine = self.beside.get(kind)
            found = sum(min(1.0, mine[other] / 2) for other in kinds) / len(kinds) if mine and kinds else 0.0
            self._together[kind, kinds] = found
        return found


def _on_ready_dough(layout: Layout, joins: Sequence[Join]) -> list[Join]:
    """Let what a video works into its dough, or lays on it first, come onto bread or dough that was bought."""
    laid = layout.laid
    if laid is None:
        return list(joins)
    bought = any(join.spot is laid and join.want.facts.is_a(*_SLICES) for join in joins)
    if bought and not any(join.want.facts.is_a("flour") for join in joins):
        return [replace(one, spot=laid) if laid.stage in one.spot.after else one for one in joins]
    ready = next((join for join in joins if join.fit == _IN_PLACE and join.want.facts.is_a("dough")), None)
    if ready is None:
        return list(joins)
    before = [join for join in joins if any(stage is ready.spot.stage for stage in join.spot.after)]
    return [Join(one.want, laid, NATURAL - 0.01) if one in before else one for one in joins]


def _in_its_layer(layout: Layout, join: Join) -> Join:
    """Return a join with its place among others that are laid on dough or bread."""
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


def _without_lone(layout: Layout, joins: Sequence[Join]) -> tuple[Join, ...]:
    """Let a food join the dish itself where it would be all that is left of a side line that is made without heat.

    Nobody sets up a blender for some chives because a video made a pesto with it.
    """
    if not layout.cold_lines or not any(join.spot.side for join in joins):
        return tuple(joins)
    found = list(joins)
    for number, join in enumerate(joins):
        path = join.spot.path
        while len(path) > 2:  # noqa: PLR2004 - a stage of the dish itself has one number
            line, path = path[:-1], path[:-2]
            if line not in layout.cold_lines:
                continue
            own = join.slot is not None and layout.cold_lines[line].isdisjoint(_CHANGES)
            if not own and not any(other is not join and other.spot.path[: len(line)] == line for other in joins):
                spot = next(spot for spot in layout.spots if spot.path == path)
                found[number] = Join(join.want, spot, min(join.fit, NATURAL - 0.01))
    return tuple(found)


def _lies_on(layout: Layout, want: Want, best: Join, known: Tables) -> bool:
    """Whether a food lies on patties though the video mixes it into them."""
    fine = known.state(want.make).fine or 0 if want.make else 0
    return best.spot is layout.bound and fine < _SMALL and want.facts.is_a(*word_list("lies on patties"))


def _in_the_pan(layout: Layout, join: Join) -> Join:
    """Let what a video fries by itself and brings to the dish when that is done fry in the dish's own pan."""
    late = join.slot is not None and bool(join.slot.cooked) and join.spot.post[1] == "before"
    due = {"cook", "boil"} & join.want.facts.owes.keys()
    hot = next((spot for spot in layout.spots if not spot.side and "heat" in spot.stage.does), None)
    return replace(join, spot=hot, slot=None) if late and not due and hot is not None else join


def _where_it_is_stacked(layout: Layout, joins: Sequence[Join]) -> list[Join]:
    """Let bread that nobody heats any more come when all the rest does: below it and on top of it."""
    last = layout.spots[-1]
    cold = [join for join in joins if join.spot is not last and not join.spot.heats_later]
    if not only_carries(last.stage) or any(not join.want.facts.is_a(*_SLICES) for join in cold):
        return list(joins)
    return [replace(join, spot=last) if join in cold else join for join in joins]


MOST_JOINERS, MOST_JOINED = 1024, 256
"""For how many foods it is kept where they join, and in how many dishes."""


class Joiner:
    """A food, and what of it decides where it joins a dish: looked up once for all dishes and recipes.

    ``fits`` says how well it takes the place of others, ``joined`` where it joins the dishes it was compared with.
    """

    def __init__(self, want: Want, known: Tables) -> None:
        is_a, facts = want.facts.is_a, want.facts
        self.want = want
        self.name = singular(want.label)
        self.fits: dict[tuple[str, str], float] = {}
        self.needs: dict[str, frozenset[str]] = {}
        self.joined: dict[tuple[Layout, bool], Join] = {}
        self.main = is_a(*MAIN)
        self.runs = is_a("liquid", "water", "creamy", "frozen")
        self.fat = is_a("fat")
        self.topping = is_a("topping")
        self.tops = is_a("topping", "herb")
        self.floats = is_a(*word_list("floats on top"))
        self.late = is_a(*_LATE)
        self.worked = is_a(*_WORKED_IN) and not is_a("herb")
        self.binds = is_a(*_BOUND) and not self.fat
        self.beaten = is_a(*word_list("is beaten with eggs")) and not self.fat
        self.served = is_a(*_SERVED_WITH)
        self.ready_made = is_a("made", "dough", "ready")
        self.due = not owed(want, known).isdisjoint({"cook", "boil"})
        self.slow = self.due and self.main and is_a(*_FLESH)
        self.only_boiled = not is_a(*_BATHED) and "boil" not in facts.owes
        self.fresh = (
            facts.sold_as != "dried"
            and not want.cooked
            and not _FRESH.isdisjoint({f"kind:{facts.kind}", facts.taken_for})
        )

    def at(self, spot: Spot) -> Join:
        """Return its join at a stage at which it has no natural place."""
        return Join(self.want, spot, NATURAL - 0.01)


class Joiners:
    """The foods of late recipes: a recipe has few that no other one has.

    It serves recipes whose foods are alike the foods of the dishes in the same way: those that ask one FOON.
    """

    def __init__(self) -> None:
        self._kept: Recent[tuple[Want, frozenset[str]], Joiner] = Recent(MOST_JOINERS)

    def of(self, wants: Sequence[Want], known: Tables) -> dict[int, Joiner]:
        """Return the foods of a recipe by their numbers. Of one name with two meanings each counts for both."""
        meant: defaultdict[str, set[str]] = defaultdict(set)
        for want in wants:
            meant[singular(want.label)].add(want.facts.taken_for)
        found = {}
        for want in wants:
            key = replace(want, number=0), frozenset(meant[singular(want.label)])
            joiner = self._kept.find(key)
            if joiner is None:
                joiner = self._kept[key] = Joiner(want, known)
            found[want.number] = joiner
        return found


class Matcher:
    """Finds where the foods of one recipe, ``wants``, join.

    ``like(food, known)`` is how sure a cook is to accept one for the other (0 to 1). ``joiners`` keeps what is found
    for recipes with the same foods and likes.
    """

    def __init__(
        self, posts: Posts, like: Callable[[str, str], float], wants: Sequence[Want], joiners: Joiners | None = None
    ) -> None:
        self.posts = posts
        self.known = posts.known
        self.like = like
        self._joiners = (joiners or Joiners()).of(wants, self.known)

    def joins(self, layout: Layout, wants: Sequence[Want], *, stacked: bool = False) -> tuple[Join, ...]:
        """Return where each food joins; ``stacked``: on bread at the end, unless it has to be cooked."""
        found = [self._kept_join(layout, want, stacked=stacked) for want in wants]
        if stacked:
            found = _where_it_is_stacked(layout, found)
        found = [_in_its_layer(layout, join) for join in _on_ready_dough(layout, found)]
        joins = _without_lone(layout, found)
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
        return Join(want, found.spot, found.fit, found.slot)

    def _join(self, layout: Layout, food: Joiner, *, stacked: bool) -> Join:
        want = food.want
        ready_made = self._in_place_of(layout, want) if food.ready_made else None
        if ready_made is not None:
            return ready_made
        best = self._natural(layout, food)
        if best is not None:
            best = _in_the_pan(layout, best)
        if stacked and (best is None or _lies_on(layout, want, best, self.known)) and self._is_stacked(layout, want):
            return food.at(layout.spots[-1])
        if layout.turned is not None and food.served and (best is None or best.fit < _SURELY):
            return food.at(layout.turned)
        if layout.pan is not None and food.fat:
            return food.at(layout.pan)
        fresh = self._at_the_end(layout, want, best) if food.fresh and layout.bound is None else None
        if fresh is not None or best is not None:
            return fresh or best or self._usual(layout, food)
        spot = self._by_the_dish(layout, food)
        return self._usual(layout, food) if spot is None else food.at(spot)

    def _by_the_dish(self, layout: Layout, food: Joiner) -> Spot | None:
        """Return where the way in which a dish is made says that a food joins for which it has no slot."""
        if layout.laid is not None and not food.worked:
            return layout.laid
        if layout.bound is not None and food.binds:
            return layout.bound
        if layout.beaten is not None and food.beaten:
            return layout.beaten
        late = food.topping or (food.floats and not layout.dry)
        return layout.spots[-1] if late and only_carries(layout.spots[-1].stage) else None

    def _is_stacked(self, layout: Layout, want: Want) -> bool:
        """Whether a food may come to a dish when it is put together on bread."""
        if not any("heat" in spot.stage.does for spot in layout.spots) and only_carries(layout.spots[-1].stage):
            return True
        uncooked = {"cook", "boil"}.isdisjoint(owed(want, self.known, Level.FATAL)) and not want.cooked
        binds = want.facts.is_a(*word_list("binds patties"))
        return uncooked and not binds and want.facts.is_a(*_STACKED) and only_carries(layout.spots[-1].stage)

    def _at_the_end(self, layout: Layout, want: Want, best: Join | None) -> Join | None:
        """Return where in a hot dish a food joins that loses by cooking: when the dish is done."""
        worked = best is not None and best.spot.post[0] in {"shape", "knead"}
        done = [spot for spot in layout.spots if spot.post[1] == "before" and not spot.side]
        if worked or not done or (best is not None and best.spot.post[1] in {"before", "never"}):
            return None
        spot = next((spot for spot in done if spot.stage.adds), done[-1])
        return Join(want, spot, best.fit if best is not None else NATURAL - 0.01)

    def _natural(self, layout: Layout, food: Joiner) -> Join | None:
        """Return the slot that such a food has there: the likest, the first of equally like ones."""
        want, dish_type = food.want, layout.frame.dish_type
        found: Place | None = None
        most = NATURAL - 1e-9
        needs = self._needs_of(food, dish_type)
        usual: float | None = None
        for place in layout.places:
            slot = place.slot
            fit = food.fits.get(place.key)
            if fit is None:
                fit = food.fits[place.key] = self._fitting(food, slot)
            if fit < _SAME_ROLE and needs and (not needs.isdisjoint(place.needs) or (food.main and place.main)):
                fit = _SAME_ROLE
            if fit <= most or (slot.kind == "water" and not food.runs):
                continue  # nor does a solid take the place of the water in which a dish is cooked
            bound = food.main and place.main and place.spot is layout.bound  # of whatever patties are made
            if NATURAL <= fit < _SURELY and slot.kind != want.facts.kind and not bound:
                # a like food may join elsewhere than foods of this one's kind do: chives late, onions early
                if usual is None:
                    usual = max(self.posts.likely(want, post, dish_type) for post in layout.posts)
                ratio = self.posts.likely(want, place.spot.post, dish_type) / usual if usual else 1.0
                fit = fit * (0.6 + 0.4 * ratio) if ratio >= _AS_USUAL else 0.0
            if fit > most:
                found, most = place, fit
        return None if found is None else Join(want, found.spot, most, found.slot)

    def _usual(self, layout: Layout, food: Joiner) -> Join:
        """Return the stage at which foods of its kind join, most likely one that still cooks what must be cooked."""
        want, dish_type = food.want, layout.frame.dish_type
        if layout.past is not None and food.only_boiled:
            return food.at(layout.past)  # what is only boiled and drained is dressed afterwards
        found, most, best = layout.spots[0], 0.0, -1.0
        for spot in layout.apart:
            if spot.post[0] == "top" and not food.tops:
                continue
            likely = self.posts.likely(want, spot.post, dish_type)
            fit = min(likely * (0.6 + 0.4 * self.posts.company(want.facts.kind, spot.kinds)), NATURAL - 0.01)
            score = fit
            if not spot.heats_later:
                score -= (0.3 if food.due else 0.0) + (0.3 if layout.heats and not food.late else 0.0)
            if food.slow:
                score += 0.3 * spot.heats / layout.hottest
            if id(spot) in layout.drained:
                score -= 0.4
            if score > best:
                found, most, best = spot, fit, score
        return Join(want, found, most)

    def _in_place_of(self, layout: Layout, want: Want) -> Join | None:
        """Return where a food joins that is bought instead of being made on the way: dough, a dressing."""
        own = frozenset(want.facts.name.split())
        dough = want.facts.is_a("dough")
        found = None
        ready = not _SHAPED.isdisjoint(own)
        for words, is_dough, shaped, label, following in layout.made:
            later = is_dough and (ready or not shaped) and "heat" not in following.stage.does
            if (words <= own or (dough and is_dough)) and (found is None or later):
                found = Join(want, following, _IN_PLACE, Slot(label, want.facts.kind))
        return found

    def _needs_of(self, food: Joiner, dish_type: str) -> frozenset[str]:
        """Return what of the needs of a dish type a food is: it can take the place of another one that is the same."""
        found = food.needs.get(dish_type)
        if found is None:
            needs = {need for dish in self.known.dishes_named(dish_type) for needs in dish.needs for need in needs}
            found = food.needs[dish_type] = frozenset(need for need in needs if is_need(need, food.want.facts))
        return found

    def _fitting(self, food: Joiner, slot: Slot) -> float:
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
