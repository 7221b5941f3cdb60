"""A sentence of a recipe without what is no action and no food: amounts, times, temperatures, distances, remarks.

"Bake 20 minutes at 180 °C" bakes no minutes. What is left is what is done and to what; :mod:`clauses` goes on with it.
"""

from __future__ import annotations

import re
from functools import cache

from foon_kg.food.lists import word_list


def plain_speech(text: str) -> str:
    """Return ``text`` without its figures and remarks in brackets.

    >>> plain_speech("Stir 90 grams plus 2 tablespoons flour into the butter (it foams).")
    'Stir flour into the butter.'
    >>> plain_speech("Bake for 10 to 15 minutes at 180 °C or until golden.")
    'Bake until golden.'
    """
    for pattern, instead in _patterns():
        text = pattern.sub(instead, text)
    return text.strip()


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    """Return what is taken out of a sentence, in its order: the longer phrases first."""
    numbers = _any_of("numbers in speech")
    number = rf"(?:\d[\dO]*(?:[.,/\u2044]\d+)?(?:\s+\d+[/\u2044]\d+)?\s*[½¼¾⅓⅔⅛]?|[½¼¾⅓⅔⅛]|\b(?:{numbers})\b)"
    several = rf"{number}(?:\s*(?:-|\u2013|to|or)\s*{number})?"
    dot = r"(?:\.(?=\s+(?-i:[a-z])))?"
    about = rf"(?:\b(?:{_any_of('about so much')})\s+)*"
    amount = rf"{about}{several}\s*-?\s*(?:{_any_of('units of food')})\b{dot}"
    spans = rf"(?:{_any_of('units of time')})\b{dot}"
    after = r"(?:\s+(?:longer|more|each|per side|on each side|or so|or more|apart))*"
    lengths = rf"(?:{_any_of('units of length')})\b{dot}"
    where = _any_of("says where a length goes")
    level = rf"(?:{_any_of('levels of heat')})"
    heat = r"(?:\W+(?:heat|flame|speed|power|setting))?\b"
    left = _any_of("goes on by itself when left to it")
    boil = r"\bbring\s+((?:[\w-]+\s+){0,8}?)(?:back\s+)?to\s+(?:an?\s+|the\s+)?(?:[\w-]+\s+)?(boil|simmer)\b"
    nouns = _any_of("verbs that are given")
    rows = (
        (boil, r"\2 \1"),
        (rf"\bgive\s+((?:the\s+)?[\w-]+(?:\s+all)?)\s+an?\s+(?:[\w-]+\s+)?({nouns})\b", r"\2 \1"),
        (r"\bbring\s+((?:[\w-]+\s+){1,4}?)together\b", r"combine \1"),
        (rf"\b(juice|zest)\s+(?:of|from)\s+(?:(?:an?|the|half|of|{number})\s+)*([a-z]+?)s?\b", r"\2 \1"),
        (rf"\b(?:let|allow to)\s+(?=(?:{left})\b)", ""),
        (rf"(?:,\s*)?\b(?:{_any_of('asides in speech')})\b", ""),
        (r"\([^()]*\)?|[)\]\[*]", " "),
        (r"(?<=s)['\u2019](?=\s)", ""),
        (r"\b(?:a little|a bit of|a lot of|plenty of|some)\s+(?=\w)", ""),
        (rf"(?:,\s*)?(?:\b(?:for|after|every|within|in)\s+)?{about}{several}\s*-?\s*(?:more\s+)?{spans}{after}", ""),
        (r"\b(?:for|over)?\s*overnight\b|(?:,\s*)?\b(?:for|after)\s+(?:a|some)\s+(?:while|time)\b", ""),
        (rf"\b(?:to|at|of)?\s*{about}{several}\s*(?:[°º]|degrees?)\s*(?:(?:c|f|celsius|fahrenheit)\b)?(?=\W|$)", ""),
        (rf"\b(?:to|at)\s+{about}\d+\s*[cf]\b", ""),
        (rf"\b(?:over|on|at|to|with)\s+(?:an?\s+)?(?:very\s+)?{level}(?:\W+(?:to\s+)?{level})*{heat}", ""),
        (rf"\b(?:{_any_of('says how warm')})\b[ -]?", ""),
        (rf"{about}{several}\s+(?:full|of the way(?:\s+full)?)\b", ""),
        (rf"\b(?:to|into)\s+{about}{several}[ -]?{lengths}(?:[ -](?:{where})\b)+", ""),
        (rf"{about}{several}[ -]?{lengths}(?:[ -](?:{where})\b)*", ""),
        (rf"\b(?:of\s+)?{amount}(?=\s*(?:[,;!]|\.(?!\s*(?-i:[a-z]))|$|each\b|apiece\b))", ""),
        (rf"\b{amount}(?:\s*(?:plus|and|\+)\s*{amount})*(?:\s+of\b)?(?:\s+(?=the\b))?", ""),
        (r"\bor\s+(?=until\b|till\b)", ""),
        (r"(?:,\s*)?\band\s+then\s+(?=(?:the|an?|your)\b)", " and "),
        (rf"\b(?:of|{_any_of('about so much')}|for|at|plus)\s*(?=[,.;!]|$)", ""),
        (r"\s+(?=[,.;!?])", ""),
        (r",(?=[.;!?]|$)|,(?=\s*,)", ""),
        (r"\s{2,}", " "),
    )
    return tuple((re.compile(pattern, re.IGNORECASE), instead) for pattern, instead in rows)


def _any_of(name: str) -> str:
    """Return a pattern for any phrase of a list of words, the longest first."""
    phrases = sorted(word_list(name), key=lambda phrase: (-len(phrase), phrase))
    return "|".join(re.escape(phrase).replace(r"\ ", r"\s+") for phrase in phrases)
