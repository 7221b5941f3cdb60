"""Steps brought in time: whatever two dishes are made in turns, it still happens, and each thing sees the same."""

from __future__ import annotations

from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from integration import school, videos
from integration.told import Likes, operators_of

from foon_kg.integration.bench import Bench, foods_of
from foon_kg.integration.bench.timing import with_water_hot_in_time, without_short_breaks
from foon_kg.world import World

BOILING = """
name: water for noodles
water (liquid; in pot) + pot ({water}; on stove) + stove (on; under pot) → BOIL
  → water (boiling; in pot) + pot (hot; {water}; on stove) + stove (on; under pot)
"""
OPERATORS = operators_of(school.SALAD, school.CRAFTS, *videos.ALL, BOILING)
LIKES = Likes()
FOODS = {
    "olive oil": ("liquid", "bottle"), "tomato": ("whole", ""), "garlic": ("minced", "jar"),
    "salt": ("granulated", "shaker"), "potato": ("whole", ""), "onion": ("whole", ""), "pasta": ("dried", "box"),
}  # fmt: skip
MOTIONS = {"pan": ("cook", "fry"), "pot": ("boil", "cook"), "saucepan": ("cook", "boil")}


class Kitchen:
    """A bench with vessels on one stove, of which one thing after the other is asked as it can happen."""

    def __init__(self):
        self.bench = Bench(OPERATORS, LIKES, LIKES.alike)
        self.vessels = {}
        self.fetched = set()
        self.names = iter(f"stew {number}" for number in range(99))

    def vessel(self, label):
        """Return the vessel so called on the stove: a new one if none stands there."""
        if label not in self.vessels:
            self.vessels[label] = self.bench.vessel(label)
        return self.vessels[label]

    def way(self, motion, foods):
        return self.bench.require(self.bench.operators.ways_of(motion), foods)

    def add(self, label, food):
        """Fetch a food and pour it into a vessel; but for water there is one of each."""
        if food in self.fetched:
            return
        self.fetched |= {food} - {"water"}
        state, storage = ("liquid", "faucet") if food == "water" else FOODS[food]
        self.bench.bring([self.bench.fetch(food, (state,), [], storage)], self.vessel(label), self.way("pour", (food,)))

    def stand(self, label):
        if self.vessel(label).device is None:
            self.bench.place(self.vessel(label), "stove", "on")

    def switch(self, label, on):
        vessel = self.vessel(label)
        if vessel.device is not None:
            self.bench.switch(vessel, vessel.device, on=on)

    def heat(self, label, motion):
        """Do so to what is in a vessel; water alone comes to the boil. Nothing, where nothing is in it."""
        vessel = self.vessel(label)
        foods = foods_of(vessel)
        if not foods:
            return
        self.stand(label)
        self.switch(label, True)
        alone = set(foods) == {"water"}
        name, states = ("water", ("boiling",)) if alone else (next(self.names), ("cooked",))
        self.bench.work(vessel, self.way("boil" if alone else motion, foods), name, states)

    def pour(self, label, other):
        """Pour what is in a vessel into another."""
        if label != other and self.vessel(label).contents:
            foods = foods_of(self.vessel(label))
            self.bench.bring(list(self.vessel(label).contents), self.vessel(other), self.way("pour", foods))

    def take_off(self, label):
        vessel = self.vessel(label)
        if vessel.device is not None:
            self.switch(label, False)
            self.bench.take_off(vessel)


LABELS = st.sampled_from(sorted(MOTIONS))
ACTS = st.one_of(
    st.tuples(st.just("add"), LABELS, st.sampled_from(sorted(FOODS))),
    st.tuples(st.just("add"), LABELS, st.just("water")),
    st.tuples(st.just("stand"), LABELS),
    st.tuples(st.just("switch"), LABELS, st.booleans()),
    st.tuples(st.just("heat"), LABELS, st.sampled_from(("boil", "cook", "fry"))),
    st.tuples(st.just("pour"), LABELS, LABELS),
    st.tuples(st.just("take_off"), LABELS),
)
STORIES = st.lists(ACTS, min_size=3, max_size=14)


def dish_and_water(dish, water, between):
    """A dish made in a pan, then what is done between, then water that boils, as the planner's stages tell it."""
    return [
        ("add", "pan", "olive oil"), *dish, ("heat", "pan", "fry"), ("switch", "pan", False), *between,
        ("add", "pot", "water"), *water, ("heat", "pot", "boil"), ("switch", "pot", False), ("pour", "pot", "pan"),
    ]  # fmt: skip


