"""A task tree as the judge reads it: from JSON that may be wrong, from FOON text, and what can be looked up in it."""

from __future__ import annotations

import copy

import pytest
from validation.judging import ONE_TOMATO
from validation.soups import SUBGRAPHS, salad

from foon_kg.model import (
    Annotation,
    FunctionalUnit,
    ObjectNode,
    Participant,
    Recipe,
    RequiredIngredient,
    Sighting,
    Subgraph,
)
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.model.errors import ReadError
from foon_kg.model.levels import Level
from foon_kg.validation import tree_from_json, tree_from_subgraph
from foon_kg.validation.notation import read_tree
from foon_kg.world import Mention

TOMATO = {"label": "tomato", "states": ["whole"], "ingredients": [], "relation": None, "container": None}
SLICED = TOMATO | {"states": ["sliced"]}
KNIFE = TOMATO | {"label": "knife", "states": []}
ENTRY = {"kind": "object", "object": "leek", "required": "leek", "equivalent": "onion", "confidence": 0.8,
         "alternatives": [{"name": "shallot", "confidence": 0.7}]}  # fmt: skip
SHALLOT = Alternative("shallot", 0.7)


def result(**changed):
    """A plan result of one step, changed in some fields; ``None`` leaves a field out."""
    value = {
        "recipe": {
            "id": "r7", "title": "Tomato Salad", "dish_type": "salad",
            "ingredients": [{"object": "tomato", "state": "sliced"}],
        },
        "goal": SLICED,
        "units": [{
            "input_nodes": [TOMATO, KNIFE], "motion_node": "slice", "output_nodes": [SLICED],
            "origin": "foon", "grounding": "food",
            "seen_in": [{"video": "salad", "unit": 3, "source": None, "start": None, "end": None}],
        }],
        "kitchen": [TOMATO, KNIFE],
        "substitutions": [ENTRY],
        "assumptions": [{"node": TOMATO, "why": "it is summer"}],
    }  # fmt: skip
    value = copy.deepcopy(value) | changed
    return {name: part for name, part in value.items() if part is not None}


def read(**changed):
    return tree_from_json(result(**changed))


# --- JSON ---


def test_a_plan_result_is_read_whole():
    tree = read()
    tomato, knife = ObjectNode("tomato", ("whole",)), ObjectNode("knife")
    (unit,) = tree.units
    assert tree.name == "r7"
    assert tree.recipe == Recipe("salad", (RequiredIngredient("tomato", "sliced"),), title="Tomato Salad", id="r7")
    assert tree.goal == ObjectNode("tomato", ("sliced",))
    assert (unit.input_nodes, unit.motion, unit.output_nodes) == ((tomato, knife), "slice", (tree.goal,))
    assert (unit.origin, unit.grounding, unit.seen_in) == ("foon", "food", (Sighting("salad", 3),))
    assert tree.kitchen == (tomato, knife)
    assert tree.substitutions == (Substitution("object", "leek", "leek", "onion", 0.8, (SHALLOT,)),)
    assert tree.assumptions == (Assumption(tomato, "it is summer"),)
    assert (tree.level, tree.error) == (None, None)


@pytest.mark.parametrize(
    ("recipe", "name"),
    [
        ({"id": "r7", "title": "Salad"}, "r7"),
        ({"id": None, "title": "Salad"}, "Salad"),
        ({"id": None, "title": None}, "line 3"),
    ],
)
def test_a_tree_is_named_by_the_id_or_title_of_its_recipe_else_by_where_it_stands(recipe, name):
    value = result(recipe={"dish_type": "salad", "ingredients": [], **recipe})
    assert tree_from_json(value, "line 3").name == name


def test_without_a_place_a_nameless_tree_is_a_plan():
    assert tree_from_json(result(recipe={"dish_type": "salad", "ingredients": [], "title": None})).name == "plan"


def test_a_result_with_an_error_has_no_steps():
    tree = tree_from_json({"recipe": result()["recipe"], "error": {"code": "no_goal", "message": "none is near"}})
    assert (tree.error, tree.units, tree.goal, tree.kitchen) == ("none is near", (), None, None)
    assert tree.recipe.dish_type == "salad"
    assert tree.name == "r7"


def test_a_classic_retrieval_says_its_level_and_is_named_after_its_goal():
    tree = read(level=2, recipe=None)
    assert (tree.level, tree.recipe, tree.name) == (Level.STATES, None, "tomato")


