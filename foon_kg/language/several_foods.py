"""Lines that ask for more than one food: "salt and pepper", "zest and juice of 1 lemon"."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.food.told_states import asked_state
from foon_kg.language.line_words import RecipeLine, as_bought, split_name, states_of
from foon_kg.model.names import canonical
from foon_kg.similarity.state_classes import state_classes

_INSTEAD = re.compile(r"\bor\b|[a-z] ?/ ?[a-z]", re.IGNORECASE)
_BESIDE = re.compile(r", and |,| and | & ")


def without_mere_states(names: Sequence[str]) -> tuple[tuple[str, ...], Sequence[str]]:
    """Return the ``names`` in front that are states and no foods ("Hot" of hot cooked rice), and the others."""
    place = 0
    while place < len(names) - 1 and _is_mere_state(names[place]):
        place += 1
    return tuple(name.lower() for name in names[:place]), names[place:]


def _is_mere_state(name: str) -> bool:
    return canonical(name) in state_classes().class_of and not tables().foods.is_listed(name)


def with_all_foods(line: RecipeLine, text: str, others: Sequence[str], preparation: str) -> RecipeLine:
    """Return a ``line`` with all that its ``text`` asks for: the ``others`` that it names, and two things of one fruit.

    ``preparation`` is what was done: to the food that it stands before, else to all of them.
    """
    if line.object is None:
        return line
    if others and _INSTEAD.search(text) is None:
        beside = [one for other in others for one in _each(other)]
        if all(map(_is_food, beside)):
            return _with_beside(line, text, beside, preparation)
    return of_one_fruit(line)


def _is_food(name: str) -> bool:
    return bool(tables().foods.find(split_name(name)[1])[1])


def _each(name: str) -> Iterator[str]:
    """Yield the foods of a name: tomato and onion, unless that is a food (half and half)."""
    parts = [part.strip() for part in _BESIDE.split(name) if part.strip()]
    apart = len(parts) > 1 and not tables().foods.is_listed(name) and all(map(tables().foods.is_listed, parts))
    yield from parts if apart else [name]


def _with_beside(line: RecipeLine, text: str, beside: Sequence[str], preparation: str) -> RecipeLine:
    """Return a line with the foods ``beside`` its own; ``preparation`` is told of one of them, of all or of its own."""
    done, _ = states_of(preparation)
    own = _told_before(preparation, beside, text)
    if own is not None:
        kept = tuple(state for state in line.states if state not in done)
        line = replace(line, state=asked_state(kept, tables()), states=kept)
        prepared: Sequence[str] = [own]
    else:
        behind_all = bool(preparation) and text.find(preparation) > text.find(beside[-1])
        prepared = beside if behind_all else []
    found = [_food_beside(line, name, done if name in prepared else ()) for name in beside]
    return replace(line, others=(), beside=tuple(one for one in found if one.object))


def _told_before(preparation: str, names: Sequence[str], text: str) -> str | None:
    """Return the name before which a text tells the preparation."""
    return next((name for name in names if preparation and f"{preparation} {name}" in text), None)


def _food_beside(line: RecipeLine, name: str, done: Sequence[str]) -> RecipeLine:
    in_name, food = split_name(name)
    states = (*in_name, *done)
    one = RecipeLine(line.text, food, asked_state(states, tables()), states, confidence=line.confidence)
    return as_bought(one, in_name)


def of_one_fruit(line: RecipeLine) -> RecipeLine:
    """Return a line that asks for the zest and the juice of a fruit as one that asks for both.

    Then its juice is pressed out of it, and comes out of no bottle.
    """
    grated = [state for state in line.states if state in word_list("is the zest of a fruit")]
    pressed = any(state in word_list("is the juice of a fruit") for state in line.states)
    if not (grated and pressed) or not tables().foods.food(line.object or "").is_any(word_list("gives zest and juice")):
        return line
    zest = replace(line, state=grated[0], states=(grated[0],), beside=())
    pressing = min(word_list("is pressed out of a fruit"))
    juice = replace(line, state=pressing, states=(pressing,), quantity="", unit="", size="", beside=())
    return replace(zest, beside=(juice,))
