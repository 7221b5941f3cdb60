"""The bench: whatever possible is done on it happens in the judge's world as well; what is refused changes nothing."""

from __future__ import annotations

from functools import partial

import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from integration import school, videos
from integration.told import Likes, operators_of

from foon_kg.integration.bench import Bench, RefusedError, foods_of, is_flat
from foon_kg.integration.teaching.operators import Nearness
from foon_kg.world import World

APPLIANCES = """
name: covering
pot ({water}) + lid → COVER → pot ({water}; covered lid)
pot ({water}; covered lid) → UNCOVER → pot ({water}) + lid
baking tray ({cake}; in oven) + oven (on; {baking tray}) → REMOVE → baking tray ({cake}) + oven (on)
oven (on) → TURN OFF → oven (off)
"""
OPERATORS = operators_of(school.SALAD, school.CRAFTS, APPLIANCES, *videos.ALL)
LIKES = Likes({("leek", "onion"): 0.8, ("cucumber", "tomato"): 0.7})

FOODS = (
    ("tomato", ("whole",), ""), ("onion", ("whole",), ""), ("leek", ("whole",), ""), ("banana", ("whole",), ""),
    ("olive oil", ("liquid",), "bottle"), ("milk", ("liquid",), "carton"), ("salt", ("granulated",), "shaker"),
    ("sugar", ("granulated",), "bag"), ("water", ("liquid",), "faucet"),
)  # fmt: skip
VESSELS = ("bowl", "bowl", "plate", "pot", "pan", "baking tray", "blender jar", "strainer")
CUTS = {"chop": "chopped", "slice": "sliced", "dice": "diced"}
STANDS = {
    "pot": ("stove", "on"), "pan": ("stove", "on"), "baking tray": ("oven", "in"),
    "blender jar": ("blender", "attached to"),
}  # fmt: skip
WORK = {
    "stove": [("heat", "cook"), ("heat", "fry")], "oven": [("bake", "bake")], "blender": [("blend", "blend")],
}  # fmt: skip


def bench():
    return Bench(OPERATORS, LIKES, LIKES.alike)


LIKELY = {"heat": 20, "blend": 30, "bake": 30, "switch": 8, "fetch": 4, "cut": 4, "bring": 12, "stand": 5, "mix": 10}
"""How much likelier than others a step is drawn: what needs much before it would hardly ever come about."""


