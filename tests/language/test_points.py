"""A point of the vector index bounds the confidence from above, whatever the two names are."""

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from foon_kg.cypher import schema_steps
from foon_kg.model.names import ALIASES_VARIABLE, canonical
from foon_kg.similarity import food_similarity
from foon_kg.similarity.points import LONGEST, POINT_LENGTH, _shared, points, question
from foon_kg.similarity.word_lists import word_lists_key

EVIDENCE = food_similarity().evidence
LISTED = EVIDENCE.food_groups.foods

foods = st.sampled_from(LISTED)
words = st.sampled_from(sorted({word for food in LISTED for word in food.split()}))
made_up = st.lists(words, min_size=1, max_size=3).map(" ".join)
names = st.lists(foods | made_up | st.text(max_size=12), min_size=1, max_size=12)


@pytest.mark.slow
@settings(deadline=None, max_examples=40)
@given(names, names)
def test_no_confidence_exceeds_what_the_cosine_allows(wanted, known):
    confidences = food_similarity().matrix(wanted, known)
    for name, row in zip(wanted, confidences, strict=True):
        about = question(name)
        cosines = np.float32(points(known)) @ np.float32(about.point)
        for other, cosine, confidence in zip(known, cosines.tolist(), row.tolist(), strict=True):
            assert confidence <= about.most(cosine) or canonical(name) == canonical(other)


def test_the_bound_is_narrow():
    """A question about any known food finds its five best among few points, else the index would be of no use."""
    known = LISTED[::6]
    table = np.array(points(known))
    looked_at = []
    for name, row in zip(known, food_similarity().matrix(known, known), strict=True):
        about = question(name)
        most = np.array([about.most(cosine) for cosine in (table @ about.point).tolist()])
        looked_at.append(int((most >= np.sort(row)[-5]).sum()))
    assert np.median(looked_at) < 12


def test_all_points_are_equally_far_from_nothing():
    lengths = np.linalg.norm(points([*LISTED[::9], "", "qwxyz"]), axis=1)
    assert np.allclose(lengths, 1.0, atol=1e-5)


def test_no_word_of_the_lists_is_too_long_for_a_point():
    about = EVIDENCE.about(sorted({*LISTED, *EVIDENCE.taxonomy.meanings}))
    rows = np.c_[_shared(about), about.dish, about.kinds.filled]
    assert np.linalg.norm(rows, axis=1).max() < LONGEST


def test_a_point_is_the_same_in_any_company_and_by_any_name():
    alone = [points([name])[0] for name in LISTED[:40]]
    assert points(LISTED[:40]) == alone
    assert points(["Courgettes"]) == points(["zucchini"])


def test_the_schema_makes_indexes_of_points_of_this_length():
    texts = [step.text for step in schema_steps() if "VECTOR INDEX" in step.text]
    assert texts
    for text in texts:
        assert re.search(r"`vector.dimensions`: (\d+)", text)[1] == str(POINT_LENGTH) == str(len(points(["caper"])[0]))


def test_other_aliases_make_other_points(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    own = tmp_path / "aliases.txt"
    own.write_text("olive = caper\n")
    without = word_lists_key()
    monkeypatch.setenv(ALIASES_VARIABLE, str(own))
    assert word_lists_key() != without
    monkeypatch.delenv(ALIASES_VARIABLE)
    assert word_lists_key() == without
