"""Ingredient lines as cookbooks have them: "2 cups finely chopped red onion" → red onion, finely chopped, 2 cups.

Plain lines are read by rules (``foon_kg.language.plain_lines``), all others by ingredient-parser-nlp (the extra
``recipes``), a model trained on 81,000 lines. It wants NLTK's tagger of parts of speech, which must be downloaded; a
small one of our own in the same form stands in its place (``nltk_data`` beside this module: word endings and the
commonest words), so that nothing is fetched and every machine reads alike.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from importlib.resources import files
from importlib.util import find_spec
from typing import Any, Self

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.food.told_states import asked_state
from foon_kg.food.words import without_heading
from foon_kg.language.foreign_units import with_english_units
from foon_kg.language.line_words import RecipeLine, as_bought, is_another_food, split_name, states_of
from foon_kg.language.plain_lines import read_quickly
from foon_kg.language.several_foods import with_all_foods, without_mere_states
from foon_kg.model.copies import copies
from foon_kg.model.errors import FoonError, UsageError

__all__ = ["LineReader", "RecipeLine", "read_fully", "read_quickly", "read_recipe_lines"]

_REMEMBERED = 20_000
_MANY = 200  # lines for the parser: a second of work, which starting a process costs as well
_AT_ONCE = 32
_READY = "foon_kg.language.parser_ready"
_NUMBER = re.compile(r"(?a:(?:\d{1,4} )?[1-9]\d{0,3}/[1-9]\d{0,3}|[1-9]\d{0,3})(?= [a-z])")
_HALF = re.compile(r"\b(?:half|1/2|\u00bd) (?:of )?an? (?!dozen)(?=[a-z])", re.IGNORECASE)
_PRESSED_FROM = re.compile(r"\b(juice|zest) (?:from|out of) (?=[a-z\d\u00bc-\u00be])", re.IGNORECASE)
_NAAN = re.compile(r"\bnan\b", re.IGNORECASE)
"""The bread in the spelling that is also a word for what is no number: the parser stumbles over it."""

_ASIDE = re.compile(r" \((?:[^()]|\([^()]*\))*\)?")
"""What stands in brackets, which may have brackets in them, or lack the second one."""


def read_recipe_lines(lines: Iterable[str]) -> tuple[RecipeLine, ...]:
    """Return what each of ``lines`` asks for, in their order; a line that comes again costs nothing.

    No line is lost: one that cannot be read is answered with ``object=None`` and all of it in ``left_over``. Raises
    ``UsageError`` where a line is not plain and the extra ``recipes`` is not installed.
    """
    return tuple(map(_read, lines))


class LineReader:
    """Reads the lines of whole collections as :func:`read_recipe_lines` does, on ``jobs`` cores, and remembers them.

    The processes start with the first lines that are many and not plain. Close it, or use it in a ``with`` statement.
    """

    def __init__(self, jobs: int = 1) -> None:
        self._jobs = jobs
        self._pool: ProcessPoolExecutor | None = None
        self._known: dict[str, RecipeLine] = {}

    def read(self, lines: Sequence[str]) -> tuple[RecipeLine, ...]:
        """Return what each of ``lines`` asks for, in their order.

        Raises ``UsageError`` where the extra ``recipes`` is missing, ``FoonError`` where a process was ended.
        """
        if len(self._known) > _REMEMBERED:
            self._known.clear()
        new = [line for line in dict.fromkeys(lines) if line not in self._known]
        found = {line: answer for line in new if (answer := read_quickly(line)) is not None}
        left = [line for line in new if line not in found]
        self._known.update(found)
        self._known.update(zip(left, self._read_fully(left), strict=True))
        return tuple(self._known[line] for line in lines)

    def _read_fully(self, lines: Sequence[str]) -> Iterable[RecipeLine]:
        if self._jobs == 1 or len(lines) < _MANY:
            return map(read_fully, lines)
        _require_parser()  # so that a missing extra is told here, not by a process
        if self._pool is None:
            self._pool = ProcessPoolExecutor(self._jobs, mp_context=copies(_READY))
        try:
            return list(self._pool.map(read_fully, lines, chunksize=_AT_ONCE))
        except BrokenProcessPool as error:
            hint = "Read them with one job, or give the processes more memory."
            raise FoonError("a process that read recipe lines was ended from outside", hint=hint) from error

    def close(self) -> None:
        """End the processes."""
        if self._pool is not None:
            self._pool.shutdown(cancel_futures=True)
            self._pool = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@lru_cache(maxsize=_REMEMBERED)
def _read(line: str) -> RecipeLine:
    return read_quickly(line) or read_fully(line)


def read_fully(line: str) -> RecipeLine:
    """Return what the parser reads in a line. One that differs only in its number from an earlier one costs little."""
    text = _HALF.sub("1/2 ", _NAAN.sub("naan", " ".join(line.split())))
    text = with_english_units(without_heading(_PRESSED_FROM.sub(r"\1 of ", text))[0])
    text = _portions().sub(" ", text, count=1)
    number = _NUMBER.match(text)
    if number is None:
        return replace(_parse(text), text=line)
    quantity = sum(map(Fraction, number[0].split()), Fraction(0))
    stand_in = "1" if quantity == 1 else "2"  # units are written in the singular after 1 alone
    answer = _parse(stand_in + text[number.end() :])
    if answer.quantity != stand_in:
        return replace(_parse(text), text=line)
    return replace(answer, text=line, quantity=str(quantity))


@lru_cache(maxsize=1)
def _portions() -> re.Pattern[str]:
    """Return what finds a portion as it is sold behind its number: nests of noodles."""
    return re.compile(rf"(?<=\d) (?:{'|'.join(sorted(word_list('is a portion as it is sold')))}) (?:of )?(?=\w)")


_A_LITTLE = re.compile(
    r"(?:an? )?(dash|drizzle|few|glug|handful|knob|pat|sleeve|splash|sprinkle|sprinkling|squeeze)(?: of)? (?=\w)",
    re.IGNORECASE,
)
"""So a little of a food is called, in front of its name; of what is squeezed it is the juice."""


@lru_cache(maxsize=_REMEMBERED)
def _parse(text: str) -> RecipeLine:
    parsed = _parsed(text)
    if parsed is None:
        return RecipeLine(text, None, left_over=(text,) if text else ())
    quantity, unit = _amount(parsed.amount[0]) if parsed.amount else ("", "")
    front, names = without_mere_states([name.text for name in parsed.name])
    name, preparation = _with_its_front(names[0], _text(parsed.preparation), text)
    in_name, name = split_name(name)
    prepared, unread = states_of(preparation)
    name, asides = _without_asides(name)
    squeezed, name = _without_a_little(name)
    remarks = [_text(part) for part in (parsed.comment, parsed.purpose) if part]
    remarks += asides
    states = tuple(dict.fromkeys((*front, *in_name, *prepared, *squeezed)))
    answer = RecipeLine(
        text,
        name,
        state=asked_state(states, tables()),
        states=states,
        quantity=quantity,
        unit=unit,
        size=_text(parsed.size),
        others=tuple(split_name(other)[1] for other in names[1:]),
        left_over=(*unread, *remarks, *(part.text for part in parsed.amount[1:])),
        confidence=round(float(parsed.name[0].confidence), 4),
    )
    return with_all_foods(as_bought(answer, in_name), text, names[1:], preparation)


def _parsed(text: str) -> Any | None:  # noqa: ANN401 - the package's own class, which mypy does not know
    """Return what the parser makes of a text; ``None`` where it finds no food in it."""
    if not any(letter.isalpha() for letter in text):
        return None
    try:
        parsed = _parser()(text, string_units=True)
    except (ArithmeticError, ValueError):  # it takes "inf" and "1/0" for numbers
        return None
    return parsed if parsed.name else None


def _with_its_front(name: str, preparation: str, text: str) -> tuple[str, str]:
    """Return a name with what the parser took for a preparation and makes another food of it, and what is left.

    Ground beef is no beef that is ground.
    """
    before, _, after = preparation.partition(", ")
    if f"{before} {name}" in text and is_another_food(before, name):
        return f"{before} {name}", after
    return name, preparation


def _without_asides(name: str) -> tuple[str, list[str]]:
    """Return a ``name`` without what stands in brackets, and this: of "glutinous (sweet) rice" the rice stays."""
    return " ".join(_ASIDE.sub(" ", name).split()), [aside.strip() for aside in _ASIDE.findall(name)]


def _without_a_little(name: str) -> tuple[tuple[str, ...], str]:
    """Return the states that "a squeeze of" tells, and the name behind such words."""
    few = _A_LITTLE.match(name)
    if few is None:
        return (), name
    return ("juice",) if few[1].lower() == "squeeze" else (), name[few.end() :]


def _amount(amount: Any) -> tuple[str, str]:  # noqa: ANN401 - the package's own class, which mypy does not know
    if not hasattr(amount, "quantity"):  # "1 cup plus 2 tablespoons" is several amounts in one
        return str(amount.text), ""
    least, most = str(amount.quantity or ""), str(amount.quantity_max or "")
    return least if most in {"", least} else f"{least}-{most}", str(amount.unit or "")


def _text(part: Any) -> str:  # noqa: ANN401 - the package's own class, which mypy does not know
    return str(part.text) if part else ""


def _require_parser() -> None:
    """Raise UsageError where the parser is not installed, without the 120 MB that importing it takes."""
    if find_spec("ingredient_parser") is None or find_spec("nltk") is None:
        raise _missing_parser()


@lru_cache(maxsize=1)
def _parser() -> Callable[..., Any]:
    try:
        import nltk.data  # noqa: PLC0415 - a second of import, only when lines are read

        nltk.data.path.insert(0, str(files("foon_kg.language").joinpath("nltk_data")))
        from ingredient_parser import parse_ingredient  # noqa: PLC0415 - the same
    except ImportError as error:
        raise _missing_parser() from error
    return parse_ingredient


def _missing_parser() -> UsageError:
    hint = "pip install 'foon-kg[recipes]'"
    return UsageError("such lines need ingredient-parser-nlp, which is not installed", hint=hint, code="recipes")
