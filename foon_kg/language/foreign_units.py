"""Units of other languages in the lines of recipes: "2 msk sugar" is read as "2 tablespoons sugar"."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache

from foon_kg.food.shipped import shipped

_HALVES = dict(zip("½¼¾⅓⅔⅛", map(Fraction, ("1/2", "1/4", "3/4", "1/3", "2/3", "1/8")), strict=True))
_APOSTROPHE = "['\N{RIGHT SINGLE QUOTATION MARK}]"
_DASH = "[-\N{EN DASH}]"
_AMOUNT = re.compile(r"(?a:(?:\d{1,4} ?)?[½¼¾⅓⅔⅛]|(?:\d{1,4} )?\d{1,4}/[1-9]\d{0,2}|\d{1,4}(?:[.,]\d{1,3})?)")
"""A number: whole, with a part behind it, or with a point or comma in it."""


def with_english_units(line: str) -> str:
    """Return a ``line`` in which a unit of another language behind a number is said in English.

    >>> with_english_units("2 msk sugar"), with_english_units("1,5 dl milk"), with_english_units("2 eggs")
    ('2 tablespoons sugar', '150 ml milk', '2 eggs')
    """
    if not line[:1].isnumeric():
        return line
    found = _unit().match(line)
    unit = _english().get(found["unit"].lower()) if found is not None else None
    if found is None or unit is None:  # a long s is found as an s
        return line
    english, times = unit
    return f"{_times(found['number'], times)} {english} {line[found.end() :]}"


def _times(number: str, times: int) -> str:
    """Return a ``number`` of a line so many ``times``, with a point for a comma; each of two where it is a range."""
    number = re.sub(_DASH, "-", number.replace(",", "."))
    return number if times == 1 else _AMOUNT.sub(lambda one: f"{float(_value(one[0])) * times:g}", number)


def _value(number: str) -> Fraction:
    """Return what a number is: "1 1/2" and "1½" are one and a half."""
    parts = re.sub(r"([½¼¾⅓⅔⅛])", r" \1", number).split()
    return sum((_HALVES.get(part) or Fraction(part) for part in parts), Fraction(0))


@lru_cache(maxsize=1)
def _english() -> Mapping[str, tuple[str, int]]:
    """Return the English unit of each unit of another language, and how many of it that is."""
    rows = shipped("units")["units"]
    return {name: (unit.strip(), row.get("times", 1)) for unit, row in rows.items() for name in row["names"]}


@lru_cache(maxsize=1)
def _unit() -> re.Pattern[str]:
    """Return what finds a number and a unit of another language in front of a food."""
    names = "|".join(map(re.escape, sorted(_english(), key=lambda name: (-len(name), name))))
    of = "|".join(sorted(shipped("units")["of"]))
    number = rf"(?P<number>{_AMOUNT.pattern}(?: ?{_DASH} ?{_AMOUNT.pattern})?)"
    return re.compile(rf"{number} ?(?P<unit>{names})\.? +(?:(?:{of})(?: +|{_APOSTROPHE}))?(?=\w)", re.IGNORECASE)
