"""The kitchen: what is at hand, and what may be a leaf (C6)."""

import json
import pathlib

import pytest

from foon_kg.food import singular, words
from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import Kitchen, LeafFault

SHARED = pathlib.Path(__file__).resolve().parents[2] / ".." / "shared" / "data"
KITCHEN = Kitchen.default()


def node(label, *states, holds=(), at=None):
    relation, container = at.split(" ", 1) if at else (None, None)
    return ObjectNode(label, states, tuple(holds), relation, container)


@pytest.mark.shared_data
def test_our_lists_agree_with_the_contracts_lists():
    if not SHARED.is_dir():
        pytest.skip(f"the public data are not at {SHARED}: the kitchen is not compared with the contract's lists")
    states = json.loads((SHARED / "start-states.json").read_text(encoding="utf-8"))
    utensils = set((SHARED / "utensils.txt").read_text(encoding="utf-8").split("\n")) - {""}
    assert {label for label in utensils if not KITCHEN.is_utensil(label)} == set()
    assert KITCHEN.start_states == set(states["start_states"])
    assert {state: set(foods) for state, foods in KITCHEN.sold_so.items()} == {
        state: {singular(food) for food in foods} for state, foods in states["start_for_some_foods"].items()
    }


def test_the_default_kitchen_is_read_once():
    assert Kitchen.default() is Kitchen.default()


@pytest.mark.parametrize("label", ["bottle", "tin can", "plastic bag", "pepper mill", "cooking spray", "Jar", "faucet"])
def test_what_shops_sell_food_in_is_storage(label):
    assert KITCHEN.is_storage(label)


@pytest.mark.parametrize(
    "label", ["can opener", "bowl", "spray cheese", "chocolate bar", "measuring cup", "blender jar", "trash can"]
)
def test_other_labels_are_no_storage(label):
    assert not KITCHEN.is_storage(label)


@pytest.mark.parametrize("label", ["wok", "santoku", "chopper", "Woks", "frying pans"])
def test_utensils_are_those_of_the_tables(label):
    assert KITCHEN.is_utensil(label)


def test_a_user_adds_utensils(tmp_path, monkeypatch):
    own = tmp_path / "mine.toml"
    own.write_text(
        '[groups."my pans"]\nrole = "vessel"\ncan = ["hold", "heat"]\nnames = ["karahi"]\n', encoding="utf-8"
    )
    assert not KITCHEN.is_utensil("karahi")
    monkeypatch.setenv("FOON_KG_UTENSILS", str(own))
    assert Kitchen.default().is_utensil("karahi")
    assert Kitchen.default().is_utensil("pan")


def test_what_is_said_to_be_a_utensil_is_one_and_storage_where_it_is_called_so():
    kitchen = KITCHEN.with_utensils(["gripper", "rice bag"])
    assert kitchen.is_utensil("gripper")
    assert not kitchen.is_storage("gripper")
    assert kitchen.is_storage("rice bag")


def test_water_is_free_and_its_namesakes_are_not():
    assert KITCHEN.is_free("Water")
    assert not KITCHEN.is_free("saltwater")
    assert not KITCHEN.is_free("salt")


def test_free_foods_are_a_setting():
    kitchen = Kitchen.default(["salt", "Black  Pepper"])
    assert kitchen.is_free("salt")
    assert kitchen.is_free("black pepper")
    assert not kitchen.is_free("water")


@pytest.mark.parametrize(
    ("label", "state", "expected"),
    [
        ("egg", "whole", True),
        ("egg", "beaten", False),
        ("black pepper", "ground", True),
        ("ground beef", "ground", True),
        ("bell peppers", "ground", True),
        ("sausage", "ground", False),
        ("rolled oats", "rolled", True),
        ("dough", "rolled", False),
        ("mixed nuts", "mixed", True),
        ("pancake", "mixed", False),
        ("cherry tomato", "on [stem]", True),
        ("Salt", "Granulated", True),
    ],
)
def test_start_states(label, state, expected):
    assert KITCHEN.is_start_state(label, state) is expected


@pytest.mark.parametrize(
    "label_and_states",
    [
        ("bowl",),
        ("bowl", "empty"),
        ("stove", "off (ready)"),
        ("fridge", "on"),
        ("bag", "sealed"),
        ("mixer", "off", "empty"),
    ],
)
def test_utensils_at_rest(label_and_states):
    assert KITCHEN.at_rest(node(*label_and_states))


