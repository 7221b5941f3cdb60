"""For what of the dish a food is, is asked alike on every way on which a recipe comes in."""

from __future__ import annotations

import json

import pytest

from foon_kg.model.collected import CalledFor
from foon_kg.planning.recipes import IngredientWords, read_recipe
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.recipes import StoredRecipe
from foon_kg.store.snapshot import Snapshot

WORDS = IngredientWords(Snapshot.of((), Kitchen.default()).vocabulary(), Kitchen.default())


@pytest.mark.parametrize(
    ("line", "food", "part"),
    [
        ("powdered sugar, for the glaze", "powdered sugar", "glaze"),
        ("lemon wedges to serve", "lemon wedges", "serving"),
        ("flour", "flour", ""),
    ],
)
def test_a_recipe_of_the_graph_a_file_and_words_ask_for_the_same_part(tmp_path, line, food, part):
    (stored,) = StoredRecipe("r1", "Cake", (), (CalledFor(food, "", f"1 cup {line}"),)).asked("cake").ingredients
    path = tmp_path / "cake.json"
    more = {"part": part} if part else {}
    path.write_text(json.dumps({"type": "cake", "ingredients": [{"object": food, "state": ""} | more]}))
    (filed,) = read_recipe(path, WORDS).recipe.ingredients
    spoken, _ = WORDS.read(line)
    assert stored.part == filed.part == spoken.part == part
