"""Fields of JSON documents: numbers that nothing can reckon with are refused by name."""

import pytest

from foon_kg.model.errors import ReadError
from foon_kg.model.json_fields import Fields


@pytest.mark.parametrize("value", [10**400, -(10**400), float("nan"), float("inf"), True, "2"])
def test_what_no_float_holds_is_no_number(value):
    with pytest.raises(ReadError, match=r"plan\.json: “confidence” should be a number"):
        Fields({"confidence": value}, "plan.json").number("confidence")


def test_a_number_too_large_is_no_text_either():
    with pytest.raises(ReadError, match="“amount” should be text"):
        Fields({"amount": 10**400}, "recipe.json").text_or_number("amount")


def test_a_number_as_text_has_no_needless_digits():
    assert Fields({"amount": 2.0}, "recipe.json").text_or_number("amount") == "2"