def quiet(labels):
    return st.lists(ACTS.filter(lambda act: act[1] in labels), max_size=4)


WAITING = st.builds(
    dish_and_water, quiet({"pan"}), st.lists(st.just(("add", "pot", "salt")), max_size=1), quiet({"saucepan"})
)


def made(story):
    """Return the bench on which a story happened, all turned off at its end."""
    kitchen = Kitchen()
    for act, *arguments in story:
        getattr(kitchen, act)(*arguments)
    kitchen.bench.all_off()
    return kitchen.bench


def played(done):
    """Return the judge's world in which those steps happened; all of them do."""
    world = World()
    for one in done:
        assert [mishap for mishap in world.play(one.step).mishaps if not mishap.minor] == []
    return world


def seen(world):
    """Return each full vessel with where it stands and what is in it, as the judge sees it; an empty one may stand."""
    return {
        number: (vessel.where and vessel.where.label, vessel.covered, sorted(map(_told, vessel.lumps)))
        for number, vessel in world.supply.numbered_vessels.items()
        if vessel.lumps
    }


def _told(lump):
    return lump.label, lump.states, sorted(part.name for part in lump.parts)


def lives(done):
    """Return for each thing the steps in which it takes part, but for the stove and the faucet, which serve all."""
    told = {}
    for one in done:
        mentions = (*one.step.inputs, *one.step.outputs)
        for number in {mention.thing for mention in mentions if mention.node.label not in {"faucet", "stove"}}:
            told.setdefault(number, []).append(plain(one))
    return told


def plain(done):
    """Return a step; a stove under no vessel without its state, which is that of its burners when the step is done."""
    mentions = (*done.step.inputs, *done.step.outputs)
    return done.step.motion, [
        (mention.thing, "stove" if is_bare_stove(mention.node) else mention.node) for mention in mentions
    ]


def is_bare_stove(node):
    return node.label == "stove" and not node.container


@examples(60)
@given(st.one_of(STORIES, WAITING))
def test_whatever_is_brought_in_time_happens_in_the_world_of_the_judge_with_the_same_end(story):
    bench = made(story)
    before = played(bench.done)
    kept = with_water_hot_in_time(bench.done, bench.known)
    assert seen(played(kept)) == seen(before)
    shorter = without_short_breaks(kept, bench.known)
    assert seen(played(shorter)) == seen(before)


@examples(60)
@given(st.one_of(STORIES, WAITING))
def test_each_thing_sees_its_steps_in_their_order_and_only_room_made_for_a_pot_is_left_out(story):
    bench = made(story)
    kept = with_water_hot_in_time(bench.done, bench.known)
    before, after = lives(bench.done), lives(kept)
    there = list(map(plain, kept))
    gone = [step for step in map(plain, bench.done) if step not in there]
    assert len(kept) + len(gone) == len(bench.done)
    for number, steps in after.items():
        assert steps == [step for step in before[number] if step not in gone]
    assert {motion for motion, _ in gone} <= {"pick-and-place", "take out"}


@examples(60)
@given(st.one_of(STORIES, WAITING))
def test_only_heat_turned_off_and_on_again_is_left_out_and_in_pairs(story):
    bench = made(story)
    kept = without_short_breaks(bench.done, bench.known)
    same = set(map(id, kept))  # the same thing may be turned off twice
    gone = [one.step for one in bench.done if id(one) not in same]
    for burner in {step.inputs for step in gone} | {step.outputs for step in gone}:
        switched = [step.motion for step in gone if burner in (step.inputs, step.outputs)]
        assert switched == ["turn off", "turn on"] * (len(switched) // 2)
    assert [one for one in bench.done if id(one) in same] == kept


def test_water_boils_before_the_pan_that_would_wait_for_it():
    bench = made(dish_and_water([("add", "pan", "onion")], [], []))
    told = [(one.step.motion, one.step.outputs) for one in with_water_hot_in_time(bench.done, bench.known)]
    places = {motion: place for place, (motion, _) in enumerate(told)}
    assert places["boil"] < places["fry"]
    assert with_water_hot_in_time(bench.done, bench.known) != bench.done
