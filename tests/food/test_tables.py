"""The tables load, agree with themselves, and know every word of the data."""

from __future__ import annotations

import json
import os
import tomllib
from importlib.resources import files
from pathlib import Path

import pytest

from foon_kg.food import Match, Tables, singular, tables
from foon_kg.food.faults import FOODS, UTENSILS, malformed, unknown_targets, words_twice
from foon_kg.food.lists import word_list, word_lists
from foon_kg.food.unknown import WordKind, unknown_words
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model import DISH_TYPES, ObjectNode
from foon_kg.model.errors import ReadError

SHARED = Path(__file__).resolve().parents[2] / ".." / "shared" / "data"
TABLES = tables()


def table(name):
    return tomllib.loads(files("foon_kg.food").joinpath(f"{name}.toml").read_text(encoding="utf-8"))


def test_the_tables_are_well_formed():
    utensils = table("utensils")
    assert list(malformed(table("foods"), FOODS)) == []
    assert list(malformed({"groups": utensils["groups"]}, UTENSILS)) == []


def test_no_word_stands_in_two_kinds_or_groups():
    assert [*words_twice(table("foods")), *words_twice(table("utensils"))] == []


def test_no_name_is_a_food_and_a_utensil_but_those_that_are():
    assert set(TABLES.foods.kind_of) & set(TABLES.utensils) == {"cooking spray", "wrap"}


def test_every_kind_and_name_that_a_row_uses_is_there():
    assert list(unknown_targets(table("foods"), TABLES.foods.kinds, TABLES.foods.kind_of)) == []


def test_the_kinds_go_in_no_circle():
    for kind, row in TABLES.foods.kinds.items():
        assert not any(kind in TABLES.foods.broader(above) for above in row.of)


def test_what_a_food_is_sold_in_is_a_utensil():
    kinds = TABLES.foods.kinds.values()
    assert {row.sold_in for row in kinds if row.sold_in and TABLES.utensil(row.sold_in) is None} == set()


def test_what_a_food_is_sold_as_is_a_state_of_the_table():
    assert {row.sold_as for row in TABLES.foods.kinds.values()} - {"", *TABLES.states} == set()


def test_what_a_motion_needs_some_utensil_can_do():
    can = {ability for row in TABLES.utensils.values() for ability in row.can}
    rows = (*TABLES.motions.values(), *TABLES.motion_words.values())
    assert {ability for row in rows for tool in row.tools for ability in tool} <= can


def test_the_opposite_of_a_state_is_a_state():
    assert {name for row in TABLES.states.values() for name in row.before} <= set(TABLES.states)


def test_what_defines_a_dish_is_in_the_table_of_foods():
    rows = [needs for dish in TABLES.dishes.values() for needs in dish.needs]
    rows += [needs for needs in TABLES.contains.values() for needs in needs]
    traits = {trait for row in TABLES.foods.kinds.values() for trait in row.traits}
    for name in {name for needs in rows for name in needs}:
        what, _, wanted = name.rpartition(":")
        known = {"kind": TABLES.foods.kinds, "trait": traits, "": TABLES.foods.kind_of}[what]
        assert (wanted if what else singular(wanted)) in known, name


def test_every_list_has_words_in_small_letters():
    for name, words in word_lists().items():
        assert words, name
        assert all(word == word.lower().strip() for word in words)


def test_there_is_no_list_of_another_name():
    with pytest.raises(KeyError):
        word_list("free food")


def guessed(nodes, motions=()):
    """Return the words that the tables know by a part of a name at most; what ends in a known name is known."""
    return [str(word) for word in unknown_words(nodes, motions) if not (word.nearly or " by its ending " in str(word))]


def words_of(folder):
    units = [one.unit for read in read_paths([folder]) if read.subgraph for one in read.subgraph.annotations]
    return [node for unit in units for node in (*unit.input_nodes, *unit.output_nodes)], [u.motion for u in units]


def test_every_word_of_the_demo_is_known():
    assert guessed(*words_of(demo_folder())) == []


def shared(name):
    if not SHARED.is_dir():
        pytest.skip(f"the public data are not at {SHARED}: their words are not looked up")
    return SHARED / name


@pytest.mark.shared_data
def test_every_word_of_the_public_foon_is_known():
    assert guessed(*words_of(shared("foon-111") / "TXT")) == []


