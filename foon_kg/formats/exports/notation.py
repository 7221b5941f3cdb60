"""Object nodes as one line of text from which they can be read back: for comments, labels and the ports of a robot."""

from __future__ import annotations

from urllib.parse import quote

from foon_kg.model import FunctionalUnit, ObjectNode

_MARKS = "%;,:(){}[]"


def node_text(node: ObjectNode) -> str:
    """Return a ``node`` as ``onion (chopped, peeled) {garlic} [on: cutting board]``, without parts that say nothing.

    The characters that mean something here, and those that would end the line, are written in names as in an address
    (``%2C``): splitting at ``;`` and then at the brackets gives back what was written.

    >>> node_text(ObjectNode("onion", ("chopped",), relation="on", container="cutting board"))
    'onion (chopped) [on: cutting board]'
    """
    parts = [_name(node.label)]
    if node.states:
        parts.append(f"({', '.join(map(_name, node.states))})")
    if node.ingredients:
        parts.append(f"{{{', '.join(map(_name, node.ingredients))}}}")
    if node.relation is not None or node.container is not None:
        parts.append(f"[{_name(node.relation or '')}: {_name(node.container or '')}]")
    return " ".join(parts)


def unit_text(unit: FunctionalUnit) -> str:
    """Return a ``unit`` on one line: what goes in, what is done, and what comes out.

    >>> from foon_kg.model import Participant
    >>> whole, chopped = (Participant(ObjectNode("onion", (state,))) for state in ("whole", "chopped"))
    >>> unit_text(FunctionalUnit((whole,), "chop", (chopped,)))
    'onion (whole) -> chop -> onion (chopped)'
    """
    inputs, outputs = ("; ".join(map(node_text, side)) for side in (unit.input_nodes, unit.output_nodes))
    return f"{inputs} -> {_name(unit.motion)}{'*' if unit.accepts_any else ''} -> {outputs}"


def _name(text: str) -> str:
    return "".join(
        c if c.isprintable() and c not in _MARKS else quote(c, safe="", errors="surrogatepass") for c in text
    )
