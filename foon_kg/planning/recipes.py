"""What people ask for, as a :class:`~foon_kg.model.Recipe`: recipe files, and ingredients in words.

Nothing is decided silently: whatever was understood in one of several ways comes with a note.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain
from pathlib import Path

from foon_kg.food import tables
from foon_kg.food.called import dish_type_called
from foon_kg.food.told_states import asked_state, in_turn
from foon_kg.food.words import without_part
from foon_kg.model import DISH_TYPES, Recipe, RequiredIngredient
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.json_fields import Fields
from foon_kg.model.json_text import json_value
from foon_kg.model.knowledge import Vocabulary
from foon_kg.model.names import canonical
from foon_kg.model.nodes import name_of_file
from foon_kg.model.regular_files import read_text
from foon_kg.planning.several_asked import amount_of, counting, read_each
from foon_kg.plans.kitchen import Kitchen

NO_FOOD, NO_STATE = "no food is called", "no state is called"
"""How notes begin that say that something asked is not known."""

UNTOUCHED = "whole"
"""The state of a food of which FOON knows no state in which it is sold."""


@dataclass(frozen=True)
class ReadRecipe:
    """A recipe and what had to be decided to read it, one sentence a note."""

    recipe: Recipe
    notes: tuple[str, ...]


@dataclass(frozen=True)
class IngredientWords:
    """The foods and states that a FOON knows, for telling them apart in ``finely chopped onion``.

    ``kitchen`` knows utensils, and in which states foods are sold; ``there`` is what a person has at hand, if they say.
    """

    vocabulary: Vocabulary
    kitchen: Kitchen
    there: Kitchen | None = None

    def read(self, text: str) -> tuple[RequiredIngredient, tuple[str, ...]]:
        """Return what ``text`` asks for, with notes.

        Written as ``state food`` (chopped onion) or ``food, state`` (onion, chopped). The food is the longest known
        one at the end that a known state stands before, else all that follows the last known state, else the longest
        known food at the end with the words before it as its state. Of several states those count that
        :func:`~foon_kg.food.told_states.asked_state` chooses.

        Raises :class:`~foon_kg.model.errors.UsageError` when nothing is asked for.
        """
        plain, part = without_part(text)
        wanted, notes = self._chosen(plain, *self.parts(plain))
        return replace(wanted, part=part), notes

    def parts(self, text: str) -> tuple[str, list[str], list[str]]:
        """Return the food that ``text`` names, its known states, and the words that are neither; see :meth:`read`.

        Raises UsageError for a text without a word.
        """
        if not text.strip(" ,"):
            raise UsageError("an ingredient is empty", hint="Write its state and its name, as in “chopped onion”.")
        food, comma, state = (part.strip() for part in text.partition(","))
        if comma and food and state:
            words = food.split()
            amount = self._amount_of(words)
            states, rest = self._states_in(state.replace(",", " ").split())
            return self.label(" ".join(words[amount:])), states, [*words[:amount], *rest]
        words = text.replace(",", " ").split()
        amount = self._amount_of(words)
        place = amount + self._food_begins(words[amount:])
        return self.label(" ".join(words[place:])), *self._states_in(words[:place])

    def _amount_of(self, words: Sequence[str]) -> int:
        """Return how many words in front say how much of a food is asked: none of “7 up” where that is known."""
        amount = counting(words)
        return 0 if amount == len(words) or canonical(" ".join(words)) in self._labels else amount

    def with_state(self, wanted: RequiredIngredient) -> tuple[RequiredIngredient, tuple[str, ...]]:
        """Return ``wanted`` with a state: its own, else how it is there, else how the food is most often taken.

        Where nobody took it, or that would be another kind of food (a sprig of what is sold dried), it is the one in
        which it is sold.
        """
        if wanted.state:
            return wanted, ()
        if self.there is not None and (made := asked_state(self.there.made_so(wanted.object), tables())):
            note = f"“{wanted.object}” names no state: taken as {made}, as it is there"
            return replace(wanted, state=made), (note,)
        plain = tables().foods.food(wanted.object)
        state = self._usual_states.get(canonical(wanted.object), plain.sold_as or UNTOUCHED)
        if plain.sold_as and tables().foods.food(wanted.object, [state]).kind != plain.kind:
            state = plain.sold_as
        usual = replace(wanted, state=state)
        return usual, (_as_usual(usual),)

    def _chosen(
        self, text: str, food: str, states: Sequence[str], rest: Sequence[str]
    ) -> tuple[RequiredIngredient, tuple[str, ...]]:
        """Return what ``text`` asks of ``food``, of whose ``states`` one counts, and the notes on it.

        ``rest`` are the words that are neither: how much it is, and states that nobody knows.
        """
        amount = counting(rest)
        measure, others = rest[:amount], rest[amount:]
        processed = [state for state in states if not self.kitchen.is_start_state(food, state)]
        unknown = " ".join(others) or _as_measured(food, [word.lower() for word in measure])
        state = asked_state(processed or list(states) or [unknown], tables())
        wanted, notes = self.with_state(RequiredIngredient(food, state, amount_of(measure)))
        left_out = _left_out(text, wanted, (*states, *others))
        return wanted, (*notes, *left_out, *self._doubts(text, wanted))

    def _doubts(self, text: str, wanted: RequiredIngredient) -> Iterator[str]:
        """Yield the note that ``text``, read as ``wanted``, may mean something else; at most one, first of the food."""
        food = wanted.object
        if not self.knows(food):
            _, meant = self._said_and_meant(text, food)
            asked = f": did you mean “{meant}”?" if meant else ", nor anything like it"
            yield f"{NO_FOOD} “{food}”{asked}"
        elif strange := self._strange(wanted.state):
            yield f"{NO_STATE} “{wanted.state}”{strange}"
        elif canonical(food) not in self._labels:
            said, meant = self._said_and_meant(text, food)
            if meant is not None and meant != said:
                yield f"“{text}” is taken at its word; if you mean “{meant}”, write that"

    def _said_and_meant(self, text: str, food: str) -> tuple[str, str | None]:
        """Return the words of ``text`` and those that they may mean; of ``food`` alone where the text means nothing."""
        said = " ".join(text.replace(",", " ").lower().split())
        meant = as_spelled(said)
        # an amount is no word of any food, so that a text with one means nothing
        return (food.lower(), as_spelled(food)) if meant is None else (said, meant)

    def knows(self, food: str) -> bool:
        """Return whether the FOON or the tables of foods have a food of this name, or one of its words."""
        listed = tables().foods.is_listed
        words = canonical(food).split()
        ends = (" ".join(words[place:]) for place in range(len(words)))
        return canonical(food) in self._labels or any(map(listed, ends)) or any(map(listed, words))

    def _strange(self, state: str) -> str:
        """Return what to say of a ``state`` of which nobody knows a word, be it of foods; ``""`` of others."""
        words = state.lower().split()
        known = tables().states
        if state.lower() in self.states or any(word in self.states or word in known for word in words):
            return ""
        meant = as_spelled(state)
        if meant is None:  # a whole question, say, in which only the food was understood
            return ", nor anything like it"
        return f": did you mean “{meant}”?" if meant != state.lower() else ""

    def _food_begins(self, words: Sequence[str]) -> int:
        """Return the place of the first word of the food; what is listed by a longer name is that: almond milk."""
        known = [place for place in range(len(words)) if canonical(" ".join(words[place:])) in self._labels]
        after_state = [place for place in range(1, len(words)) if self._ends_with_state(words[:place])]
        both = [place for place in known if place == 0 or place in after_state]
        found = min(both, default=max(after_state, default=min(known, default=0)))
        return self._longer(words, found)

    def _longer(self, words: Sequence[str], found: int) -> int:
        """Return where the longest listed name that ends ``words`` begins; ``found`` where it is in a state."""
        is_listed = tables().foods.is_listed
        longer = next((place for place in range(found) if is_listed(" ".join(words[place:]))), found)
        rest = self._states_in(words[longer:found])[1]
        is_in_a_state = all(word.lower() in tables().states for word in rest) and is_listed(" ".join(words[found:]))
        return found if is_in_a_state else longer

    def _ends_with_state(self, words: Sequence[str]) -> bool:
        return any(" ".join(words[place:]).lower() in self.states for place in range(len(words)))

    def _states_in(self, words: Sequence[str]) -> tuple[list[str], list[str]]:
        """Return the known states among ``words``, the longest first tried, and the words that belong to none."""
        states, rest, place = [], [], 0
        while place < len(words):
            ends = range(len(words), place, -1)
            end = next((end for end in ends if " ".join(words[place:end]).lower() in self.states), None)
            if end is None:
                rest.append(words[place])
            else:
                states.append(" ".join(words[place:end]).lower())
            place = end or place + 1
        return states, rest

    def label(self, food: str) -> str:
        """Return the name by which the FOON has ``food``; its own where it has it under none."""
        return self._labels.get(canonical(food), food)

    @cached_property
    def _labels(self) -> dict[str, str]:
        """The label of each known food by what it is compared by; of several the first in their order."""
        labels: dict[str, str] = {}
        for label in self.vocabulary.rows_of:
            labels.setdefault(canonical(label), label)
        return labels

    @cached_property
    def states(self) -> frozenset[str]:
        """The states that the FOON knows, in lower case."""
        seen = chain((row.state for row in self.vocabulary.foods), self.vocabulary.other_states)
        return frozenset(state.lower() for state in seen if state)

    @cached_property
    def _usual_states(self) -> dict[str, str]:
        """The state in which each food is most often taken among those in which it is sold."""
        rows = [row for row in self.vocabulary.foods if row.state and self.kitchen.is_start_state(row.label, row.state)]
        rows.sort(key=lambda row: (row.used, row.state))
        return {canonical(row.label): row.state for row in rows}


def _as_measured(food: str, measure: Sequence[str]) -> str:
    """Return the state that the words of a measure say of a food; ``""`` where they say none."""
    foods = tables().foods
    return foods.as_measured(food, measure) or foods.as_spooned(food, measure)


def _left_out(text: str, wanted: RequiredIngredient, words: Iterable[str]) -> Iterator[str]:
    """Yield the note on those of ``words`` that are not in the state of what ``text`` is read as, where there are."""
    said = {wanted.state, *wanted.state.split(), *in_turn(wanted.state)}
    left_out = [word for word in words if word not in said]
    if left_out:
        yield f"“{text}” is read as {wanted.object}, {wanted.state}: “{' '.join(left_out)}” is left out"


def as_spelled(text: str) -> str | None:
    """Return ``text`` with its words as they are spelled; ``None`` where one of them is like none that is known."""
    from foon_kg.planning.spelling import spelled  # noqa: PLC0415 - few questions have a word that nobody knows

    return spelled(text)


def recipe_of(dish_type: str, texts: Iterable[str], words: IngredientWords, title: str | None = None) -> ReadRecipe:
    """Return the recipe called ``title`` that asks for ``texts`` (``chopped onion``, …) as a ``dish_type``.

    ``words`` are those by which the FOON knows its foods. Raises :class:`~foon_kg.model.errors.UsageError` where no
    food of it is known.
    """
    read = [one for text in texts for one in read_each(text, words.read)]
    if read and not any(words.knows(wanted.object) for wanted, _ in read):
        told = _unknown_foods(note for _, notes in read for note in notes)
        raise UsageError(f"nothing is known of what is asked. {told}", hint="Check the spelling.", code="unknown-food")
    recipe = Recipe(dish_type, tuple(wanted for wanted, _ in read), title=title)
    return ReadRecipe(recipe, _gathered(read))


def _unknown_foods(notes: Iterable[str]) -> str:
    """Return those of ``notes`` that say that a food is not known, as sentences."""
    unknown = (note for note in notes if note.startswith(NO_FOOD))
    return " ".join(f"N{note[1:]}" + ("" if note.endswith("?") else ".") for note in unknown)


def of_known_type(read: ReadRecipe) -> ReadRecipe:
    """Return what was read as a recipe of one of the dish types, where it asks for a dish by a name of its own.

    A “risotto” is planned as rice that is called so, which is noted; a name of which nothing is known stays.
    """
    asked = read.recipe.dish_type
    known = dish_type_called(asked) if asked and asked not in DISH_TYPES else None
    if known is None:
        return read
    called = read.recipe.title or asked
    note = f"“{asked}” is no dish type by itself: planned as {known}, called {called}"
    return ReadRecipe(replace(read.recipe, dish_type=known, title=called), (note, *read.notes))


def with_states(recipe: Recipe, words: IngredientWords) -> ReadRecipe:
    """Return ``recipe`` with a state for each food: its own, else the usual one among ``words``, which is noted."""
    stated = [words.with_state(wanted) for wanted in recipe.ingredients]
    return ReadRecipe(
        replace(recipe, ingredients=tuple(wanted for wanted, _ in stated)),
        _gathered(stated),
    )


def _as_usual(wanted: RequiredIngredient) -> str:
    """Return the note of a food whose state nobody named."""
    return f"“{wanted.object}” names no state: taken as {wanted.state}"


def _gathered(read: Sequence[tuple[RequiredIngredient, tuple[str, ...]]]) -> tuple[str, ...]:
    """Return the notes of several foods; of all those whose states nobody named there is one."""
    usual = {_as_usual(wanted): wanted for wanted, notes in read if _as_usual(wanted) in notes}
    notes = tuple(chain.from_iterable(said for _, said in read))
    if len(usual) <= 1:
        return notes
    told = ", ".join(f"{wanted.object} ({wanted.state})" for wanted in usual.values())
    return f"no state is named for some foods, taken as usual: {told}", *(note for note in notes if note not in usual)


def recipe_files(paths: Iterable[Path]) -> Iterator[Path]:
    """Yield the recipe files that ``paths`` name, in their order; of a folder every ``.json`` below it, by name.

    Raises :class:`~foon_kg.model.errors.UsageError` for a path that is not there or a folder without recipes.
    """
    for path in paths:
        if not path.exists():
            raise UsageError(
                f"there is no file or folder {path}",
                hint="Name recipe files, or say --dish TYPE and give ingredients in words.",
            )
        below = sorted(path.rglob("*.json")) if path.is_dir() else [path]
        if not below:
            raise UsageError(f"{path} has no recipes", hint="A recipe is a .json file with type and ingredients.")
        yield from below


def read_recipe(path: Path, words: IngredientWords) -> ReadRecipe:
    """Return the recipe of the file at ``path``, read by the FOON's ``words``.

    It is ``{"id", "title", "type", "ingredients": [{"object", "state", "amount", "part"}]}``. ``id`` is the file's name
    where it is left out; ``dish_type`` is understood for ``type``. An ingredient may be a line ("200 g flour");
    ``quantity`` and ``unit`` are understood for ``amount``. One without a name is left out, one without a state gets
    the usual one; both are noted. Raises ReadError with the place.
    """
    fields = Fields(_json(path), str(path))
    wanted: list[RequiredIngredient] = []
    notes: list[str] = []
    for place, value in enumerate(fields.items("ingredients")):
        where = f"{path}: ingredients[{place}]"
        found, said = _read_one(value, where, words)
        wanted += found
        notes += (f"{where}: {note}" for note in said)
    dish_type = fields.text("dish_type" if "dish_type" in fields and "type" not in fields else "type")
    recipe_id = fields.optional_text("id") or name_of_file(path)
    return ReadRecipe(Recipe(dish_type, tuple(wanted), recipe_id, fields.optional_text("title")), tuple(notes))


def _read_one(value: object, where: str, words: IngredientWords) -> tuple[list[RequiredIngredient], list[str]]:
    """Return what one of a file's ingredients asks for, by ``words``, with the notes on it: nothing, if it is empty."""
    if not isinstance(value, str):
        one = _asked(Fields(value, where))
        read = [words.with_state(one)] if one.object else []
    else:
        read = read_each(value.strip(), words.read) if value.strip() else []
    if not read:
        return [], [f"{'the line' if isinstance(value, str) else '“object”'} is empty; the ingredient is left out"]
    return [wanted for wanted, _ in read], [note for _, notes in read for note in notes]


