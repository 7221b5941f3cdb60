"""Where each asked food joins a dish: at a slot that such a food has there, else at the stage where its kind joins.

Stages of different dishes are compared by their *post*: what is done to the whole there, whether it is heated then or
later, and whether they are the dish's own line or one that joins it. How often foods of each kind join at each post
is counted over all frames, by dish type.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from foon_kg.food import Food, Tables, singular, tables
from foon_kg.food.lists import word_list
from foon_kg.integration.frames import Frame, Line, Slot, Stage
from foon_kg.integration.preparation import Want, owed

Post = tuple[str, str, bool]
"""What is done (``blend``, ``knead``, ``mix``, ``heat``, ``bake``, ``boil``, ``shape``, ``rest``, ``top``), when it is
heated (``now``, ``later``, ``before``, ``never``), and whether the line joins another one."""

_WORKS = (
    ("blend", {"blend"}), ("knead", {"knead"}), ("bake", {"dry"}), ("boil", {"liquid"}), ("heat", {"heat", "warm"}),
    ("shape", {"shape"}), ("mix", {"mix", "whip", "mash"}), ("rest", {"wait"}),
)  # fmt: skip

_LATE = word_list("joins late")

_SAME_ROLE = 0.55
"""How well a food fits where another one is that defines the dish as it does: one vegetable for another."""

NATURAL = 0.5
"""A slot is natural for a food that its own can stand for with at least this confidence."""


@dataclass(frozen=True)
class Spot:
    """One stage of a frame with its line, and what comes after it. ``path`` are places in nested lines."""

    path: tuple[int, ...]
    stage: Stage
    post: Post
    side: bool
    after: tuple[Stage, ...]

    @property
    def heats_later(self) -> bool:
        """Whether the whole is heated here or later."""
        return any("heat" in stage.does for stage in (self.stage, *self.after))


@dataclass(frozen=True)
class Join:
    """Where one asked food joins, how well that fits (0 to 1), and the slot that it takes, if one is natural."""

    want: Want
    spot: Spot
    fit: float
    slot: Slot | None = None


def spots_of(line: Line, *, side: bool = False, after: tuple[Stage, ...] = (), path: tuple[int, ...] = ()) -> Iterator[Spot]:
    """Yield every stage of a line and of those that join it, in the order of execution."""
    for place, stage in enumerate(line.stages):
        later = (*line.stages[place + 1 :], *after)
        for number, add in enumerate(stage.adds):
            if isinstance(add, Line):
                yield from spots_of(add, side=True, after=(stage, *later), path=(*path, place, number))
        before = any("heat" in one.does for one in line.stages[:place])
        yield Spot((*path, place), stage, _post(stage, later, before=before, side=side), side, later)


def _post(stage: Stage, later: Sequence[Stage], *, before: bool, side: bool) -> Post:
    work = next((name for name, does in _WORKS if not stage.does.isdisjoint(does)), "top")
    if "heat" in stage.does:
        when = "now"
    elif any("heat" in one.does for one in later):
        when = "later"
    else:
        when = "before" if before else "never"
    return work, when, side


_FACTORS = 3
_SMOOTH = 0.02
"""What a post has in common with those at which no such food was ever seen."""


class Posts:
    """How often foods join at each post and beside which others, counted over frames."""

    def __init__(self, frames: Iterable[Frame], known: Tables | None = None) -> None:
        self.known = known or tables()
        self.counts: defaultdict[tuple[str, str], tuple[Counter[object], ...]] = defaultdict(
            lambda: tuple(Counter() for _ in range(_FACTORS))
        )
        self.beside: defaultdict[str, Counter[str]] = defaultdict(Counter)
        self.cooked: defaultdict[str, Counter[str]] = defaultdict(Counter)
        self._kept: dict[tuple[str, frozenset[str], Post, str], float] = {}
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
                found *= self._factor(want, factor, post[factor], dish_type)
            found = self._kept[key] = found ** (1 / _FACTORS)
        return found

    def _factor(self, want: Want, factor: int, value: object, dish_type: str) -> float:
        share = _SMOOTH
        traits = sorted(f"trait:{trait}" for trait in want.facts.traits)
        for names in (("",), traits, (want.facts.kind,)):  # from what all foods do to what its kind does
            for dish in ("", dish_type):
                counts: Counter[object] = Counter()
                for name in names:
                    counts += self.counts[name, dish][factor] if (name, dish) in self.counts else Counter()
                total = sum(counts.values())
                trust = total / (total + 3.0)
                share = trust * (counts[value] / total if total else 0.0) + (1 - trust) * share
        return max(share, _SMOOTH)

    def company(self, kind: str, spot: Spot) -> float:
        """Return how usual (0 to 1) it is that such a food joins together with those that join there."""
        mine = self.beside.get(kind)
        others = [slot.kind for slot in spot.stage.slots]
        if not mine or not others:
            return 0.0
        return sum(min(1.0, mine[other] / 2) for other in others) / len(others)


def _is(need: str, food: Food) -> bool:
    """Whether a food is of the very kind or trait that a dish needs; a word in its name does not count."""
    scheme, _, name = need.rpartition(":")
    if scheme == "trait":
        return name in food.traits
    return name in food.kinds if scheme == "kind" else food.name == name


def _only_carries(stage: Stage) -> bool:
    """Whether a stage brings the dish to where it is served, or only adds to it."""
    return all(stage.does.isdisjoint(does) for _, does in _WORKS)


class Matcher:
    """Finds where foods join. ``like(food, known)`` is how sure a cook is to accept one for the other (0 to 1)."""

    def __init__(self, posts: Posts, like: Callable[[str, str], float]) -> None:
        self.posts = posts
        self.known = posts.known
        self.like = like
        self._spots: dict[str, tuple[Spot, ...]] = {}

    def with_likeness(self, like: Callable[[str, str], float]) -> Matcher:
        """Return a matcher for other foods, which shares what is known of the frames."""
        other = Matcher(self.posts, like)
        other._spots = self._spots
        return other

    def spots(self, frame: Frame) -> tuple[Spot, ...]:
        """Return the stages of a frame in the order of execution."""
        key = frame.key
        if key not in self._spots:
            self._spots[key] = tuple(spots_of(frame.line))
        return self._spots[key]

    def _garnish(self, frame: Frame) -> Spot:
        """Return the last stage of the dish, at which what belongs on top may always join."""
        return self.spots(frame)[-1]

    def group(self, vessel: str) -> str:
        """Return what group of utensils a vessel is of (pots, pans)."""
        row = self.known.utensil(vessel)
        return row.group if row is not None else ""

    def joins(self, frame: Frame, wants: Sequence[Want]) -> tuple[Join, ...]:
        """Return where each food joins."""
        return tuple(self._join(frame, want) for want in wants)

    def _join(self, frame: Frame, want: Want) -> Join:
        ready_made = self._in_place_of(frame, want)
        if ready_made is not None:
            return ready_made
        best: tuple[float, Join] | None = None
        must = bool({"cook", "boil"} & owed(want, self.known))
        needs = self._needs_met(frame.dish_type, want.facts)
        heats = any("heat" in spot.stage.does for spot in self.spots(frame) if not spot.side)
        for spot in self.spots(frame):
            slot, fit = self._slot(spot, want, needs)
            if fit >= NATURAL:
                score = 1 + fit
            else:
                slot = None
                if not spot.stage.adds or (spot.post[0] == "top" and not self._tops(want)):
                    continue
                fit = self.posts.likely(want, spot.post, frame.dish_type) * (0.6 + 0.4 * self.posts.company(want.facts.kind, spot))
                fit = min(fit, NATURAL - 0.01)
                score = fit - (0.3 if must and not spot.heats_later else 0.0)
                if heats and not spot.heats_later and not want.facts.is_a(*_LATE):
                    score -= 0.3
                if self._drained(spot):
                    score -= 0.4
            join = Join(want, spot, fit, slot)
            if best is None or score > best[0]:
                best = (score, join)
        garnish = self._garnish(frame)
        if want.facts.is_a("topping") and (best is None or best[1].slot is None) and _only_carries(garnish.stage):
            return Join(want, garnish, NATURAL - 0.01)
        if best is None:
            return Join(want, self.spots(frame)[0], 0.0)
        return best[1]

    def _in_place_of(self, frame: Frame, want: Want) -> Join | None:
        """Return where a food joins that is bought in the place of what the dish makes on its way: dough, a dressing."""
        own = set(want.facts.name.split())
        spots = self.spots(frame)
        for spot in spots:
            made = set(singular(spot.stage.label).split())
            if not spot.after or not made or not self.known.foods.food(spot.stage.label).is_a("made", "dough"):
                continue
            doughs = want.facts.is_a("dough") and self.known.foods.food(spot.stage.label).is_a("dough")
            if made == own or doughs or (made < own and want.facts.is_a("made", "dough", "ready")):
                following = next(other for other in spots if other.stage is spot.after[0])
                slot = Slot(spot.stage.label, want.facts.kind)
                return Join(want, following, 0.95, slot)
        return None

    def _drained(self, spot: Spot) -> bool:
        """Whether what is liquid runs out later: the whole comes into a strainer."""
        rows = (self.known.utensil(stage.vessel) for stage in spot.after if stage.vessel)
        return any(row is not None and "strain" in row.can for row in rows)

    def _tops(self, want: Want) -> bool:
        return want.facts.is_a("topping", "herb")

    def _needs_met(self, dish_type: str, food: Food) -> frozenset[str]:
        """Return what of the needs of a dish type a food is: it can take the place of another one that is the same."""
        dishes = self.known.dishes_named(dish_type)
        needs = {need for dish in dishes for needs in dish.needs for need in needs}
        return frozenset(need for need in needs if _is(need, food))

    def _slot(self, spot: Spot, want: Want, needs: frozenset[str]) -> tuple[Slot | None, float]:
        name = singular(want.label)
        best: tuple[float, Slot | None] = (0.0, None)
        for slot in spot.stage.slots:
            if slot.food == name or slot.food == want.facts.taken_for:
                fit = 1.0
            else:
                fit = self.like(name, slot.food)
                if slot.kind == want.facts.kind and slot.kind != "unknown":
                    fit = max(fit, 0.6)
                elif needs and any(_is(need, self.known.foods.food(slot.food)) for need in needs):
                    fit = max(fit, _SAME_ROLE)
                elif slot.kind not in want.facts.kinds and fit < 0.8:
                    fit *= 0.7
            if fit > best[0]:
                best = (fit, slot)
        return best[1], best[0]
