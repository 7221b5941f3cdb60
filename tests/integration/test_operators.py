"""What a FOON attests: which way of doing something, for which food, by which units."""

from __future__ import annotations

import random
from itertools import chain

import pytest
from demo_foon import demo_foon
from hypothesis import given
from hypothesis import strategies as st
from integration.told import Likes, operators_of, snapshot_of

from foon_kg.food import singular, tables
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.operators import MOST_SIGHTINGS, Nearness, Operators
from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Participant, Sighting

SLICE, CHOP, POUR = ("slice", ("knife",)), ("chop", ("knife",)), ("pour", ())

TOMATO = """
name: tomatoes
dish: salad
goal: tomato salad ({salt, tomato}; in bowl)
tomato (whole) + cutting board (empty) + knife → SLICE → tomato (sliced; on cutting board) + cutting board ({tomato})
tomato (sliced; on cutting board) + cutting board ({tomato}) + bowl (empty) → POUR
  → tomato (sliced; in bowl) + bowl ({tomato}) + cutting board (empty)
salt (granulated; in shaker) + tomato (sliced; in bowl) + bowl ({tomato}) → SPRINKLE
  → tomato salad ({salt, tomato}; in bowl) + bowl ({tomato salad})
"""
CARROT = """
name: carrots
carrot (whole) + peeler → PEEL → carrot (peeled)
carrot (peeled) + cutting board (empty) + knife → CHOP → carrot (chopped; on cutting board) + cutting board ({carrot})
"""


def sightings(attested):
    return [(one.video, one.position) for one in attested.seen_in]


# --- by hand ---


def test_the_same_food_is_attested_by_the_unit_that_does_it():
    found = operators_of(TOMATO, CARROT).attested(SLICE, ("tomato",))
    assert (found.way, found.nearness, found.like, sightings(found)) == (SLICE, Nearness.FOOD, None, [("tomatoes", 0)])
    assert found.nearness.word == "food"


def test_a_like_food_stands_where_no_unit_has_the_food_itself():
    likes = Likes({("dragon fruit", "carrot"): 0.6, ("dragon fruit", "tomato"): 0.9})
    operators = operators_of(TOMATO, CARROT)
    sliced = operators.attested(SLICE, ("dragon fruit",), likes)
    assert (sliced.nearness, sliced.like) == (Nearness.LIKE, ("dragon fruit", "tomato", 0.9))
    assert sightings(sliced) == [("tomatoes", 0)]
    chopped = operators.attested(CHOP, ("dragon fruit",), likes)
    assert (chopped.like, sightings(chopped)) == (("dragon fruit", "carrot", 0.6), [("carrots", 1)])


def test_without_likes_only_the_food_and_its_kind_count():
    operators = operators_of(TOMATO, CARROT)
    assert operators.attested(SLICE, ("dragon fruit",)) is None
    beet = operators.attested(CHOP, ("beet",))
    assert tables().foods.find("beet")[0] == tables().foods.find("carrot")[0]
    assert (beet.nearness, beet.like, sightings(beet)) == (Nearness.KIND, None, [("carrots", 1)])


def test_a_like_food_is_nearer_than_one_of_the_kind():
    likes = Likes({("beet", "tomato"): 0.5})
    pear = "name: beets\nradish (whole) + knife → SLICE → radish (sliced)\n"
    assert operators_of(TOMATO, pear).attested(SLICE, ("beet",), likes).nearness is Nearness.LIKE


def test_a_motion_without_foods_is_attested_by_itself():
    stove = "name: stoves\nstove (off) → TURN ON → stove (on)\n"
    found = operators_of(TOMATO, stove).attested(("turn on", ()), ())
    assert (found.nearness, sightings(found)) == (Nearness.MOTION, [("stoves", 0)])
    assert found.nearness.word == "motion"


SWITCHES = """
name: creams
mixer (off) → TURN ON → mixer (on)
mixer (on) → TURN OFF → mixer (off)
---
name: loaves
oven (off) → TURN ON → oven (on)
stove (off) → TURN ON → stove (on)
"""


