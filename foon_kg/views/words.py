"""Object nodes and motions as coloured words: objects plain, states green, motions red, unseen ingredients blue.

Without colour everything is still told apart: states stand in brackets, motions in capitals, unseen ingredients
have a wavy sign.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from rich.text import Text

from foon_kg.model import ObjectNode

STATE = "green"
MOTION = "bold red"
UNSEEN = "blue"
ASIDE = "dim"
UNSEEN_SIGN = "~"


def node_words(node: ObjectNode, unseen: Collection[str] = ()) -> Text:
    """Answer ``onion (chopped, on cutting board)``; a food of ``unseen`` is marked as one that FOON has not seen so."""
    text = food_words(node.label, unseen)
    return text + _bracketed(node.states, _contents(node, unseen), _place(node.relation, node.container))


def food_words(label: str, unseen: Collection[str] = ()) -> Text:
    """Answer the name of a food or utensil."""
    return Text(UNSEEN_SIGN + label, UNSEEN) if label in unseen else Text(label)


def stage_words(states: Sequence[str], relation: str | None, container: str | None) -> Text:
    """Answer ``chopped, on cutting board``: how and where something is."""
    return _listed([Text(state, STATE) for state in states] + _place(relation, container))


def motion_words(motion: str) -> Text:
    """Answer a motion as it stands between what it takes and what it makes."""
    return Text(motion.upper(), MOTION)


def nodes_words(nodes: Iterable[ObjectNode], unseen: Collection[str] = (), between: str = " + ") -> Text:
    """Answer several nodes in a row."""
    return Text(between, ASIDE).join(node_words(node, unseen) for node in nodes)


def shown_nodes(nodes: Sequence[ObjectNode]) -> list[ObjectNode]:
    """Leave out the vessels whose foods all stand beside them and say where they are."""
    return [node for node in nodes if not _told_by_others(node, nodes)]


def _told_by_others(vessel: ObjectNode, nodes: Sequence[ObjectNode]) -> bool:
    inside = {node.label for node in nodes if node.container == vessel.label}
    return bool(vessel.ingredients) and inside.issuperset(vessel.ingredients)


def _contents(node: ObjectNode, unseen: Collection[str]) -> list[Text]:
    if not node.ingredients:
        return []
    return [Text("with ") + Text(", ").join(food_words(name, unseen) for name in node.ingredients)]


def _place(relation: str | None, container: str | None) -> list[Text]:
    return [Text(f"{relation or 'at'} {container}")] if container else []


def _bracketed(states: Sequence[str], *parts: list[Text]) -> Text:
    words = [Text(state, STATE) for state in states] + [word for part in parts for word in part]
    return Text(" (") + _listed(words) + Text(")") if words else Text()


def _listed(words: Sequence[Text]) -> Text:
    return Text(", ").join(words)
