"""Recipes of a collection understood: which dish, which foods in which states.

A collection that names the food of a line itself is believed, and only state and amount are read from the line: by the
rules for plain lines, and where it is not plain the state alone, by the words of the state classes around the food. The
parser of recipe lines reads what that leaves, or everything.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from foon_kg.food import tables
from foon_kg.food.dish_classes import dish_classes
from foon_kg.food.lists import word_list
from foon_kg.language.plain_lines import amount_in_front, is_measure
from foon_kg.language.recipe_lines import LineReader, RecipeLine, read_quickly
from foon_kg.model import DISH_TYPES
from foon_kg.model.collected import CalledFor, CollectedLine, CollectedRecipe, DishClass, UnderstoodRecipe
from foon_kg.model.knowledge import Vocabulary
from foon_kg.model.names import canonical
from foon_kg.similarity.states import state_in

READING = 6
"""Counts the ways in which lines were ever understood; a change of the rules below is a new one."""

_REMEMBERED = 50_000
_PATTERNS = 5_000
_IN_BRACKETS = re.compile(r"\([^()]*\)")
_PARTS = word_list("parts of a dish")
"""What cooks call the parts of a dish."""
_BARE = word_list("ends a heading without an amount")
_PHRASE = re.compile(r",|;|\band\b|\bthen\b")


@dataclass
class CollectionReader:
    """Understands recipes for a FOON whose foods go by ``labels`` (see :func:`labels_of`), many lines at a time.

    ``lines`` reads what the collection does not tell itself; with ``full`` every line. Lines come again and again in a
    collection; the last 50,000 different ones are remembered.
    """

    labels: Mapping[str, str]
    lines: LineReader = field(default_factory=LineReader)
    full: bool = False
    _known: dict[CollectedLine, tuple[CalledFor, ...]] = field(default_factory=dict)

    @property
    def version(self) -> str:
        """Names this way of understanding: with another one, what was understood before counts no more."""
        return f"{READING}-{'full' if self.full else 'quick'}"

    def understand(self, recipes: Sequence[CollectedRecipe]) -> tuple[UnderstoodRecipe, ...]:
        """Return what each of ``recipes`` asks for, in their order."""
        self._read(dict.fromkeys(line for recipe in recipes for line in recipe.lines))
        return tuple(map(self._understood, recipes))

    def _understood(self, recipe: CollectedRecipe) -> UnderstoodRecipe:
        bare = bare_headings([line.text for line in recipe.lines])
        read = [
            (line, () if place in bare and not (line.detected or line.quantity) else self._known[line])
            for place, line in enumerate(recipe.lines)
        ]
        return UnderstoodRecipe(
            recipe,
            classes_of(recipe),
            tuple(one for _, called in read for one in called),
            tuple(line.text for line, called in read if not called),
        )

    def _read(self, lines: Mapping[CollectedLine, None]) -> None:
        """Bring ``_known`` to have ``lines``: first what the collection says itself, then all others at one go."""
        if len(self._known) + len(lines) > _REMEMBERED:
            self._known = {line: self._known[line] for line in lines if line in self._known}
        left = []
        for line in [line for line in lines if line not in self._known]:
            called = self._at_once(line)
            if called is None:
                left.append(line)
            else:
                self._known[line] = called
        for line, read in zip(left, self.lines.read([line.text for line in left]), strict=True):
            self._known[line] = tuple(self._as_read(line, read))

    def _at_once(self, line: CollectedLine) -> tuple[CalledFor, ...] | None:
        """Return what a line calls for without reading it, nothing for a heading; ``None`` where it has to be read."""
        if not line.is_readable or (not line.detected and is_heading(line.text)):
            return ()
        called = self._without_parser(line)
        return None if called is None else (called,)

    def _as_read(self, line: CollectedLine, read: RecipeLine) -> Iterator[CalledFor]:
        """Yield what a line calls for as it was ``read``; what the collection says itself holds for the first food."""
        told, quantity, unit = line.state or "", line.quantity, line.unit
        for one in read.foods:
            food = self._label(one.object or "")
            if food:
                yield CalledFor(food, told or one.state, line.text, quantity or one.quantity, unit or one.unit)
            told, quantity, unit = "", "", ""

    def _without_parser(self, line: CollectedLine) -> CalledFor | None:
        """Return what a line calls for by what the collection says itself; ``None`` leaves it to the parser."""
        parsed_anyway = self.full and line.text and not line.state
        return None if parsed_anyway else self._as_told(line)

    def _as_told(self, line: CollectedLine) -> CalledFor | None:
        """Return the food that the collection names with what the line says of it; ``None`` where it names none."""
        food = (line.detected or "").strip()
        if not food:
            return None
        if line.state:
            return CalledFor(self._label(food), line.state, line.text, line.quantity, line.unit)
        plain = read_quickly(line.text)
        state = plain.state if plain else state_beside(food, line.text)
        if state is None:
            return None
        read = (plain.quantity, plain.unit) if plain else amount_in_front(line.text)
        amount = (line.quantity, line.unit) if line.quantity else read
        return CalledFor(self._label(food), state, line.text, *amount)

    def _label(self, food: str) -> str:
        """Return what the FOON calls a food; cloves of garlic are garlic, where it has no name for cloves."""
        name = canonical(food)
        whole, _, last = name.rpartition(" ")
        if name not in self.labels and whole in self.labels and is_measure(last):
            name = whole
        return self.labels.get(name, name or food)


def labels_of(vocabulary: Vocabulary) -> dict[str, str]:
    """Return the label of each food in the ``vocabulary`` of a FOON by its canonical name; of several the first."""
    return labels_by_name(row.label for row in vocabulary.foods)


def labels_by_name(labels: Iterable[str]) -> dict[str, str]:
    """Return each of ``labels`` by its canonical name; of several the first in their order."""
    found: dict[str, str] = {}
    for label in labels:
        found.setdefault(canonical(label), label)
    return found


def classes_of(recipe: CollectedRecipe) -> tuple[DishClass, ...]:
    """Return the dish classes of a recipe: the one that its collection gives is sure; else those of its title."""
    named = dish_classes(recipe.title)
    if recipe.dish_type not in DISH_TYPES:
        return named
    others = (DishClass(dish.name, sure=False) for dish in named if dish.name != recipe.dish_type)
    return (DishClass(recipe.dish_type, sure=True), *others)


def is_heading(text: str) -> bool:
    """Return whether the ``text`` of a line names a part of the dish and no food: "For the sauce", "TOPPING".

    So do what ends in a colon and what begins with "for the", whatever the part is called, and has no comma.

    >>> is_heading("For the cake batter:"), is_heading("1 cup sauce"), is_heading("tomato sauce")
    (True, False, False)
    >>> is_heading("For the cobbler"), is_heading("For the pan, butter")
    (True, False)
    """
    words = text.strip(" *-_").split()
    if not words or any(map(str.isdigit, text)):
        return False
    if words[-1].endswith(":"):
        return True
    if re.match(r"for the \w", " ".join(words), re.IGNORECASE):
        return "," not in text
    part = canonical(words[-1]) in _PARTS
    return part and (len(words) == 1 or text.isupper() or words[0].lower() == "for")


def bare_headings(lines: Sequence[str]) -> frozenset[int]:
    """Return the places of those of ``lines``, a list of ingredients, that are headings only beside the others.

    "Onion gravy" names a part and has no amount. It stands above two lines that have one, as most lines of the list do.

    >>> bare_headings(["500 g minced pork", "1 egg", "Onion gravy", "2 onions, sliced", "500 ml beef stock"])
    frozenset({2})
    >>> bare_headings(["500 g minced pork", "1 egg", "soy sauce", "2 onions, sliced"])
    frozenset()
    """
    counted = [any(char.isnumeric() for char in text) for text in lines]
    if sum(counted) * 2 < len(lines):
        return frozenset()
    above = (place for place, _ in enumerate(lines[:-2]) if counted[place : place + 3] == [False, True, True])
    return frozenset(place for place in above if _is_bare_heading(lines[place]))


def _is_bare_heading(text: str) -> bool:
    """Whether a line is of two or three words, of which the last names a part, and no known food.

    What is the same kind of food without that word is one as it is sold: harissa paste, filo pastry.
    """
    words = text.lower().strip(" *-_").split()
    if len(words) not in {2, 3} or canonical(words[-1]) not in _BARE:
        return False
    foods, name = tables().foods, " ".join(words)
    sold = foods.food(" ".join(words[:-1]))
    return not foods.is_listed(name) and not (sold.name and sold.is_a(foods.food(name).kind))


def state_beside(food: str, text: str) -> str | None:
    """Return the last state that ``text`` says around ``food``, ``""`` for none; ``None`` where the food is not in it.

    >>> state_beside("onion", "2 cups finely chopped onions, sauteed")
    'sauteed'
    """
    line = _IN_BRACKETS.sub(" ", text.lower())
    found = _as_words(food.lower()).search(line)
    if found is None:
        return None
    before, after = line[: found.start()], line[found.end() :]
    phrases = [before, *_PHRASE.split(after)]
    states = [state for phrase in phrases if (state := state_in(phrase))]
    return states[-1] if states else ""


@lru_cache(maxsize=_PATTERNS)
def _as_words(food: str) -> re.Pattern[str]:
    """Return what finds ``food`` in the singular or plural, and no longer word that begins with it (eggplant)."""
    return re.compile(rf"(?<!\w){re.escape(food)}(?:e?s)?(?!\w)")