@pytest.mark.shared_data
@pytest.mark.parametrize("name", ["queries", "queries-more"])
def test_every_food_and_state_of_the_recipes_is_known(name):
    found = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(shared(name).rglob("*.json"))]
    recipes = [recipe for read in found for recipe in (read if isinstance(read, list) else [read])]
    wanted = [(one["object"], one["state"]) for recipe in recipes for one in recipe["ingredients"] if one["object"]]
    assert len(wanted) > 500
    assert guessed([ObjectNode(food, (state,) if state else ()) for food, state in wanted]) == []


@pytest.mark.shared_data
def test_every_food_that_was_judged_by_hand_is_known():
    judged = json.loads(shared("substitutes.json").read_text(encoding="utf-8"))
    names = {name for food, others in judged.items() for name in (food, *others)}
    assert guessed([ObjectNode(name) for name in sorted(names)]) == []


# --- kinds as a function of states ---


@pytest.mark.parametrize(
    ("food", "states", "kind"),
    [
        ("pepper", ["ground"], "black pepper"),
        ("pepper", ["chopped"], "sweet pepper"),
        ("pepper", ["whole", "veg"], "sweet pepper"),
        ("pepper", [], "black pepper"),
        ("chicken", ["whole"], "whole bird"),
        ("chicken", ["ground"], "minced meat"),
        ("chicken breast", ["whole"], "poultry"),
        ("lemon", ["juice"], "sour juice"),
        ("lemon", ["squeezed"], "remains"),
        ("lemon", ["zest"], "zest"),
        ("corn", ["frozen"], "kernel vegetable"),
        ("corn", ["powder"], "starch"),
        ("bean", ["dried"], "dry pulse"),
        ("bean", ["canned"], "canned pulse"),
        ("tomato", ["thick sauce"], "tomato sauce"),
        ("stick", ["whole veg"], "vegetable stick"),
        ("stick", ["stick"], "butter"),
        ("rib", ["chopped"], "crisp vegetable"),
        ("rib", ["raw"], "meat"),
        ("fat", ["whipped"], "whipped topping"),
        ("tuna", ["raw"], "fish"),
        ("tuna", ["canned"], "ready fish"),
        ("garlic", ["powder"], "ground spice"),
        ("clove", ["minced"], "garlic"),
        ("clove", ["ground"], "ground spice"),
        ("pizza", ["uncooked"], "uncooked dish"),
        ("coconut", ["juice"], "plant milk"),
        ("thinly shaved corn", ["thinly shaved"], "kernel vegetable"),
    ],
)
def test_the_kind_of_a_food_hangs_on_its_states(food, states, kind):
    assert TABLES.foods.food(food, states).kind == kind


@pytest.mark.parametrize(
    ("food", "match", "taken_for"),
    [
        ("Bell Peppers", Match.NAME, "bell pepper"),
        ("red kidney beans", Match.HEAD, "kidney bean"),
        ("cloudyberries", Match.SUFFIX, "berry"),
        ("tomato xyz", Match.PART, "tomato"),
        ("xylocarp", Match.UNKNOWN, ""),
        ("", Match.UNKNOWN, ""),
    ],
)
def test_how_a_name_is_found(food, match, taken_for):
    known = TABLES.foods.food(food)
    assert (known.match, known.taken_for) == (match, taken_for)


@pytest.mark.parametrize(
    ("motion", "does", "source"),
    [
        ("scoop and pour", {"fetch", "move"}, ""),
        ("Stir and Fry", {"fat", "heat"}, "heat"),
        ("remove seeds", {"core"}, ""),
        ("zib", set(), ""),
    ],
)
def test_what_a_motion_does_is_what_its_words_do_or_its_own_row(motion, does, source):
    row = TABLES.motion(motion)
    assert (row.does, row.source) == (does, source)


def test_a_state_of_several_words_is_read_by_them():
    assert TABLES.state("very thinly sliced").earns == {"cut"}
    assert TABLES.state("wobbly").earns == set()


# --- a user's own tables ---


@pytest.fixture
def own(tmp_path, monkeypatch):
    """Read a text as a user's own table of utensils or foods."""

    def read(text: str, variable: str = "FOON_KG_UTENSILS") -> Tables:
        path = tmp_path / "mine.toml"
        path.write_text(text, encoding="utf-8")
        monkeypatch.setenv(variable, str(path))
        return tables()

    return read


