"""Names that every reader of PDDL takes, and comments that end where their line does."""

from __future__ import annotations

import re
import unicodedata

from foon_kg.model import ObjectNode

_OUTSIDE = re.compile(r"[^a-z0-9]+")
_LONGEST = 60
"""Letters of a name: it can still be read; the number in front of it tells it from others."""


def slug(text: str) -> str:
    """Return ``text`` in the letters a to z, digits and ``_``; empty where nothing of it can be said in these.

    >>> slug("Crème fraîche (light)"), slug("味噌")
    ('creme_fraiche_light', '')
    """
    folded = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    return _OUTSIDE.sub("_", folded)[:_LONGEST].strip("_")


def name_of(prefix: str, text: str) -> str:
    """Return a name for ``text`` that begins with ``prefix``: so it is unique, and no word of PDDL.

    >>> name_of("o3", "olive oil"), name_of("o4", "味噌")
    ('o3_olive_oil', 'o4')
    """
    words = slug(text)
    return f"{prefix}_{words}" if words else prefix


def words_of(node: ObjectNode) -> str:
    """Return all that a node says, as the words of a name.

    >>> words_of(ObjectNode("salad", ("mixed",), ("onion", "tomato"), "in", "bowl"))
    'salad mixed with onion tomato in bowl'
    """
    holding = ("with", *node.ingredients) if node.ingredients else ()
    return " ".join((node.label, *node.states, *holding, node.relation or "", node.container or ""))


def comment(text: str) -> str:
    """Return ``text`` as a comment to the end of the line."""
    return "; " + " ".join("".join(c if c.isprintable() else " " for c in text).split())