@pytest.mark.parametrize(
    ("motion", "appliance", "nearness", "seen"),
    [
        ("turn on", "mixer", Nearness.FOOD, [("creams", 0)]),
        ("turn on", "oven", Nearness.FOOD, [("loaves", 0)]),
        ("turn on", "stove", Nearness.FOOD, [("loaves", 1)]),
        ("turn on", "hand mixer", Nearness.KIND, [("creams", 0)]),
        ("turn on", "toaster oven", Nearness.KIND, [("loaves", 0)]),
        ("turn off", "oven", Nearness.MOTION, [("creams", 1)]),
        ("turn on", "toaster", Nearness.MOTION, [("creams", 0), ("loaves", 0), ("loaves", 1)]),
    ],
)
def test_without_food_the_appliance_says_by_which_units_it_is_attested(motion, appliance, nearness, seen):
    found = operators_of(SWITCHES).attested((motion, ()), (), appliance=appliance)
    assert (found.nearness, sightings(found)) == (nearness, seen)


def test_another_tool_is_another_way():
    operators = operators_of(TOMATO, CARROT)
    assert operators.attested(("slice", ()), ("tomato",)) is None
    assert operators.attested(("slice", ("mandoline",)), ("tomato",)) is None
    assert operators.ways_of("slice") == (SLICE,)


def test_vessels_and_appliances_are_no_tools():
    assert operators_of(TOMATO).ways_of("pour") == (POUR,)


def test_an_act_is_attested_only_for_what_it_changes():
    operators = operators_of(TOMATO)
    sprinkle = ("sprinkle", ())
    assert operators.attested(sprinkle, ("tomato",)).nearness is Nearness.FOOD
    assert operators.attested(sprinkle, ("tomato",), act=True) is None
    assert operators.attested(POUR, ("tomato",), act=True).nearness is Nearness.FOOD


def test_what_a_vessel_or_product_holds_takes_part():
    found = operators_of(TOMATO).attested(("sprinkle", ()), ("salt",))
    assert sightings(found) == [("tomatoes", 2)]


def test_plural_and_singular_are_one_food():
    plural = TOMATO.replace("tomato (", "tomatoes (")
    assert operators_of(plural).attested(SLICE, ("tomato",)).nearness is Nearness.FOOD


def test_the_unit_of_two_videos_is_seen_in_both():
    found = operators_of(TOMATO, TOMATO.replace("name: tomatoes", "name: again")).attested(SLICE, ("tomato",))
    assert sightings(found) == [("again", 0), ("tomatoes", 0)]


def test_a_removed_video_takes_its_evidence_along():
    before, after = operators_of(TOMATO, CARROT), operators_of(TOMATO)
    assert before.attested(CHOP, ("carrot",)) is not None
    assert after.attested(CHOP, ("carrot",)) is None
    assert after.ways_of("peel") == ()
    assert "carrot" not in after.foods
    assert list(after.making("peeled")) == []
    assert list(after.making("sliced")) == [SLICE]


def test_the_likest_food_of_all_is_taken_in_need():
    alike = Likes({("yeti", "tomato"): 0.35}).alike
    found = operators_of(TOMATO, CARROT).farthest(SLICE, ("yeti",), alike)
    assert (found.nearness, found.like) == (Nearness.LIKE, ("yeti", "tomato", 0.35))


def test_where_none_is_alike_it_is_done_as_it_is_most_often():
    again = "name: more\nsalt (granulated; in shaker) + plate (empty) → SPRINKLE → salt (on plate) + plate ({salt})\n"
    found = operators_of(TOMATO, again).farthest(("sprinkle", ()), ("yeti",), Likes().alike)
    assert (found.nearness, found.like) == (Nearness.MOTION, None)
    assert [one.video for one in found.seen_in] == ["more", "tomatoes"]


def test_ways_that_give_a_state_come_before_those_that_could():
    rings = "name: rings\nonion (whole) + mandoline → CUT → onion (sliced)\n"
    assert list(operators_of(TOMATO, rings).making("sliced")) == [("cut", ("mandoline",)), SLICE]
    assert list(operators_of(TOMATO, CARROT).making("diced"))[-1] in {SLICE, CHOP}


def test_the_usual_ways_to_bring_food_depend_on_its_form_and_on_where_it_is():
    operators = operators_of(TOMATO)
    assert operators.brings("pieces", "tool") == ()
    assert operators.brings("pieces", "vessel") == (POUR,)


