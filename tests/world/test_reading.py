"""What an object node says: food or utensil, contents, place, and the claims of its states."""

from __future__ import annotations

import pytest

from foon_kg.food import tables
from foon_kg.model import ObjectNode
from foon_kg.validation.notation import read_tree
from foon_kg.world.reading import Reader, reader


def read(text, foods=()):
    """Return what the node in ``text`` says, read anew."""
    ((mention,),) = (unit.inputs for unit in read_tree(f"{text} → PUT → nothing").units)
    return Reader(tables(), frozenset(foods)).read(mention.node)


CLAIMS = ("empty", "on", "off", "hot", "covered", "uncovered", "undivided", "remains")


def claims(text):
    """Return what is claimed of a node, in the order of ``CLAIMS``."""
    said = read(text)
    return [claim for claim in CLAIMS if getattr(said, claim)]


def test_labels_and_names_are_in_the_singular():
    said = read("tomatoes ({Red Onions, leaves})")
    assert (said.label, said.names) == ("tomato", {"red onion", "leaf"})
    assert said.node.label == "tomatoes"


def test_a_food_is_what_no_table_lists_as_a_utensil():
    tomato, bowl, stove = read("tomato"), read("bowls"), read("stove")
    assert (tomato.is_food, tomato.is_appliance, tomato.utensil) == (True, False, None)
    assert (bowl.is_food, bowl.is_appliance, bowl.utensil.name) == (False, False, "bowl")
    assert (stove.is_food, stove.is_appliance) == (False, True)


def test_a_name_that_is_food_here_is_no_utensil():
    assert not read("wrap").is_food
    assert read("wraps", foods=["wrap"]).is_food
    assert read("bowl ({wrap})").names == frozenset()
    assert read("bowl ({wrap})", foods=["wrap"]).names == {"wrap"}


def test_utensils_in_braces_are_no_contents():
    assert read("drawer ({knives, tomato})").names == {"tomato"}
    assert claims("bowl (empty; {spoon})") == ["empty"]
    assert claims("bowl (empty; {tomato})") == []


@pytest.mark.parametrize("relation", ["in", "on", "inside", "from", "attached to", "over", "below"])
def test_a_thing_is_in_or_on_its_container(relation):
    said = read(f'tomato ("{relation}" bowls)')
    assert (said.place, said.place_utensil.name, said.covers) == ("bowl", "bowl", None)


@pytest.mark.parametrize("relation", ["with", "contains", "covered", "covering", "coated"])
def test_what_is_on_a_thing_is_not_where_it_is(relation):
    said = read(f'pot ("{relation}" lids)')
    assert (said.place, said.place_utensil, said.covers) == (None, None, "lid")


def test_a_utensil_under_another_bears_it_and_a_food_under_one_lies_there():
    assert (read("stove (under pot)").place, read("stove (under pot)").covers) == (None, "pot")
    assert (read("tomato (under lid)").place, read("tomato (under lid)").covers) == ("lid", None)


def test_a_node_without_a_container_is_nowhere():
    said = read("tomato (sliced)")
    assert (said.place, said.place_utensil, said.covers) == (None, None, None)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ('tomato ("on [cutting boards]")', "cutting board"),
        ('tomato ("In [Bowl]")', "bowl"),
        ('tomato ("inside [bowl]")', "bowl"),
        ('tomato ("from [bag]")', "bag"),
        ('tomato (sliced, "on [board]")', "board"),
        ('tomato ("under [bowl]")', None),
        ('tomato ("on [bowl] there")', None),
        ('tomato ("on bowl")', None),
        ('tomato ("in [bowl]"; in pot)', "pot"),
        ('pot ("on [stove]"; with lid)', "stove"),
        ('stove ("on [table]"; under pot)', "table"),
        ('tomato ("in [bowl]"; from bag)', "bowl"),
        ("tomato (from bag)", "bag"),
    ],
)
def test_a_place_may_stand_among_the_states(text, place):
    assert read(text).place == place


def test_a_place_that_is_a_food_is_no_utensil():
    said = read("cheese (on breads)")
    assert (said.place, said.place_utensil) == ("bread", None)


@pytest.mark.parametrize(
    ("text", "claimed"),
    [
        ("bowl", []), ("bowl (empty)", ["empty"]), ("bowl (Empty)", ["empty"]),
        ('pot ("empty (ready)")', ["empty", "off"]), ("bowl (clean)", []),
        ("stove (on)", ["on"]), ("stove (ON)", ["on"]), ("oven (preheated)", ["on", "hot"]), ("stove (off)", ["off"]),
        ('stove ("off (ready)")', ["off"]), ("stove (unplugged)", ["off"]),
        ("pan (hot)", ["hot"]), ("pan (boiling)", ["hot"]), ("pan (cold)", []),
        ("jar (closed)", ["covered"]), ("jar (sealed)", ["covered"]), ('pot ("covered [pot lid]")', ["covered"]),
        ("pot (covered lid)", ["covered"]), ('pot ("covered" lid)', ["covered"]), ("jar (open)", ["uncovered"]),
        ("jar (uncovered)", ["uncovered"]), ('pot ("open [lid]")', []),
        ("tomato", []), ("tomato (whole)", ["undivided"]), ("tomato (uncut)", ["undivided"]),
        ("tomato (sliced)", []), ("tomato (whole, sliced)", []), ("tomato (whole, wet)", ["undivided"]),
        ("onion (skin)", ["remains"]), ("egg shell", ["remains"]), ("tomato (peeled)", []),
        ("bowl (whole)", []), ("bowl (remains)", []),
    ],
)  # fmt: skip
def test_claims_of_a_node(text, claimed):
    assert claims(text) == claimed


@pytest.mark.parametrize(
    ("text", "fine"),
    [
        ("tomato", None), ("tomato (ripe)", None), ("tomato (whole)", 0), ("tomato (sliced)", 2),
        ("tomato (sliced, minced)", 4), ("tomato (whole, sliced)", 2), ("bowl (sliced)", None),
    ],
)  # fmt: skip
def test_of_several_states_the_finest_counts(text, fine):
    assert read(text).fine == fine


def test_states_tell_what_was_done():
    assert read("tomato (peeled, sliced)").earns == {"peel", "cut"}
    assert read("tomato (ripe)").earns == frozenset()
    assert read("bowl (peeled)").earns == frozenset()


def test_a_node_is_read_once():
    one = Reader(tables())
    node = ObjectNode("tomato", ("sliced",))
    assert one.read(node) is one.read(ObjectNode("tomato", ("sliced",)))
    assert one.read(node).node is node
    assert one.read(ObjectNode("tomato")) is not one.read(node)


def test_trees_with_the_same_words_share_a_reader():
    assert reader(tables()) is reader(tables())
    assert reader(tables(), frozenset({"wrap"})) is not reader(tables())
    assert reader(tables(), frozenset({"wrap"})).utensil("wrap") is None
    assert reader(tables()).utensil("bowl").role == "vessel"
    assert reader(tables()).utensil("tomato") is None
