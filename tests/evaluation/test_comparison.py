"""What got better and worse between two evaluations, and when that is more than chance."""

from __future__ import annotations

import json

import pytest

from foon_kg.evaluation.comparison import compare, earlier_evaluation, shares_of
from foon_kg.model.errors import ReadError, UsageError


def shares(*values):
    return {(f"recipe {number:02}", "salad"): value for number, value in enumerate(values)}


def test_the_same_evaluation_changed_nothing():
    found = compare(shares(0.5, 1.0), shares(0.5, 1.0), seed=0)
    assert (found.verdict, found.better, found.worse) == ("nothing changed", (), ())


@pytest.mark.parametrize(("step", "verdict"), [(0.1, "better"), (-0.1, "worse")])
def test_a_change_of_every_recipe_is_more_than_chance(step, verdict):
    found = compare(shares(*[0.5] * 20), shares(*[0.5 + step] * 20), seed=0)
    assert found.verdict == f"{verdict}, and more than chance"
    assert found.difference.mean == pytest.approx(step)


def test_as_much_up_as_down_is_chance():
    found = compare(shares(*[0.5] * 20), shares(*[0.4, 0.6] * 10), seed=0)
    assert found.verdict == "no more than chance"
    assert (len(found.better), len(found.worse)) == (10, 10)


def test_the_greatest_changes_come_first_and_what_only_one_asked_is_named():
    before, after = shares(0.1, 0.9, 0.9, 0.5), {**shares(0.2, 0.6, 1.0), ("new", "soup"): 1.0}
    found = compare(before, after, seed=0)
    assert [change.name for change in found.better] == ["recipe 00", "recipe 02"]
    assert [change.name for change in found.worse] == ["recipe 01"]
    assert (found.gone, found.new) == (("recipe 03",), ("new",))


def test_nothing_in_common_is_no_change():
    assert compare(shares(0.5), {}, seed=0).verdict == "nothing changed"


def test_what_is_printed_is_read_back(tmp_path):
    value = {"evaluation": "recipes", "recipes": [{"id": "one", "dish_type": "salad", "correct": 0.75}]}
    path = tmp_path / "old.json"
    path.write_text(json.dumps(value))
    assert shares_of(earlier_evaluation(path, "recipes").value, str(path)) == {("one", "salad"): 0.75}


@pytest.mark.parametrize(
    ("text", "said"),
    [("{\n,}", ":2: not JSON"), ("[]", "expected a JSON object"), ("{}", "“evaluation” is missing"), ("\xff", "UTF-8")],
)
def test_what_is_no_evaluation_is_refused_by_file(tmp_path, text, said):
    path = tmp_path / "old.json"
    path.write_bytes(text.encode("latin-1"))
    with pytest.raises(ReadError, match=said):
        earlier_evaluation(path, "recipes")


def test_one_kind_is_not_compared_with_the_other(tmp_path):
    path = tmp_path / "old.json"
    path.write_text('{"evaluation": "leave-one-out"}')
    with pytest.raises(UsageError, match="not of recipes"):
        earlier_evaluation(path, "recipes")
