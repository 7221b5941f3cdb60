"""Object nodes and motions as coloured words: objects plain, states green, motions red, unseen ingredients blue.

Without colour everything is still told apart: states stand in brackets, motions in capitals, unseen ingredients
have a wavy sign.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.text import Text

from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import Kitchen

STATE = "green"
MOTION = "bold red"
UNSEEN = "blue"
ASIDE = "dim"
ALARM = "bold red"
UNSEEN_SIGN = "~"
EMPTY = "empty"


def node_words(node: ObjectNode, unseen: Collection[str] = (), *, contents: bool = True) -> Text:
    """Return ``node`` as ``onion (chopped, on cutting board)``, with its ``contents`` if they are asked.

    A food of ``unseen`` is marked as one that FOON has not seen so.
    """
    words = [Text(state, STATE) for state in node.states]
    words += _contents(node, unseen) if contents else []
    words += _place(node.relation, node.container)
    name = food_words(node.label, unseen)
    return Text.assemble(name, " (", in_a_row(words, ", "), ")") if words else name


def food_words(label: str, unseen: Collection[str] = ()) -> Text:
    """Return the name of a food or utensil by its ``label``, marked where it is in ``unseen``."""
    return Text(UNSEEN_SIGN + label, UNSEEN) if label in unseen else Text(label)


def stage_words(states: Sequence[str], relation: str | None, container: str | None) -> Text:
    """Return how and where something is, by its ``states`` and place: ``chopped, on cutting board``.

    The place is a ``relation`` and a ``container``.
    """
    return in_a_row([Text(state, STATE) for state in states] + _place(relation, container), ", ")


def motion_words(motion: str) -> Text:
    """Return a motion as it stands between what it takes and what it makes."""
    return Text(motion.upper(), MOTION)


def section(title: str, body: RenderableType) -> RenderableType:
    """Return ``body`` under a ``title``."""
    return Group(Text(), Text(title, "bold"), Padding(body, (0, 0, 0, 2)))


def in_a_row(words: Iterable[Text], between: str) -> Text:
    """Return ``words`` with something plain between them, each in its own colour."""
    return Text(between).join(words)


def shown_inputs(nodes: Sequence[ObjectNode]) -> list[ObjectNode]:
    """Return ``nodes`` without the vessels whose foods all stand beside them and say where they are."""
    return [node for node in nodes if not _told_by_others(node, nodes)]


def shown_outputs(nodes: Sequence[ObjectNode]) -> list[ObjectNode]:
    """Return ``nodes`` without the same vessels, and without what is only empty now where anything else comes out."""
    shown = shown_inputs(nodes)
    return [node for node in shown if node.states != (EMPTY,) or node.ingredients] or shown


def handled(inputs: Sequence[ObjectNode]) -> str:
    """Return what a step with these ``inputs`` is about: the foods, and what holds some; where none are, everything."""
    kitchen = Kitchen.default()
    nodes = shown_inputs(inputs)
    foods = [node for node in nodes if kitchen.is_food(node) or kitchen.foods_in(node)]
    return ", ".join(dict.fromkeys(node.label for node in foods or nodes))


def _told_by_others(vessel: ObjectNode, nodes: Sequence[ObjectNode]) -> bool:
    inside = {node.label for node in nodes if node.container == vessel.label}
    return bool(vessel.ingredients) and inside.issuperset(vessel.ingredients)


def _contents(node: ObjectNode, unseen: Collection[str]) -> list[Text]:
    if not node.ingredients:
        return []
    return [Text.assemble("with ", in_a_row((food_words(name, unseen) for name in node.ingredients), ", "))]


def _place(relation: str | None, container: str | None) -> list[Text]:
    return [Text(f"{relation or 'at'} {container}")] if container else []