class Cook:
    """Does on a bench what is possible, and plays it at once in the world of the judge."""

    def __init__(self, found_on=None):
        self.bench = bench()
        self.bench.found_on = found_on or {}
        self.world = World()
        self.world.supply.found_on = frozenset(found_on or ())
        self.vessels = [self.bench.vessel(label) for label in VESSELS]
        self.free = []
        self.fresh = list(FOODS)
        self.products = ["mixture", "medley", "stew", "filling", "mash"]

    # --- what is possible now ---

    def moves(self):
        """Return the possible steps by their kind."""
        found = {}
        for kind, step in self._moves():
            found.setdefault(kind, []).append(step)
        return found

    def _moves(self):
        yield from (("fetch", partial(self.fetch, food)) for food in self.fresh)
        for stuff in self.free:
            if stuff.at is None:
                yield from (("cut", partial(self.cut, stuff, motion)) for motion in CUTS)
            yield from (("bring", partial(self.bring, stuff, v)) for v in self.vessels if self.may_take(v, [stuff]))
        for vessel in self.vessels:
            if vessel.contents and self.is_in_reach(vessel):
                others = [v for v in self.vessels if v is not vessel and self.may_take(v, vessel.contents)]
                yield from (("pour", partial(self.pour, vessel, other)) for other in others)
                if len(vessel.contents) > 1 and vessel.label in {"bowl", "pot", "pan"} and self.products:
                    yield "mix", partial(self.work, vessel, "mix")
            yield from self._with_appliances(vessel)

    def _with_appliances(self, vessel):
        if vessel.label == "pot" and vessel.contents:
            yield "cover", partial(self.cover, vessel)
        if vessel.device is None:
            if vessel.label in STANDS and not vessel.lid and self.is_free(STANDS[vessel.label][0]):
                yield "stand", partial(self.bench.place, vessel, *STANDS[vessel.label])
            return
        device, runs = vessel.device, self.bench.is_running(vessel)
        if not vessel.lid and (device.label == "oven" or not runs):
            yield "take off", partial(self.bench.take_off, vessel)
        if vessel.contents or device.label != "blender":
            yield "switch", partial(self.bench.switch, vessel, device, on=not runs)
        if runs and vessel.contents and self.products:
            yield from ((kind, partial(self.work, vessel, motion)) for kind, motion in WORK[device.label])

    def is_in_reach(self, vessel):
        """Whether food may come into a vessel or out of it: not under a lid, in the oven, or while it is blended."""
        if vessel.lid:
            return False
        return vessel.device is None or vessel.device.label == "stove" or not self.runs_closed(vessel)

    def runs_closed(self, vessel):
        return vessel.device.label == "oven" or self.bench.is_running(vessel)

    def may_take(self, vessel, stuffs):
        liquid = any(self.bench.known.foods.food(food).is_a("liquid") for stuff in stuffs for food in stuff.foods)
        deep = not is_flat(vessel.label) and vessel.label != "strainer"
        return self.is_in_reach(vessel) and (deep or not liquid)

    def is_free(self, appliance):
        there = {vessel.device.label for vessel in self.vessels if vessel.device is not None}
        return appliance == "stove" or appliance not in there

    # --- steps ---

    def way(self, motion, foods, *, act=False):
        return self.bench.require(self.bench.operators.ways_of(motion), foods, act=act)

    def fetch(self, food):
        self.fresh.remove(food)
        label, states, storage = food
        self.free.append(self.bench.fetch(label, states, [len(self.fresh)], storage))

    def cut(self, stuff, motion):
        self.bench.act(stuff, self.way(motion, stuff.foods, act=True), (CUTS[motion],), "cutting board")
        self.free.remove(stuff)
        self.vessels.append(stuff.at)

    def bring(self, stuff, vessel):
        self.bench.bring([stuff], vessel, self.way("pour", stuff.foods))
        self.free.remove(stuff)

    def pour(self, vessel, other):
        self.bench.bring(list(vessel.contents), other, self.way("pour", foods_of(vessel)))

    def work(self, vessel, motion):
        states = {"blend": "blended", "bake": "baked", "mix": "mixed"}.get(motion, "cooked")
        heats = motion != "mix"
        self.bench.work(vessel, self.way(motion, foods_of(vessel)), self.products.pop(), (states,), with_device=heats)

    def cover(self, vessel):
        self.bench.uncover(vessel) if vessel.lid else self.bench.cover(vessel, "lid")

    # --- what always holds ---

    def check(self):
        for done in self.bench.done[len(self.world.played_steps) :]:
            played_step = self.world.play(done.step)
            assert [mishap for mishap in played_step.mishaps if not mishap.minor] == []
            assert done.attested.seen_in
        for vessel in self.vessels:
            assert all(stuff.at is vessel for stuff in vessel.contents)
        assert len(self.wants()) == len(set(self.wants())) == len(FOODS) - len(self.fresh)

    def is_as_in_the_world(self):
        """Whether each vessel is where the judge sees it, covered or not, with the same foods, over the same fire."""
        for vessel in self.vessels:
            seen = self.world.supply.numbered_vessels.get(vessel.number)
            if seen is None:
                continue
            device = vessel.device.label if vessel.device else None
            foods = {part.name for lump in seen.lumps for part in lump.parts}
            assert (seen.where and seen.where.label, seen.covered) == (device, bool(vessel.lid))
            assert foods == set(foods_of(vessel))
            assert device is None or seen.where.is_on(vessel.label) == self.bench.is_running(vessel)

    def wants(self):
        stuffs = [*self.free, *(stuff for vessel in self.vessels for stuff in vessel.contents)]
        return [number for stuff in stuffs for number in stuff.wants]

    def told(self):
        """Return all that is so on the bench."""
        return (
            len(self.bench.done),
            [(device.label, set(device.running)) for device in self.bench.devices.values()],
            [_vessel(vessel) for vessel in self.vessels],
            [(stuff.number, stuff.states, stuff.at and _vessel(stuff.at)) for stuff in self.free],
        )

    def refuses(self, step):
        """Return whether a step is refused and has changed nothing."""
        before = self.told()
        with pytest.raises(RefusedError):
            step()
        return self.told() == before


