"""Write a FOON subgraph as text, in the plain dialect.

One way to write each thing: an object's states in alphabetical order, then ``contains {…}``, then its place; times as
``<m:ss-m:ss>``. Two forms go beyond what the published files have, so that every node can be written: a place without
a known relation has an empty second column (``S<TAB><TAB>[bowl]``), and an object that keeps places as states only ends
with the empty place ``S<TAB><TAB>[]``.

The file of a task tree is no video: comments before each step name the places where it was seen.

The format has no way to escape anything. Names with tabs, line ends, double blanks, or with brackets and commas
where the format reads those, cannot be written; nor can times that are none.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from foon_kg.loaders.text_reader import read_text
from foon_kg.loaders.times import write_timing
from foon_kg.model import DISH_TYPES, UNMEASURED, Annotation, ObjectNode, Participant, Sighting, Subgraph
from foon_kg.model.errors import FormatError

_PLACE_AS_STATE = re.compile(r"([^\[{]*?) ?(\[[^\[\]{}]*\])")
_NUMBER_OF_CLASS = {dish_type: number for number, dish_type in enumerate(DISH_TYPES)}


def write_text(subgraph: Subgraph) -> str:
    """Return ``subgraph`` as FOON text, which ``read_text`` reads back to the same but for measures: it has none.

    Raises ``FormatError`` where it would be read back as something else, naming the first unit or source at fault.
    """
    text = _text(subgraph)
    units = tuple(replace(one, measures=UNMEASURED) for one in subgraph.annotations)
    if read_text(text, subgraph.name).subgraph != replace(subgraph, annotations=units):
        raise FormatError(
            f"{subgraph.name}: {_fault(subgraph)} cannot be written as FOON text",
            hint="Take tabs, line ends, brackets and commas out of its names, or write JSON.",
        )
    return text


def _text(subgraph: Subgraph) -> str:
    lines = [f"# Source:\t{source}" for source in subgraph.sources]
    lines.append("//")
    for annotation in subgraph.annotations:
        lines += _unit_lines(annotation)
        lines.append("//")
    return "\n".join(lines) + "\n"


def _unit_lines(annotation: Annotation) -> Iterator[str]:
    unit = annotation.unit
    yield from _seen_lines(annotation.seen_in)
    for participant in unit.inputs:
        yield from _object_lines(participant)
    motion = ["M", unit.motion + ("*" if unit.accepts_any else ""), write_timing(annotation.timing)]
    yield "\t".join(motion if motion[-1] else motion[:-1])
    for participant in unit.outputs:
        yield from _object_lines(participant)


def _seen_lines(seen_in: Sequence[Sighting] | None) -> Iterator[str]:
    """Yield where a step of a task tree was seen; a step that was seen nowhere says so."""
    for seen in seen_in or ():
        times = ("" if time is None else repr(time) for time in (seen.start, seen.end))
        yield "\t".join(("# Seen in:", seen.video, str(seen.position), *times, seen.source or ""))
    if seen_in is not None and not seen_in:
        yield "# Seen in:"


def _object_lines(participant: Participant) -> Iterator[str]:
    columns = ["O", participant.node.label, "1" if participant.moving else "0"]
    if participant.dish_type is not None:
        columns.append(str(_NUMBER_OF_CLASS.get(participant.dish_type, participant.dish_type)))
    yield "\t".join(columns)
    yield from _state_lines(participant.node)


def _state_lines(node: ObjectNode) -> Iterator[str]:
    has_place = node.relation is not None or node.container is not None
    for state in node.states:
        if place := _PLACE_AS_STATE.fullmatch(state):
            yield f"S\t{place[1]}\t{place[2]}"
            has_place = True
        else:
            yield f"S\t{state}"
    if node.ingredients:
        yield f"S\tcontains\t{{{','.join(node.ingredients)}}}"
    if has_place:
        yield f"S\t{node.relation or ''}\t[{node.container or ''}]"


def _fault(subgraph: Subgraph) -> str:
    """Return what of ``subgraph`` does not come back, once it is known that something does not."""
    if not subgraph.annotations:
        return "a subgraph without units"
    for place, annotation in enumerate(subgraph.annotations):
        alone = Subgraph(subgraph.name, (annotation,))
        if read_text(_text(alone), subgraph.name).subgraph != alone:
            return f"unit {place} ({annotation.unit.motion!r} of {_names(annotation)})"
    return f"one of the sources {list(subgraph.sources)!r}"


def _names(annotation: Annotation) -> str:
    return ", ".join(repr(str(node)) for node in annotation.unit.input_nodes)
