"""A draft under review: what is asked, what each decision makes of the table, and that nothing else of it changes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.language.reviewing import Review
from foon_kg.loaders.draft_tables import read_draft
from foon_kg.model.errors import ReadError, UsageError

HEADER = "start,end,motion,inputs,outputs,dish,confidence,doubt,said,source\n"
ROWS = (
    "0:01,0:04,peel,onion on cutting board; knife,onion (peeled) on cutting board,,0.90,sure of it,“peel it”,a.mp4\n",
    "0:05,,chop,onion (peeled) on cutting board; knife,onion (chopped) on cutting board,,0.05,a | b,“chop it”,a.mp4\n",
    ",,pick-and-place,onion (chopped) on cutting board; xyzzy (empty),onion (chopped) in xyzzy; xyzzy {onion},,.8,,,\n",
    ",,pour,salt; xyzzy {onion},salt in xyzzy; xyzzy {onion; salt},,0.8,,,\n",
    ",,,,,,0.00,no motion,“wow”,a.mp4\n",
    ",,mix,bowl {egg},omelette (mixed) {egg} in bowl,omelette,0.9,,,\n",
)
DRAFT = HEADER + "".join(ROWS)


def asked(review):
    return [(one.place, [reason.kind for reason in one.reasons]) for one in review.decisions]


def test_what_is_asked():
    review = Review.of(DRAFT, "a")
    assert asked(review) == [
        (1, ["doubt", "doubt"]),
        (2, ["from nowhere", "unknown"]),
        (4, ["no unit"]),
        (5, ["from nowhere"]),
    ]
    assert review.units == 5
    assert [reason.text for reason in review.decisions[0].reasons] == ["a", "b"]
    assert (review.decisions[0].moment, review.decisions[0].start) == ("0:05", 5.0)


def test_a_word_that_was_accepted_is_not_asked_about_again():
    review = Review.of(DRAFT, "a").accepted(2)
    assert 3 not in [place for place, _ in asked(review)]
    told = Review.of(review.text(), "a")
    assert asked(told) == asked(review), "the table is all that is kept"


@given(st.lists(st.tuples(st.integers(0, 5), st.sampled_from(["accept", "drop"])), max_size=8))
def test_decisions_change_their_row_and_no_other(steps):
    review, expected = Review.of(DRAFT, "a"), [dict(row) for row in Review.of(DRAFT, "a").rows]
    for place, what in steps:
        if place >= len(expected):
            with pytest.raises(UsageError, match=f"there is no row {place}"):
                review.accepted(place)
            continue
        if what == "drop" or not expected[place]["motion"]:
            review = review.dropped(place)
            del expected[place]
        else:
            review = review.accepted(place)
            expected[place] |= {"doubt": "", "reviewed": "yes"}
        assert [dict(row) for row in review.rows] == expected
        assert Review.of(review.text(), "a") == review


def test_what_is_decided_is_what_the_command_accept_takes(tmp_path):
    review = Review.of(DRAFT, "a")
    while review.decisions:
        review = review.accepted(review.decisions[0].place)
    (tmp_path / "a.csv").write_text(review.text())
    draft = read_draft(tmp_path / "a.csv")
    assert draft.subgraph == review.subgraph()
    assert len(draft.rows) == 5
    assert [row.doubts for row in draft.rows if row.confidence < 0.5] == [()]


def test_an_edit_is_a_unit_or_refused():
    review = Review.of(DRAFT, "a")
    edited = review.edited(4, {"motion": "add", "inputs": "salt;\n egg", "outputs": "egg {salt}"})
    assert edited.rows[4]["inputs"] == "salt; egg"
    assert (edited.rows[4]["confidence"], edited.rows[4]["doubt"], edited.rows[4]["reviewed"]) == ("", "", "yes")
    assert edited.units == 6
    for cells in ({"motion": ""}, {"inputs": "(("}, {"outputs": ""}, {"dish": "stew of stews"}):
        with pytest.raises(UsageError):
            review.edited(1, cells)
    with pytest.raises(UsageError, match="a unit has no doubt"):
        review.edited(1, {"doubt": "x"})


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no table of units"),
        ("a,b\n1,2\n", "no table of units"),
        (HEADER + '"', "no table"),
        ("video,start,end,motion,inputs,outputs\n1,,,chop,a,b\n2,,,chop,a,b\n", "several videos"),
        (HEADER + ",,a,b,c,,,,,\n" * 5_001, "5001 rows"),
    ],
)
def test_what_is_no_draft_is_refused(text, said):
    with pytest.raises(ReadError, match=said):
        Review.of(text, "a")


def test_a_table_without_confidences_is_reviewed_too():
    review = Review.of("start,end,motion,inputs,outputs\n,,chop,onion; knife,onion (chopped)\n,,,,x\n", "a")
    assert asked(review) == [(1, ["no unit"])]
    with pytest.raises(UsageError, match="a has no unit"):
        review.dropped(0).dropped(0).subgraph()
