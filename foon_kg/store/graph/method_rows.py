"""The rows of questions about what was learnt of a FOON: operators, their evidence, and frames."""

from __future__ import annotations

from foon_kg.store.graph.rows import Counted, Row

SightingValue = tuple[str, int, str | None, float | None, float | None]
"""The values of a ``Sighting``: video, position, source, start and end."""

EvidenceValue = tuple[int, int, list[str], list[str]]
"""``[units, changed, seen, changes]``: how many units of an operator are done to a matter, how many
change it, and the texts of the first sightings of either."""

MatterValue = tuple[str, list[tuple[int, EvidenceValue]], list[tuple[int, str, int]], list[str]]
"""``[name, evidence, brings, states]`` of a matter: see :class:`MethodsAskedRow`."""

FrameReadValue = tuple[str, str, list[str]]
"""``[key, text, videos]`` of a frame; the videos are those that show a way to its goal."""

StageTypeCount = tuple[str, str, str, str, bool, int]
"""``[kind, dish_type, work, heated, joins, count]``."""

NearValue = tuple[str, int, float | None, list[str]]
"""A food, how many points were looked at for it, the cosine of the furthest, and the names of the near ones."""


class AttestedRow(Row):
    """For each unit its key, that of its operator, what it is done to, and what of that it changes."""

    attested: list[tuple[str, str, list[str], list[str]]]


class EvidenceRow(Row):
    """For operators and matters how many units are kept, how many that change it, and of either the first sightings."""

    kept: list[tuple[str, str, int, int, list[str], list[str]]]


class FirstSightingsRow(Row):
    """Where an operator was first seen done to a matter, and first seen to change it."""

    operator: str
    matter: str
    seen: list[SightingValue]
    changes: list[SightingValue]


class TextRow(Row):
    """The text of one frame."""

    text: str


class MethodsCommonRow(Row):
    """What of the methods matters to every question, in no order. Operators go by their numbers in the store.

    ``operators``: number, motion, tools, and evidence for anything. ``usual``: the foods that each is most often done
    to, and most often changes. ``appliances``: those with which each is done.
    """

    operators: list[tuple[int, str, list[str], EvidenceValue]]
    usual: list[tuple[int, str, EvidenceValue]]
    gives: list[tuple[int, str, int]]
    places: list[tuple[int, str, int]]
    appliances: list[tuple[int, str, EvidenceValue]]
    brings: list[tuple[int, str, str, int]]
    states: list[tuple[str, list[str]]]
    stage_types: list[StageTypeCount]
    beside: list[tuple[str, str, int]]
    cooked: list[tuple[str, str, int]]


class MethodsAskedRow(Row):
    """For each asked food the number of points looked at, the cosine of the furthest, and the names of the near ones.

    For each matter the evidence of its operators, from where they bring it (number, role, count), and its states.
    """

    near: list[NearValue]
    matters: list[MatterValue]


class FramesRow(Row):
    """The texts of the outlines of all frames, in no order."""

    frames: list[str]


class FramesReadRow(Row):
    """Frames that are looked at closely, in no order."""

    frames: list[FrameReadValue]


class MethodsRow(Row):
    """What was learnt of a FOON, in no order. The first five columns have a value for each operator.

    Of ``brings`` matter, role and count; of ``stage_types`` kind, dish type, the three parts of the type,
    and count.
    """

    operators: list[tuple[str, list[str]]]
    evidence: list[list[tuple[str, EvidenceValue]]]
    gives: list[Counted]
    brings: list[list[tuple[str, str, int]]]
    places: list[Counted]
    states: list[tuple[str, list[str]]]
    stage_types: list[StageTypeCount]
    beside: list[tuple[str, str, int]]
    cooked: list[tuple[str, str, int]]
    frames: list[str]