WOK = '[groups."my woks"]\nrole = "vessel"\ncan = ["hold", "heat"]\nmany = true\nnames = ["wok2", "karahi"]\n'


def test_a_user_adds_utensils(own):
    mine = own(WOK)
    assert mine.utensil("Karahi").can == {"hold", "heat"}
    assert mine.utensil("pan") is not None
    assert TABLES.utensil("karahi") is None


def test_a_user_adds_foods_and_kinds(own):
    mine = own(
        '[kinds.herb]\nwords = ["xylocarp"]\n'
        '[kinds."space fruit"]\nof = ["fruit"]\nowes = { peel = "fatal" }\nwords = ["moonmelon"]\n'
        '[homonyms.moonmelon]\njuice = "orange juice"\n',
        "FOON_KG_FOODS",
    )
    assert mine.foods.food("xylocarp").is_a("herb")
    assert mine.foods.food("moonmelons").owes["peel"] == "fatal"
    assert mine.foods.food("moonmelon").is_a("fruit")
    assert mine.foods.food("moonmelon", ["juice"]).kind == "juice"
    assert mine.foods.food("basil") is not None


def test_what_a_user_adds_is_no_unknown_word(own):
    nodes = [ObjectNode("karahi", ("empty",))]
    assert [word.kind for word in unknown_words(nodes)] == [WordKind.UTENSIL]
    own(WOK)
    assert unknown_words(nodes) == ()


@pytest.mark.parametrize(
    ("text", "variable", "said"),
    [
        ("nonsense", "FOON_KG_UTENSILS", "cannot be read"),
        ('[groups.x]\nrole = "pot"\nnames = ["a"]', "FOON_KG_UTENSILS", "its role is 'pot'"),
        ('[groups.x]\nrole = "tool"\nsource = "gas"\nnames = ["a"]', "FOON_KG_UTENSILS", "its source is 'gas'"),
        ("nonsense", "FOON_KG_FOODS", "cannot be read"),
        ('[kinds.x]\nowes = { cook = "always" }\nwords = ["a"]', "FOON_KG_FOODS", "“always”"),
    ],
)
def test_a_bad_table_is_refused_with_its_name_and_what_to_do(own, text, variable, said):
    with pytest.raises(ReadError, match=r"mine\.toml") as refused:
        own(text, variable)
    assert said in refused.value.message
    assert "foon_kg/food" in refused.value.hint


def test_a_table_that_is_not_there_is_refused(tmp_path, monkeypatch):
    monkeypatch.setenv("FOON_KG_FOODS", str(tmp_path / "lost.toml"))
    with pytest.raises(ReadError, match=r"lost\.toml"):
        tables()


def test_a_pipe_that_nobody_writes_to_is_refused_and_not_waited_for(tmp_path, monkeypatch):
    os.mkfifo(tmp_path / "pipe.toml")
    monkeypatch.setenv("FOON_KG_FOODS", str(tmp_path / "pipe.toml"))
    with pytest.raises(ReadError, match="it is a pipe"):
        tables()


@pytest.mark.parametrize(
    ("text", "sections", "fault"),
    [
        ("groups = 3", UTENSILS, "“groups” holds no rows"),
        ("[groups]\nx = 3", UTENSILS, "groups “x”: it is no row"),
        ('[groups.x]\nnames = "wok2"', UTENSILS, "groups “x”: “names” is not a list of texts"),
        ("[groups.x]\nnames = [3]", UTENSILS, "groups “x”: “names” is not a list of texts"),
        ("[groups.x]\nmany = 1", UTENSILS, "groups “x”: “many” is not true or false"),
        ('[groups.x]\nname = ["a"]', UTENSILS, "groups “x”: nobody asks for “name” (near it: names)"),
        ('[kinds.x]\nwords = ["a"]', UTENSILS, "nobody asks for “kinds”"),
        ("[kinds.x]\nowes = 3", FOODS, "kinds “x”: “owes” is not a row of texts"),
        ('[foods.x]\nowes = { cook = "x" }', FOODS, "foods “x”: “x” is not one of fatal, minor, advice"),
        ("[homonyms.x]\nground = 3", FOODS, "homonyms “x”: “ground” is not a text"),
    ],
)
def test_what_is_wrong_with_the_form_of_a_table(text, sections, fault):
    assert list(malformed(tomllib.loads(text), sections)) == [fault]


