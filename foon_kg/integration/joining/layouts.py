"""Frames as places: what joins where, worked out once for every question."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.food import Food, Level, Tables, singular
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.batters import Batter, batter_of
from foon_kg.integration.joining.spots import Spot, StageType, only_carries, spots_of
from foon_kg.integration.teaching.frames import Frame, Slot

MAIN = word_list("is the main part")


@dataclass(frozen=True)
class Place:
    """A slot with its stage, what it is of all that dishes of its type need, and whether it is the main part."""

    slot: Slot
    spot: Spot
    needs: frozenset[str]
    main: bool = False

    @cached_property
    def key(self) -> tuple[str, str]:
        """The food of the slot and its kind: what decides which foods may take its place."""
        return self.slot.food, self.slot.kind


@dataclass(frozen=True)
class Made:
    """What a dish makes on its way and somebody may buy instead, called ``label``: dough, a sauce.

    ``words`` are those of its name; ``is_dough``, and ``shaped``: that is rolled out or formed. ``taken_at`` is the
    stage that takes it.
    """

    words: frozenset[str]
    is_dough: bool
    shaped: bool
    label: str
    taken_at: Spot


@dataclass(frozen=True, eq=False)
class Layout:
    """A frame as places: worked out once, whatever is asked.

    ``open`` are the stages at which foods without a slot may join. ``bound`` is where foods are mixed that are then
    shaped as one, and ``pan`` where they are cooked; eggs are beaten at ``beaten`` that set by dry heat. ``laid`` is
    where foods are laid on dough that is rolled out, before it is baked. ``turned`` is where what was fried on both
    sides is served. ``batter`` is where a batter comes together. ``past`` is where other foods join a dish that is
    boiled and drained, and no more. ``raw``: something in it is never cooked that has to be. ``drained`` are the spots
    (by ``id``) whose liquid is poured away later, ``made`` what the dish makes on its way.
    """

    frame: Frame
    spots: tuple[Spot, ...]
    places: tuple[Place, ...]
    open: tuple[Spot, ...]
    drained: frozenset[int]
    past: Spot | None
    bound: Spot | None
    beaten: Spot | None
    pan: Spot | None
    laid: Spot | None
    turned: Spot | None
    batter: Batter | None
    raw: bool
    made: tuple[Made, ...]

    @cached_property
    def foods(self) -> frozenset[str]:
        """The foods of its places."""
        return frozenset(place.slot.food for place in self.places)

    @cached_property
    def stage_types(self) -> tuple[StageType, ...]:
        """The stage types of its places, each once."""
        return tuple(dict.fromkeys(place.spot.stage_type for place in self.places))

    @cached_property
    def apart(self) -> tuple[Spot, ...]:
        """Where foods without a slot may join: what its video mashes is mashed, and nothing else with it."""
        apart = (spot for spot in self.open if "mash" not in spot.stage.does or "heat" in spot.stage.does)
        return tuple(apart) or self.open

    @cached_property
    def heats(self) -> bool:
        """Whether the dish itself is heated."""
        return any("heat" in spot.stage.does and not spot.side for spot in self.spots)

    @cached_property
    def dry(self) -> bool:
        """Whether there is nothing like a soup in it."""
        return not any("liquid" in spot.stage.does or "water" in spot.kinds for spot in self.spots)

    @cached_property
    def done(self) -> tuple[Spot, ...]:
        """The stages of the dish itself that come when it is cooked."""
        return tuple(spot for spot in self.spots if spot.stage_type.heated == "before" and not spot.side)

    @cached_property
    def cold_lines(self) -> Mapping[tuple[int, ...], frozenset[str]]:
        """The side lines that are made of several foods and without heat, and what is done in each."""
        found = {}
        for line in self._side_lines:
            stages = [spot.stage for spot in self.spots if spot.path[: len(line)] == line]
            does = frozenset().union(*(stage.does for stage in stages))
            foods = [slot for stage in stages for slot in stage.slots]
            if "heat" not in does and len(foods) > 1:
                found[line] = does
        return found

    @property
    def _side_lines(self) -> Iterable[tuple[int, ...]]:
        """The paths of its side lines: a stage's place and the number of what joins there, however deep."""
        ends = ((spot, end) for spot in self.spots for end in range(2, len(spot.path) + 1, 2))
        return dict.fromkeys(spot.path[:end] for spot, end in ends)

    @cached_property
    def hottest(self) -> int:
        """How often what joins first is heated; at least 1."""
        return max([1, *(spot.heats for spot in self.spots)])

    @classmethod
    def of(cls, frame: Frame, known: Tables) -> Layout:
        """Return the layout of a frame, its foods read by the tables ``known``."""
        spots = tuple(spots_of(frame.line))
        places = tuple(_places(spots, frame.dish_type, known))
        drained = frozenset(id(spot) for spot in spots if _is_drained(spot, known))
        laid = _laid(spots, known)
        bound = _bound(spots) if laid is None else None
        return cls(
            frame,
            spots,
            places,
            open=tuple(spot for spot in spots if _is_open(spot, known)),
            drained=drained,
            past=_past(spots, drained),
            bound=bound,
            beaten=_beaten(spots, known),
            pan=_pan(spots, bound),
            laid=laid,
            turned=_turned(spots),
            batter=batter_of(spots, known),
            raw=any(_stays_raw(place, frame.dish_type, known) for place in places),
            made=tuple(_made(spots, known)),
        )


