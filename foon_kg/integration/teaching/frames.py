"""How a recorded dish is made, as data: lines of stages, and the slots at which foods join."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.model import ObjectNode, content_key


@dataclass(frozen=True)
class Slot:
    """A food that joins a stage.

    ``states`` are those in which it joins, ``cooked`` the motions that cooked it by itself before. It is brought by
    ``motion`` with ``tools`` out of ``source`` (a vessel's label, ``""`` for none).
    """

    food: str
    kind: str
    states: tuple[str, ...] = ()
    cooked: tuple[str, ...] = ()
    motion: str = ""
    tools: tuple[str, ...] = ()
    source: str = ""


BATH = Slot("water", "water", ("boiling",))
"""Water in which something is boiled that is taken out of it, whatever else water is asked for."""

THINNED = Slot("water", "water", ("liquid",))
"""Water that makes what is dry a batter, where nothing liquid is asked for that."""


HEATS = frozenset({"heat", "warm"})
"""What a stage does that makes things hot, be they cooked by it or only warmed."""


ADDED = -1
"""The ``step`` of a stage that no video has: a table adds it, or it is done to a dish that is ready by then."""


@dataclass(frozen=True)
class Stage:
    """What joins, and what is then done to the whole.

    ``adds`` are slots and lines in the order in which they join. ``motion`` is ``""`` where nothing is done after it.
    The whole is then in or on ``vessel``; ``appliance`` is what works on it or keeps it (``""`` for none). ``label``
    and ``states`` are what the whole is called afterwards. ``step`` is the place of the unit in its video, 0 where no
    unit does it, and :data:`ADDED` where no video has such a stage.
    """

    adds: tuple[Slot | Line, ...]
    motion: str
    does: frozenset[str]
    tools: tuple[str, ...]
    vessel: str
    relation: str
    appliance: str
    source: str
    label: str
    states: tuple[str, ...]
    step: int

    @property
    def heats(self) -> bool:
        """Whether the whole is heated, or only warmed."""
        return not self.does.isdisjoint(HEATS)

    @property
    def is_added(self) -> bool:
        """Whether no video has it: a table adds it, or it is done to a dish that is ready by then."""
        return self.step == ADDED

    @property
    def slots(self) -> Iterator[Slot]:
        """The foods that join here by themselves."""
        return (add for add in self.adds if isinstance(add, Slot))

    @property
    def lines(self) -> tuple[Line, ...]:
        """The lines that join here: what was made apart."""
        return tuple(add for add in self.adds if isinstance(add, Line))


def place_among(stages: Sequence[Stage], stage: Stage) -> int | None:
    """Return the place of this very ``stage`` among ``stages``, ``None`` where it is none of them.

    Not by ``index``: what is fried on both sides has two stages that are equal.
    """
    return next((place for place, one in enumerate(stages) if one is stage), None)


@dataclass(frozen=True)
class Phase(Stage):
    """A stage of a vessel over the heat of which nothing but the place is the video's: the plan orders its foods.

    ``bath``: there is a liquid in which things boil. ``small``: it is eaten with a spoon or fork alone, so that meat
    comes in pieces.
    """

    bath: bool = False
    small: bool = False


@dataclass(frozen=True)
class Asked(Stage):
    """A stage that a title or a table asks for: it is done to whatever is there, as the FOON does it to anything."""


@dataclass(frozen=True)
class Steamed(Stage):
    """A stage at which what is in its vessel is cooked in the steam of a vessel that is ``over`` the heat, under it."""

    over: str = ""


@dataclass(frozen=True)
class LiftedOut(Stage):
    """A stage at which flesh is lifted out of what it was cooked in."""


@dataclass(frozen=True)
class Rejoined(Stage):
    """A stage at which the rest comes to flesh that was lifted out of it."""


@dataclass(frozen=True)
class Line:
    """Stages one after another that lead to one thing: the dish, or what joins it (a dressing, a batter)."""

    stages: tuple[Stage, ...]

    def all_stages(self) -> Iterator[Stage]:
        """Yield every stage of this line and of the lines that join it."""
        for stage in self.stages:
            yield stage
            for line in stage.lines:
                yield from line.all_stages()

    def all_slots(self) -> Iterator[Slot]:
        """Yield every slot of this line and of the lines that join it."""
        for stage in self.stages:
            for add in stage.adds:
                if isinstance(add, Slot):
                    yield add
                else:
                    yield from add.all_slots()


@dataclass(frozen=True)
class Frame:
    """How the dish ``goal`` is made in the video ``video``.

    ``weak`` are the foods of the goal that could not be followed through the video, so that they have no slot.
    """

    goal: ObjectNode
    dish_type: str
    video: str
    line: Line
    weak: tuple[str, ...] = ()

    @cached_property
    def key(self) -> str:
        """The content hash under which the graph keeps this frame: one goal of one video and dish type."""
        return content_key(self.video, self.goal.key, self.dish_type)
