import json
import subprocess
import sys
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from foon_kg.model.errors import UsageError
from foon_kg.model.knowledge import UNLIKE
from foon_kg.model.names import canonical
from foon_kg.similarity import Neighbour, cosine_similarity, food_similarity, spacy_similarity
from foon_kg.similarity.evidence import KINDS
from foon_kg.similarity.forms import plain
from foon_kg.similarity.groups import food_groups
from foon_kg.similarity.taxonomy import food_taxonomy
from foon_kg.similarity.vectors import food_vectors

KNOWN = [
    "onion", "garlic", "green olive", "parsley", "olive oil", "butter", "black pepper", "chili pepper", "sugar",
    "vanilla extract", "lemon extract", "chicken broth", "cheddar", "salmon", "milk", "soy sauce", "lettuce", "walnut",
    "rice", "potato salad", "flour mixture",
]  # fmt: skip

foods = st.sampled_from([*KNOWN, "caper", "leek", "stock", "hoisin sauce", "xyzzy", "", "Käse", "prunes"])


@pytest.mark.parametrize(
    ("wanted", "expected"),
    [
        ("caper", "green olive"),
        ("leek", "onion"),
        ("oil", "olive oil"),
        ("pepper", "black pepper"),
        ("extract", "vanilla extract"),
        ("stock", "chicken broth"),
        ("cheese", "cheddar"),
        ("cod", "salmon"),
        ("brown sugar", "sugar"),
        ("margarine", "butter"),
        ("pecans", "walnut"),
        ("tamari", "soy sauce"),
    ],
)
def test_a_cook_would_take_the_nearest(wanted, expected):
    nearest = food_similarity().nearest(wanted, KNOWN, limit=1)[0]
    assert nearest.name == expected
    assert nearest.confidence > 0.5


def test_the_raw_cosine_takes_capers_for_parsley_as_the_paper_does_and_the_default_does_not():
    assert cosine_similarity().nearest("caper", KNOWN, limit=1)[0].name == "parsley"
    assert food_similarity().nearest("caper", KNOWN, limit=1)[0].name == "green olive"


@pytest.mark.parametrize("strange", ["xyzzy", "", "42", "qwert zuiop", "печень"])
def test_nothing_is_like_a_word_that_nobody_knows(strange):
    assert food_similarity().nearest(strange, KNOWN, limit=len(KNOWN)) == ()
    assert not food_similarity().matrix([strange], KNOWN).any()


@pytest.mark.parametrize(
    ("wanted", "known", "others"),
    [
        ("bacon piece", "bacon", ["bread", "salmon"]),
        ("garlic", "garlic powder", ["cayenne pepper", "green olive", "clove"]),
        ("icing", "frosting", ["ice", "sugar"]),
        ("broccoli florets", "broccoli", ["flower", "cabbage"]),
        ("chicken pieces", "chicken", ["turkey", "beef"]),
        ("onion", "onion powder", ["cayenne pepper", "curry powder"]),
    ],
)
def test_a_piece_or_another_form_of_a_food_is_nearer_than_another_food(wanted, known, others):
    row = dict(zip([known, *others], food_similarity().matrix([wanted], [known, *others])[0], strict=True))
    assert row[known] > 0.5
    assert row[known] > max(row[other] for other in others)


@pytest.mark.parametrize(("name", "read"), [
    ("bacon piece", "bacon"), ("fresh basil leaf", "basil"), ("bouillon cube", "bouillon cube"), ("piece", "piece"),
    ("grape leaf", "grape leaf"), ("baby spinach", "baby spinach"),
])  # fmt: skip
def test_names_are_read_without_words_for_pieces_unless_the_whole_is_another_thing(name, read):
    assert plain(name, food_groups().places) == read


@given(foods, st.sampled_from(["piece", "slice", "chunk"]))
def test_a_piece_of_a_food_is_like_what_the_food_is_like(food, piece):
    name = canonical(food)
    assume(name and food_groups().places.get(f"{name} {piece}") is None)
    others = [other for other in KNOWN if canonical(other) != name]
    np.testing.assert_array_equal(
        food_similarity().matrix([f"{name} {piece}"], others), food_similarity().matrix([name], others)
    )


def test_the_same_food_is_certain_and_nothing_else_is():
    row = food_similarity().matrix(["Soy  Sauces"], [*KNOWN, "soya sauce", "dark soy sauce"])[0]
    certain = {name for name, value in zip([*KNOWN, "soya sauce", "dark soy sauce"], row, strict=True) if value == 1}
    assert certain == {"soy sauce", "soya sauce"}


def test_a_prepared_dish_is_no_stand_in_for_its_ingredient():
    row = food_similarity().matrix(["sweet potato"], ["potato", "potato salad"])[0]
    assert row[0] > 0.5 > row[1]


@given(st.lists(foods, max_size=6), st.lists(foods, max_size=6))
def test_every_similarity_answers_probabilities_and_certainty_only_for_one_food(wanted, known):
    for similarity in (food_similarity(), cosine_similarity()):
        matrix = similarity.matrix(wanted, known)
        assert matrix.shape == (len(wanted), len(known))
        assert ((matrix >= 0) & (matrix <= 1)).all()
        if similarity is food_similarity():
            assert ((matrix == 0) | (matrix >= UNLIKE)).all()
        for row, one in enumerate(wanted):
            for column, other in enumerate(known):
                assert (canonical(one) != canonical(other)) or matrix[row, column] == 1