@pytest.mark.parametrize("level", [0, 4])
def test_a_level_that_no_foon_has_is_refused(level):
    with pytest.raises(ReadError, match=f"line 3: a FOON has no level {level}") as caught:
        tree_from_json(result(level=level, recipe=None), "line 3")
    assert caught.value.hint == "The levels are 1, 2 and 3."


@pytest.mark.parametrize(
    "broken",
    [
        {"units": 3}, {"units": [{"input_nodes": []}]}, {"kitchen": "all"}, {"goal": 1}, {"recipe": 1},
        {"substitutions": [{"confidence": "high"}]}, {"assumptions": [{"why": "so"}]}, {"level": "two"},
    ],
)  # fmt: skip
def test_a_field_of_the_wrong_type_is_told_with_its_place(broken):
    with pytest.raises(ReadError, match=r"^line 3"):
        tree_from_json(result(**broken), "line 3")


@pytest.mark.parametrize("field", ["units", "kitchen", "goal", "recipe", "substitutions", "assumptions"])
def test_a_field_that_is_missing_is_told(field):
    with pytest.raises(ReadError, match=field):
        read(**{field: None})


def test_a_step_need_not_say_origin_grounding_or_where_it_was_seen():
    (unit,) = read(units=[{"input_nodes": [TOMATO], "motion_node": "slice", "output_nodes": [SLICED]}]).units
    assert (unit.origin, unit.grounding, unit.seen_in) == (None, None, ())


def test_things_carry_their_numbers():
    placed = SLICED | {"relation": "in", "container": "bowl", "thing": 3, "container_thing": 4}
    step = {"input_nodes": [TOMATO | {"thing": 2}], "motion_node": "put", "output_nodes": [placed]}
    (unit,) = read(units=[step]).units
    assert unit.inputs == (Mention(ObjectNode("tomato", ("whole",)), 2, None),)
    assert unit.outputs == (Mention(ObjectNode("tomato", ("sliced",), (), "in", "bowl"), 3, 4),)


def test_a_node_that_one_side_names_twice_counts_once():
    (unit,) = read(
        units=[{"input_nodes": [TOMATO, KNIFE, TOMATO], "motion_node": "slice", "output_nodes": [SLICED, SLICED]}]
    ).units
    assert [node.label for node in unit.input_nodes] == ["tomato", "knife"]
    assert len(unit.output_nodes) == 1


def test_two_things_with_one_node_are_two():
    (unit,) = read(
        units=[{
            "input_nodes": [TOMATO | {"thing": 1}, TOMATO | {"thing": 2}], "motion_node": "slice",
            "output_nodes": [SLICED],
        }]
    ).units  # fmt: skip
    assert [mention.thing for mention in unit.inputs] == [1, 2]


@pytest.mark.parametrize(
    ("field", "kept"),
    [
        ("kind", Substitution("", "leek", "leek", "onion", 0.8, (SHALLOT,))),
        ("object", Substitution("object", "", "leek", "onion", 0.8, (SHALLOT,))),
        ("required", Substitution("object", "leek", "", "onion", 0.8, (SHALLOT,))),
        ("equivalent", Substitution("object", "leek", "leek", "", 0.8, (SHALLOT,), frozenset({"equivalent"}))),
        ("confidence", Substitution("object", "leek", "leek", "onion", 0.0, (SHALLOT,), frozenset({"confidence"}))),
        ("alternatives", Substitution("object", "leek", "leek", "onion", 0.8, (), frozenset({"alternatives"}))),
    ],
)
def test_what_a_substitution_does_not_say_is_left_open(field, kept):
    (entry,) = read(substitutions=[{name: part for name, part in ENTRY.items() if name != field}]).substitutions
    assert entry == kept


def test_what_an_alternative_or_an_assumption_does_not_say_is_left_open():
    tree = read(substitutions=[ENTRY | {"alternatives": [{}]}], assumptions=[{"node": TOMATO}])
    assert tree.substitutions[0].alternatives == (Alternative("", 0.0, frozenset({"confidence"})),)
    assert tree.assumptions[0].why == ""


def test_a_plan_of_the_planner_is_read():
    tree = tree_from_json(salad())
    assert (tree.name, len(tree.units), tree.goal.label) == ("r1", 5, "tomato salad")


# --- FOON text ---


def test_foon_text_has_the_last_marked_output_for_its_goal_and_claims_nothing():
    tree = tree_from_subgraph(SUBGRAPHS[0])
    assert (tree.name, tree.goal.label) == ("tomato_salad", "tomato salad")
    assert (tree.kitchen, tree.substitutions, tree.assumptions, tree.recipe) == (None, None, None, None)
    assert {(unit.origin, unit.grounding, unit.seen_in) for unit in tree.units} == {(None, None, None)}
    assert [unit.motion for unit in tree.units] == ["pick-and-place", "chop", "pour", "sprinkle", "mix"]


