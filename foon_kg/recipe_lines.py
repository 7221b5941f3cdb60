"""Ingredient lines as cookbooks have them: "2 cups finely chopped red onion" → red onion, finely chopped, 2 cups.

Read by ingredient-parser-nlp (the extra ``recipes``), a model trained on 81,000 lines. It wants NLTK's tagger of parts
of speech, which must be downloaded; a small one of our own in the same form (``data/nltk_data``: word endings and the
commonest words) stands in its place, so that nothing is fetched and every machine reads alike.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from importlib.resources import files
from typing import Any

from foon_kg.errors import UsageError
from foon_kg.names import canonical
from foon_kg.similarity.groups import food_groups
from foon_kg.states import state_in

_REMEMBERED = 100_000
_NUMBER = re.compile(r"(?a:(?:\d{1,4} )?[1-9]\d{0,3}/[1-9]\d{0,3}|[1-9]\d{0,3})(?= [a-z])")
_PHRASE = re.compile(r",|;|\band\b|\bthen\b|\(|\)", re.IGNORECASE)


@dataclass(frozen=True)
class RecipeLine:
    """What one line asks for. ``text`` is the line as written; what was not understood of it is in ``left_over``.

    ``object`` is ``None`` where the line names no food (a heading); ``others`` are further foods that it names, in its
    place ("sugar or honey") or beside it ("salt and pepper"). ``state`` is the last thing done to the food, ``""``
    where the line says nothing of it; ``states`` are all of them in their order. ``quantity`` ("2", "3/2", "2-3") and
    ``unit`` are ``""`` where there is none. ``confidence`` is the model's, from 0 to 1, for the food.
    """

    text: str
    object: str | None
    state: str = ""
    states: tuple[str, ...] = ()
    quantity: str = ""
    unit: str = ""
    others: tuple[str, ...] = ()
    left_over: tuple[str, ...] = ()
    confidence: float = 0.0


def read_recipe_lines(lines: Iterable[str]) -> tuple[RecipeLine, ...]:
    """Answer what each of ``lines`` asks for, in their order; a line that comes again costs nothing.

    No line is lost: one that cannot be read is answered with ``object=None`` and all of it in ``left_over``. Raises
    ``UsageError`` where the extra ``recipes`` is not installed.
    """
    return tuple(_read(line) for line in lines)


def _read(line: str) -> RecipeLine:
    """Read a line, or find one again that differs only in its number: cookbooks have "2 cups sugar" in every amount."""
    text = " ".join(line.split())
    number = _NUMBER.match(text)
    if number is None:
        return replace(_parse(text), text=line)
    quantity = sum(map(Fraction, number[0].split()), Fraction(0))
    stand_in = "1" if quantity == 1 else "2"  # units are written in the singular after 1 alone
    answer = _parse(stand_in + text[number.end() :])
    if answer.quantity != stand_in:
        return replace(_parse(text), text=line)
    return replace(answer, text=line, quantity=str(quantity))


@lru_cache(maxsize=_REMEMBERED)
def _parse(text: str) -> RecipeLine:
    if not any(letter.isalpha() for letter in text):
        return RecipeLine(text, None, left_over=(text,) if text else ())
    parsed = _parser()(text, string_units=True)
    if not parsed.name:
        return RecipeLine(text, None, left_over=(text,))
    quantity, unit = _amount(parsed.amount[0]) if parsed.amount else ("", "")
    name, preparation = parsed.name[0].text, _text(parsed.preparation)
    if f"{preparation} {name}" in text and _is_another_food(preparation, name):
        name, preparation = f"{preparation} {name}", ""
    in_name, name = _split_name(name)
    prepared, unread = _states_of(preparation)
    remarks = [_text(part) for part in (parsed.comment, parsed.purpose) if part]
    states = tuple(dict.fromkeys((*in_name, *prepared)))
    return RecipeLine(
        text,
        name,
        state=states[-1] if states else "",
        states=states,
        quantity=quantity,
        unit=unit,
        others=tuple(_split_name(other.text)[1] for other in parsed.name[1:]),
        left_over=(*unread, *remarks, *(part.text for part in parsed.amount[1:])),
        confidence=round(float(parsed.name[0].confidence), 4),
    )


def _amount(amount: Any) -> tuple[str, str]:  # noqa: ANN401 - the package's own class, which mypy does not know
    if not hasattr(amount, "quantity"):  # "1 cup plus 2 tablespoons" is several amounts in one
        return str(amount.text), ""
    least, most = str(amount.quantity or ""), str(amount.quantity_max or "")
    return least if most in {"", least} else f"{least}-{most}", str(amount.unit or "")


def _split_name(text: str) -> tuple[tuple[str, ...], str]:
    """Split states off the front of a name: "frozen chopped spinach"; "ground beef" and "white rice" stay whole."""
    words = text.replace(",", " ").split()
    states = []
    while len(words) > 1 and (state := _state_before(words[0], " ".join(words[1:]))):
        states.append(state)
        words = words[1:]
    return tuple(states), " ".join(words)


def _state_before(word: str, food: str) -> str | None:
    is_food = canonical(word) in food_groups().places  # "bean" is a state of the FOON, but not in "bean sprout"
    return None if is_food or _is_another_food(word, food) else state_in(word)


def _is_another_food(state: str, food: str) -> bool:
    """Whether the word for a state makes another food: ground beef is used as no beef is, diced tomato as tomatoes."""
    groups = food_groups()
    return not set(groups.of(canonical(f"{state} {food}"))) <= set(groups.of(canonical(food)))


def _states_of(preparation: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    phrases = [phrase.strip() for phrase in _PHRASE.split(preparation) if phrase.strip()]
    read = [(phrase, state_in(phrase)) for phrase in phrases]
    states = tuple(state for _, state in read if state is not None)
    return states, tuple(phrase for phrase, state in read if state is None)


def _text(part: Any) -> str:  # noqa: ANN401 - the package's own class, which mypy does not know
    return str(part.text) if part else ""


@lru_cache(maxsize=1)
def _parser() -> Callable[..., Any]:
    try:
        import nltk.data  # noqa: PLC0415 - a second of import, only when lines are read

        nltk.data.path.insert(0, str(files("foon_kg.data").joinpath("nltk_data")))
        from ingredient_parser import parse_ingredient  # noqa: PLC0415 - the same
    except ImportError as error:
        hint = "pip install 'foon-kg[recipes]'"
        raise UsageError("ingredient-parser-nlp is not installed.", hint=hint, code="recipes") from error
    return parse_ingredient