def _asked(ingredient: Fields) -> RequiredIngredient:
    """Return what an object of a recipe file asks for."""
    food, state = ingredient.text("object").strip(), (ingredient.optional_text("state") or "").strip(" ,")
    return RequiredIngredient(food, state, amount_said(ingredient), (ingredient.optional_text("part") or "").strip())


def amount_said(ingredient: Fields) -> str:
    """Return how much an ingredient of a recipe file is: its ``amount``, else its ``quantity`` and ``unit``."""
    if "amount" in ingredient:
        return (ingredient.optional_text("amount") or "").strip()
    return " ".join(filter(None, map(ingredient.text_or_number, ("quantity", "unit"))))


def foods_named(path: Path) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the foods that the recipe file at ``path`` names, and the lines in it, which are still to be read.

    There are none where it cannot be read: :func:`read_recipe` says why.
    """
    try:
        values = Fields(_json(path), str(path)).items("ingredients")
        lines = tuple(value for value in values if isinstance(value, str))
        named = (Fields(value, str(path)).text("object").strip() for value in values if not isinstance(value, str))
        return tuple(filter(None, named)), lines
    except ReadError:
        return (), ()


def _json(path: Path) -> object:
    try:
        return json_value(read_text(path))
    except json.JSONDecodeError as error:
        raise ReadError(f"{path}:{error.lineno}: not JSON: {error.msg}", hint="Correct this line.") from error
    except UnicodeDecodeError as error:
        raise ReadError(f"{path}: not UTF-8 text (byte {error.start})", hint="Save it as UTF-8.") from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="Make the file readable.") from error
