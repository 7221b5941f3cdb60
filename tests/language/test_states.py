import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.loaders import read_paths
from foon_kg.model.errors import ReadError
from foon_kg.model.recent import MOST_WORDS
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.state_classes import STATES_VARIABLE, state_classes
from foon_kg.similarity.states import state_class, state_in
from foon_kg.store.snapshot import Snapshot

SHARED = Path(__file__).parents[3] / "shared" / "data"


def test_there_are_twelve_classes():
    assert len(set(state_classes().class_of.values())) == 12


@pytest.mark.parametrize(
    ("state", "expected"),
    [
        ("whole", "raw or whole"),
        ("peeled", "cleaned or peeled"),
        ("sliced", "coarsely separated"),
        ("choppped", "coarsely separated"),
        ("minced", "finely separated"),
        ("Grated", "finely separated"),
        ("ground", "powder"),
        ("mashed", "soft mass"),
        ("juice", "liquid"),
        ("beaten", "mixed"),
        ("fried", "cooked"),
        ("dried", "kept"),
        ("wrapped", "shaped or dressed"),
        ("preheated", "of a vessel or device"),
    ],
)
def test_a_listed_state_is_certainly_in_its_class(state, expected):
    assert state_class(state) == (expected, 1)


@pytest.mark.parametrize(
    ("state", "expected"),
    [
        ("finely cubed", "finely separated"),
        ("coarsely grated", "coarsely separated"),
        ("cut into cubes", "coarsely separated"),
        ("quickly fried", "cooked"),
        ("hand-torn", "coarsely separated"),
        ("in pieces", "coarsely separated"),
        ("with [rind]", "of a vessel or device"),
        ("attached to [blender]", "of a vessel or device"),
        ("covered [pot lid]", "shaped or dressed"),
    ],
)
def test_an_unseen_state_is_placed_by_its_words(state, expected):
    name, confidence = state_class(state)
    assert name == expected
    assert 0.5 < confidence < 1


@pytest.mark.parametrize(
    ("phrase", "said"),
    [
        ("roughly chopped", "chopped"),
        ("finely chopped", "finely chopped"),
        ("cut into thin strips", "cut"),
        ("torn into bite-size pieces", "torn"),
        ("bay leaves", "leaf"),
        ("at room temperature", None),
        ("", None),
    ],
)
def test_the_state_in_a_phrase_is_what_was_done(phrase, said):
    assert state_in(phrase) == said


@given(st.text(max_size=20))
def test_any_word_has_a_class_with_a_confidence(text):
    name, confidence = state_class(text)
    assert name in state_classes().class_of.values()
    assert 0 < confidence <= 1


def test_a_word_that_nobody_knows_is_placed_with_little_confidence():
    assert state_class("frobbed")[1] < 0.3


def test_guesses_are_kept_up_to_a_limit():
    classes = state_classes()
    for number in range(MOST_WORDS + 10):
        classes.place(f"chopped {number}")
    assert len(classes._placed) == MOST_WORDS


def test_the_classes_can_be_replaced_by_a_file(tmp_path, monkeypatch):
    table = json.loads(
        (Path(__file__).parents[2] / "foon_kg" / "similarity" / "states.json").read_text(encoding="utf-8")
    )
    table["classes"][0]["states"].append("frobbed")
    own = tmp_path / "states.json"
    own.write_text(json.dumps(table), encoding="utf-8")
    monkeypatch.setenv(STATES_VARIABLE, str(own))
    assert state_class("frobbed") == ("raw or whole", 1)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "[" * 100_000,
        '{"classes": []}',
        '{"classes": [{"name": 1}]}',
        '{"classes": [{"name": "whole", "states": [5]}]}',
    ],
)
def test_a_broken_table_of_classes_is_said(tmp_path, monkeypatch, text):
    own = tmp_path / "states.json"
    own.write_text(text, encoding="utf-8")
    monkeypatch.setenv(STATES_VARIABLE, str(own))
    with pytest.raises(ReadError, match=r"states\.json"):
        state_class("chopped")


@pytest.mark.shared_data
def test_every_state_of_the_public_foon_and_recipes_is_listed():
    if not SHARED.is_dir():
        pytest.skip(f"the public data are not at {SHARED}")
    results = read_paths([SHARED / "foon-111" / "TXT"])
    subgraphs = [result.subgraph for result in results if result.subgraph is not None]
    vocabulary = Snapshot.of(subgraphs, Kitchen.default()).vocabulary()
    asked = {
        row["state"]
        for path in (SHARED / "queries").glob("*/*.json")
        for row in json.loads(path.read_text(encoding="utf-8"))["ingredients"]
    }
    seen = {row.state for row in vocabulary.foods if row.state and "[" not in row.state}
    assert seen
    assert sorted(state for state in seen | asked if state_class(state)[1] < 1) == []