def test_of_two_marked_outputs_the_later_is_the_goal():
    first, second = (ObjectNode(label, ("sliced",)) for label in ("salad", "soup"))
    units = [
        FunctionalUnit((), "mix", (Participant(node, dish_type="salad"), Participant(ObjectNode("bowl"))))
        for node in (first, second)
    ]
    tree = tree_from_subgraph(Subgraph("two", tuple(map(Annotation, units))), Recipe("salad", ()))
    assert tree.goal == second
    assert tree.recipe == Recipe("salad", ())


def test_unmarked_food_and_marked_utensils_are_no_goal():
    outputs = (Participant(ObjectNode("salad")), Participant(ObjectNode("bowl"), dish_type="salad"))
    tree = tree_from_subgraph(Subgraph("one", (Annotation(FunctionalUnit((), "mix", outputs)),)))
    assert tree.goal is None
    assert tree.units[0].motion == "mix"


# --- what can be looked up ---

TWO_STEPS = read_tree(f"""
{ONE_TOMATO}
tomato (sliced; on plate) + stove (off) → PUT → tomato (sliced; in pan) + stove (off)
""")
"""The stove comes out of its only step as it went in."""


def node(label, *states, at=None):
    relation, _, container = (at or "").partition(" ")
    return ObjectNode(label, states, (), relation or None, container or None)


def test_made_has_the_steps_that_output_a_node_without_having_taken_it():
    assert TWO_STEPS.made[node("tomato", "sliced", at="on plate")] == (0,)
    assert TWO_STEPS.made[node("tomato", "sliced", at="in pan")] == (1,)
    assert node("stove", "off") not in TWO_STEPS.made


def test_takers_has_the_steps_that_take_a_node():
    assert TWO_STEPS.takers[node("tomato", "whole")] == (0,)
    assert TWO_STEPS.takers[node("tomato", "sliced", at="on plate")] == (1,)
    twice = read_tree(f"{ONE_TOMATO}\n{ONE_TOMATO}")
    assert twice.takers[node("knife")] == (0, 1)
    assert twice.made[node("tomato", "sliced", at="on plate")] == (0, 1)


def test_leaves_are_what_no_earlier_step_outputs_in_the_order_of_use():
    assert TWO_STEPS.leaves == (node("tomato", "whole"), node("plate", "empty"), node("knife"), node("stove", "off"))


def test_what_is_made_only_later_is_a_leaf():
    tree = read_tree(f"tomato (sliced) → PUT → tomato (sliced; in pan)\nknife → SLICE → tomato (sliced)\n{ONE_TOMATO}")
    assert node("tomato", "sliced") in tree.leaves
    assert node("tomato", "sliced", at="in pan") not in tree.leaves


def test_nodes_are_all_of_them_in_the_order_of_appearance():
    assert [str(one) for one in TWO_STEPS.nodes] == [
        str(one)
        for one in (
            node("tomato", "whole"), node("plate", "empty"), node("knife"), node("tomato", "sliced", at="on plate"),
            ObjectNode("plate", (), ("tomato",)), node("stove", "off"), node("tomato", "sliced", at="in pan"),
        )
    ]  # fmt: skip


def test_new_outputs_are_those_that_did_not_go_in():
    assert TWO_STEPS.units[1].new_outputs == (node("tomato", "sliced", at="in pan"),)


def test_two_units_are_the_same_whatever_the_order_of_their_nodes():
    one, other = read_tree("a + b → MIX → c + d").units[0], read_tree("b + a → MIX → d + c").units[0]
    assert one.identity == other.identity
    assert one.nodes_key == other.nodes_key


@pytest.mark.parametrize("text", ["a + c → MIX → d", "a + b → STIR → d", "a + b → MIX → e"])
def test_units_with_another_input_motion_or_output_are_others(text):
    one, other = read_tree("a + b → MIX → d").units[0], read_tree(text).units[0]
    assert one.identity != other.identity
    assert one.nodes_key != other.nodes_key


def test_numbers_of_things_count_for_a_unit_of_the_tree_and_not_for_one_of_the_foon():
    one, other = read_tree("a#1 → MIX → d#1").units[0], read_tree("a#2 → MIX → d#2").units[0]
    assert one.identity != other.identity
    assert one.nodes_key == other.nodes_key


def test_a_unit_knows_its_motion():
    assert TWO_STEPS.units[0].motion == "slice"
