"""What is told of a plan beside the plan itself, field by field, as docs/reference/result.md says."""

from __future__ import annotations

import pytest

from foon_kg.foon import Explanation, Joining
from foon_kg.model import RequiredIngredient
from foon_kg.web.plan_answer import explanation_to_json
from foon_kg.web.telling_plans import ExplanationTold

LEEK = RequiredIngredient("leek", "sliced")
POURED = {"motion": "pour", "like": "onion", "likeness": 0.83, "left_open": ()}


@pytest.mark.parametrize(
    ("joins", "told"),
    [
        (None, None),
        (Joining(None, "pour", "onion", 0.83), POURED),
        (Joining(4, "pour", "onion", 0.83), POURED | {"step": 4}),
    ],
)
def test_where_a_food_joins_is_told_only_where_it_does(joins, told):
    explained = explanation_to_json(Explanation(LEEK, "made", "leek", joins=joins))
    assert explained.get("joins") == told
    assert None not in {**explained, **explained.get("joins", {})}.values()
    assert set(explained) - {"joins"} == set(ExplanationTold.model_json_schema()["required"])
    ExplanationTold.model_validate(explained)
