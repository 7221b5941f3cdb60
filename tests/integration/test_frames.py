"""How a recorded dish is made, followed backwards from its goal: lines, stages, and the slots at which foods join."""

from __future__ import annotations

import pytest
from examples import examples
from hypothesis import assume, given
from integration import videos
from integration.told import snapshot_of, subgraphs
from planner.public_foon import public_snapshot
from world.kitchen_walk import walks

from foon_kg.food import singular, tables
from foon_kg.integration.methods import Methods
from foon_kg.integration.teaching.derivation import frame_of, frames_of
from foon_kg.integration.teaching.frames import Line, Slot
from foon_kg.model import FunctionalUnit, ObjectNode, Participant

TO_BE_MENDED = frozenset({"same food in two", "between two of a kind", "scoop"})
"""What nodes without numbers cannot tell (see tests/world/test_walks.py), and what may leave a part of it behind."""

LEAST_RECALL = 0.95
"""Which share of the foods of the recorded goals has a slot at least."""


def frame(text):
    """Return the one frame of a video."""
    (found,) = snapshot_of(text).methods().frames
    return found


def told(line):
    """Return a line as a cook would tell it, a stage a row."""
    return [_stage(stage) for stage in line.stages]


def _stage(stage):
    adds = "; ".join(map(_add, stage.adds)) or "nothing"
    appliance = f" @ {stage.appliance}" if stage.appliance else ""
    states = f" ({', '.join(stage.states)})" if stage.states else ""
    return f"{adds} → {stage.motion or 'done'} {stage.relation} {stage.vessel}{appliance}: {stage.label}{states}"


def _add(add):
    if isinstance(add, Line):
        return "[" + " | ".join(told(add)) + "]"
    cooked = f" by {'+'.join(add.cooked)}" if add.cooked else ""
    return f"{add.food} ({', '.join(add.states)}){cooked}"


# --- six dishes by hand ---


def test_a_dressing_is_a_line_of_its_own_that_joins_the_salad():
    (stage,) = told(frame(videos.MIXED_SALAD).line)
    assert stage == (
        "tomato (diced); cucumber (sliced); "
        "[lemon (juice); olive oil (liquid); salt (granulated) → whisk in cup: dressing (mixed)] "
        "→ mix in bowl: salad (mixed)"
    )


def test_fat_on_the_tin_joins_before_the_batter_that_is_baked_there():
    (stage,) = told(frame(videos.BAKED_BATTER).line)
    assert stage == (
        "butter (); [flour (powder); sugar (granulated); egg (whole) → whisk in bowl: batter (mixed)] "
        "→ bake on baking tray @ oven: cake (baked)"
    )


def test_what_was_boiled_and_drained_joins_as_cooked_by_itself_and_without_its_water():
    (stage,) = told(frame(videos.BOILED_PASTA).line)
    assert stage == (
        "pasta (boiled) by boil; "
        "[olive oil (liquid); tomato (diced); garlic (minced) → cook in pan @ stove: sauce (cooked)] "
        "→ mix in bowl: pasta (cooked)"
    )


def test_what_is_stacked_joins_one_after_another_and_is_called_the_dish_at_the_end():
    assert told(frame(videos.SANDWICH).line) == [
        "bread (sliced); butter (creamy) → spread on plate: bread (sliced)",
        "cheese (sliced); tomato (sliced) → done on plate: sandwich",
    ]


def test_what_is_blended_is_brought_where_it_is_served():
    found = told(frame(videos.DRINK).line)
    assert found[0].startswith("banana (sliced); milk (liquid); honey (liquid) → blend in blender jar @ blender: smoot")
    assert found[1].startswith("nothing → pour in glass: smoot")
    assert len(found) == 2


def test_a_soup_over_a_stove_that_is_on_is_heated_though_nobody_noted_it():
    found = frame(videos.SOUP_WITHOUT_HEAT)
    assert told(found.line) == [
        "water (liquid); potato (diced); onion (chopped); salt (granulated) → stir in pot @ stove: soup (cooked)"
    ]
    (stage,) = found.line.stages
    assert stage.does == {"heat", "mix"}
    assert stage.source == "heat"


def test_stirring_away_from_the_stove_heats_nothing():
    cold = videos.SOUP_WITHOUT_HEAT.replace("pot (empty) + stove (on) → PICK-AND-PLACE → pot (empty; on stove)", "")
    cold = cold.replace(" + stove (on; under pot)\n", "").replace("; on stove", "").replace("\n\n", "\n")
    (stage,) = frame(cold).line.stages
    assert stage.does == {"mix"}


def test_a_slot_tells_how_a_food_is_brought_and_out_of_what():
    slots = {slot.food: slot for slot in frame(videos.MIXED_SALAD).line.all_slots()}
    assert (slots["tomato"].motion, slots["tomato"].tools, slots["tomato"].source) == ("pour", (), "cutting board")
    assert (slots["lemon"].motion, slots["lemon"].tools) == ("squeeze", ("squeezer",))
    assert slots["salt"].motion == "sprinkle"
    assert {food: slot.kind for food, slot in slots.items()} == {
        food: tables().foods.find(food)[0] for food in ("tomato", "cucumber", "lemon", "olive oil", "salt")
    }