@pytest.mark.parametrize(
    "label_and_states",
    [("stove", "on"), ("pot", "empty", "hot"), ("pan", "greased"), ("oven", "preheated"), ("fridge", "hot!")],
)
def test_utensils_in_use(label_and_states):
    assert not KITCHEN.at_rest(node(*label_and_states))


def test_a_running_fridge_does_not_count_as_running():
    assert KITCHEN.is_running(node("oven", "on"))
    assert not KITCHEN.is_running(node("fridge", "on"))
    assert not KITCHEN.is_running(node("pan", "greased"))


@pytest.mark.parametrize(
    "known",
    [
        node("bowl"),
        node("cooking pan", "empty", at="on stove"),
        node("bottle", holds=["olive oil"]),
        node("egg"),
        node("egg", "whole"),
        node("salt", "granulated", at="in shaker"),
        ObjectNode("salt", ("granulated",), (), None, "shaker"),
        node("potato", holds=["packet"], at="in packet"),
        node("olive oil", holds=["olive oil"], at="in bottle"),
    ],
)
def test_a_search_finds_these_at_hand(known):
    assert KITCHEN.has(known)
    assert KITCHEN.may_be_leaf(known)


@pytest.mark.parametrize(
    "missing",
    [
        node("bowl", holds=["egg"]),
        node("jar", holds=["oil", "vinegar"]),
        node("stove", "on"),
        node("egg", "whole", at="in bowl"),
        node("egg", "whole", at="on jar"),
        node("egg", "whole", "beaten"),
        node("egg mixture"),
        node("broth", "liquid", holds=["chicken broth", "flour"]),
        node("cherry tomato", "whole", "on [stem]"),
    ],
)
def test_a_search_must_make_these(missing):
    assert not KITCHEN.has(missing)


@pytest.mark.parametrize(
    ("leaf", "beside", "fault"),
    [
        (node("egg", "whole", at="in bowl"), [], None),
        (node("egg", "beaten"), [], LeafFault.PROCESSED),
        (node("broth", "liquid", holds=["chicken broth", "flour"]), [], LeafFault.MIXTURE),
        (node("egg mixture"), [], LeafFault.MIXTURE),
        (node("stove", "on"), [], LeafFault.RUNNING),
        (node("pot", "hot", holds=["soup"]), [], LeafFault.RUNNING),
        (node("pan", "greased"), [], LeafFault.USED),
        (node("bowl", holds=["eggs"]), [node("egg", at="in bowl")], None),
        (node("bowl", holds=["egg"]), [node("milk")], LeafFault.HELD),
        (node("bowl", holds=["egg", "milk"]), [node("milk")], LeafFault.HELD),
        (node("bowl", holds=["egg", "milk"]), [node("milk"), node("egg")], None),
        (node("tin can", "opened", holds=["tuna"]), [], None),
        (node("fridge", "on", holds=["butter"]), [node("butter")], None),
    ],
)
def test_leaf_faults(leaf, beside, fault):
    assert KITCHEN.leaf_fault(leaf, beside) is fault
    assert KITCHEN.may_be_leaf(leaf, beside) is (fault in {None, LeafFault.RUNNING})


def test_processed_states_are_those_that_somebody_made():
    assert KITCHEN.processed_states(node("garlic", "clove", "peeled", "on [board]")) == ("peeled",)


@pytest.mark.parametrize(
    ("plural", "one"),
    [
        ("Bell Peppers", "bell pepper"), ("tomatoes", "tomato"), ("berries", "berry"), ("cookies", "cookie"),
        ("cookie", "cookie"), ("smoothies", "smoothie"), ("pies", "pie"), ("peas", "pea"), ("bay leaves", "bay leaf"),
        ("radishes", "radish"),
        ("asparagus", "asparagus"), ("swiss", "swiss"), ("boxes", "box"), ("gas", "gas"), ("olives", "olive"),
    ],
)  # fmt: skip
def test_labels_meet_in_the_singular(plural, one):
    assert singular(plural) == one
    assert singular(one) == one


def test_words_leave_out_what_is_no_letter():
    assert words("off (ready) 2") == ("off", "ready")
