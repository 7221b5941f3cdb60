"""Random walks through a kitchen: whoever follows one does nothing that cannot be done.

The model is its own and much smaller than the world of the judge, so that the two can disagree: foods with states and a
place, vessels with contents, a stove with burners, an oven, a blender and a few tools. A walk chooses among the
operators that are possible now, writes each as one step in object nodes as annotators of the FOON do, and ends with all
food in one dish. It knows which steps need which others, so that a test knows which corruption matters.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from hypothesis import strategies as st

from foon_kg.model import ObjectNode


@dataclass(frozen=True)
class Told:
    """An object node with the numbers of the thing and of what it is in."""

    node: ObjectNode
    thing: int | None = None
    inside: int | None = None


@dataclass(frozen=True)
class Line:
    """One step of a walk.

    ``kind`` is the operator, ``needs`` are the lines that last changed its foods and its appliances, ``about`` is the
    food that it works on, by number.
    """

    kind: str
    inputs: tuple[Told, ...]
    motion: str
    outputs: tuple[Told, ...]
    needs: frozenset[int] = frozenset()
    about: int | None = None


@dataclass(frozen=True)
class Walk:
    """A tree and what its model knows: ``foods`` are those of the dish, by number."""

    lines: tuple[Line, ...]
    goal: ObjectNode
    foods: tuple[Food, ...]


@dataclass(frozen=True)
class Kind:
    """A food as it is bought: its state, in what it is sold, what can be done to it, and what is inedible without."""

    label: str
    state: str
    sold_in: str = ""
    can: frozenset[str] = frozenset()
    owes: frozenset[str] = frozenset()
    liquid: bool = False


def _kind(label: str, state: str, sold_in: str = "", can: str = "", owes: str = "", *, liquid: bool = False) -> Kind:
    return Kind(label, state, sold_in, frozenset(can.split()), frozenset(owes.split()), liquid)


SOLID = (
    _kind("tomato", "whole", can="wash cut", owes="cut"),
    _kind("cucumber", "whole", can="wash peel cut", owes="cut"),
    _kind("onion", "whole", can="peel cut", owes="cut"),
    _kind("carrot", "whole", can="wash peel cut grate", owes="cut"),
    _kind("potato", "whole", can="wash peel cut grate", owes="cook"),
    _kind("banana", "whole", can="peel cut", owes="peel"),
    _kind("mozzarella", "block", can="cut grate"),
    _kind("chicken", "raw", can="wash cut", owes="cook"),
)
EGG = _kind("egg", "whole", owes="cook")
STORED = (
    _kind("salt", "granulated", "shaker"),
    _kind("sugar", "granulated", "bag"),
    _kind("flour", "powder", "bag"),
    _kind("rice", "uncooked", "bag", owes="cook"),
    _kind("olive oil", "liquid", "bottle", liquid=True),
    _kind("milk", "liquid", "carton", liquid=True),
)
WATER = _kind("water", "liquid", "faucet", liquid=True)
FOODS = frozenset(kind.label for kind in (*SOLID, EGG, *STORED, WATER))
CUTS = {"chop": "chopped", "slice": "sliced", "dice": "diced"}
COOKS = {"boil": "boiled", "fry": "fried", "heat": "hot", "bake": "baked"}
PRODUCTS = ("mixture", "mix", "filling", "stew", "smoothie", "medley", "soup")
VESSELS = (
    "bowl", "bowl", "bowl", "plate", "cutting board", "cutting board", "pot", "pan", "baking tray", "blender jar",
    "strainer", "serving bowl", "wooden spoon",
)  # fmt: skip
DEEP = frozenset({"bowl", "pot", "pan", "blender jar"})
FLAT = frozenset({"plate", "cutting board", "baking tray"})
ON = frozenset({"plate", "cutting board", "baking tray"})


LIKELY = {
    "boil": 20, "fry": 20, "heat": 8, "bake": 20, "blend": 20, "drain": 20, "put in oven": 12, "blender on": 12,
    "stove on": 8, "put on stove": 4, "attach": 2, "cut": 6, "pour stored": 6, "place": 4, "pour": 4, "scoop": 6,
}  # fmt: skip
"""How much likelier than others an operator is drawn: what needs much before it would hardly ever come about."""


@dataclass(eq=False)
class Food:
    """A food thing: its states, what was mixed into it and where it is; ``done`` has what was done to it."""

    kind: Kind
    number: int
    label: str
    states: tuple[str, ...]
    holds: tuple[Food, ...] = ()
    place: Vessel | None = None
    done: set[str] = field(default_factory=set)

    @property
    def foods(self) -> tuple[Food, ...]:
        """What it is made of, to the last: itself where nothing was mixed."""
        return tuple(one for held in self.holds for one in held.foods) if self.holds else (self,)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all foods in it."""
        return tuple(dict.fromkeys(food.label for food in self.foods))

    @property
    def is_plain(self) -> bool:
        """Whether it is one food from the shop that is still in one piece."""
        return not self.holds and self.done <= {"wash", "peel"}


