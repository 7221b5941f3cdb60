"""A person's wishes come before what the similarity says: substitutes that they choose, foods that they avoid."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from planner.dishes import KITCHEN, SETTINGS, questions
from planner.judged import fatal
from planner.test_demo_dishes import SNAPSHOT

from foon_kg.food import tables
from foon_kg.food.shipped import shipped
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.planning.avoidance import kitchen_without, names_avoided, why_avoided, without_avoided
from foon_kg.planning.batch import Cook, Question
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings, Substitute
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot


def recipe(*foods, dish_type="salad"):
    return Recipe(dish_type, tuple(RequiredIngredient(*food) for food in foods))


SALAD = recipe(("kohlrabi", "chopped"), ("tomato", "chopped"), ("olive oil", "liquid"), ("salt", "granulated"))


def plan(asked, *, substitutes=(), avoided=()):
    wishes = replace(SETTINGS, substitutes=tuple(Substitute(*pair) for pair in substitutes), avoided=avoided)
    return Planner(SNAPSHOT, wishes, SNAPSHOT.units).plan(asked)


@pytest.mark.parametrize(
    ("allergen", "foods", "others"),
    [
        ("eggs", ["mayonnaise", "meringue", "eggnog", "doughnut"], ["onion", "white onion", "garden egg", "guacamole"]),
        (
            "gluten",
            [
                "flour",
                "bread",
                "spaghetti",
                "dark soy sauce",
                "wheat starch",
                "rye berries",
                "oat flour",
                "stout",
                "malt vinegar",
                "matzo ball mix",
            ],
            [
                "rice",
                "potato",
                "rice noodle",
                "corn starch",
                "brown rice flour",
                "potato flour",
                "buckwheat flour",
                "tamari",
            ],
        ),
        ("lactose", ["butter", "yogurt", "cheddar", "white sauce"], ["olive oil", "tofu"]),
        ("dairy", ["milk chocolate", "ice cream"], ["unsweetened almond milk", "coconut milk", "sorbet"]),
        ("tree nuts", ["walnut", "marzipan", "almond milk", "nut meal"], ["onion", "sunflower seeds", "tahini"]),
        ("crustaceans", ["shrimp", "crab", "bay shrimp", "prawn cracker"], ["salmon", "mussel"]),
        ("molluscs", ["mussel", "dried squid", "clam juice", "conch"], ["salmon", "shrimp"]),
        ("fish", ["salmon", "worcestershire sauce", "surimi"], ["chicken fillets", "filet mignon"]),
        ("soy", ["tofu", "teriyaki sauce", "miso paste", "natto"], ["broad bean", "paneer", "fish sauce"]),
        ("mustard", ["dijon mustard", "piccalilli"], ["horseradish", "hummus"]),
        ("sesame", ["tahini", "hummus", "gingelly oil", "benne seed"], ["sugar"]),
        ("celery", ["chicken stock", "minestrone"], ["flour", "sugar", "salt"]),
        ("sulphites", ["white wine", "raisins", "balsamic vinegar"], ["grape", "malt vinegar"]),
        ("peanut", ["peanut oil", "satay skewer"], ["walnut", "pea"]),
        ("lupin", ["lupin flour"], ["flour"]),
    ],
)
def test_what_is_made_with_an_allergen_is_left_out(allergen, foods, others):
    assert [food for food in foods if not why_avoided(food, [allergen])] == []
    assert [food for food in others if why_avoided(food, [allergen])] == []
    _, notes = without_avoided(recipe((foods[0], "whole"), ("kohlrabi", "chopped")), (allergen,))
    assert [note.startswith(f"“{foods[0]}” is left out") for note in notes] == [True]


def test_the_fourteen_allergens_of_the_law_have_a_row():
    assert len(shipped("allergens")) == 14
    assert all(set(row) == {"called", "has", "in_names", "lacks"} for row in shipped("allergens").values())


def test_allergens_name_foods_and_kinds_that_the_tables_have():
    foods = tables().foods
    rows = shipped("allergens").items()
    named = [(name, one) for name, row in rows for one in (*row["has"], *row["lacks"])]
    assert [(name, one) for name, one in named if one not in foods.kinds and not foods.is_listed(one)] == []
    assert [name for name, row in rows if not set(row["has"]).isdisjoint(row["lacks"])] == []


@pytest.mark.parametrize("name", ["", " ", "-", "2%", "★"])
def test_a_name_without_a_letter_is_refused_and_avoids_nothing(name):
    assert why_avoided("onion", [name]) is None
    with pytest.raises(UsageError, match="is no food that can be avoided"):
        PlanSettings(avoided=("nuts", name))


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("nutts", "did you mean “nuts”?"),
        ("zzz", "is called “zzz”."),
        ("nuts", None),
        ("kohlrabi", None),
        ("dairy", None),
        ("stone fruits", None),
    ],
)
def test_what_nobody_knows_is_told_and_not_avoided_in_silence(name, said):
    _, notes = without_avoided(SALAD, (name,))
    told = [note for note in notes if "Nothing is left out for it" in note]
    assert [said in note for note in told] == ([True] if said else [])


def test_several_names_in_one_wish_are_several():
    assert PlanSettings(avoided=("walnut, almond and dairy", "half and half")).avoided == (
        "walnut",
        "almond",
        "dairy",
        "half and half",
    )
    with pytest.raises(UsageError, match="is a list"):
        PlanSettings(avoided="walnut")


def objects(result):
    return [s for s in result.substitutions if s.kind == "object"]


def nodes(result):
    return {node for unit in result.units for node in (*unit.input_nodes, *unit.output_nodes)}


def test_a_substitute_is_taken_however_unlike_it_is_and_its_true_likeness_is_told():
    (usual,) = objects(plan(SALAD))
    assert (usual.required, usual.equivalent, usual.confidence) == ("kohlrabi", "carrot", 0.8)
    (chosen,) = objects(plan(SALAD, substitutes=[("kohlrabi", "onion")]))
    assert (chosen.required, chosen.equivalent, chosen.confidence) == ("kohlrabi", "onion", 0.1)
    assert chosen.alternatives[0].name in {"carrot", "potato"}
    assert chosen.alternatives[0].confidence == 0.8


@pytest.mark.parametrize(("food", "told"), [("kohlrabi", False), ("salt", False), ("leek", False)])
def test_a_choice_of_which_the_tree_shows_nothing_is_told(food, told):
    cook = Cook(SNAPSHOT, PlanSettings(substitutes=(Substitute(food, "onion"),)), SNAPSHOT.units)
    notes = cook.answer(Question(given=SALAD)).notes
    assert notes == ((f"no step of this tree handles “{food}” like onion, as was chosen",) if told else ())


def test_a_tree_with_a_chosen_substitute_keeps_the_contract():
    assert fatal(plan(SALAD, substitutes=[("kohlrabi", "onion")]), SNAPSHOT) == []


def test_even_a_food_that_foon_knows_is_handled_like_the_chosen_one():
    result = plan(SALAD, substitutes=[("tomato", "onion")])
    assert ("tomato", "onion", 0.1) in {(s.required, s.equivalent, s.confidence) for s in objects(result)}


def test_a_substitute_for_a_food_that_is_not_asked_for_changes_nothing():
    assert plan(SALAD, substitutes=[("caper", "onion")]).to_json() == plan(SALAD).to_json()


def test_names_of_a_substitute_are_compared_as_all_names_are():
    plural = plan(SALAD, substitutes=[("Tomatoes", "Onions")])
    assert plural.to_json() == plan(SALAD, substitutes=[("tomato", "onion")]).to_json() != plan(SALAD).to_json()


def test_an_unknown_substitute_is_wrong_usage_that_names_words_like_it():
    with pytest.raises(UsageError, match="does not know “tomatto”") as found:
        plan(SALAD, substitutes=[("kohlrabi", "tomatto")])
    assert "tomato" in found.value.hint


def test_two_substitutes_for_one_food_are_wrong_usage():
    with pytest.raises(UsageError, match="two substitutes"):
        plan(SALAD, substitutes=[("tomato", "onion"), ("tomatoes", "carrot")])


def test_an_avoided_food_is_left_out_of_recipe_and_tree():
    result = plan(SALAD, avoided=("tomatoes",))
    assert [wanted.object for wanted in result.recipe.ingredients] == ["kohlrabi", "olive oil", "salt"]
    assert not any(names_avoided(node, ("tomatoes",)) for node in nodes(result))
    assert fatal(result, SNAPSHOT) == []


def test_nothing_left_is_wrong_usage_that_names_what_was_left_out():
    with pytest.raises(UsageError, match="nothing is left of the recipe: “walnut” is left out"):
        plan(recipe(("walnut", "chopped")), avoided=("nuts",))


def test_a_dish_that_is_called_like_an_avoided_food_is_not_made():
    asked = recipe(("carrot", "chopped"), ("salt", "granulated"))
    with pytest.raises(NoTreeError) as found:
        plan(asked, avoided=("salad",))
    assert found.value.code == "avoided"


@pytest.mark.parametrize(
    ("food", "avoided", "reason"),
    [
        ("walnuts", "nuts", "walnut belongs to “nuts”"),
        ("walnut oil", "nut", "walnut belongs to “nuts”"),
        ("mixed nuts", "nuts", "mixed nut belongs to “nuts”"),
        ("cheddar", "dairy", "cheddar belongs to “dairy product”"),
        ("bacon", "pork", "bacon belongs to “pork”"),
        ("red onion", "onion", "red onion belongs to “onions”"),
        ("dragon fruit jam", "dragon fruits", "“dragon fruits” is to be avoided"),
    ],
)
def test_a_food_is_avoided_by_its_words_and_by_its_kinds(food, avoided, reason):
    assert why_avoided(food, (avoided,)) == reason


@pytest.mark.parametrize(
    ("food", "avoided"), [("nutmeg", "nuts"), ("doughnut", "nut"), ("eggplant", "eggs"), ("oil", "olive oil")]
)
def test_a_word_inside_another_is_no_reason(food, avoided):
    assert why_avoided(food, (avoided,)) is None


def test_an_avoided_food_is_not_free_either():
    kitchen = Kitchen.default(["water", "ice"])
    assert kitchen_without(kitchen, ("ice",)).free_foods == {"water"}
    assert kitchen_without(kitchen, ("nuts",)) is kitchen


def test_a_node_that_contains_an_avoided_food_names_it():
    assert names_avoided(ObjectNode("bowl", (), ("walnut",)), ("nuts",))
    assert not names_avoided(ObjectNode("bowl", (), ("onion",)), ("nuts",))


def test_what_is_left_out_is_said():
    kept, notes = without_avoided(recipe(("walnut", "whole"), ("onion", "chopped")), ("nuts",))
    assert kept == recipe(("onion", "chopped"))
    assert notes == ("“walnut” is left out: walnut belongs to “nuts”",)


@settings(max_examples=40, deadline=None)
@given(questions(), st.sampled_from(["onion", "vegetables", "salt", "eggs", "dairy"]))
def test_no_tree_for_any_recipe_has_an_avoided_food(question, avoided):
    subgraphs, asked = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    try:
        result = Planner(snapshot, replace(SETTINGS, avoided=(avoided,))).plan(asked)
    except (NoTreeError, UsageError):
        return
    assert not any(names_avoided(node, (avoided,)) for node in nodes(result))


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(questions(), st.data())
def test_any_choice_of_a_substitute_gives_a_sound_tree_or_a_reason(question, data):
    subgraphs, asked = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    food = data.draw(st.sampled_from(sorted({wanted.object for wanted in asked.ingredients})))
    like = data.draw(st.sampled_from(sorted({row.label for row in snapshot.vocabulary().foods})))
    wishes = replace(SETTINGS, substitutes=(Substitute(food, like),))
    try:
        result = Planner(snapshot, wishes).plan(asked)
    except NoTreeError:
        return
    assert fatal(result, snapshot) == []
    assert all(s.confidence in {0.1, 0.8, 1.0} for s in objects(result))
