"""For what of a dish a recipe says that a food is: "for dusting", "to serve", or the heading above it."""

from __future__ import annotations

import re

from foon_kg.food.lists import word_list

_USE = re.compile(r"[,(]?\s*(?<!more )\b(?:for|to) (?:the |an? )?(?P<words>[a-z][a-z -]*)\)?", re.IGNORECASE)
_USES = {"serve": "serving", "garnish": "garnish", "finish": "finishing", "decorate": "garnish"}
"""What is said with "to", and for what a food is then."""


def without_part(text: str) -> tuple[str, str]:
    """Return a line without the words that say for what its food is, and for what; ``""`` where it says nothing.

    >>> without_part("powdered sugar, for the glaze"), without_part("lemon wedges to serve"), without_part("1 egg")
    (('powdered sugar', 'glaze'), ('lemon wedges', 'serving'), ('1 egg', ''))
    """
    for use in _USE.finditer(text):
        said = use["words"].lower().split()
        found = next((word for word in said if word in _named()), _USES.get(said[0], ""))
        if found:
            return f"{text[: use.start()]}{text[use.end() :]}".strip(), found
    return text, ""


def heading_part(text: str) -> str:
    """Return the part of a dish that a heading names; ``""`` where it names none.

    >>> heading_part("For the lemon glaze:")
    'glaze'
    """
    return next((word for word in reversed(re.findall(r"[a-z]+", text.lower())) if word in _named()), "")


def _named() -> frozenset[str]:
    return word_list("parts of a dish") | word_list("says what a food is for")