@dataclass(eq=False)
class Vessel:
    """A vessel with its foods; ``stands`` is the appliance on, in or at which it is."""

    label: str
    number: int
    foods: list[Food] = field(default_factory=list)
    stands: Device | None = None
    hot: bool = False
    covered: bool = False

    @property
    def is_within_reach(self) -> bool:
        """Whether food can be put in and taken out: not from the oven, nor while a device works."""
        if self.covered:
            return False
        return (
            self.stands is None
            or self.stands.label == "stove"
            or (self.stands.label == "blender" and not self.stands.on)
        )


@dataclass(eq=False)
class Device:
    """An appliance; ``on`` has the vessels whose burner is lit, or ``""`` for the whole."""

    label: str
    number: int
    relation: str
    on: set[str] = field(default_factory=set)


@dataclass(frozen=True)
class Style:
    """How an annotator writes: one way throughout a tree."""

    tools_come_out: bool = True
    sources_come_out: bool = True
    vessel_tells_parts: bool = False
    pours_tell_foods: bool = True
    packages_are_told: bool = False
    off: str = "off"
    stove: str = "under"


styles = st.builds(
    Style, st.booleans(), st.booleans(), st.booleans(), st.booleans(), st.booleans(),
    st.sampled_from(("off", "off (ready)")), st.sampled_from(("under", "holds", "bare")),
)  # fmt: skip
Move = Callable[[], None]


