"""Plain ingredient lines read by rules, a hundred times as fast as by the trained parser.

A line is plain where every word of it is known: an amount, a unit, a size, what was done, a food of the table of
groups, what else was done, a remark of the usual ones. "2 cups finely chopped red onion" is; a line with a word more is
left to the parser, and so is one that could mean two things. ``benchmarks/similarity_lines.py`` measures how often both
read alike; the spelling of units and the order of states are the parser's.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.food.told_states import asked_state
from foon_kg.language.foreign_units import with_english_units
from foon_kg.language.line_words import RecipeLine, as_bought, is_another_food, split_name, states_of
from foon_kg.language.several_foods import of_one_fruit
from foon_kg.model.names import canonical
from foon_kg.similarity.groups import food_groups
from foon_kg.similarity.state_classes import state_classes

AGREES = 0.99
"""How often the parser reads a plain line just so; the confidence of a line that was read by rules."""

_REMEMBERED = 20_000


def _all(words: str) -> frozenset[str]:
    return frozenset(words.split())


_PACKAGES = {"bag": "bags", "bottle": "bottles", "box": "boxes", "can": "cans"}
_PACKAGES |= {"envelope": "envelopes", "jar": "jars", "package": "packages", "packet": "packets"}
_MANY = _PACKAGES | {"bunch": "bunches", "dash": "dashes", "loaf": "loaves", "pinch": "pinches"}
_UNITS = (
    "clove cup drop gallon gram head kilogram liter milliliter ounce piece pint pound quart rib slice sprig stalk stem "
    "stick tablespoon tbsp teaspoon tsp"
)
_MANY |= {unit: f"{unit}s" for unit in _UNITS.split()} | {unit: unit for unit in ("g", "kg", "ml", "oz")}
_ONE = {many: one for one, many in _MANY.items()} | {one: one for one in _MANY}
_SIZES = _all("small medium large")
_ADVERBS = _all("finely coarsely roughly thinly thickly freshly")
_SORTS = word_list("sorts")
_AS_SOLD = word_list("sold as, in a line")
_SEPARATED = frozenset({"coarsely separated", "finely separated", "powder"})
_DONE = _SEPARATED | {"cleaned or peeled", "soft mass", "liquid", "mixed", "cooked"}
_REMARKS = frozenset({"divided", "or to taste", "or more to taste", "or as needed", "or more as needed"})
_CUT = re.compile(
    r"cut (?:in half|(?:into|in) (?:\d(?:/\d)?[ -]inch |bite-size |bite-sized |thin |small )?"
    r"(?:chunks|cubes|halves|pieces|quarters|rings|slices|strips|wedges))"
)

_NUMBER = r"\d{1,4} [1-9]\d?/[1-9]\d{0,2}|[1-9]\d?/[1-9]\d{0,2}|[1-9]\d{0,3}"
_LINE = re.compile(
    rf"(?:(?P<quantity>{_NUMBER}) )?(?:\((?P<inside>\d{{1,3}}(?:\.\d{{1,2}})?)[ -]ounces?\) )?"
    r"(?P<words>[A-Za-z][A-Za-z' -]*[a-z])(?:, (?P<done>[a-z][a-z0-9/, -]*[a-z]))?(?P<optional> \(optional\))?",
    re.ASCII,
)


_AMOUNT = re.compile(
    rf"(?P<least>\d{{1,3}}\.\d{{1,2}}|{_NUMBER})(?:(?: ?- ?| to | or )(?P<most>\d{{1,3}}\.\d{{1,2}}|{_NUMBER}))?"
    r"(?![\d/.,%-])(?: \([^()]*\))?(?: (?P<unit>[A-Za-z]+)\b)?",
    re.ASCII,
)
_FRACTION = re.compile("[\u00bc-\u00be\u2150-\u215e]")


def amount_in_front(line: str) -> tuple[str, str]:
    """Return quantity and unit with which a line begins, ``""`` for what is not there; written as the parser does.

    >>> amount_in_front("2-3 cups of very good stock")
    ('2-3', 'cups')
    """
    text = line if line.isascii() else unicodedata.normalize("NFKD", _FRACTION.sub(r" \g<0>", line))
    match = _AMOUNT.match(" ".join(text.replace("\u2044", "/").split()))
    if match is None:
        return "", ""
    quantity = _quantity(match["least"], match["most"] or "")
    unit = _ONE.get((match["unit"] or "").lower())
    return quantity, "" if unit is None else unit if quantity == "1" else _MANY[unit]


@lru_cache(maxsize=_REMEMBERED)
def _quantity(least: str, most: str) -> str:
    """Return a quantity, or a range of them; of "1-1/2" the second is the rest of the first."""
    low, high = _sum(least), _sum(most)
    if low < high:
        return f"{low}-{high}"
    return str(low + high if 0 < high < 1 else low)


def _sum(numbers: str | None) -> Fraction:
    """Return the sum of the numbers of a text: of "1 1/2" one and a half, of none nothing."""
    return sum(map(Fraction, (numbers or "").split()), Fraction(0))


def is_measure(word: str) -> bool:
    """Return whether a word counts pieces or measures: clove, stalk, sprig, slice, cup."""
    return word in _ONE


def read_quickly(line: str) -> RecipeLine | None:
    """Return what ``line`` asks for, or ``None`` where a word of it leaves any doubt."""
    match = _LINE.fullmatch(with_english_units(" ".join(line.split())))
    if match is None:
        return None
    quantity = _sum(match["quantity"])
    unit, size, words = _measures(match["words"], quantity)
    food, done = _food(words), _done(match["done"] or "")
    if food is None or done is None or _is_measured_oddly(unit, food[1], match["inside"]):
        return None
    if (unit or size) and not quantity:
        return None
    states = tuple(dict.fromkeys((*food[0], *done[0])))
    answer = RecipeLine(
        line,
        food[1],
        state=asked_state(states, tables()),
        states=states,
        quantity=str(quantity) if quantity else "",
        unit=unit,
        size=size,
        left_over=(*done[1], *_in_brackets(match)),
        confidence=AGREES,
    )
    return of_one_fruit(as_bought(answer, food[0]))


def _is_measured_oddly(unit: str, food: str, inside: str | None) -> bool:
    """Whether a unit may be no unit of a food, cloves being a spice too, or holds nothing that may be ``inside`` it."""
    if unit in {"clove", "cloves"} and canonical(food) != "garlic":
        return True
    return bool(inside) and _ONE.get(unit) not in _PACKAGES


def _in_brackets(match: re.Match[str]) -> Iterator[str]:
    """Yield what the brackets of a line say: that it is optional, and how much is in a package."""
    if match["optional"]:
        yield "(optional)"
    if match["inside"]:
        yield f"{match['inside']} ounce{'' if match['inside'] == '1' else 's'}"


def _measures(words: str, quantity: Fraction) -> tuple[str, str, str]:
    """Take unit and size off the front; a unit is written in the singular after 1 alone, as the parser has it."""
    first, _, rest = words.partition(" ")
    if rest and first in _ONE:
        return (_ONE[first] if quantity == 1 else _MANY[_ONE[first]]), "", rest
    if rest and first in _SIZES:
        return "", first, rest
    return "", "", words


@lru_cache(maxsize=_REMEMBERED)
def _food(words: str) -> tuple[tuple[str, ...], str] | None:
    """Return the states before a food, in the order in which they are told, and the food; ``None`` where in doubt."""
    adverb, _, rest = words.partition(" ")
    if adverb.lower() in _ADVERBS:
        state, _, name = rest.partition(" ")
        return _done_before(f"{adverb} {state}", name)
    if _is_listed(words):
        return split_name(words)
    state, _, name = words.partition(" ")
    if canonical(state) in _AS_SOLD and _is_listed(name):
        return None if split_name(name)[0] else split_name(words)
    return _done_before(state, name)


def _done_before(done: str, name: str) -> tuple[tuple[str, ...], str] | None:
    """Take what was done before the name; where the name has a state of its own, which comes first is in doubt."""
    states, _ = _done(done.lower()) or ((), ())
    food = name.removeprefix("fresh ")
    if not states or not _is_listed(food) or is_another_food(done, name):
        return None
    if canonical(food.partition(" ")[0]) in state_classes().class_of:
        return None
    in_name, _ = split_name(name)
    return (*in_name, *states), food


def _is_listed(name: str) -> bool:
    """Return whether the table lists the name, perhaps less a word for its sort, and no word of it is a measure."""
    sort, _, rest = name.partition(" ")
    listed = food_groups().places
    known = canonical(name) in listed or (sort.lower() in _SORTS and canonical(rest) in listed)
    return known and not (set(name.split()) & (_ONE.keys() | _SIZES | _ADVERBS))


@lru_cache(maxsize=_REMEMBERED)
def _done(text: str) -> tuple[tuple[str, ...], tuple[str, ...]] | None:
    """Return the states and the remarks of a text that has nothing else in it; ``None`` where it says more."""
    states: list[str] = []
    remarks: list[str] = []
    for phrase in re.split(r", and |, | and ", text) if text else ():
        if phrase in _REMARKS:
            remarks.append(phrase)
        elif not remarks and (_CUT.fullmatch(phrase) or _is_state(phrase)):
            states += states_of(phrase)[0]
        else:
            return None
    return tuple(states), tuple(remarks)


def _is_state(phrase: str) -> bool:
    """Return whether a phrase is a state that hands make, with an adverb at most."""
    classes = state_classes()
    adverb, _, state = phrase.rpartition(" ")
    place = classes.class_of.get(canonical(state))
    return place in _DONE and (not adverb or (adverb in _ADVERBS and place in _SEPARATED))
