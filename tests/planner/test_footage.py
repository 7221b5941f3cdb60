from kitchen_stories import node, script, subgraph
from planner.dishes import KITCHEN, SETTINGS

from foon_kg.footage import footage, same_things
from foon_kg.form import KnownFoon, TaskTree, check
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planner import plan
from foon_kg.snapshot import Snapshot

BROWNIE = (
    "bag{flour}; flour(powder)@bag; bowl(empty) > pour > bowl{flour}; flour(powder)@bowl",
    "bowl{flour}; carton{milk}; milk(liquid)@carton > pour > bowl{flour,milk}; milk(liquid)@bowl",
    "bowl{flour,milk}; flour(powder)@bowl; milk(liquid)@bowl; spoon > mix > bowl{batter}; batter{flour,milk}@bowl",
    "bowl{batter}; batter{flour,milk}@bowl; baking tray > pour > baking tray{batter}; batter{flour,milk}@on tray",
    "baking tray{batter}; batter{flour,milk}@on tray > bake > baking tray{brownie}; brownie(baked){flour,milk}@on tray",
    "brownie(baked)@on tray; knife > cut > brownie(baked,divided){flour,milk}@on tray",
)
"""The brownie is cut by another name than it was baked by."""

GOAL = node("brownie(baked,divided){flour,milk}@on tray")
CUT, BAKED = node("brownie(baked)@on tray"), node("brownie(baked){flour,milk}@on tray")


def makers(units):
    return lambda made: [known for known in units if made in known.unit.output_nodes]


def test_an_input_that_no_unit_makes_is_what_was_made_by_another_name():
    assert same_things(script(*BROWNIE), KITCHEN) == {CUT: BAKED}


def test_of_several_that_it_may_be_it_is_the_likest():
    likest = node("bowl{egg,flour,milk}")
    units = script(
        "bowl(empty); flour(powder) > pour > bowl{egg,flour}",
        "bowl{egg,flour}; milk(liquid) > pour > bowl{egg,flour,milk}",
        "bowl{egg,flour,milk,oil}; spoon > mix > bowl{batter}",
    )
    assert same_things(units, KITCHEN) == {node("bowl{egg,flour,milk,oil}"): likest}


def test_what_is_in_another_state_or_place_is_another_thing():
    raw = "bowl(empty); egg(whole) > pour > omelette(raw){egg,salt}@pan; omelette(fried){egg,salt}@plate"
    assert same_things(script(raw, "omelette(fried){egg,salt}@pan > fold > omelette(folded)@pan"), KITCHEN) == {}


def test_what_a_kitchen_has_is_never_taken_for_something_made():
    units = script("board{onion}; onion(whole){salt} > pour > onion(whole){salt}@bowl", "onion(whole) > peel > onion")
    assert same_things(units, KITCHEN) == {}


def test_the_footage_of_a_goal_ends_with_it_and_has_only_what_lies_behind_it():
    units = script(
        *BROWNIE[:5], "napkin(dirty) > wash > napkin(clean)", BROWNIE[5], "knife(dirty) > wash > knife(clean)"
    )
    behind = footage(GOAL, ("story",), makers((*units,)), KITCHEN.has)
    assert [known.unit.motion for known in behind] == ["cut"]
    linked = (*units, *script("oven; baking tray{batter} > look > brownie(baked)@on tray", video="other"))
    behind = footage(GOAL, ("story",), makers(linked), KITCHEN.has)
    assert [known.unit.motion for known in behind] == ["pour", "pour", "mix", "pour", "cut"]


def test_a_goal_that_its_video_does_not_make_has_no_footage():
    assert footage(node("cake"), ("story",), makers(script(*BROWNIE)), KITCHEN.has) == ()


def test_a_dish_whose_video_changes_a_name_on_the_way_is_made_through_to_the_end():
    links = ("baking tray{brownie}; brownie(baked)@on tray; spatula > scrape > brownie(baked)@on tray; napkin",)
    snapshot = Snapshot.of([subgraph("brownie", "cake", *BROWNIE), subgraph("loop", "pie", *links)], KITCHEN)
    recipe = Recipe("cake", (RequiredIngredient("flour", "powder"), RequiredIngredient("milk", "liquid")))
    result = plan(snapshot, recipe, SETTINGS)
    assert [unit.motion_node for unit in result.units] == ["pour", "pour", "mix", "pour", "bake", "cut"]
    assert BAKED in result.units[-1].input_nodes
    report = check(TaskTree.from_json(result.to_json()), KnownFoon.of(snapshot.units, snapshot.goals()))
    assert [str(finding) for finding in report.findings] == []
