"""C7 (docs/contract.md): what a tree says of its substitutions, kept and broken clause by clause."""

from __future__ import annotations

import pytest
from validation.handled import FOON, LEEK, entries, sliced
from validation.judging import ONE_TOMATO, found

# --- C7: entries ---


@pytest.mark.parametrize(
    "entry",
    [
        "object (tomato): tomato like bell pepper (0.9); onion (0.8), leek (0.7)",
        "object (tomato): tomato like bell pepper (0.0); nothing",
        "object (tomato): tomato like bell pepper (1.0); nothing",
        'state (tomato): diced like "" (0.5); nothing',
        "motion (tomato): slice like chop (0.5); nothing",
        "tool (tomato): knife like peeler (0.5); nothing",
        "vessel (tomato): plate like bowl (0.5); nothing",
        "tool (leek): knife like peeler (0.5); nothing",
        "vessel (leek): plate like bowl (0.5); nothing",
        "object (leek): tomato like onion (0.5); nothing",
        "object (tomato): tomatoes like peppers (0.5); nothing",
        "object (plates): plate like bowl (0.5); nothing",
    ],
)
def test_c7_an_entry_that_says_everything_of_what_a_step_uses(entry):
    assert found("C7", f"{entries(entry)}\n{ONE_TOMATO}") == []


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        (
            "food (tomato): tomato like onion (0.9); nothing",
            "tomato: tomato for onion (food): its kind is “food”, not object, state, motion, tool, vessel",
        ),
        ('"" (tomato): tomato like onion (0.9); nothing',
         "tomato: tomato for onion (no kind): its kind is “”, not object, state, motion, tool, vessel"),
        (
            'object (tomato): "" like onion (0.9); nothing',
            "nothing for onion (object): it does not say what is required",
        ),
        ("object (tomato): tomato like nothing (0.9); nothing", "tomato for nothing (object): it names no equivalent"),
        (
            "state (tomato): sliced like nothing (0.9); nothing",
            "tomato: sliced for nothing (state): it names no equivalent",
        ),
        ('object (tomato): tomato like "" (0.9); nothing', "tomato for nothing (object): it names no equivalent"),
        (
            "object (tomato): tomato like tomato (0.9); nothing",
            "tomato for tomato (object): the equivalent is what was required",
        ),
        ("object (tomato): tomato like onion; nothing",
         "tomato for onion (object): it has no confidence between 0 and 1"),
        ("object (tomato): tomato like onion (1.1); nothing",
         "tomato for onion (object): it has no confidence between 0 and 1"),
        ("object (tomato): tomato like onion (-0.1); nothing",
         "tomato for onion (object): it has no confidence between 0 and 1"),
        ('object (""): tomato like onion (0.9); nothing', "tomato for onion (object): it does not name its object"),
        ("object (tomato): tomato like onion (0.9)", "tomato for onion (object): it has no list of alternatives"),
        (
            "object (tomato): tomato like onion (0.9); leek (0.8), shallot",
            "tomato for onion (object): an alternative has no name or no confidence",
        ),
        (
            'object (tomato): tomato like onion (0.9); "" (0.8)',
            "tomato for onion (object): an alternative has no name or no confidence",
        ),
    ],
)  # fmt: skip
def test_c7_an_entry_that_leaves_something_out(entry, told):
    assert found("C7", f"{entries(entry)}\n{ONE_TOMATO}") == [f"C7: substitution 0, {told}"]


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        ("object (leek): leek like onion (0.9); nothing", "leek for onion (object)"),
        ("state (leek): diced like sliced (0.9); nothing", "leek: diced for sliced (state)"),
        ("motion (tomato): chop like dice (0.9); nothing", "tomato: chop for dice (motion)"),
        ("motion (slice): chop like dice (0.9); nothing", "slice: chop for dice (motion)"),
        ("tool (leek): grater like peeler (0.9); nothing", "leek: grater for peeler (tool)"),
        ("vessel (leek): cup like glass (0.9); nothing", "leek: cup for glass (vessel)"),
        ("state (leek): knife like sliced (0.9); nothing", "leek: knife for sliced (state)"),
    ],
)
def test_c7_what_no_step_uses_is_not_declared(entry, told):
    assert found("C7", f"{entries(entry)}\n{ONE_TOMATO}") == [f"C7: substitution 0, {told}: no unit uses it"]


def test_c7_a_food_that_only_a_name_in_braces_tells_is_used():
    salted = ONE_TOMATO.replace("{tomato}", "{salts, tomato}")
    assert found("C7", f"{entries('object (salt): salt like sugar (0.5); nothing')}\n{salted}") == []


def test_c7_an_entry_that_is_there_twice():
    assert found("C7", f"{entries(LEEK, LEEK)}\n{ONE_TOMATO}") == [
        "C7: substitution 1, tomato for bell pepper (object), is there twice"
    ]
    other = LEEK.replace("0.9", "0.8")
    assert found("C7", f"{entries(LEEK, other)}\n{ONE_TOMATO}") == []


def test_c7_entries_are_counted_from_0_as_they_stand():
    told = found("C7", f"{entries(LEEK, 'object (leek): leek like onion (0.9); nothing')}\n{ONE_TOMATO}")
    assert told == ["C7: substitution 1, leek for onion (object): no unit uses it"]


def test_c7_a_tree_without_substitutions_declares_nothing_wrong():
    assert found("C7", ONE_TOMATO) == []
    assert found("C7", f"substitution: nothing\n{ONE_TOMATO}") == []


# --- C7: evidence ---


def test_c7_a_step_that_was_seen_with_another_kind_says_what_is_handled_like_what():
    assert found("C7", sliced("tomato", seen="breads 0"), FOON) == [
        "C7 step 1: no substitution says what tomato is handled like"
    ]


@pytest.mark.parametrize(
    "text",
    [
        sliced(seen="tomatoes 0"),
        sliced(seen=""),
        sliced(seen="breads 7"),
        sliced(seen="breads 0", grounding="motion"),
        sliced(seen="breads 0; tomatoes 0"),
        sliced(seen="breads 0", head=entries("object (tomato): tomato like bread (0.9); nothing")),
    ],
)
def test_c7_a_step_whose_evidence_is_near_or_told(text):
    assert found("C7", text, FOON) == []


def test_c7_evidence_is_not_asked_without_a_foon():
    assert found("C7", sliced("tomato", seen="breads 0")) == []


def test_c7_a_food_of_the_same_kind_is_declared_too():
    assert found("C7", sliced("tomatillo", seen="tomatoes 0"), FOON) == [
        "C7 step 1: no substitution says what tomatillo is handled like"
    ]


def test_c7_several_foods_are_told_in_order():
    text = "onion (whole) + leek (whole) + knife → SLICE → onion (sliced) + leek (sliced)\nseen in: breads 0"
    assert found("C7", text, FOON) == ["C7 step 1: no substitution says what leek, onion is handled like"]


def test_c7_a_step_that_only_puts_out_food_handles_nothing_like_it():
    text = "plate (empty) + knife → SLICE → tomato (sliced; on plate)\nseen in: breads 0"
    assert found("C7", text, FOON) == ["C7 step 1: no substitution says what nothing is handled like"]
