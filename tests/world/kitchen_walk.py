"""Random walks through a kitchen: whoever follows one does nothing that cannot be done.

The model is its own and much smaller than the world of the judge, so that the two can disagree: foods with states and a
place, vessels with contents, a stove with burners, an oven, a blender and a few tools. A walk chooses among the
operators that are possible now, writes each as one step in object nodes as annotators of the FOON do, and ends with all
food in one dish. It knows which steps need which others, so that a test knows which corruption matters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from hypothesis import strategies as st
from world.kitchen_operators import Kitchen
from world.kitchen_things import (
    CUTS,
    DEEP,
    EGG,
    FLAT,
    STORED,
    WATER,
    Food,
    Line,
    Style,
    Told,
    Vessel,
    Walk,
)

LIKELY = {
    "boil": 20, "fry": 20, "heat": 8, "bake": 20, "blend": 20, "drain": 20, "put in oven": 12, "blender on": 12,
    "stove on": 8, "put on stove": 4, "attach": 2, "cut": 6, "pour stored": 6, "place": 4, "pour": 4, "scoop": 6,
}  # fmt: skip
"""How much likelier than others an operator is drawn: what needs much before it would hardly ever come about."""

styles = st.builds(
    Style, st.booleans(), st.booleans(), st.booleans(), st.booleans(), st.booleans(),
    st.sampled_from(("off", "off (ready)")), st.sampled_from(("under", "holds", "bare")),
)  # fmt: skip

Move = Callable[[], None]


class Cook(Kitchen):
    """A cook who knows what is possible next, and how to bring it to an end."""

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

    def _would_be_twice(self, name: str, vessel: Vessel, source: Vessel | None = None) -> bool:
        """Whether a food would be in two vessels of one kind, which only numbers tell apart."""
        others = (one for one in self.vessels if one not in {vessel, source} and one.label == vessel.label)
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
            if vessel.label == "cutting board" and food.is_plain:
                yield from self._on_the_board(food, vessel)
            if len(vessel.foods) > 1 and vessel.label != "strainer":
                yield from self._one_of_several(food, vessel, others)
            if vessel.label == "bowl" and food.can_be_mashed:
                yield "mash", lambda food=food: self.mash(food)
        if vessel.label == "bowl" and [one.states for one in vessel.foods] == [("cracked",)]:
            yield "beat", lambda: self.beat(vessel)
        if vessel.foods:
            for other in self._targets(vessel, vessel.foods, others):
                yield "pour", lambda other=other: self.pour(vessel, other)
        if len(vessel.foods) > 1 and vessel.label in DEEP - {"blender jar"}:
            yield "stir", lambda: self.stir(vessel)
            if len(self.products) > 1:
                yield "mix", lambda: self.mix(vessel, self.products.pop(0))

    def _on_the_board(self, food: Food, board: Vessel) -> Iterator[tuple[str, Move]]:
        can = food.kind.can - food.done
        if "cut" in can:
            for motion in CUTS:
                yield "cut", lambda motion=motion: self.cut(food, board, motion)
        if "peel" in can:
            yield "peel", lambda: self.peel(food)

    def _one_of_several(self, food: Food, vessel: Vessel, others: Sequence[Vessel]) -> Iterator[tuple[str, Move]]:
        for other in self._targets(vessel, [food], others):
            yield "scoop", lambda other=other: self.scoop(food, other)
            if len(food.foods) == 1 and food.label not in {one.label for one in other.foods}:
                yield "scoop", lambda other=other: self.spoon(food, other)

    def _targets(self, vessel: Vessel, foods: Sequence[Food], others: Sequence[Vessel]) -> list[Vessel]:
        wet = any(one.kind.liquid for food in foods for one in food.foods)
        fits = DEEP if wet else DEEP | FLAT
        names = {name for food in foods for name in food.names}
        apart = "between two of a kind" in self.left_out
        return [
            one
            for one in others
            if one.label in fits
            and _can_be_told(vessel, one, foods)
            and not (apart and one.label == vessel.label)
            and not any(self._would_be_twice(name, one, vessel) for name in names)
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
        if vessel.stands is None:
            # only a burner of its own tells which of two vessels is hot
            if self.style.stove == "under" or not any(one.stands is self.stove for one in self.vessels):
                yield "put on stove", lambda: self.stand(vessel, self.stove)
            return
        lit = vessel.label in self.stove.on
        if not lit or vessel.hot:
            yield ("stove off" if lit else "stove on"), lambda: self.switch(self.stove, vessel.label, vessel)
        if not lit and vessel.hot and not vessel.covered:
            yield "take off stove", lambda: self.lift(vessel)
        if lit and vessel.foods:
            yield from self._over_heat(vessel)
        if vessel.covered:
            yield "uncover", lambda: self.uncover(vessel)
        elif vessel.label == "pot" and vessel.foods:
            yield "cover", lambda: self.cover(vessel)
            yield from self._to_be_drained(vessel)

    def _over_heat(self, vessel: Vessel) -> Iterator[tuple[str, Move]]:
        names = {name for food in vessel.foods for name in food.names}
        yield "heat", lambda: self.heat(vessel, "heat", self.device(self.stove, vessel))
        if "water" in names and len(vessel.foods) > 1:
            yield "boil", lambda: self.heat(vessel, "boil", self.device(self.stove, vessel))
            if "soup" in self.products:
                yield "boil", lambda: self.boil_into(vessel, "soup")
        if vessel.label == "pan" and len(vessel.foods) > 1 and "olive oil" in names:
            yield "fry", lambda: self.heat(vessel, "fry", self.device(self.stove, vessel))

    def _to_be_drained(self, pot: Vessel) -> Iterator[tuple[str, Move]]:
        strainer = self._vessel("strainer")
        solid = [food for food in pot.foods if food.label != "water"]
        wet = any(one.kind.liquid for food in solid for one in food.foods)
        if solid and len(solid) < len(pot.foods) and not wet and not strainer.foods:
            yield "drain", lambda: self.drain(pot, strainer)

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

    def _wet(self, vessel: Vessel) -> bool:
        return any(one.kind.liquid for food in vessel.foods for one in food.foods)


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