def test_what_a_table_uses_and_nobody_has():
    text = (
        '[kinds.x]\nof = ["fruits"]\nwhen = { dried = "nothing at all" }\n'
        '[foods.xylocarp]\n[homonyms.y]\nground = "blak pepper"\n[plurals.ys]\nfood = "bel pepper"\n[plurals.zs]\n'
    )
    assert list(unknown_targets(tomllib.loads(text), TABLES.foods.kinds, TABLES.foods.kind_of)) == [
        "kinds “x”: there is no kind “fruits” (near it: fruit)",
        "kinds “x”: there is no kind “nothing at all”",
        "foods “xylocarp”: no kind has it among its words",
        "homonyms “y”: there is no food “blak pepper” (near it: black pepper)",
        "plurals “ys”: there is no food “bel pepper” (near it: bell pepper)",
        "plurals “zs”: there is no food “”",
    ]


def test_a_word_in_two_kinds_is_told_and_two_spellings_are_not():
    text = '[kinds.x]\nwords = ["pea", "peas"]\n[kinds.y]\nwords = ["Pea"]\n'
    assert list(words_twice(tomllib.loads(text))) == ["kinds: “pea” stands in 2 of them"]


def test_a_bar_of_chocolate_is_cut_and_what_is_sold_in_pieces_is_not():
    bar, chip = TABLES.foods.food("dark chocolate"), TABLES.foods.food("white chocolate chip")
    assert ("cut" in bar.owes, bar.sold_as) == (True, "bar")
    assert ("cut" in chip.owes, chip.sold_as, chip.is_of("chocolate")) == (False, "pieces", True)


def test_what_a_dish_is_for_does_not_name_it():
    named = [dish.name for dish in tables().dishes_named("sauce", "Peppercorn Sauce for Steak")]
    assert "sauce" in named
    assert "steak" not in named
    assert [dish.name for dish in tables().dishes_named("Steak for Two")] == ["steak"]


def test_a_dish_before_the_name_of_the_type_asks_for_nothing():
    needs = {
        (title, dish.name): dish.needs
        for title in ("Spaghetti-Night Meatballs", "Spaghetti and Meatballs", "Meatball Soup")
        for dish in tables().dishes_named("soup" if "Soup" in title else "meatball", title)
    }
    assert needs["Spaghetti-Night Meatballs", "spaghetti"] == ()
    assert needs["Spaghetti and Meatballs", "spaghetti"]
    assert needs["Meatball Soup", "meatball"]
    assert not [dish for dish in tables().dishes_named("Wacky Cake (No Eggs, No Milk)") if dish.name == "egg"]
    assert [dish.needs for dish in tables().dishes_named("Faux Apple Pie") if dish.name == "apple pie"] == [()]


@pytest.mark.parametrize("title", ["Fish-Fragrant Aubergine", "Chicken-Flavored Noodles", "Egg-Free Mayonnaise"])
def test_a_dish_is_not_what_it_only_tastes_like_or_is_free_of(title):
    assert not {dish.name for dish in tables().dishes_named(title)} & {"fish", "chicken", "egg"}


def test_a_cocktail_of_shrimps_is_no_drink():
    assert [dish.name for dish in tables().dishes_named("seafood", "Shrimp Cocktail")] == ["seafood", "shrimp cocktail"]


@pytest.mark.parametrize(
    ("title", "named"),
    [
        ("Arepas (Venezuelan corn cakes with cheese)", {"arepa"}),
        ("Zorbik (a sweet bread)", {"bread"}),
        ("Spice Cake (the best bread)", {"cake"}),
    ],
)
def test_what_stands_in_brackets_names_a_dish_only_beside_a_name_that_nobody_knows(title, named):
    assert {dish.name for dish in tables().dishes_named(title)} == named


def test_what_is_cooked_and_cut_is_not_only_cut():
    called = tables().state_called
    assert [called(name) for name in ("thin slivers", "raw slices")] == ["slivered", "sliced"]
    assert [called(name) for name in ("cooked slices", "boiled, chopped")] == ["cooked slices", "boiled, chopped"]


def test_each_list_of_what_stays_whole_is_of_a_dish_type():
    types = {name.removeprefix("stays whole in ") for name in word_lists() if name.startswith("stays whole in ")}
    assert types
    assert types <= set(DISH_TYPES)
