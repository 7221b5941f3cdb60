"""Units of other languages in the lines of recipes: "2 msk sugar" is read as "2 tablespoons sugar"."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache

from foon_kg.food.shipped import shipped

_NUMBER = r"(?:(?a:\d{1,4})[ -])?(?a:\d{1,4})?[½¼¾⅓⅔⅛]|(?a:\d{1,4}) (?a:\d{1,3})/(?a:\d{1,3})|(?a:\d{1,4})(?:[.,/](?a:\d{1,3}))?"


def with_english_units(line: str) -> str:
    """Return a ``line`` in which a unit of another language behind a number is said in English.

    >>> with_english_units("2 msk sugar"), with_english_units("1,5 dl milk"), with_english_units("2 eggs")
    ('2 tablespoons sugar', '150 ml milk', '2 eggs')
    """
    if not line[:1].isnumeric():
        return line
    found = _unit().match(line)
    if found is None:
        return line
    english, times = _english()[found["unit"].lower()]
    return f"{_times(found['number'], times)} {english} {line[found.end() :]}"


def _times(number: str, times: int) -> str:
    """Return a ``number`` of a line so many ``times``, with a point for a comma; each of two where it is a range."""
    number = number.replace(",", ".").replace("–", "-")
    if times == 1:
        return number
    return _AMOUNT.sub(lambda one: f"{float(sum(map(_fraction, one[0].split()))) * times:g}", number)


def _fraction(number: str) -> Fraction:
    return _HALVES.get(number) or Fraction(number)


_HALVES = {one: Fraction(text) for one, text in zip("½¼¾⅓⅔⅛", ("1/2", "1/4", "3/4", "1/3", "2/3", "1/8"), strict=True)}
_AMOUNT = re.compile(r"(?a:(?:\d+ )?\d+/\d+|(?:\d+ )?[½¼¾⅓⅔⅛]|\d+(?:\.\d+)?)")


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
    number = rf"(?P<number>(?:{_NUMBER})(?: ?[-–] ?(?:{_NUMBER}))?)"
    return re.compile(rf"{number} ?(?P<unit>{names})\.? +(?:(?:{of})(?: +|['’]))?(?=\w)", re.IGNORECASE)