def _vessel(vessel):
    foods = tuple((stuff.label, stuff.number, stuff.states) for stuff in vessel.contents)
    stands = vessel.device.label if vessel.device else ""
    return vessel.label, vessel.number, foods, stands, vessel.relation, vessel.lid, vessel.hot


@st.composite
def cooks(draw, most=40):
    """Draw a cook after some possible steps, each of which was played in the world of the judge."""
    cook = Cook(draw(st.sampled_from([{}, {"oven": ("preheated",)}, {"stove": ("on",)}])))
    for _ in range(draw(st.integers(most // 4, most))):
        moves = cook.moves()
        kind = draw(st.sampled_from([kind for kind in sorted(moves) for _ in range(LIKELY.get(kind, 1))]))
        draw(st.sampled_from(moves[kind]))()
        cook.check()
        cook.is_as_in_the_world()
    return cook


for_many_cooks = examples(40)


@for_many_cooks
@given(cooks())
def test_whatever_is_possible_happens_in_the_world_of_the_judge_too_and_can_be_ended(cook):
    cook.bench.all_off()
    cook.check()
    assert not any(device.running for device in cook.bench.devices.values())


@for_many_cooks
@given(cooks(most=20))
def test_what_is_refused_changes_nothing(cook):
    for vessel in cook.vessels:
        if vessel.contents:
            assert cook.refuses(lambda vessel=vessel: cook.bench.require([("levitate", ())], foods_of(vessel)))
        for stuff in cook.free if vessel.lid else ():
            assert cook.refuses(partial(cook.bench.bring, [stuff], vessel, cook.way("pour", stuff.foods)))


def pot_of_potatoes(*, on):
    cook = Cook()
    pot = next(vessel for vessel in cook.vessels if vessel.label == "pot")
    for food in (("water", ("liquid",), "faucet"), ("potato", ("whole",), "")):
        cook.bench.bring([cook.bench.fetch(*food[:2], [], food[2])], pot, cook.way("pour", (food[0],)))
    device = cook.bench.place(pot, "stove", "on")
    cook.bench.switch(pot, device, on=on)
    return cook, pot


def test_food_does_not_come_into_a_covered_vessel():
    cook, pot = pot_of_potatoes(on=False)
    cook.bench.cover(pot, "lid")
    salt = cook.bench.fetch("salt", ("granulated",), [], "shaker")
    cook.free.append(salt)
    assert cook.refuses(lambda: cook.bench.bring([salt], pot, cook.way("sprinkle", ("salt",))))
    cook.bench.uncover(pot)
    cook.bench.bring([salt], pot, cook.way("sprinkle", ("salt",)))
    assert foods_of(pot) == ("water", "potato", "salt")


def test_food_does_not_come_out_of_a_covered_vessel():
    cook, pot = pot_of_potatoes(on=False)
    cook.bench.cover(pot, "lid")
    bowl = cook.vessels[0]
    assert cook.refuses(lambda: cook.bench.bring(list(pot.contents), bowl, cook.way("pour", foods_of(pot))))


def test_nothing_is_cooked_over_a_stove_that_is_off():
    cook, pot = pot_of_potatoes(on=False)
    assert cook.refuses(lambda: cook.bench.work(pot, cook.way("boil", foods_of(pot)), "stew", ("cooked",)))


def test_over_a_stove_that_is_on_it_is_cooked():
    cook, pot = pot_of_potatoes(on=True)
    stew = cook.bench.work(pot, cook.way("boil", foods_of(pot)), "stew", ("cooked",))
    assert (stew.label, stew.foods, stew.mixed, stew.at) == ("stew", ("potato", "water"), True, pot)
    assert pot.hot
    cook.bench.all_off()
    assert [done.step.motion for done in cook.bench.done][-2:] == ["boil", "turn off"]


def test_what_is_taken_off_its_appliance_stands_nowhere_and_is_told_so():
    cook, pot = pot_of_potatoes(on=False)
    stove = pot.device
    cook.bench.take_off(pot)
    assert (pot.device, pot.relation) == (None, "")
    outputs = {mention.thing: mention.node for mention in cook.bench.done[-1].step.outputs}
    assert (outputs[pot.number].container, outputs[stove.number].container) == (None, None)
    cook.check()
    assert cook.world.supply.numbered_vessels[pot.number].where is None


def test_what_nobody_does_is_refused_and_the_refusal_names_it():
    with pytest.raises(RefusedError, match="“levitate” to tomato"):
        bench().require([("levitate", ())], ("tomato",))


def test_a_switch_that_is_there_already_is_no_step():
    cook, pot = pot_of_potatoes(on=True)
    count = len(cook.bench.done)
    cook.bench.switch(pot, pot.device, on=True)
    assert len(cook.bench.done) == count


SHELF = """
name: a shelf
mixer (off) → TURN ON → mixer (on)
pan (empty) + shelf → PICK-AND-PLACE → pan (empty; on shelf)
oven (off) → TURN ON → oven (on)
pan (empty) + stove (off) → PLACE → pan (empty; on stove) + stove (off; under pan)
stove (off; under pan) → TURN ON → stove (on; under pan)
stove (on; under pan) → TURN OFF → stove (off; under pan)
pan (empty; on stove) + stove (off; under pan) → TAKE OUT → pan (empty) + stove (off)
"""


def test_what_is_done_with_an_appliance_and_no_food_is_attested_by_units_with_it():
    one = Bench(operators_of(SHELF), LIKES, LIKES.alike)
    pan = one.vessel("pan")
    stove = one.place(pan, "stove", "on")
    one.switch(pan, stove, on=True)
    one.heat_off(pan)
    one.take_off(pan)
    one.switch(None, one.device("oven"), on=True)
    one.all_off()
    named = [(done.step.motion, done.attested.nearness, done.attested.seen_in[0].position) for done in one.done]
    same, motion = Nearness.FOOD, Nearness.MOTION
    assert named == [
        ("place", same, 3), ("turn on", same, 4), ("turn off", same, 5), ("take out", same, 6), ("turn on", same, 2),
        ("turn off", motion, 5),
    ]  # fmt: skip


def test_a_step_that_changes_nothing_is_none():
    one = bench()
    tomato = one.fetch("tomato", ("whole",), [1], "")
    one.act(tomato, one.require([("slice", ("knife",))], ("tomato",)), ("whole",))
    assert one.done == []


def test_each_thing_keeps_its_number_and_tools_are_one_thing():
    one = bench()
    tomato, onion = (one.fetch(food, ("whole",), [], "") for food in ("tomato", "onion"))
    for stuff in (tomato, onion):
        one.act(stuff, one.require([("chop", ("knife",))], stuff.foods, act=True), ("chopped",), "cutting board")
    first, second = (done.step for done in one.done)
    numbers = [{m.node.label: m.thing for m in (*step.inputs, *step.outputs)} for step in (first, second)]
    assert numbers[0]["knife"] == numbers[1]["knife"]
    assert numbers[0]["cutting board"] != numbers[1]["cutting board"]
    assert numbers[0]["tomato"] == tomato.number


def test_nearer_evidence_comes_first_and_of_equal_ones_the_first_way():
    one = bench()
    ways = [("dice", ("knife",)), ("slice", ("knife",))]
    assert one.attest(ways, ("tomato",)).way == ("dice", ("knife",))
    assert one.attest(ways, ("cucumber",)).way == ("slice", ("knife",))
    assert one.attest([("dice", ("knife",)), ("chop", ("knife",))], ("leek",)).nearness is Nearness.LIKE
    assert one.attest(ways, ("leek",)).way == ("dice", ("knife",))
    assert one.attest(ways, ("leek",)).like == ("leek", "onion", 0.8)
    assert one.attest([("levitate", ())], ("tomato",)) is None
    assert one.first([("levitate", ()), ("slice", ("knife",))], ("tomato",)).way == ("slice", ("knife",))


def test_an_oven_that_was_found_on_is_used_so_and_turned_off_once():
    cook = Cook({"oven": ("preheated",)})
    tray = next(vessel for vessel in cook.vessels if vessel.label == "baking tray")
    oven = cook.bench.place(tray, "oven", "in")
    cook.bench.switch(None, oven, on=True)
    cook.bench.all_off()
    cook.check()
    first, last = (done.step for done in cook.bench.done)
    assert "oven (preheated)" in map(str, (one.node for one in first.inputs))
    assert [str(one.node) for one in last.outputs] == ["oven (off)"]
