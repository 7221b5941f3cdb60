"""Single faults in a walk through a kitchen: each makes of a possible tree one that nobody can carry out or eat."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from world.kitchen_things import VESSELS, Line, Told, Walk

from foon_kg.model import ObjectNode

MADE_OF_NOTHING = ("W1", "W2", "W3", "W4", "K1", "K2", "K4", "K7", "C2", "C3", "C6")
"""What a tree may be told that goes on from something that never happened."""


@dataclass(frozen=True)
class Fault:
    """The lines of a walk with one fault, the line that it befell, and the rules of which one tells it.

    ``mild``: a cook may let it pass, so that a minor finding is enough.
    """

    kind: str
    line: Line
    lines: tuple[Line, ...]
    rules: tuple[str, ...]

    @property
    def mild(self) -> bool:
        """Whether a minor finding is enough: a state that nobody gave, or something that was not turned off."""
        return self.kind.startswith("a new state") or self.line.kind.endswith(" off")


MOVES = frozenset({"place", "pour", "scoop", "pour stored", "crack", "cut", "grate", "drain"})
GIVES = frozenset({"peel", "wash", "heat", "boil", "fry", "bake", "beat", "mash", "stir"})
SWITCHES = frozenset({"stove on", "stove off", "oven on", "oven off", "blender on", "blender off"})
JOINS = frozenset({"mix", "blend"})


def dropped(walk: Walk) -> Iterator[Fault]:
    """A step left out that a later one needs."""
    needed = frozenset(place for line in walk.lines for place in line.needs)
    for place in sorted(needed):
        line = walk.lines[place]
        if line.kind in MOVES | GIVES | SWITCHES | JOINS:
            lines = (*walk.lines[:place], *walk.lines[place + 1 :])
            yield Fault(f"{_what(line)} dropped", line, lines, MADE_OF_NOTHING)


def _what(line: Line) -> str:
    """Return what kind of a step it is: a move, into what, a new state, a switch, or a product."""
    if line.kind in GIVES or (line.kind == "cut" and _stays(line)):
        return "a new state"
    if line.kind not in MOVES:
        return "a switch" if line.kind in SWITCHES else "a product"
    filled = [told for told in line.inputs if told.node.label in VESSELS and told.node.ingredients]
    kept = [told for told in line.outputs if any(told.thing == one.thing for one in filled) and told.node.ingredients]
    return "a move between others" if kept else "a move"


def _stays(line: Line) -> bool:
    """Whether the food that a line works on is in one place before and after."""
    before, after = (next(told for told in side if told.thing == line.about) for side in (line.inputs, line.outputs))
    return before.inside == after.inside


def doubled(walk: Walk) -> Iterator[Fault]:
    """A step done twice in a row."""
    for place, line in enumerate(walk.lines):
        yield Fault("doubled", line, (*walk.lines[: place + 1], *walk.lines[place:]), ("C3", "W1", "W2", "W3", "W4"))


def swapped(walk: Walk) -> Iterator[Fault]:
    """Two steps in the wrong order, the second of which needs the first."""
    for place, (one, other) in enumerate(zip(walk.lines, walk.lines[1:], strict=False)):
        if place in other.needs and one.kind in MOVES | SWITCHES | JOINS:
            yield Fault(
                f"{_what(one)} swapped",
                one,
                (*walk.lines[:place], other, one, *walk.lines[place + 2 :]),
                MADE_OF_NOTHING,
            )


HEATS = frozenset({"heat", "boil", "fry", "bake", "blend"})


def unlit(walk: Walk) -> Iterator[Fault]:
    """An appliance that works and that nobody turned on."""
    for place, line in enumerate(walk.lines):
        if line.kind in {"stove on", "oven on", "blender on"} and any(
            place in later.needs and later.kind in HEATS for later in walk.lines
        ):
            yield Fault("unlit", line, (*walk.lines[:place], *walk.lines[place + 1 :]), ("W3",))


def renamed(walk: Walk) -> Iterator[Fault]:
    """A filled vessel that turns into another in the outputs of a step."""
    for place, line in enumerate(walk.lines):
        for told in line.outputs:
            if told.node.label not in VESSELS or not told.node.ingredients:
                continue
            other = replace(told, node=replace(told.node, label="jug"))
            outputs = tuple(other if one is told else one for one in line.outputs)
            lines = (*walk.lines[:place], replace(line, outputs=outputs), *walk.lines[place + 1 :])
            yield Fault("renamed", line, lines, ("W1", "W2"))


def poured_twice(walk: Walk) -> Iterator[Fault]:
    """A vessel that is poured out once more, into a cup, when it is empty."""
    for place, line in enumerate(walk.lines):
        again = _into_a_cup(line) if line.kind == "pour" else None
        if again is not None:
            yield Fault("poured twice", line, (*walk.lines[: place + 1], again, *walk.lines[place + 1 :]), ("W1",))


def _into_a_cup(line: Line) -> Line | None:
    emptied = next((told for told in line.outputs if "empty" in told.node.states), None)
    if emptied is None:
        return None
    source = next(told for told in line.inputs if told.thing == emptied.thing)
    foods = [told for told in line.inputs if told.inside == source.thing]
    cup = Told(ObjectNode("cup", ("empty",)), 999)
    filled = Told(ObjectNode("cup", (), source.node.ingredients), 999)
    moved = [replace(told, node=replace(told.node, relation="in", container="cup"), inside=999) for told in foods]
    return replace(line, inputs=(*foods, source, cup), outputs=(*moved, filled, emptied))


def left_whole(walk: Walk) -> Iterator[Fault]:
    """A food that is never cut or peeled, though nobody eats it so: later lines tell it as it was before."""
    for food in walk.foods:
        for owed in sorted(food.kind.owes):
            places = [place for place, line in enumerate(walk.lines) if _gives(line, owed, food.number)]
            enough = food.done & {"cut", "grate", "mash", "blend", "beat"} if owed == "cut" else {owed} & food.done
            if owed == "cook" or len(enough) != 1 or len(places) != 1:
                continue
            yield Fault("left whole", walk.lines[places[0]], _without(walk.lines, places[0], food.number), ("K2",))


def _gives(line: Line, owed: str, number: int) -> bool:
    return line.about == number and line.kind == owed


def _without(lines: tuple[Line, ...], place: int, number: int) -> tuple[Line, ...]:
    """Return the lines with a step that only moves its food, if that, and the food as it was before."""
    line = lines[place]
    before = next(told for told in line.inputs if told.thing == number)
    after = next(told for told in line.outputs if told.thing == number)

    def as_before(told: Told) -> Told:
        if told.thing != number:
            return told
        gone = set(after.node.states) - set(before.node.states)
        states = (*(state for state in told.node.states if state not in gone), *before.node.states)
        return replace(told, node=replace(told.node, states=states))

    moved = before.node.container != after.node.container
    step = replace(
        line, inputs=tuple(t for t in line.inputs if t.node.label not in {"knife", "peeler"}), motion="pick-and-place",
        outputs=tuple(as_before(t) for t in line.outputs if t.node.label not in {"knife", "peeler"}),
    )  # fmt: skip
    later = [
        replace(one, inputs=tuple(map(as_before, one.inputs)), outputs=tuple(map(as_before, one.outputs)))
        for one in lines[place + 1 :]
    ]
    return (*lines[:place], *((step,) if moved else ()), *later)


FAULTS: tuple[Callable[[Walk], Iterator[Fault]], ...] = (
    dropped, doubled, swapped, unlit, renamed, poured_twice, left_whole,
)  # fmt: skip