class Cook:
    """A kitchen in the middle of a walk. ``moves`` are the operators that are possible; each of them writes a line."""

    def __init__(self, style: Style, left_out: frozenset[str] = frozenset()) -> None:
        self.style = style
        self.left_out = left_out
        self.lines: list[Line] = []
        self.numbers = itertools.count(1)
        self.stove = Device("stove", next(self.numbers), "on")
        self.oven = Device("oven", next(self.numbers), "in")
        self.blender = Device("blender", next(self.numbers), "attached to")
        self.vessels = [Vessel(name, next(self.numbers)) for name in VESSELS]
        self.tools = {
            name: next(self.numbers) for name in ("knife", "peeler", "grater", "spoon", "whisk", "fork", "lid")
        }
        self.packages = {kind.sold_in: next(self.numbers) for kind in (*STORED, WATER)}
        self.fresh = [*SOLID, EGG]
        self.washed: list[Food] = []
        self.products = list(PRODUCTS)
        self.written: dict[tuple[int | None, int | None], int] = {}

    # --- how things are told ---

    def food(self, food: Food, *extra: str) -> Told:
        place = food.place
        holds = food.names if food.holds else ()
        if place is None:
            return Told(ObjectNode(food.label, (*food.states, *extra), holds), food.number)
        relation = "on" if place.label in ON else "in"
        node = ObjectNode(food.label, (*food.states, *extra), holds, relation, place.label)
        return Told(node, food.number, place.number)

    def vessel(self, vessel: Vessel) -> Told:
        states = ("empty",) if not vessel.foods else ()
        states += ("hot",) if vessel.hot else ()
        states += ("covered",) if vessel.covered else ()
        tell = (lambda food: food.names) if self.style.vessel_tells_parts else (lambda food: (food.label,))
        holds = tuple(name for food in vessel.foods for name in tell(food))
        if vessel.stands is None:
            return Told(ObjectNode(vessel.label, states, holds), vessel.number)
        device = vessel.stands
        return Told(
            ObjectNode(vessel.label, states, holds, device.relation, device.label), vessel.number, device.number
        )

    def device(self, device: Device, vessel: Vessel | None = None) -> Told:
        burner = vessel.label if device is self.stove and vessel is not None else ""
        state = "on" if burner in device.on else self.style.off
        if device is self.stove and self.style.stove != "under":
            stands = tuple(one.label for one in self.vessels if one.stands is device)
            return Told(
                ObjectNode(device.label, (state,), stands if self.style.stove == "holds" else ()), device.number
            )
        if device is self.oven:
            inside = tuple(one.label for one in self.vessels if one.stands is device)
            states = (state,) if inside else (state, "empty")
            return Told(ObjectNode(device.label, states, inside), device.number)
        if vessel is None:
            return Told(ObjectNode(device.label, (state,)), device.number)
        relation = "under" if device is self.stove else "with"
        return Told(ObjectNode(device.label, (state,), (), relation, vessel.label), device.number, vessel.number)

    def tool(self, name: str) -> Told:
        return Told(ObjectNode(name), self.tools[name])

    def write(
        self, kind: str, inputs: Iterable[Told], motion: str, outputs: Iterable[Told], *,
        tools: Sequence[str] = (), touches: Iterable[Food] = (), about: Food | None = None,
    ) -> None:  # fmt: skip
        """Write a line; ``touches`` are foods that take part and are not told."""
        tools_told = tuple(map(self.tool, tools))
        inputs = (*inputs, *tools_told)
        outputs = (*outputs, *(tools_told if self.style.tools_come_out else ()))
        before = {told.node: told for told in inputs}
        devices = {device.number for device in (self.stove, self.oven, self.blender)}
        taken = [_key(told) for told in inputs if told.thing in devices or _is_food(told)]
        taken += [(food.number, None) for food in touches]
        needs = frozenset(self.written[key] for key in taken if key in self.written)
        place = len(self.lines)
        self.lines.append(Line(kind, inputs, motion, outputs, needs, about.number if about else None))
        changed = [_key(told) for told in outputs if before.get(told.node) != told]
        for key in (*changed, *((food.number, None) for food in touches)):
            self.written[key] = place

    # --- what is possible now ---

    def moves(self) -> dict[str, list[Move]]:
        """Return the possible operators by their kind."""
        found: dict[str, list[Move]] = {}
        for kind, move in self._moves():
            if kind not in self.left_out:
                found.setdefault(kind, []).append(move)
        return found

    def _moves(self) -> Iterator[tuple[str, Move]]:
        open_vessels = [
            one
            for one in self.vessels
            if one.is_within_reach and one.label not in {"strainer", "serving bowl", "wooden spoon"}
        ]
        open_vessels += [
            one for one in open_vessels if one.stands is not None or one.label in {"baking tray", "blender jar"}
        ] * 2
        for food in self._unplaced():
            yield from ((kind, move) for kind, move in self._with_unplaced(food, open_vessels))
        for kind in (*STORED, WATER, WATER):
            for vessel in open_vessels:
                deep = vessel.label in DEEP or (vessel.label in FLAT and not kind.liquid and vessel.foods)
                if deep and not self._would_be_twice(kind.label, vessel):
                    yield "pour stored", lambda kind=kind, vessel=vessel: self.pour_stored(kind, vessel)
        for vessel in self.vessels:
            if vessel.is_within_reach:
                yield from self._with_vessel(vessel, open_vessels)
        yield from self._with_devices()

    def _would_be_twice(self, name: str, vessel: Vessel) -> bool:
        """Whether a food would be in two vessels of one kind, which only numbers tell apart."""
        others = (one for one in self.vessels if one is not vessel and one.label == vessel.label)
        return "same food in two" in self.left_out and any(name in food.names for one in others for food in one.foods)

    def _unplaced(self) -> list[Food]:
        return [*self.washed, *(Food(kind, 0, kind.label, (kind.state,)) for kind in self.fresh)]

    def _with_unplaced(self, food: Food, vessels: Sequence[Vessel]) -> Iterator[tuple[str, Move]]:
        can = food.kind.can - food.done
        for vessel in vessels:
            if food.kind is EGG and vessel.label in DEEP:
                yield "crack", lambda vessel=vessel: self.crack(food, vessel)
            if food.kind is not EGG:
                yield "place", lambda vessel=vessel: self.place(food, vessel)
            if "cut" in can and vessel.label == "cutting board":
                for motion in CUTS:
                    yield "cut", lambda vessel=vessel, motion=motion: self.cut(food, vessel, motion)
            if "grate" in can and vessel.label == "bowl":
                yield "grate", lambda vessel=vessel: self.grate(food, vessel)
        if "wash" in can and not food.done:
            yield "wash", lambda: self.wash(food)
        if "peel" in can:
            yield "peel", lambda: self.peel(food)

    def _with_vessel(self, vessel: Vessel, others: Sequence[Vessel]) -> Iterator[tuple[str, Move]]:
        for food in vessel.foods:
            can = food.kind.can - food.done if food.is_plain else frozenset()
            if vessel.label == "cutting board" and "cut" in can:
                for motion in CUTS:
                    yield "cut", lambda food=food, motion=motion: self.cut(food, vessel, motion)
            if vessel.label == "cutting board" and "peel" in can:
                yield "peel", lambda food=food: self.peel(food)
            if len(vessel.foods) > 1 and vessel.label != "strainer":
                for other in self._targets(vessel, [food], others):
                    yield "scoop", lambda food=food, other=other: self.scoop(food, other)
                    if len(food.foods) == 1 and food.label not in {one.label for one in other.foods}:
                        yield "scoop", lambda food=food, other=other: self.spoon(food, other)
            if vessel.label == "bowl" and food.is_plain is False and food.kind.label in {"potato", "banana"}:
                if not food.holds and "mash" not in food.done and "cook" in food.done | food.kind.owes ^ {"cook"}:
                    yield "mash", lambda food=food: self.mash(food)
        if vessel.label == "bowl" and [one.states for one in vessel.foods] == [("cracked",)]:
            yield "beat", lambda: self.beat(vessel)
        if vessel.foods:
            for other in self._targets(vessel, vessel.foods, others):
                yield "pour", lambda other=other: self.pour(vessel, other)
        if len(vessel.foods) > 1 and vessel.label in DEEP - {"blender jar"} and len(self.products) > 1:
            yield "mix", lambda: self.mix(vessel, self.products.pop(0))
        if len(vessel.foods) > 1 and vessel.label in DEEP - {"blender jar"}:
            yield "stir", lambda: self.stir(vessel)

    def _targets(self, vessel: Vessel, foods: Sequence[Food], others: Sequence[Vessel]) -> list[Vessel]:
        wet = any(one.kind.liquid for food in foods for one in food.foods)
        return [
            one for one in others if one.label in (DEEP if wet else DEEP | FLAT) and _can_be_told(vessel, one, foods)
        ]

    def _with_devices(self) -> Iterator[tuple[str, Move]]:
        for vessel in self.vessels:
            if vessel.label in {"pot", "pan"}:
                yield from self._on_the_stove(vessel)
            if vessel.label == "baking tray":
                yield from self._in_the_oven(vessel)
            if vessel.label == "blender jar":
                yield from self._at_the_blender(vessel)
        if not self.oven.on:
            yield "oven on", lambda: self.switch(self.oven, "")
        elif any(one.hot for one in self.vessels):
            yield "oven off", lambda: self.switch(self.oven, "")

    def _on_the_stove(self, vessel: Vessel) -> Iterator[tuple[str, Move]]:
        lit = vessel.label in self.stove.on
        if vessel.stands is None:
            # only a burner of its own tells which of two vessels is hot
            if self.style.stove == "under" or not any(one.stands is self.stove for one in self.vessels):
                yield "put on stove", lambda: self.stand(vessel, self.stove)
            return
        if not lit or vessel.hot:
            yield ("stove off" if lit else "stove on"), lambda: self.switch(self.stove, vessel.label, vessel)
        beside = "take off a lit stove" in self.left_out and self.stove.on
        if not lit and vessel.hot and not beside and not vessel.covered:
            yield "take off stove", lambda: self.lift(vessel)
        foods = [one for food in vessel.foods for one in food.foods]
        if lit and foods:
            yield "heat", lambda: self.heat(vessel, "heat", self.device(self.stove, vessel))
            if any(one.label == "water" for one in foods) and len(vessel.foods) > 1:
                yield "boil", lambda: self.heat(vessel, "boil", self.device(self.stove, vessel))
                closed = "boil into soup under a lid" in self.left_out and vessel.covered
                if "soup" in self.products and not closed:
                    yield "boil", lambda: self.boil_into(vessel, "soup")
            if vessel.label == "pan" and len(vessel.foods) > 1 and any(one.label == "olive oil" for one in foods):
                yield "fry", lambda: self.heat(vessel, "fry", self.device(self.stove, vessel))
        if vessel.covered:
            yield "uncover", lambda: self.uncover(vessel)
            return
        if vessel.label == "pot" and foods:
            yield "cover", lambda: self.cover(vessel)
        strainer = next(one for one in self.vessels if one.label == "strainer")
        cooked = [food for food in vessel.foods if food.label != "water"]
        if vessel.label == "pot" and len(cooked) < len(vessel.foods) and cooked and not strainer.foods:
            if not any(one.kind.liquid for food in cooked for one in food.foods):
                yield "drain", lambda: self.drain(vessel, strainer)

    def _in_the_oven(self, vessel: Vessel) -> Iterator[tuple[str, Move]]:
        if vessel.stands is None:
            if vessel.foods:
                yield "put in oven", lambda: self.stand(vessel, self.oven)
            return
        if vessel.hot:
            yield "take out of oven", lambda: self.lift(vessel)
        if self.oven.on:
            yield "bake", lambda: self.heat(vessel, "bake", self.device(self.oven))

    def _at_the_blender(self, vessel: Vessel) -> Iterator[tuple[str, Move]]:
        if vessel.stands is None:
            yield "attach", lambda: self.stand(vessel, self.blender)
            return
        if self.blender.on:
            yield "blender off", lambda: self.switch(self.blender, "", vessel)
            if len(self.products) > 1:
                yield "blend", lambda: self.blend(vessel, self.products.pop(0))
            return
        if vessel.foods:
            yield "detach", lambda: self.lift(vessel)
            yield "blender on", lambda: self.switch(self.blender, "", vessel)

    # --- the operators ---

    def take(self, food: Food) -> Food:
        """Take a food out of the shopping basket, once."""
        if food.number == 0:
            food.number = next(self.numbers)
            self.fresh.remove(food.kind)
        if food in self.washed:
            self.washed.remove(food)
        return food

    def place(self, food: Food, vessel: Vessel) -> None:
        self.take(food)
        inputs = (self.food(food), self.vessel(vessel))
        self._put(food, vessel)
        self.write("place", inputs, "pick-and-place", (self.food(food), self.vessel(vessel)), about=food)

    def crack(self, food: Food, vessel: Vessel) -> None:
        self.take(food)
        inputs = (self.food(food), self.vessel(vessel))
        self._put(food, vessel)
        self._become(food, "crack", "cracked")
        self.write("crack", inputs, "crack", (self.food(food), self.vessel(vessel)), about=food)

    def wash(self, food: Food) -> None:
        before = self.food(self.take(food))
        self.washed.append(food)
        food.done.add("wash")
        food.states = (*food.states, "washed")
        self.write("wash", (before,), "wash", (self.food(food),), about=food)

    def peel(self, food: Food) -> None:
        vessel = food.place
        self.take(food) if vessel is None else None
        before = (self.food(food), *self._around(vessel))
        self.washed += [food] if vessel is None else []
        self._become(food, "peel", "peeled")
        tool = ("peeler",) if food.label != "banana" else ()
        self.write("peel", before, "peel", (self.food(food), *self._around(vessel)), tools=tool, about=food)

    def cut(self, food: Food, board: Vessel, motion: str) -> None:
        self.take(food) if food.place is None else None
        inputs = (self.food(food), self.vessel(board))
        if food.place is None:
            self._put(food, board)
        self._become(food, "cut", CUTS[motion])
        self.write("cut", inputs, motion, (self.food(food), self.vessel(board)), tools=("knife",), about=food)

    def grate(self, food: Food, bowl: Vessel) -> None:
        self.take(food)
        inputs = (self.food(food), self.vessel(bowl))
        self._put(food, bowl)
        self._become(food, "grate", "grated")
        self.write("grate", inputs, "grate", (self.food(food), self.vessel(bowl)), tools=("grater",), about=food)

    def pour_stored(self, kind: Kind, vessel: Vessel) -> None:
        food = Food(kind, next(self.numbers), kind.label, (kind.state,))
        relation = "from" if kind is WATER else "in"
        package = self.packages[kind.sold_in]
        told = Told(ObjectNode(kind.label, food.states, (), relation, kind.sold_in), food.number, package)
        box = Told(ObjectNode(kind.sold_in, (), (kind.label,)), None)
        boxes = (box,) if self.style.packages_are_told and kind is not WATER else ()
        inputs = (*boxes, told, self.vessel(vessel))
        same = next((other for other in vessel.foods if other.label == kind.label and not other.holds), None)
        if same is not None:
            inputs = (*inputs, self.food(same))
            food = same
        else:
            self._put(food, vessel)
        motion = "pour" if kind.liquid or kind.sold_in == "bag" else "sprinkle"
        self.write("pour stored", inputs, motion, (self.food(food), self.vessel(vessel), *boxes), about=food)

    def pour(self, vessel: Vessel, other: Vessel) -> None:
        foods = list(vessel.foods)
        told = self.style.pours_tell_foods
        inputs = [*(self.food(food) for food in foods if told), self.vessel(vessel), self.vessel(other)]
        for food in foods:
            self._put(food, other)
        vessel.hot = False
        outputs = [*(self.food(food) for food in foods if told), self.vessel(other), self.vessel(vessel)]
        self.write("pour", inputs, "pour", outputs, touches=foods)

    def scoop(self, food: Food, other: Vessel) -> None:
        vessel = food.place
        inputs = (self.food(food), *self._around(vessel), self.vessel(other))
        self._put(food, other)
        outputs = (self.food(food), self.vessel(other), *self._around(vessel))
        self.write("scoop", inputs, "scoop and pour", outputs, tools=("spoon",), about=food)

    def mix(self, vessel: Vessel, label: str, motion: str = "mix", state: str = "mixed") -> None:
        self._join(vessel, label, "mix", motion, state, ("spoon",))

    def blend(self, vessel: Vessel, label: str) -> None:
        self._join(vessel, label, "blend", "blend", "blended", ())

    def _join(self, vessel: Vessel, label: str, kind: str, motion: str, state: str, tools: Sequence[str]) -> None:
        foods = tuple(vessel.foods)
        source = (self.device(self.blender, vessel),) if kind == "blend" else ()
        inputs = (*map(self.food, foods), self.vessel(vessel), *source)
        vessel.foods.clear()
        product = Food(foods[0].kind, next(self.numbers), label, (state,), foods)
        for food in product.foods:
            food.done.add(kind)
        self._put(product, vessel)
        back = source if self.style.sources_come_out else ()
        outputs = (self.food(product), self.vessel(vessel), *back)
        self.write(kind, inputs, motion, outputs, tools=tools, about=product, touches=(*foods, product))

    def stir(self, vessel: Vessel) -> None:
        inputs = (*map(self.food, vessel.foods), self.vessel(vessel))
        for food in vessel.foods:
            food.states = tuple(dict.fromkeys((*food.states, "mixed")))
        outputs = (*map(self.food, vessel.foods), self.vessel(vessel))
        self.write("stir", inputs, "stir", outputs, tools=("spoon",))

    def stand(self, vessel: Vessel, device: Device) -> None:
        motion = {"stove": "pick-and-place", "oven": "put inside", "blender": "attach"}[device.label]
        kind = {"stove": "put on stove", "oven": "put in oven", "blender": "attach"}[device.label]
        before = (self.vessel(vessel), self.device(device))
        vessel.stands = device
        vessel.hot = False
        self.write(kind, before, motion, (self.vessel(vessel), self.device(device, vessel)))

    def lift(self, vessel: Vessel) -> None:
        device = vessel.stands
        if device is None:
            return
        motion = {"stove": "pick-and-place", "oven": "remove", "blender": "detach"}[device.label]
        kind = {"stove": "take off stove", "oven": "take out of oven", "blender": "detach"}[device.label]
        before = (self.vessel(vessel), self.device(device, vessel))
        vessel.stands = None
        self.write(kind, before, motion, (self.vessel(vessel), self.device(device)))

    def switch(self, device: Device, burner: str, vessel: Vessel | None = None) -> None:
        before = self.device(device, vessel)
        word = "off" if burner in device.on else "on"
        device.on ^= {burner}
        self.write(f"{device.label} {word}", (before,), f"turn {word}", (self.device(device, vessel),))

    def heat(self, vessel: Vessel, motion: str, source: Told) -> None:
        inputs = (*map(self.food, vessel.foods), self.vessel(vessel), source)
        for food in vessel.foods:
            food.states = tuple(dict.fromkeys((*(one for one in food.states if one != "raw"), COOKS[motion])))
            for one in food.foods:
                one.done |= {"heat"} if motion == "heat" else {"heat", "cook"}
        vessel.hot = True
        back = (source,) if self.style.sources_come_out else ()
        outputs = (*map(self.food, vessel.foods), self.vessel(vessel), *back)
        self.write(motion, inputs, motion, outputs, touches=vessel.foods)

    def boil_into(self, pot: Vessel, label: str) -> None:
        self.products.remove(label)
        foods, source = tuple(pot.foods), self.device(self.stove, pot)
        inputs = (*map(self.food, foods), self.vessel(pot), source)
        pot.foods.clear()
        soup = Food(foods[0].kind, next(self.numbers), label, ("cooked",), foods)
        for food in soup.foods:
            food.done |= {"mix", "heat", "cook"}
        self._put(soup, pot)
        pot.hot = True
        back = (source,) if self.style.sources_come_out else ()
        self.write("boil", inputs, "boil", (self.food(soup), self.vessel(pot), *back), about=soup, touches=foods)

    def mash(self, food: Food) -> None:
        vessel = food.place
        inputs = (self.food(food), *self._around(vessel))
        self._become(food, "mash", "mashed")
        self.write("mash", inputs, "mash", (self.food(food), *self._around(vessel)), tools=("fork",), about=food)

    def beat(self, vessel: Vessel) -> None:
        egg = vessel.foods[0]
        inputs = (self.food(egg), self.vessel(vessel))
        self._become(egg, "beat", "beaten")
        self.write("beat", inputs, "beat", (self.food(egg), self.vessel(vessel)), tools=("whisk",), about=egg)

    def spoon(self, food: Food, other: Vessel) -> None:
        """Take a food up with a spoon and let it go over another vessel: two lines."""
        vessel, spoon = food.place, self._vessel("wooden spoon")
        inputs = (self.food(food), *self._around(vessel), self.vessel(spoon))
        self._put(food, spoon)
        self.write("scoop", inputs, "scoop", (self.food(food), self.vessel(spoon), *self._around(vessel)), about=food)
        inputs = (self.food(food), self.vessel(spoon), self.vessel(other))
        self._put(food, other)
        self.write("pour", inputs, "pour", (self.food(food), self.vessel(other), self.vessel(spoon)), about=food)

    def cover(self, pot: Vessel) -> None:
        lid = Told(ObjectNode("lid"), self.tools["lid"])
        before = (self.vessel(pot), lid)
        pot.covered = True
        self.write("cover", before, "cover", (self.vessel(pot),))

    def uncover(self, pot: Vessel) -> None:
        lid = Told(ObjectNode("lid"), self.tools["lid"])
        before = (self.vessel(pot),)
        pot.covered = False
        self.write("uncover", before, "uncover", (self.vessel(pot), lid))

    def drain(self, pot: Vessel, strainer: Vessel) -> None:
        foods = [food for food in pot.foods if food.label != "water"]
        inputs = (*map(self.food, foods), self.vessel(pot), self.vessel(strainer))
        for food in foods:
            self._put(food, strainer)
        pot.foods.clear()
        outputs = (*map(self.food, foods), self.vessel(strainer), self.vessel(pot))
        self.write("drain", inputs, "drain", outputs)

    # --- the end ---

    def finish(self) -> None:
        """Switch everything off, bring all food into one bowl and mix it."""
        self._rest()
        full = [vessel for vessel in self.vessels if vessel.foods]
        if not full:
            self.place(self._unplaced()[0], self._vessel("plate"))
            return
        bowls = [vessel for vessel in self.vessels if vessel.label == "bowl"]
        bowl = next(
            (one for one in bowls if [one] == [other for other in bowls if other.foods]), self._vessel("serving bowl")
        )
        for vessel in full:
            if vessel is not bowl:
                self.pour(vessel, bowl)
        if len(bowl.foods) > 1:
            self.mix(bowl, "salad")
        elif self.lines[-1].kind not in {"pour", "mix", "place", "scoop"}:
            self.pour(bowl, self._vessel("serving bowl"))

    def _rest(self) -> None:
        for vessel in self.vessels:
            if vessel.covered:
                self.uncover(vessel)
            if vessel.label in self.stove.on:
                self.switch(self.stove, vessel.label, vessel)
            if vessel.stands is self.oven:
                self.lift(vessel)
            if vessel.stands is self.blender:
                if self.blender.on:
                    self.switch(self.blender, "", vessel)
                self.lift(vessel)
        if self.oven.on:
            self.switch(self.oven, "")

    def _vessel(self, label: str) -> Vessel:
        return next(vessel for vessel in self.vessels if vessel.label == label)

    def _wet(self, vessel: Vessel) -> bool:
        return any(one.kind.liquid for food in vessel.foods for one in food.foods)

    def _around(self, vessel: Vessel | None) -> tuple[Told, ...]:
        return () if vessel is None else (self.vessel(vessel),)

    def _put(self, food: Food, vessel: Vessel) -> None:
        if food.place is not None and food in food.place.foods:
            food.place.foods.remove(food)
        food.place = vessel
        vessel.foods.append(food)

    def _become(self, food: Food, what: str, state: str) -> None:
        food.done.add(what)
        kept = tuple(one for one in food.states if one == "washed")
        food.states = (*kept, state)