@pytest.mark.parametrize(
    ("food", "state", "form"),
    [
        ("water", "liquid", "liquid"), ("olive oil", "liquid", "liquid"), ("milk", "liquid", "liquid"),
        ("mayonnaise", "creamy", "soft"), ("yogurt", "creamy", "soft"),
        ("salt", "granulated", "powder"), ("flour", "powder", "powder"), ("cinnamon", "ground", "powder"),
        ("tomato", "sliced", "pieces"), ("carrot", "grated", "pieces"), ("potato", "mashed", "soft"),
        ("tomato", "whole", "whole"), ("egg", "whole", "whole"), ("chicken", "raw", "whole"),
    ],
)  # fmt: skip
def test_a_food_is_handled_by_its_form(food, state, form):
    assert form_of(tables(), food, (state,)) == form


# --- an oracle: all units, one after another ---

FOODS = ("tomato", "tomatoes", "onion", "carrot", "beet", "salt", "olive oil", "dragon fruit")
TOOLS = ("knife", "spoon", "peeler")
LIKES = Likes({("dragon fruit", "tomato"): 0.9, ("dragon fruit", "carrot"): 0.7, ("salt", "onion"): 0.6})

_labels = st.sampled_from(FOODS)
_states = st.lists(st.sampled_from(("whole", "sliced", "peeled", "mixed")), max_size=2, unique=True).map(tuple)
_nodes = st.one_of(
    st.builds(ObjectNode, _labels, _states, st.just(()), st.just("in"), st.sampled_from(("bowl", "shaker"))),
    st.builds(ObjectNode, _labels, _states),
    st.builds(ObjectNode, st.sampled_from(("bowl", "plate")), st.just(()), st.lists(_labels, max_size=2).map(tuple)),
    st.builds(ObjectNode, st.sampled_from(TOOLS)),
    st.builds(ObjectNode, st.just("salad"), _states, st.lists(_labels, min_size=1, max_size=2).map(tuple)),
)
_sides = st.lists(_nodes, min_size=1, max_size=4).map(lambda nodes: tuple(map(Participant, nodes)))
_units = st.builds(FunctionalUnit, _sides, st.sampled_from(("slice", "pour", "mix")), _sides)


@st.composite
def foons(draw):
    """Units of two videos, now and then the same one in both."""
    units = draw(st.lists(_units, min_size=1, max_size=8, unique_by=lambda unit: unit.key))
    rows = []
    for place, unit in enumerate(units):
        videos = draw(st.sampled_from((("a",), ("b",), ("a", "b"))))
        rows.append(KnownUnit(unit, tuple(Sighting(video, place) for video in videos)))
    return rows


def is_food(label):
    return tables().utensil(label) is None


def foods_of(unit, nodes=None):
    """Every food that is named in a unit."""
    nodes = [*unit.input_nodes, *unit.output_nodes] if nodes is None else nodes
    names = chain.from_iterable((node.label, *node.ingredients) for node in nodes)
    return {singular(name) for name in names if is_food(name)}


def way_of(unit):
    rows = [tables().utensil(node.label) for node in unit.input_nodes]
    return unit.motion, tuple(sorted({row.name for row in rows if row is not None and row.role == "tool"}))


def kind_of(food):
    return tables().foods.find(food)[0]


def changed_in(unit):
    """The foods that come out otherwise than one of them went in."""
    before = {singular(node.label): node for node in unit.input_nodes if is_food(node.label)}
    after = [node for node in unit.output_nodes if is_food(node.label) and singular(node.label) in before]
    return {singular(node.label) for node in after if before[singular(node.label)] != node}


def first_of(units):
    """The sightings that are named of some units."""
    found = {sighting for known in units for sighting in known.seen_in}
    return tuple(sorted(found, key=lambda one: (one.video, one.position))[:MOST_SIGHTINGS])


