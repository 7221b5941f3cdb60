"""Nodes, steps and the entries of a plan result in the notation of :mod:`foon_kg.validation.notation`, both ways."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from foon_kg.model import ObjectNode, RequiredIngredient, Sighting
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.validation.notation_line import LIKE, NOTHING, Line, in_quotes, written_motion, written_name, written_rest
from foon_kg.world import Mention, Step

RELATIONS = (
    "at", "attached to", "below", "contains", "covered", "covering", "from", "in", "on", "over", "under", "with",
)  # fmt: skip
"""The words before a container that need no quotes; ``at`` stands for a place of which no relation is told."""

ARROWS = ("→", "->")

_PLACE = re.compile(rf"\s*({'|'.join(RELATIONS)})\s+(?=[^\s,;)}}])")
_EMPTY_SIDE = re.compile(rf"\s*{NOTHING}\s*(?=→|->|$)")
_SIGHTING = re.compile(r"(.+) (-?\d+)")

T = TypeVar("T")

# --- nodes ---


def written_node(mention: Mention) -> str:
    """Return the node of ``mention`` as ``label#thing (states; {ingredients}; relation container#thing)``."""
    node = mention.node
    words = [", ".join(map(_written_state, node.states))] if node.states else []
    if node.ingredients:
        words.append("{" + ", ".join(map(written_name, node.ingredients)) + "}")
    if (node.relation, node.container, mention.container_thing) != (None, None, None):
        words.append(_written_place(node, mention.container_thing))
    inside = f" ({'; '.join(words)})" if words else ""
    return written_name(node.label) + _written_thing(mention.thing) + inside


def _written_state(state: str) -> str:
    return in_quotes(state) if _PLACE.match(state) else written_name(state)


def _written_place(node: ObjectNode, number: int | None) -> str:
    relation = "at" if node.relation is None else node.relation
    if node.relation == "at" or relation not in RELATIONS:
        relation = in_quotes(relation)
    container = NOTHING if node.container is None else written_name(node.container)
    return f"{relation} {container}{_written_thing(number)}"


def _written_thing(number: int | None) -> str:
    return "" if number is None else f"#{number}"


def read_node(line: Line) -> ObjectNode:
    """Return the node that comes next in ``line``; ReadError if it has a number, which only things of steps have."""
    mention = _read_mention(line)
    if (mention.thing, mention.container_thing) != (None, None):
        line.fail("only the things of steps have numbers")
    return mention.node


def _read_mention(line: Line) -> Mention:
    label, thing = line.name(), _read_thing(line)
    told: dict[str, Any] = {}
    if line.take("("):
        _read_part(line, told)
        while line.take(";"):
            _read_part(line, told)
        line.expect(")")
    relation, container, number = told.pop("place", (None, None, None))
    return Mention(ObjectNode(label, **told, relation=relation, container=container), thing, number)


def _read_part(line: Line, told: dict[str, Any]) -> None:
    """Read states, ``{ingredients}`` or a place into ``told``."""
    value: Any
    if line.take("{"):
        name, value = "ingredients", _read_all(line, ",", Line.name)
        line.expect("}")
    elif (value := _read_place(line)) is not None:
        name = "place"
    else:
        name, value = "states", _read_all(line, ",", Line.name)
    if name in told:
        line.fail(f"{name} told twice: put commas between states, and give a node one place")
    told[name] = value


def _read_place(line: Line) -> tuple[str | None, str | None, int | None] | None:
    relation: str | None
    if match := _PLACE.match(line.text, line.at):
        relation, line.at = None if match[1] == "at" else match[1], match.end()
    elif line.next_is('"'):
        start, relation = line.at, line.quoted()
        if line.next_is(",", ";", ")"):
            line.at = start
            return None
    else:
        return None
    return relation, line.optional_name(), _read_thing(line)


def _read_thing(line: Line) -> int | None:
    return line.whole_number() if line.take("#") else None


def _read_all(line: Line, mark: str, read: Callable[[Line], T]) -> tuple[T, ...]:
    found = [read(line)]
    while line.take(mark):
        found.append(read(line))
    return tuple(found)


# --- steps ---


def written_step(step: Step) -> str:
    """Return ``step`` as ``inputs → MOTION → outputs``."""
    return f"{_written_side(step.inputs)} → {written_motion(step.motion)} → {_written_side(step.outputs)}"


def _written_side(mentions: Iterable[Mention]) -> str:
    return " + ".join(map(written_node, mentions)) or NOTHING


def read_step(line: Line) -> Step:
    """Return the step that a whole line is; capitals stand for small letters in its motion."""
    inputs = _read_side(line)
    line.expect(*ARROWS)
    quoted = line.next_is('"')
    motion = line.name()
    line.expect(*ARROWS)
    return Step(inputs, motion if quoted or motion != motion.upper() else motion.lower(), _read_side(line))