def _key(told: Told) -> tuple[int | None, int | None]:
    """Return which thing is told: a burner of a stove is one by itself."""
    return (told.thing, told.inside if told.node.label == "stove" else None)


def _is_food(told: Told) -> bool:
    return told.node.label in FOODS or told.node.label in {*PRODUCTS, "salad"}


def _can_be_told(vessel: Vessel, other: Vessel, foods: Sequence[Food]) -> bool:
    """Whether nodes without numbers can tell a pour: not one from a bowl into an empty bowl."""
    if other.label != vessel.label:
        return True
    names = {name for food in foods for name in food.names}
    if other is vessel or any(not names.isdisjoint(food.names) for food in other.foods):
        return False
    return bool(other.foods) or len(foods) < len(vessel.foods)


def walked(cook: Cook) -> Walk:
    """Return the walk that a cook has made."""
    last = max(cook.vessels, key=lambda vessel: len([one for food in vessel.foods for one in food.foods]))
    dish = last.foods[-1]
    return Walk(tuple(cook.lines), cook.food(dish).node, dish.foods)


@st.composite
def walks(draw: st.DrawFn, left_out: frozenset[str] = frozenset(), most: int = 24) -> Walk:
    """Draw a walk of at most ``most`` operators before the dish is put together; ``left_out`` are operators unused."""
    cook = Cook(draw(styles), left_out)
    for _ in range(draw(st.integers(most // 3, most))):
        moves = cook.moves()
        kind = draw(st.sampled_from([kind for kind in sorted(moves) for _ in range(LIKELY.get(kind, 1))]))
        draw(st.sampled_from(moves[kind]))()
    cook.finish()
    return walked(cook)


def without_numbers(line: Line) -> Line:
    """Return a line as FOON text has it, whose things have no numbers."""
    return replace(
        line,
        inputs=tuple(Told(told.node) for told in line.inputs),
        outputs=tuple(Told(told.node) for told in line.outputs),
    )