def expected(rows, way, food, *, act=False):
    """What attests ``way`` for ``food``: nearness, likeness and sightings, by looking at every unit."""
    named = changed_in if act else foods_of
    ways = [known for known in rows if way_of(known.unit) == way and named(known.unit)]
    same = [known for known in ways if food in named(known.unit)]
    if same:
        return Nearness.FOOD, None, first_of(same)
    for like, sure in LIKES(food):
        found = [known for known in ways if like in named(known.unit)]
        if found:
            return Nearness.LIKE, (food, like, sure), first_of(found)
    kind = kind_of(food)
    found = [known for known in ways if kind != "unknown" and kind in set(map(kind_of, named(known.unit)))]
    return (Nearness.KIND, None, first_of(found)) if found else None


@pytest.mark.slow
@given(foons(), st.sampled_from(FOODS).map(singular), st.booleans())
def test_what_is_attested_is_what_a_look_at_every_unit_finds(rows, food, act):
    operators = Operators(rows)
    ways = {way_of(known.unit) for known in rows}
    for way in sorted(ways):
        found = operators.attested(way, (food,), LIKES, act=act)
        told = (found.nearness, found.like, found.seen_in) if found is not None else None
        assert told == expected(rows, way, food, act=act)


def all_told(operators):
    """Everything that operators say, as plain values."""
    states = ("whole", "sliced", "peeled", "mixed", "chopped")
    return (
        [
            (way, food, act, operators.attested(way, (food,), LIKES, act=act), operators.count(way))
            for way in sorted(operators.evidence)
            for food in sorted(set(map(singular, FOODS)))
            for act in (True, False)
        ],
        [operators.farthest(way, ("salt", "carrot"), LIKES.alike) for way in sorted(operators.evidence)],
        [list(operators.making(state)) for state in states],
        [operators.ways_of(motion) for motion in ("slice", "pour", "mix")],
        [operators.brings(form, role) for form in ("whole", "pieces", "powder") for role in ("", "vessel", "storage")],
        dict(operators.ways),
        operators.foods,
    )


@pytest.mark.slow
@given(foons(), st.randoms(use_true_random=False))
def test_the_order_of_units_does_not_matter(rows, chance: random.Random):
    assert all_told(Operators(chance.sample(rows, len(rows)))) == all_told(Operators(rows))


@pytest.mark.slow
@given(foons(), st.data())
def test_a_removed_unit_attests_nothing_any_more_and_all_others_as_before(rows, data):
    gone = data.draw(st.sampled_from(rows))
    kept = [known for known in rows if known is not gone]
    operators, lost = Operators(kept), set(gone.seen_in) - {one for known in kept for one in known.seen_in}
    for way in sorted(Operators(rows).evidence):
        for food in sorted(set(map(singular, FOODS))):
            found = operators.attested(way, (food,), LIKES)
            assert found is None or lost.isdisjoint(found.seen_in)
            assert (found.nearness, found.like, found.seen_in) == expected(kept, way, food) if found else True


@pytest.fixture(scope="module")
def demo():
    return demo_foon()


def test_every_sighting_of_the_demo_has_the_motion_the_tools_and_a_food_of_that_nearness(demo):
    operators = Operators(demo.units)
    at = {(one.video, one.position): known.unit for known in demo.units for one in known.seen_in}
    likes = Likes({("kohlrabi", "potato"): 0.8, ("leek", "onion"): 0.8})
    seen = set()
    for way in operators.evidence:
        for food in ("tomato", "potato", "onion", "salt", "egg", "kohlrabi", "leek", "parsnip", "salmon", "zeppelin"):
            found = operators.attested(way, (food,), likes)
            if found is None:
                continue
            seen.add(found.nearness)
            assert 0 < len(found.seen_in) <= MOST_SIGHTINGS
            for one in found.seen_in:
                unit = at[one.video, one.position]
                assert way_of(unit) == way
                assert near(found, food, foods_of(unit))
    assert seen == {Nearness.FOOD, Nearness.LIKE, Nearness.KIND}


def near(found, food, foods):
    """Whether foods hold one that is as near as is said."""
    if found.nearness is Nearness.LIKE:
        return found.like[0] == food and found.like[1] in foods
    return food in foods if found.nearness is Nearness.FOOD else kind_of(food) in set(map(kind_of, foods))


def test_snapshots_attest_by_the_numbers_of_units_in_their_videos():
    found = Operators(snapshot_of(CARROT).units).attested(("peel", ("peeler",)), ("carrot",))
    assert sightings(found) == [("carrots", 0)]
