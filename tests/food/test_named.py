"""The table of what titles ask to be done: every row names what is there, and a title is read by its words."""

from __future__ import annotations

import pytest

from foon_kg.food import tables
from foon_kg.food.lists import word_lists
from foon_kg.food.named import named_by
from foon_kg.food.shipped import shipped
from foon_kg.food.techniques import works

FOODS = tables().foods
ROWS = shipped("named")["named"]


def asked(title, dish_type, *foods):
    return [said for _, said in named_by(title, dish_type, [(food, FOODS.food(food)) for food in foods])]


@pytest.mark.parametrize("name", ROWS)
def test_a_row_names_only_what_the_tables_know(name):
    row = ROWS[name]
    assert row["called"]
    assert row["by"]
    assert row.get("when", "") in {"", "before", "done", "heat"}
    assert ("stage" in row) == ("at" in row)
    assert row.get("stage", "stir") in works()
    assert row.get("at", "last") in {"before", "done", "heat", "last"}
    traits = {trait for kind in FOODS.kinds.values() for trait in kind.traits}
    for text in (*row.get("of", ()), *row.get("without", ()), *row.get("fills", ())):
        for term in (term.lstrip("!") for term in text.split("&")):
            assert term in FOODS.kinds or term in traits or term.removeprefix("@") in word_lists(), term


@pytest.mark.parametrize(
    ("title", "dish_type", "foods", "said"),
    [
        ("Pineapple Upside-Down Cake", "cake", ("flour",), ["upside down"]),
        ("Jam Thumbprints", "cookie", ("flour",), ["thumbprint"]),
        ("Thumbprint Rolls", "bread", ("flour",), []),
        ("Pulled Pork", "pork", ("pork shoulder",), ["pulled"]),
        ("Pulled Pork", "pork", ("ham",), []),
        ("Grilled Cheese", "sandwich", ("bread",), []),
        ("Frozen Yogurt Pie", "pie", ("yogurt",), ["frozen"]),
        ("Frozen Yogurt Pie", "pie", ("frozen yogurt",), []),
        ("Tomato Soup", "soup", ("tomato",), []),
        ("Baked Meatballs", "meatball", ("ground beef",), ["baked"]),
        ("Beer Can Chicken", "chicken", ("chicken",), ["beer can"]),
    ],
)
def test_a_title_asks_for_what_its_words_say(title, dish_type, foods, said):
    assert asked(title, dish_type, *foods) == said


@pytest.mark.parametrize(
    ("title", "to_be"),
    [("Char siu bao", True), ("Rava idli", True), ("Baked siopao", False), ("Chicken momos", False)],
)
def test_dishes_of_a_family_are_asked_to_be_steamed(title, to_be):
    found = named_by(title, "bread", [("flour", FOODS.food("flour"))])
    assert any("steam" in one.by for one, _ in found) is to_be
