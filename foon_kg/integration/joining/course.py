"""What is to be made after which frame: the foods of one recipe at the stages at which they join."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from foon_kg.food.lists import word_list
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import HEATS, Line, Phase, Stage, place_among

MIXES = frozenset({"mix", "whip", "knead", "mash", "blend"})
COATS = frozenset({"coat", "mix"})
"""What a stage does at which one food is turned in another, and stays what it is."""

WORKS = MIXES | HEATS | {"wait", "shape", "turn", "cut", "peel"}


@dataclass
class Plan:
    """What is made: the name of the dish, its states, and which foods join where.

    ``goal`` is what the recorded dish is called. ``cooked_by`` are the motions by which foods of a kind are cooked on
    their own in this FOON; foods of the kinds in ``eased`` may stay raw in such a dish. ``tin`` is what the batter
    or dough of such a dish is baked in; ``stacked``: the dish is put together on bread at the end;
    ``one_pot``: what is boiled is boiled in it; ``cold``: it is served cold; ``cooled``: what is cooked for it is no
    longer hot when it meets the rest; ``flat``: its dough is rolled out;
    ``grilled``: it is fried once it is put together; ``in_pieces``: what it is made of is eaten with a fork;
    ``laid``: it lies on dough, and bakes no longer than that; ``portioned``: its dough is cut into pieces;
    ``spooned``: all that is in it is eaten with the spoon; ``by_bites``: with a spoon or fork alone;
    ``in_glass``: it is served in a glass; ``closed_by``: what is done at last to bread around what lies on it;
    ``by_table``: a technique says all of it; ``fat`` is what it may be fried in though nobody asked for any.
    """

    label: str
    goal: str
    joins: Sequence[Join]
    cooked_by: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    eased: frozenset[str] = frozenset()
    tin: str = ""
    stacked: bool = False
    one_pot: bool = False
    cold: bool = False
    cooled: bool = False
    flat: bool = False
    grilled: bool = False
    in_pieces: bool = False
    laid: bool = False
    portioned: bool = False
    spooned: bool = False
    by_bites: bool = False
    in_glass: bool = False
    closed_by: str = ""
    by_table: bool = False
    fat: Want | None = None

    @property
    def has_a_side(self) -> bool:
        """Whether something is asked for serving that lies beside the dish: rice, bread, a stiff porridge."""
        said, sides = word_list("is for what is done"), word_list("lies beside a dish")
        beside = (join.want for join in self.joins if join.want.part in said)
        return not self.spooned and any(want.facts.is_any(sides) for want in beside)


class Course:
    """The stages of a frame with the foods that join at each (``at``, by the stage's identity)."""

    def __init__(self, line: Line, plan: Plan) -> None:
        self.line = line
        self.plan = plan
        self.at: dict[int, list[Join]] = {}
        for join in plan.joins:
            self.at.setdefault(id(join.spot.stage), []).append(join)

    def in_order(self) -> Iterator[Join]:
        """Yield all joins in the order in which the lines come together."""

        def walk(line: Line) -> Iterator[Join]:
            for stage in line.stages:
                for add in stage.lines:
                    yield from walk(add)
                yield from self.ordered(stage)

        yield from walk(self.line)

    def ordered(self, stage: Stage) -> list[Join]:
        """Return the foods that join a stage in their order: as the frame has them; others by what they are."""
        if isinstance(stage, Phase):
            return list(self.at.get(id(stage), ()))
        slots = list(stage.adds)
        heats = stage.heats

        # a slot of this stage has a whole number, so that what has none can come between; -1 is before all slots
        def order(join: Join) -> tuple[float, int, int]:
            facts = join.want.facts
            if join.slot is not None:
                place: float = slots.index(join.slot) if join.slot in slots else -0.5  # another stage had it: early
            elif facts.is_a("fat") and heats:
                place = -1
            elif "dry" in stage.does and facts.is_any(word_list("melts on top")):
                place = len(slots) + 0.8  # nothing is poured over what browns
            elif "dry" in stage.does and facts.is_any(word_list("is browned on top")):
                place = len(slots) + 0.9
            elif facts.is_a("liquid", "creamy"):
                place = len(slots) + 0.5
            elif facts.is_a("spice", "herb"):
                place = len(slots) + 1
            else:
                place = len(slots)
            owes = 0 if "cook" in facts.owes else 1
            return (place, owes, join.want.number)

        found = sorted(self.at.get(id(stage), ()), key=order)
        if heats:  # fat with a slot of its own, too: nothing is fried before it is hot
            found.sort(key=lambda join: not join.want.facts.is_a("fat"))
        return found

    def taken(self, stage: Stage) -> list[Join]:
        """Return the foods that join a stage in their order; they join earlier now."""
        found = self.ordered(stage)
        self.at.pop(id(stage), None)
        return found

    def is_hot(self, stage: Stage) -> bool:
        """Return whether the vessel of ``stage`` is hot already when foods join there."""
        return bool(self.heated_before(stage))

    def heated_before(self, stage: Stage) -> list[Stage]:
        """Return the stages at which the vessel of ``stage`` was heated with something in it."""

        def before(line: Line) -> list[Stage]:
            place = place_among(line.stages, stage)
            if place is not None:
                return [one for one in line.stages[:place] if "heat" in one.does and self.stage_alive(one)]
            return next(filter(None, (before(add) for one in line.stages for add in one.lines)), [])

        return before(self.line)

    def was_only_fried_before(self, stage: Stage) -> bool:
        """Return whether the vessel of ``stage`` was heated before, and only to fry: nothing simmered or baked."""
        hot = self.heated_before(stage)
        return bool(hot) and all(one.does.isdisjoint({"liquid", "dry"}) for one in hot)

    def joins_of(self, stages: Sequence[Stage]) -> list[Join]:
        """Return the foods that join ``stages``, those of the lines that join these left out."""
        return [join for stage in stages for join in self.ordered(stage)]

    def follows_heat(self, stage: Stage) -> bool:
        """Return whether something is heated before foods join ``stage``: on its line, or one that has joined that."""

        def before(line: Line) -> bool:
            place = place_among(line.stages, stage)
            if place is None:
                return any(before(add) for one in line.stages for add in one.lines)
            come = line.stages[: place + 1]
            beside = [add for one in come for add in one.lines if self.alive(add)]
            return any("heat" in one.does for add in beside for one in add.all_stages())

        return self.is_hot(stage) or before(self.line)

    def has_liquid(self, stages: Sequence[Stage]) -> bool:
        """Return whether a liquid to cook in is there at the last of ``stages``."""
        for join in self.plan.joins:
            if join.want.facts.is_a("cooking liquid") and any(join.spot.stage is s for s in self.until(stages[-1])):
                return True
        return self._water_slot(stages)

    def swells_there(self, join: Join) -> bool:
        """Return whether the food of ``join`` swells in what the dish is made of: a liquid joins there, and stays.

        So does what is cooked beside the dish in the liquid that is asked for it.
        """
        if not join.want.facts.is_any(word_list("swells")) or not (self.plan.one_pot or join.spot.side):
            return False
        there = {id(stage) for stage in (join.spot.stage, *(join.spot.after if self.plan.one_pot else ()))}
        liquid = word_list("swells what is dry")
        return any(id(one.spot.stage) in there and one.want.facts.is_of(*liquid) for one in self.plan.joins)

    def until(self, last: Stage) -> list[Stage]:
        """Return the stages that are done before ``last``, those of the lines that join them too, and that itself."""
        found: list[Stage] = []

        def walk(line: Line) -> bool:
            for stage in line.stages:
                if any(map(walk, stage.lines)):
                    return True
                found.append(stage)
                if stage is last:
                    return True
            return False

        walk(self.line)
        return found

    def _water_slot(self, stages: Sequence[Stage]) -> bool:
        last = stages[-1]
        return any(slot.food == "water" for stage in self.until(last) for slot in stage.slots)

    def alive(self, line: Line) -> bool:
        """Return whether any of the asked foods joins ``line``."""
        return any(map(self.stage_alive, line.stages))

    def stage_alive(self, stage: Stage) -> bool:
        """Return whether any of the asked foods joins at ``stage``, by itself or in a line."""
        return bool(self.at.get(id(stage))) or any(map(self.alive, stage.lines))
