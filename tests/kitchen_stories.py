"""A small FOON for the planner's tests, written as short lines: ``inputs > motion > outputs``."""

from __future__ import annotations

import re

from foon_kg.model import (
    Annotation,
    FunctionalUnit,
    KnownUnit,
    ObjectNode,
    Participant,
    Sighting,
    Subgraph,
)

_NODE = re.compile(r"^(?P<label>[^(\[{@]+?)(?:\((?P<states>[^)]*)\))?(?:\{(?P<inside>[^}]*)\})?(?:@(?P<place>.+))?$")


def node(text: str) -> ObjectNode:
    """Read ``label(state,state){ingredient,ingredient}@relation container``."""
    match = _NODE.match(text.strip())
    assert match is not None, text
    relation, _, container = (match["place"] or "").rpartition(" ")
    return ObjectNode(
        match["label"].strip(),
        tuple(filter(None, (match["states"] or "").split(","))),
        tuple(filter(None, (match["inside"] or "").split(","))),
        (relation or "in") if match["place"] else None,
        container.replace("_", " ") or None,
    )


def unit(text: str, goal: str | None = None) -> FunctionalUnit:
    """Read ``node; node > motion > node; node``; a star after the motion lets any number of foods enter."""
    inputs, motion, outputs = (part.strip() for part in text.split(" > "))
    return FunctionalUnit(
        tuple(Participant(node(n)) for n in inputs.split(";")),
        motion.rstrip("*"),
        tuple(Participant(node(n), dish_type=goal) for n in outputs.split(";")),
        motion.endswith("*"),
    )


def script(*lines: str, video: str = "story") -> tuple[KnownUnit, ...]:
    """Return the units of ``lines`` in order, each seen in ``video``."""
    return tuple(KnownUnit(unit(line), (Sighting(video, place),)) for place, line in enumerate(lines))


def subgraph(name: str, dish_type: str, *lines: str) -> Subgraph:
    """Return a subgraph whose last unit makes the goal."""
    units = [*(unit(line) for line in lines[:-1]), unit(lines[-1], dish_type)]
    return Subgraph(name, tuple(Annotation(u) for u in units))


CHOP_ONION = (
    "cutting board(empty); onion(whole) > pick-and-place > cutting board{onion}; onion(whole)@on cutting_board",
    "onion(whole)@on cutting_board; knife > chop > onion(chopped)@on cutting_board",
)
ADD_TOMATO = (
    "bowl(empty); cutting board{tomato}; tomato(diced)@on cutting_board"
    " > pour > bowl{tomato}; tomato(diced)@bowl; cutting board(empty)"
)
ADD_ONION = (
    "bowl{tomato}; cutting board{onion}; onion(chopped)@on cutting_board"
    " > pour > bowl{onion,tomato}; onion(chopped)@bowl; cutting board(empty)"
)
ADD_SALT = (
    "bowl{onion,tomato}; shaker{salt}; salt(granulated)@shaker"
    " > sprinkle > bowl{onion,salt,tomato}; salt(granulated)@bowl"
)
MIX = (
    "bowl{onion,salt,tomato}; tomato(diced)@bowl; onion(chopped)@bowl; salt(granulated)@bowl; spoon"
    " > mix* > bowl{salad}; salad(mixed){onion,salt,tomato}@bowl"
)
SALAD = (
    "cutting board(empty); tomato(whole) > pick-and-place > cutting board{tomato}; tomato(whole)@on cutting_board",
    "tomato(whole)@on cutting_board; knife > dice > tomato(diced)@on cutting_board",
    ADD_TOMATO,
    *CHOP_ONION,
    ADD_ONION,
    ADD_SALT,
    MIX,
)
