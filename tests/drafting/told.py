"""Actions as people tell them, and what is drafted of them."""

from __future__ import annotations

from drafting.kitchen_foon import precedents

from foon_kg.language.drafting import draft
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place, Sentence

FOON = precedents()


def action(verb, *objects, to=None, **fields):
    places = (Place("into", to),) if to else ()
    return NarratedAction(verb, tuple(map(Mention, objects)), places, said=f"{verb} {objects}", **fields)


def drafted(*actions, **wishes):
    return draft(Narration("video", tuple(actions)), FOON, **wishes)


def from_text(*actions):
    """Draft the actions as if they had been read in free text."""
    narration = Narration("video", tuple(actions), (Sentence("as it was said"),))
    return [row.annotation.unit for row in draft(narration, FOON).units]


def units(*actions):
    return [row.annotation.unit for row in drafted(*actions).units]