@pytest.mark.xfail(strict=True, reason="what is poured straight out of a bottle is said to come out of nothing")
def test_a_slot_tells_the_bottle_out_of_which_a_food_comes():
    slots = {slot.food: slot for slot in frame(videos.MIXED_SALAD).line.all_slots()}
    assert slots["olive oil"].source == "bottle"


def test_the_whole_is_called_as_in_the_video():
    assert {stage.label for stage in frame(videos.DRINK).line.stages} == {"smoothie"}


def test_stages_say_when_they_were():
    assert [stage.step for stage in frame(videos.SANDWICH).line.stages] == [1, 5]
    assert [stage.step for stage in frame(videos.BOILED_PASTA).line.stages] == [17]


def test_a_frame_knows_its_goal_its_dish_type_and_its_video():
    found = frame(videos.BAKED_BATTER)
    assert (found.goal.label, found.dish_type, found.video) == ("cake", "cake", "plain_cake")


def test_each_goal_of_a_video_has_a_frame():
    units = [unit.unit for unit in subgraphs(videos.BOILED_PASTA)[0].annotations]
    sauce = next(node for unit in units for node in unit.output_nodes if node.label == "sauce")
    pasta = units[-1].output_nodes[0]
    found = frames_of(units, [(pasta, "pasta"), (sauce, "sauce")], "both")
    assert [one.goal.label for one in found] == ["pasta", "sauce"]
    assert [slot.food for slot in found[1].line.all_slots()] == ["olive oil", "tomato", "garlic"]
    assert len({one.key for one in found}) == 2


def test_a_goal_that_no_unit_makes_has_no_frame():
    units = [unit.unit for unit in subgraphs(videos.SANDWICH)[0].annotations]
    assert frame_of(units, ObjectNode("pie"), "pie", "nothing") is None


def test_the_order_of_units_in_the_graph_does_not_matter():
    snapshot = snapshot_of(*videos.ALL)
    turned = Methods.of(snapshot.units[::-1], snapshot.goals()[::-1])
    assert turned.frames == snapshot.methods().frames
    assert [one.video for one in turned.frames] == sorted(one.video for one in turned.frames)


def test_each_dish_cooks_its_foods_as_its_video_does():
    assert snapshot_of(*videos.ALL).methods().cooked_by["dry pasta"] == ("boil",)


TWICE = """
name: salted_twice
dish: salad
goal: salad (mixed; {carrot, salt, tomato}; in bowl)
carrot (whole) + plate (empty) → PICK-AND-PLACE → carrot (whole; on plate) + plate ({carrot})
salt (granulated; in shaker) + plate ({carrot}) → SPRINKLE → salt (granulated; on plate) + plate ({carrot, salt})
tomato (whole) + bowl (empty) → PICK-AND-PLACE → tomato (whole; in bowl) + bowl ({tomato})
carrot (whole; on plate) + salt (granulated; on plate) + plate ({carrot, salt}) + bowl ({tomato}) → POUR
  → carrot (whole; in bowl) + salt (granulated; in bowl) + bowl ({carrot, salt, tomato}) + plate (empty)
salt (granulated; in shaker) + salt (granulated; in bowl) + bowl ({carrot, salt, tomato}) → SPRINKLE
  → salt (granulated; in bowl) + bowl ({carrot, salt, tomato})
carrot (whole; in bowl) + salt (granulated; in bowl) + tomato (whole; in bowl) + bowl ({carrot, salt, tomato}) + spoon
  → MIX → salad (mixed; {carrot, salt, tomato}; in bowl) + bowl ({salad})
"""


PORTIONS = """
name: two_portions
dish: salad
goal: salad (mixed; {carrot, salt, tomato}; in bowl)
carrot (whole) + plate (empty) → PICK-AND-PLACE → carrot (whole; on plate) + plate ({carrot})
salt (granulated; in shaker) + plate ({carrot}) → SPRINKLE → salt (granulated; on plate) + plate ({carrot, salt})
tomato (whole) + bowl (empty) → PICK-AND-PLACE → tomato (whole; in bowl) + bowl ({tomato})
salt (granulated; in shaker) + bowl ({tomato}) → SPRINKLE → salt (granulated; in bowl) + bowl ({salt, tomato})
carrot (whole; on plate) + salt (granulated; on plate) + plate ({carrot, salt}) + bowl ({salt, tomato}) → POUR
  → carrot (whole; in bowl) + salt (granulated; in bowl) + bowl ({carrot, salt, tomato}) + plate (empty)
carrot (whole; in bowl) + salt (granulated; in bowl) + tomato (whole; in bowl) + bowl ({carrot, salt, tomato}) + spoon
  → MIX → salad (mixed; {carrot, salt, tomato}; in bowl) + bowl ({salad})
"""


def test_two_portions_of_a_food_that_meet_are_one_slot():
    assert sorted(slot.food for slot in frame(PORTIONS).line.all_slots()) == ["carrot", "salt", "tomato"]


