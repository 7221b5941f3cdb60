"""Phrases of a sentence to a cook: names with their article, motions with their object, states that are reached.

How each motion, state and utensil is said is data (``food/speech.toml``).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

from foon_kg.food import motions, tables
from foon_kg.food.lists import word_list
from foon_kg.food.shipped import shipped
from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import is_place

_AFTER_THE_OBJECT = frozenset({"in", "with", "into"})
_PARTS = frozenset({"ends", "seeds", "skin", "slits"})
_COGNATE = 3
"""So many first letters are the same in a motion and in the state that it gives."""


def listed(names: Iterable[str]) -> str:
    """Return ``a, b and c``, each name once; nothing for no names.

    >>> listed(["egg", "milk", "egg", "salt"])
    'egg, milk and salt'
    """
    *first, last = dict.fromkeys(names) or ("",)
    return f"{', '.join(first)} and {last}" if first else last


def the(labels: Iterable[str]) -> str:
    """Return ``labels`` in words: ``the a, b and c``."""
    return f"the {listed(_said('names').get(label, label) for label in labels)}"


def with_object(verb: str, thing: str) -> str:
    """Return a ``verb`` with the ``thing`` it is done to: ``cut off the ends of the onion``, ``let the dough rise``.

    >>> with_object("chop", "the onion"), with_object("pick-and-place", "the egg")
    ('chop the onion', 'put the egg')
    """
    said = _said("motions").get(verb, verb)
    if "\u2026" in said:
        return said.replace("\u2026", thing)
    words = said.split()
    if len(words) > 1 and words[-1] in _PARTS:
        between = "in" if words[-1] == "slits" else "of"
        return f"{' '.join(words[:-1])} {'' if between == 'in' else 'the '}{words[-1]} {between} {thing}"
    if len(words) > 1 and words[1] in _AFTER_THE_OBJECT:
        return f"{words[0]} {thing} {' '.join(words[1:])}"
    return f"{' '.join(words)} {thing}"


def motion_said(verb: str) -> str:
    """Return the motion of a ``verb`` alone as it is said: ``put``, ``rise``."""
    return _said("motions").get(verb, verb).removeprefix("let \u2026 ")


def joined_by(verb: str) -> str | None:
    """Return what stands between the two things of a ``verb`` that joins or takes apart (attach: to).

    ``None`` for others.
    """
    return _said("joins").get(verb)


def in_words(verb: str, states: Iterable[str]) -> tuple[str, str]:
    """Return how the states that a step gives are said: an adverb before its verb, and words after all the rest.

    >>> in_words("chop", ["finely chopped"])
    ('finely ', '')
    >>> in_words("cook", ["cubed", "soft"])
    ('', ' into cubes until soft')
    """
    if verb.rsplit(maxsplit=1)[-1] in _PARTS:
        return "", ""
    told = [state for state in states if not _goes_without_saying(verb, state)]
    manner = next((state for state in told if _is_manner(verb, state)), None)
    adverb = "" if manner is None else f"{manner.split()[0]} "
    return adverb, _shapes_in_words(told) + _until(told, manner)


def _shapes_in_words(states: Iterable[str]) -> str:
    shapes = _said("shapes")
    cut = listed(shapes[state] for state in states if state in shapes)
    return f" into {cut}" if cut else ""


def _until(states: Iterable[str], manner: str | None) -> str:
    """Return in words how far a step goes, by the states that are no shapes nor its ``manner``."""
    shapes = _said("shapes")
    rest = listed(state for state in states if state not in shapes and state != manner)
    return f" until {rest}" if rest else ""


def _goes_without_saying(verb: str, state: str) -> bool:
    return is_place(state) or state in _unsaid() or _is_said_by(verb, state)


def _is_said_by(verb: str, state: str) -> bool:
    words = [*_said("motions").get(verb, verb).split(), *verb.split()]
    return _said("participles").get(words[0]) == state or (" " not in state and _cognate(words, state))


def _is_manner(verb: str, state: str) -> bool:
    """Return whether a state says how the motion is done (chop: finely chopped), and not how far (partly cooked)."""
    adverb, _, rest = state.partition(" ")
    how = adverb.endswith("ly") and rest != "" and not motions.heats(verb)
    return how and " " not in rest and _cognate(verb.split()[:1], rest)


def _cognate(words: Iterable[str], state: str) -> bool:
    return state[:_COGNATE] in {_said("participles").get(word, word)[:_COGNATE] for word in words}


def stands_in(inner: str, outer: str, nodes: Iterable[ObjectNode]) -> bool:
    """Return whether the thing labelled ``inner`` is in or on the one labelled ``outer``, by their ``nodes``."""
    return any(node.label == inner and node.container == outer for node in nodes)


def is_flat(label: str) -> bool:
    """Return whether things lie on the utensil called ``label``, and not in it: a board, a plate."""
    return bool(label) and label.rsplit(maxsplit=1)[-1] in word_list("flat utensils")


def hosts_things(label: str) -> str:
    """Return ``in`` or ``on`` for the ``label`` of an appliance (an oven, a stove), ``""`` for any other."""
    row = tables().utensil(label)
    return row.holds if row is not None and row.role == "appliance" and row.holds in {"in", "on"} else ""


def motion_to(label: str, after: Iterable[ObjectNode]) -> str:
    """Return ``onto`` or ``into``, as things are on or in the utensil of that label ``after`` the step."""
    relations = {node.relation for node in after if node.container == label}
    return "onto" if "on" in relations or (is_flat(label) and "in" not in relations) else "into"


def resting_in(label: str) -> str:
    """Return ``on`` or ``in``, as things are in the utensil of that label."""
    return "on" if is_flat(label) else "in"


@cache
def _said(table: str) -> Mapping[str, str]:
    return dict(shipped("speech")[table])


@cache
def _unsaid() -> frozenset[str]:
    """Return the states that go without saying."""
    return frozenset(shipped("speech")["states"]["goes without saying"])