@given(st.lists(foods, min_size=1, max_size=6, unique=True), foods)
def test_an_answer_does_not_depend_on_what_else_is_asked(known, name):
    similarity = food_similarity()
    alone = [float(similarity.matrix([name], [other])[0, 0]) for other in known]
    together = similarity.matrix([*KNOWN, name], known)[-1]
    np.testing.assert_allclose(together, alone, atol=2e-6)


@given(st.lists(foods, min_size=1, max_size=8, unique=True), foods, st.integers(0, 9))
def test_nearest_is_the_sorted_row_with_ties_by_name(known, name, limit):
    row = food_similarity().matrix([name], known)[0]
    expected = sorted((-float(value), other) for value, other in zip(row, known, strict=True) if value > 0)[:limit]
    assert food_similarity().nearest(name, known, limit=limit) == tuple(Neighbour(n, -v) for v, n in expected)


@given(st.permutations(KNOWN))
def test_nearest_does_not_depend_on_the_order_of_the_known(known):
    assert food_similarity().nearest("caper", known) == food_similarity().nearest("caper", KNOWN)


def test_rows_that_were_forgotten_are_answered_again_alike(monkeypatch):
    names = [*KNOWN, "caper", "leek", "stock"]
    at_once = food_similarity().matrix(names, KNOWN)
    monkeypatch.setattr("foon_kg.similarity.food._REMEMBERED", 2)
    for start in range(0, len(names), 5):
        some = food_similarity().matrix(names[start : start + 5], KNOWN)
        np.testing.assert_allclose(some, at_once[start : start + 5], atol=2e-6)


def test_a_strange_food_is_placed_by_its_last_words_or_its_neighbours():
    similarity = food_similarity()
    assert similarity.nearest("organic baby lettuce hearts of salinas lettuce", KNOWN, limit=1)[0].name == "lettuce"
    assert "fingerling onion" not in food_groups().places
    assert similarity.nearest("fingerling onion", KNOWN, limit=1)[0].name == "onion"


def test_the_reasons_are_told_and_the_same_food_needs_none():
    assert food_similarity().why("prawn", "shrimps") == ("the same food",)
    reasons = food_similarity().why("caper", "green olive")
    assert any("pickled and briny" in reason for reason in reasons)


def test_the_weights_that_ship_speak_of_every_kind_of_evidence():
    path = Path(__file__).parents[2] / "foon_kg" / "similarity" / "similarity.json"
    assert tuple(json.loads(path.read_text(encoding="utf-8"))["weights"]) == KINDS


def test_the_food_vectors_are_the_mean_of_their_words():
    vectors = food_vectors()
    places = [vectors.places["soy"], vectors.places["sauc"]]
    mean = vectors.vectors[places].mean(axis=0)
    np.testing.assert_allclose(vectors.embed(["soy sauce"])[0], mean / np.linalg.norm(mean))


def test_the_taxonomy_speaks_in_canonical_names():
    assert [word for word in food_taxonomy().meanings if canonical(word) != word] == []


def test_every_listed_food_is_in_a_group():
    assert (food_groups().listed.sum(axis=1) > 0).all()


def test_neither_spacy_nor_the_recipe_parser_is_imported_unasked():
    program = (
        "import sys, foon_kg.similarity as s; s.food_similarity().nearest('caper', ['olive']); print(*sys.modules)"
    )
    modules = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout.split()
    assert {"spacy", "nltk", "ingredient_parser", "pandas", "scipy"}.isdisjoint(modules)


def test_vectors_of_a_pipeline_that_is_not_there_are_a_usage_error_that_says_what_to_do():
    with pytest.raises(UsageError) as caught:
        spacy_similarity("no_such_pipeline")
    assert caught.value.hint


def test_a_spacy_pipeline_answers_the_cosine_of_its_vectors(tmp_path):
    spacy = pytest.importorskip("spacy", reason="the extra 'vectors' is not installed: pip install 'foon-kg[vectors]'")
    pipeline = spacy.blank("en")
    for word, vector in {"caper": (1, 0), "olive": (3, 4), "brick": (-1, 0)}.items():
        pipeline.vocab.set_vector(word, np.array(vector, dtype=np.float32))
    pipeline.to_disk(tmp_path / "tiny")
    row = spacy_similarity(str(tmp_path / "tiny")).matrix(["caper"], ["olive", "brick", "xyzzy", "capers"])[0]
    np.testing.assert_allclose(row, [0.6, 0, 0, 1], atol=1e-6)


def test_a_spacy_pipeline_without_vectors_is_a_usage_error(tmp_path):
    spacy = pytest.importorskip("spacy", reason="the extra 'vectors' is not installed: pip install 'foon-kg[vectors]'")
    spacy.blank("en").to_disk(tmp_path / "empty")
    with pytest.raises(UsageError, match="no word vectors"):
        spacy_similarity(str(tmp_path / "empty"))


@pytest.mark.slow
def test_memory_does_not_grow_with_how_many_names_are_asked():
    similarity, known = food_similarity(), ("egg", "onion", "grated cheddar")
    similarity.matrix(["leek"], known)
    peaks = []
    for count in (1_500, 6_000):
        names = [f"food {count} {number}" for number in range(count)]
        tracemalloc.start()
        similarity.matrix(names, known)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 2 * peaks[0]