def test_a_food_that_is_poured_twice_has_a_slot():
    assert {slot.food for slot in frame(TWICE).line.all_slots()} == {"carrot", "salt", "tomato"}


# --- any possible kitchen ---

STORAGE = frozenset({"shaker", "bag", "bottle", "carton", "faucet"})


def _units(walk):
    for line in walk.lines:
        inputs, outputs = (
            dict.fromkeys(Participant(told.node) for told in side) for side in (line.inputs, line.outputs)
        )
        yield FunctionalUnit(tuple(inputs), line.motion, tuple(outputs))


def _frame_of(walk):
    """Return the frame of a walk that brings several foods together, each of them out of its storage once."""
    poured = [told.node.label for line in walk.lines for told in line.inputs if told.node.container in STORAGE]
    is_told = any(told.node == walk.goal for told in walk.lines[-1].outputs)
    assume(is_told and len(walk.foods) > 1 and len(poured) == len(set(poured)))
    return frame_of(list(_units(walk)), walk.goal, "salad", "walk")


for_many_walks = examples(40)
short_walks = walks(TO_BE_MENDED, most=15)


@pytest.mark.slow
@for_many_walks
@given(short_walks)
def test_every_food_that_a_video_brings_into_the_goal_is_in_exactly_one_slot(walk):
    found = _frame_of(walk)
    assert sorted(slot.food for slot in found.line.all_slots()) == sorted(food.label for food in walk.foods)


@for_many_walks
@given(short_walks)
def test_slots_and_stages_of_any_video_tell_the_truth(walk):
    found = _frame_of(walk)
    cooked = {food.label for food in walk.foods if {"heat", "cook"} & food.done}
    motions = [line.motion for line in walk.lines]
    for slot in found.line.all_slots():
        assert slot.kind == tables().foods.food(slot.food, slot.states).kind
        assert not slot.cooked or slot.food in cooked
    for stage in _stages(found.line):
        assert not stage.motion or motions[stage.step] == stage.motion
        assert stage.vessel
    steps = [stage.step for stage in found.line.stages]
    assert steps == sorted(set(steps))


def _stages(line):
    for stage in line.stages:
        yield stage
        for add in stage.adds:
            if not isinstance(add, Slot):
                yield from _stages(add)


# --- the public FOON ---


def _brought(units):
    """The foods that a video takes from the kitchen as single foods."""
    made, found = set(), set()
    for unit in units:
        leaves = [node for node in unit.input_nodes if node not in made and not node.ingredients]
        found |= {singular(node.label) for node in leaves if tables().utensil(node.label) is None}
        made.update(unit.output_nodes)
    return found


@pytest.mark.shared_data
def test_nearly_all_foods_of_the_public_goals_have_a_slot():
    snapshot = public_snapshot()
    videos_by_name = {one.name: [annotation.unit for annotation in one.annotations] for one in snapshot.subgraphs}
    found, asked = 0, 0
    for one in snapshot.methods().frames:
        wanted = {singular(name) for name in one.goal.ingredients} & _brought(videos_by_name[one.video])
        found += len(wanted & {slot.food for slot in one.line.all_slots()})
        asked += len(wanted)
    assert asked > 700
    assert found >= LEAST_RECALL * asked


def public_frame(video):
    """Return the one frame of a public video."""
    (found,) = (one for one in public_snapshot().methods().frames if one.video == video)
    return found


@pytest.mark.shared_data
def test_a_dish_that_is_called_like_its_main_food_has_a_slot_for_it():
    slots = {slot.food for slot in public_frame("0060-spicy_black_beans").line.all_slots()}
    assert {"black bean", "bay leaf", "jalapeno"} - slots == {"bay leaf"}  # bay leaves are taken out again
    assert "salmon" in {slot.food for slot in public_frame("EPIC-P20_04-cooked_salmon-XXX").line.all_slots()}


@pytest.mark.shared_data
def test_a_dish_is_no_food_of_itself_however_its_name_is_written():
    assert "hash brown" not in {slot.food for slot in public_frame("0039-crispy_hash_browns").line.all_slots()}


@pytest.mark.shared_data
def test_a_frame_tells_which_foods_of_its_goal_were_lost():
    assert public_frame("EPIC-P04_23-massaman_curry_paste-X").weak == ("onion",)  # it is nowhere but in the goal
    assert public_frame("ACT-0003-blueberry_muffin").weak == ()


@pytest.mark.shared_data
def test_what_comes_twice_out_of_its_vessel_or_from_nowhere_is_followed_as_far_as_the_video_goes():
    slots = {slot.food for slot in public_frame("0058-chocolate_cake").line.all_slots()}
    assert {"flour", "sugar", "cocoa powder", "baking powder", "salt", "milk", "frosting"} <= slots
    baked = {slot.food for slot in public_frame("0055-southern-baked_macaroni_and_cheese").line.all_slots()}
    assert "macaroni" in baked
    assert "water" not in baked  # told in the goal alone; it was poured away
