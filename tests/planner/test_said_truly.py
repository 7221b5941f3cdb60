"""What an answer says of itself is so: of two alternatives the surer one is never called less sure."""

from __future__ import annotations

from foon_kg.foon import Foon
from foon_kg.foon.demo import demo_folder
from foon_kg.model.names import canonical
from foon_kg.similarity import food_similarity

ASKED = [
    ("salad", ["diced kohlrabi", "chopped leek", "yogurt", "quartered radish"]),
    ("soup", ["chopped parsnip", "diced squash", "chicken stock", "chopped shallot"]),
    ("omelette", ["beaten egg", "sliced chorizo", "grated gouda"]),
    ("drinks", ["almond milk", "sliced mango", "honey"]),
]


def test_no_alternative_that_is_surer_is_called_less_sure():
    said = set()
    with Foon.from_files(demo_folder()) as foon:
        for dish_type, texts in ASKED:
            for one in foon.plan(dish_type, texts).explain():
                for other in one.passed_over:
                    said.add(other.why)
                    assert (other.why == "less sure") == (other.confidence < one.confidence), (one.label, other)
    assert "less sure" in said


def test_the_core_of_a_reference_is_of_the_foods_that_were_asked():
    with Foon.from_files(demo_folder()) as foon:
        for dish_type, texts in ASKED:
            result = foon.plan(dish_type, texts).result
            asked = [canonical(one.object) for one in result.recipe.ingredients]
            likes = food_similarity().matrix(asked, result.reference.core) if result.reference.core else []
            for place, food in enumerate(result.reference.core):
                assert canonical(food) in asked or max(row[place] for row in likes) >= 0.5, food


def test_a_tree_that_tables_order_says_so():
    with Foon.from_files(demo_folder()) as foon:
        plain = foon.plan("salad", ["sliced cucumber", "olive oil"]).result
        sauce = foon.plan("omelette", ["egg", "canned tomatoes", "onion", "cumin"], title="Shakshuka").result
    assert not plain.reference.technique
    assert "technique" not in plain.to_json()["reference"]
    assert sauce.reference.technique
    assert type(sauce).from_json(sauce.to_json()).reference == sauce.reference
