"""What can be done in the kitchen of a walk, and how an annotator of the FOON writes each step down."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

from world.kitchen_things import (
    COOKS,
    CUTS,
    EGG,
    FOODS,
    ON,
    PRODUCTS,
    SOLID,
    STORED,
    VESSELS,
    WATER,
    Device,
    Food,
    Kind,
    Line,
    Style,
    Told,
    Vessel,
)

from foon_kg.model import ObjectNode


class Kitchen:
    """A kitchen in the middle of a walk: each operator changes it and writes a line."""

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

    def mix(self, vessel: Vessel, label: str) -> None:
        self._join(vessel, label, "mix", "mixed")

    def blend(self, vessel: Vessel, label: str) -> None:
        self._join(vessel, label, "blend", "blended")

    def _join(self, vessel: Vessel, label: str, motion: str, state: str) -> None:
        foods = tuple(vessel.foods)
        source = (self.device(self.blender, vessel),) if motion == "blend" else ()
        tools = ("spoon",) if motion == "mix" else ()
        inputs = (*map(self.food, foods), self.vessel(vessel), *source)
        vessel.foods.clear()
        product = Food(foods[0].kind, next(self.numbers), label, (state,), foods)
        for food in product.foods:
            food.done.add(motion)
        self._put(product, vessel)
        back = source if self.style.sources_come_out else ()
        outputs = (self.food(product), self.vessel(vessel), *back)
        self.write(motion, inputs, motion, outputs, tools=tools, about=product, touches=(*foods, product))

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

    def _vessel(self, label: str) -> Vessel:
        return next(vessel for vessel in self.vessels if vessel.label == label)

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