def _read_side(line: Line) -> tuple[Mention, ...]:
    if match := _EMPTY_SIDE.match(line.text, line.at):
        line.at = match.end()
        return ()
    return _read_all(line, "+", _read_mention)


def written_sightings(seen: Iterable[Sighting]) -> str:
    """Return where a unit was ``seen`` as ``video place; video place``."""
    return "; ".join(f"{written_name(one.video)} {one.position}" for one in seen) or NOTHING


def read_sightings(line: Line) -> tuple[Sighting, ...]:
    """Return the sightings that are left on a line."""
    return () if line.take_nothing() else _read_all(line, ";", _read_sighting)


def _read_sighting(line: Line) -> Sighting:
    if line.next_is('"'):
        return Sighting(line.quoted(), line.whole_number())
    match = _SIGHTING.fullmatch(line.name())
    if match is None:
        line.fail("expected the name of a video and the place of its unit, as “potato_soup 4”")
    return Sighting(match[1].strip(), int(match[2]))


# --- what is told of the whole tree ---


def written_kitchen(kitchen: Iterable[ObjectNode]) -> str:
    """Return the nodes of ``kitchen`` as ``node + node``."""
    return _written_side(map(Mention, kitchen))


def read_kitchen(line: Line) -> tuple[ObjectNode, ...]:
    """Return the nodes that are left on a line."""
    return () if line.take_nothing() else _read_all(line, "+", read_node)


def written_asked(asked: Iterable[RequiredIngredient]) -> str:
    """Return the foods that were ``asked`` as ``food (state); food (state; for part)``."""
    return "; ".join(map(_written_wanted, asked)) or NOTHING


def _written_wanted(one: RequiredIngredient) -> str:
    words = [written_name(one.state)] if one.state else []
    words += [f"; for {written_name(one.part)}"] if one.part else []
    return written_name(one.object) + (f" ({''.join(words)})" if words else "")


def read_asked(line: Line) -> tuple[RequiredIngredient, ...]:
    """Return the required foods that are left on a line."""
    return () if line.take_nothing() else _read_all(line, ";", _read_wanted)


def _read_wanted(line: Line) -> RequiredIngredient:
    food, state, part = line.name(), "", ""
    if line.take("("):
        state = "" if line.next_is(";") else ", ".join(_read_all(line, ",", Line.name))
        if line.take(";"):
            line.expect("for ")
            part = line.name()
        line.expect(")")
    return RequiredIngredient(food, state, part=part)


def written_substitution(entry: Substitution) -> str:
    """Return ``entry`` as ``kind (object): required like equivalent (confidence); alternative (confidence), …``."""
    equivalent = NOTHING if "equivalent" in entry.missing else written_name(entry.equivalent)
    told = f"{written_name(entry.kind)} ({written_name(entry.object)}): {written_name(entry.required)} {LIKE} "
    told += equivalent + _written_confidence(entry)
    if "alternatives" in entry.missing:
        return told
    others = ", ".join(written_name(other.name) + _written_confidence(other) for other in entry.alternatives)
    return f"{told}; {others or NOTHING}"


def _written_confidence(entry: Substitution | Alternative) -> str:
    return "" if "confidence" in entry.missing else f" ({entry.confidence!r})"


def read_substitutions(line: Line) -> tuple[Substitution, ...]:
    """Return the one substitution of a line; ``()`` for ``nothing``."""
    if line.take_nothing():
        return ()
    kind = line.name()
    line.expect("(")
    about = line.name()
    line.expect(")")
    line.expect(":")
    required = line.name()
    line.expect(LIKE)
    equivalent, confidence = line.optional_name(), _read_confidence(line)
    alternatives: tuple[Alternative, ...] | None = None
    if line.take(";"):
        alternatives = () if line.take_nothing() else _read_all(line, ",", _read_alternative)
    return (Substitution.claimed(kind, about, required, equivalent, confidence=confidence, alternatives=alternatives),)


def _read_alternative(line: Line) -> Alternative:
    return Alternative.claimed(line.name(), _read_confidence(line))


def _read_confidence(line: Line) -> float | None:
    if not line.take("("):
        return None
    number = line.number()
    line.expect(")")
    return number


def written_assumption(entry: Assumption) -> str:
    """Return ``entry`` as ``node: why``."""
    return f"{written_node(Mention(entry.node))}: {written_rest(entry.why)}"


def read_assumptions(line: Line) -> tuple[Assumption, ...]:
    """Return the one assumption of a line; ``()`` for ``nothing``."""
    if line.take_nothing():
        return ()
    node = read_node(line)
    line.expect(":")
    return (Assumption(node, line.rest()),)
