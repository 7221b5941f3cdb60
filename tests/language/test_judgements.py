"""Against what a cook accepts. The figures that count are on halves unseen in fitting: benchmarks/similarity.py."""

import json
from pathlib import Path

import numpy as np
import pytest

from foon_kg.integration.teaching.operators import LIKE_AT_ALL
from foon_kg.loaders import read_paths
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import cosine_similarity, food_similarity
from foon_kg.similarity.in_role import in_role
from foon_kg.store.snapshot import Snapshot

OWN = json.loads((Path(__file__).parent / "data" / "accepted.json").read_text(encoding="utf-8"))
PARTS = ["unseen foods", "recipe words", "judged afterwards", "forms and parts"]
SHARED = Path(__file__).parents[3] / "shared" / "data"


def folded(judged):
    return {canonical(food): set(map(canonical, accepted)) for food, accepted in judged.items()}


def share_right(similarity, judged, known, *, among):
    right = 0
    for food, accepted in judged.items():
        others = [other for other in known if other != food]
        right += any(near.name in accepted for near in similarity.nearest(food, others, limit=among))
    return right / len(judged)


def brier(answers, truth):
    return float(((answers - truth) ** 2).mean())


@pytest.fixture(scope="module")
def known():
    """All foods that any judgement accepts."""
    return sorted({canonical(other) for part in PARTS for a in OWN[part].values() for other in a})


@pytest.mark.parametrize("part", PARTS)
def test_nine_of_ten_foods_get_an_equivalent_that_a_cook_accepts(part, known):
    judged = folded(OWN[part])
    assert share_right(food_similarity(), judged, known, among=1) >= 0.85
    assert share_right(food_similarity(), judged, known, among=3) >= 0.95


@pytest.mark.parametrize("part", PARTS)
def test_the_default_is_better_than_the_raw_cosine(part, known):
    judged = folded(OWN[part])
    cosine = share_right(cosine_similarity(), judged, known, among=1)
    assert share_right(food_similarity(), judged, known, among=1) > cosine + 0.05


def test_a_confidence_above_one_half_is_right_more_often_than_not(known):
    judged = folded(OWN["unseen foods"])
    answers = food_similarity().matrix(list(judged), known)
    truth = np.array([[other in accepted for other in known] for accepted in judged.values()])
    assert truth[(answers > 0.5) & (answers < 0.7)].mean() > 0.35
    assert truth[answers > 0.9].mean() > 0.8
    assert truth[answers < 0.1].mean() < 0.02
    assert brier(answers, truth) < 0.6 * brier(truth.mean(), truth)


@pytest.mark.shared_data
def test_in_a_slot_the_right_food_is_nearest_and_as_many_are_accepted_as_was_said(foon_foods):
    told, first = [], []
    for role, foods in OWN["in a slot"].items():
        for food, accepted in folded(foods).items():
            found = [near for near in in_role(food, foon_foods, role, len(foon_foods)) if near.name != food]
            first.append(found[0].name in accepted)
            told += [(near.confidence, near.name in accepted) for near in found]
    assert sum(first) / len(first) > 0.85
    for low, high in ((0.3, 0.7), (0.7, 0.9), (0.9, 1.0)):
        inside = [(said, was) for said, was in told if low <= said < high]
        said, was = (sum(column) / len(inside) for column in zip(*inside, strict=True))
        assert abs(said - was) < 0.1


def test_of_what_is_told_as_many_are_accepted_as_was_said(known):
    told = []
    for part in PARTS:
        for food, accepted in folded(OWN[part]).items():
            others = [other for other in known if other != food]
            told += [(near.confidence, near.name in accepted) for near in food_similarity().nearest(food, others)]
    for low, high in ((0.1, 0.3), (0.3, 0.5), (0.5, 0.7), (0.7, 0.9), (0.9, 1.0)):
        inside = [(said, was) for said, was in told if low <= said < high]
        said, was = (sum(column) / len(inside) for column in zip(*inside, strict=True))
        assert abs(said - was) < 0.12


@pytest.mark.shared_data
def test_nothing_fair_is_said_of_what_is_no_food(foon_foods):
    nearest = {name: food_similarity().nearest(name, foon_foods, limit=1) for name in OWN["no foods"]}
    assert sum(not found for found in nearest.values()) >= len(nearest) / 2
    assert all(near.confidence < LIKE_AT_ALL for found in nearest.values() for near in found)


@pytest.fixture(scope="module")
def foon_foods():
    folder = SHARED / "foon-111" / "TXT"
    if not folder.is_dir():
        pytest.skip(f"the public data are not at {SHARED}")
    subgraphs = [result.subgraph for result in read_paths([folder]) if result.subgraph is not None]
    vocabulary = Snapshot.of(subgraphs, Kitchen.default()).vocabulary()
    return sorted({canonical(row.label) for row in vocabulary.foods})


@pytest.mark.shared_data
def test_the_public_judgements_are_met_among_all_foods_of_the_public_foon(foon_foods):
    judged = folded(json.loads((SHARED / "substitutes.json").read_text(encoding="utf-8")))
    assert share_right(food_similarity(), judged, foon_foods, among=1) >= 0.9
    assert share_right(food_similarity(), judged, foon_foods, among=3) >= 0.97
    assert share_right(cosine_similarity(), judged, foon_foods, among=1) < 0.8


@pytest.mark.shared_data
def test_every_label_and_recipe_word_of_the_public_data_has_an_answer(foon_foods):
    recipes = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((SHARED / "queries").glob("*/*.json"))]
    words = sorted({row["object"] for recipe in recipes for row in recipe["ingredients"]})
    assert words
    matrix = food_similarity().matrix(words, foon_foods)
    assert matrix.shape == (len(words), len(foon_foods))
    assert np.isfinite(matrix).all()


def test_of_a_name_with_a_word_that_nobody_read_of_food_nothing_is_sure(known):
    similarity = food_similarity()
    for name, accepted in folded(OWN["unknown words"]).items():
        most = similarity.nearest(name, sorted({*known, *accepted}), limit=1)
        assert most == () or most[0].confidence <= 0.6, name
    ketchup = similarity.nearest("zorbo ketchup", ["ketchup", "mayonnaise", "salt"], limit=1)
    assert [near.name for near in ketchup] == ["ketchup"]
    assert (
        similarity.nearest("zorbo ketchup", ["ketchup"])[0].confidence
        < similarity.nearest("tomato ketchup", ["ketchup"])[0].confidence
    )
