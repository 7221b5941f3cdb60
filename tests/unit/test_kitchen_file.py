"""``--kitchen FILE``: what people write down, and what is said where it cannot be read or is not known."""

from __future__ import annotations

import json

import pytest
from kitchen_stories import SALAD, node, subgraph

from foon_kg.model.errors import FoonError, ReadError
from foon_kg.model.node_json import node_to_json
from foon_kg.planning.kitchen_file import read_kitchen
from foon_kg.planning.recipes import IngredientWords
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

EVERYBODY = Kitchen.default()
SNAPSHOT = Snapshot.of([subgraph("salad", "salad", *SALAD)], EVERYBODY)
WORDS = IngredientWords(SNAPSHOT.vocabulary(), EVERYBODY)


@pytest.fixture
def read(tmp_path):
    def read_text(text, name="kitchen.txt"):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return read_kitchen(path, WORDS)

    return read_text


def things(kitchen):
    return [
        thing for thing in (*(kitchen.utensils_named or ()), *(kitchen.foods_named or ())) if thing.label != "water"
    ]


@pytest.mark.parametrize(
    ("line", "thing"),
    [
        ("onion", "onion"),
        ("Onions", "onion"),
        ("onion, chopped", "onion(chopped)"),
        ("chopped onion", "onion(chopped)"),
        ("- tomato  # from the garden", "tomato"),
        ("onion, chopped, on the cutting board", "onion(chopped)@on cutting_board"),
        ("salt in a shaker", "salt@in shaker"),
        ("knives", "knife"),
        ("knife", "knife"),
        ("Cutting  Board", "cutting board"),
        ("oven, preheated", "oven(preheated)"),
        ("preheated oven", "oven(preheated)"),
        ("tuna in oil", "tuna in oil"),
    ],
)
def test_a_line_names_one_thing(read, line, thing):
    assert things(read(f"# at home\n\n{line}\n").kitchen)[0] == node(thing)


def test_utensils_alone_leave_the_foods_open_and_the_other_way_round(read):
    assert read("knife\nbowl").kitchen.foods_named is None
    assert read("onion").kitchen.utensils_named is None


@pytest.mark.parametrize("wrapped", [False, True])
def test_json_says_the_same_in_texts_nodes_and_recipe_ingredients(read, wrapped):
    entries = ["onion, chopped", node_to_json(node("egg(whole)@in carton")), {"object": "tomato", "state": "diced"}]
    kitchen = read(json.dumps({"foods": entries} if wrapped else entries), "kitchen.json").kitchen
    assert things(kitchen) == [node("onion(chopped)"), node("egg(whole)@in carton"), node("tomato(diced)")]


def test_a_list_for_foods_makes_foods_of_what_has_a_utensils_name_and_the_other_way_round(read):
    kitchen = read('{"foods": ["cooking spray"], "utensils": ["gripper"]}', "kitchen.json").kitchen
    assert not kitchen.is_utensil("cooking spray")
    assert kitchen.is_utensil("gripper")
    assert not kitchen.lacks(node("gripper"))
    assert kitchen.lacks(node("bowl(empty)"))


@pytest.mark.parametrize(
    ("text", "note"),
    [
        ("salt\noniom", "kitchen.txt:2: this FOON knows no food “oniom” (near it: onion); it counts as a food at hand"),
        ("bowll", "kitchen.txt:1: this FOON knows no food “bowll” (near it: bowl"),
        (
            "onion, choped",
            "kitchen.txt:1: this FOON knows no state “choped” (near it: chopped); it is kept as it stands",
        ),
        ("bowl {onion, oniom}", "kitchen.txt:1: this FOON knows no food “oniom” (near it: onion)"),
        ("3 onions, chopped", "kitchen.txt:1: “3 onions, chopped” is read as onion: “3” is left out"),
        ("3 onions", "kitchen.txt:1: “3 onions” is read as onion: “3” is left out"),
    ],
)
def test_what_is_not_known_is_said_with_the_nearest_known_words(read, text, note):
    (said,) = read(text).notes
    assert note in said


@pytest.mark.parametrize(
    ("text", "inside"),
    [
        ("bowl {chopped onion, tomato}", ["onion(chopped)@bowl", "tomato@bowl"]),
        ("shaker {salt}", []),  # it is sold so
        ("bowl {onion}\nonion, chopped in bowl", []),  # that is the one
        ('[{"label": "bowl", "ingredients": ["onion"]}]', ["onion@bowl"]),
    ],
)
def test_what_a_vessel_holds_is_there_in_it_in_the_state_that_is_said(read, text, inside):
    kitchen = read(text).kitchen
    assert list(kitchen.inside) == [node(food) for food in inside]
    assert (kitchen.foods_named is None) is ("in bowl" not in text)
    assert read(text).notes == ()


def test_known_things_need_no_note(read):
    assert read("knife\nonion, chopped\nsalt in shaker\n").notes == ()


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("kitchen.txt", "# nothing\n\n", "kitchen.txt: it names nothing"),
        ("kitchen.txt", "onion\n , \n", "kitchen.txt:2: a thing without a name"),
        ("kitchen.json", '{"foods": [\n"onion",]}', "kitchen.json:2: not JSON"),
        ("kitchen.json", '{"food": ["onion"]}', "kitchen.json: nobody asks for the field “food”"),
        ("kitchen.json", '{"foods": "onion"}', "kitchen.json: “foods” should be a list"),
        ("kitchen.json", '{"foods": [{"state": "whole"}]}', "foods[0]: the field “label” is missing"),
        ("kitchen.json", '[{"label": "bowl", "count": 0}]', "[0]: “count” should be at least 1, found 0"),
        ("kitchen.json", "[7]", "kitchen.json: [0]: expected a JSON object"),
        ("kitchen.json", '{"foods": []}', "kitchen.json: it names nothing"),
    ],
)
def test_a_file_that_cannot_be_read_is_refused_with_its_place(read, name, text, message):
    with pytest.raises(ReadError) as refused:
        read(text, name)
    assert message in refused.value.message
    assert refused.value.hint


def test_a_file_that_is_not_there_or_no_text_is_refused(tmp_path):
    (tmp_path / "photo").write_bytes(b"\xff\xd8\xff")
    for name, message in (("nowhere", "there is no file"), ("photo", "not UTF-8"), (".", "kitchen")):
        with pytest.raises(FoonError, match=message if name != "." else str(tmp_path)) as refused:
            read_kitchen(tmp_path / name, WORDS)
        assert refused.value.hint


def test_a_thing_or_a_list_that_is_too_long_is_refused_at_once(read):
    with pytest.raises(ReadError, match=r"kitchen\.txt:2: a thing of 300000 characters; 300 are the most"):
        read("onion\n" + "a " * 149_999 + "aa")
    with pytest.raises(ReadError, match="more than 1000 things"):
        read("glorp\n" * 100_000)