def _places(spots: Sequence[Spot], dish_type: str, known: Tables) -> Iterator[Place]:
    """Yield the slots of stages as places of a dish of such a type."""
    needs = {need for dish in known.dishes_named(dish_type) for needs in dish.needs for need in needs}
    for spot in spots:
        for slot in spot.stage.slots:
            food = known.foods.food(slot.food)
            met = frozenset(need for need in needs if is_need(need, food))
            yield Place(slot, spot, met, bool(met) and food.is_any(MAIN))


def _foods_at(spot: Spot, known: Tables) -> list[Food]:
    return [known.foods.food(slot.food, slot.states) for slot in spot.stage.slots]


def _is_open(spot: Spot, known: Tables) -> bool:
    """Whether foods without a slot may join at a stage: not where a batter or dough is only baked in its tin."""
    if not spot.stage.adds:
        return False
    if spot.stage_type.work != "bake":
        return True
    return _are_more_than_dusted(_foods_at(spot, known))


def _made(spots: Sequence[Spot], known: Tables) -> Iterator[Made]:
    """Yield what stages make that is a food of its own, and that a later stage takes."""
    for spot in spots:
        label = singular(spot.stage.label)
        facts = known.foods.food(label)
        if label and spot.after and facts.is_a("made", "dough"):
            following = next(other for other in spots if other.stage is spot.after[0])
            shaped = spot.stage_type.work == "shape"
            yield Made(frozenset(label.split()), facts.is_a("dough"), shaped, spot.stage.label, following)


def _is_drained(spot: Spot, known: Tables) -> bool:
    """Whether what is liquid runs out later: the whole comes into a strainer."""
    rows = (known.utensil(stage.vessel) for stage in spot.after if stage.vessel)
    return any(row is not None and "strain" in row.can for row in rows)


def _bound(spots: Sequence[Spot]) -> Spot | None:
    """Return the stage at which the mass of patties is mixed, in a dish that is made of such."""
    for number, spot in enumerate(spots):
        if spot.stage_type.work == "shape" and spot.heats_later and "heat" not in spot.stage.does:
            before = [
                one for one in spots[:number] if one.stage.adds and one.stage_type.work == "mix" and one.heats_later
            ]
            return before[-1] if before else None
    return None


def _beaten(spots: Sequence[Spot], known: Tables) -> Spot | None:
    """Return the stage at which eggs are beaten that set by dry heat, in what is no batter."""
    for spot in spots:
        foods = _foods_at(spot, known)
        eggs = any(food.is_a("egg") for food in foods) and not any(food.is_a("flour", "leaven") for food in foods)
        if eggs and spot.stage_type[:2] == ("mix", "later") and not any("liquid" in stage.does for stage in spot.after):
            return spot
    return None


def _pan(spots: Sequence[Spot], bound: Spot | None) -> Spot | None:
    """Return the stage at which what was shaped is cooked first."""
    if bound is None:
        return None
    later = set(map(id, bound.after))
    return next((spot for spot in spots if "heat" in spot.stage.does and id(spot.stage) in later), None)


def _turned(spots: Sequence[Spot]) -> Spot | None:
    """Return where a dish is served that is made of a mass and fried on both sides."""
    turns = any("turn" in spot.stage.does for spot in spots if not spot.side or spot.heats_later)
    mixes = any(spot.stage_type.work == "mix" and spot.heats_later for spot in spots)
    return spots[-1] if turns and mixes and only_carries(spots[-1].stage) else None


def _laid(spots: Sequence[Spot], known: Tables) -> Spot | None:
    """Return the last stage at which something comes onto dough that is rolled out, before it is done.

    What joins before the dough is shaped for the last time is in it, and not on it.
    """
    found, dough, shaped = None, False, False
    for spot in spots:
        if spot.side:
            continue
        foods = _foods_at(spot, known)
        if dough and _only_shapes(spot):
            shaped, found = True, None
        elif shaped and spot.heats_later and _are_more_than_dusted(foods):
            found = spot
        dough = dough or any(food.is_a("flour", "dough") for food in foods)
    return found


def _are_more_than_dusted(foods: Iterable[Food]) -> bool:
    """Whether there are other foods than those with which a tin or a board is greased and dusted."""
    return any(not food.is_a("fat", "flour") for food in foods)


def _only_shapes(spot: Spot) -> bool:
    """Whether what is there is rolled out or shaped before it is heated, and nothing joins it."""
    return spot.stage_type.work == "shape" and spot.heats_later and not any(spot.stage.slots)


def _stays_raw(place: Place, dish_type: str, known: Tables) -> bool:
    """Whether nobody ever cooks what has to be cooked: the video leaves it out, or it was not followed."""
    slot, spot = place.slot, place.spot
    facts = known.foods.food(slot.food, slot.states)
    due = any(facts.owes.get(name) is Level.FATAL for name in ("cook", "boil"))
    done = bool(slot.cooked) or any({"cook", "boil"} & known.state(state).earns for state in slot.states)
    eased = any(not dish.eases.isdisjoint({facts.kind, *facts.kinds}) for dish in known.dishes_named(dish_type))
    return due and not done and not eased and not spot.heats_later


def _past(spots: Sequence[Spot], drained: frozenset[int]) -> Spot | None:
    """Return the last stage of a dish that is only carried on once it is drained."""
    own = [spot for spot in spots if not spot.side]
    after = [spot for spot in own if id(spot) not in drained]
    if not after or len(after) == len(own):
        return None
    return after[-1] if all(only_carries(spot.stage) for spot in after) else None


def is_need(need: str, food: Food) -> bool:
    """Return whether a food is of the very kind or trait that a dish needs; a word in its name does not count."""
    scheme, _, name = need.rpartition(":")
    if scheme == "trait":
        return name in food.traits
    return name in food.kinds if scheme == "kind" else food.name == name
