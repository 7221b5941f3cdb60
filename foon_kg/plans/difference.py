"""What a subgraph file would change in a FOON, before it is loaded; and what is lost when a video is taken out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from foon_kg.model import FunctionalUnit, Subgraph

Videos = tuple[str, ...]


class Status(StrEnum):
    """How a subgraph stands to the FOON."""

    NEW = "new"
    CHANGED = "changed"
    UNCHANGED = "unchanged"
    REMOVED = "removed"


@dataclass(frozen=True)
class ShownUnit:
    """A unit and the other videos that show it, sorted."""

    unit: FunctionalUnit
    videos: Videos


@dataclass(frozen=True)
class VideoDifference:
    """What loading one subgraph, or taking one video out, would do. Every distinct unit stands in one list.

    ``added`` units are shown by no video yet, ``shared`` ones by others already; ``dropped`` ones only this video has
    and would have no more, ``left`` ones others keep. ``kept`` counts the units that it goes on showing. ``new_labels``
    are objects that the FOON has never seen. Units come in the order of the video.
    """

    name: str
    status: Status
    added: tuple[FunctionalUnit, ...] = ()
    shared: tuple[ShownUnit, ...] = ()
    dropped: tuple[FunctionalUnit, ...] = ()
    left: tuple[ShownUnit, ...] = ()
    kept: int = 0
    new_labels: tuple[str, ...] = ()


def difference(
    name: str, before: Subgraph | None, after: Subgraph | None, shown: Mapping[str, Videos], labels: frozenset[str]
) -> VideoDifference:
    """Return what it changes that the video ``name`` was ``before`` and is ``after``; ``None`` where it is not there.

    ``shown`` has, for the key of every unit of both that the FOON has, the videos that show it; ``labels`` those of
    their labels that it has.
    """
    old, new = _units(before), _units(after)
    others = {key: tuple(video for video in videos if video != name) for key, videos in shown.items()}
    come = [unit for key, unit in new.items() if key not in old]
    added, shared = _apart(come, others)
    dropped, left = _apart([unit for key, unit in old.items() if key not in new], others)
    return VideoDifference(
        name,
        _status(before, after),
        added=added,
        shared=shared,
        dropped=dropped,
        left=left,
        kept=len(old.keys() & new.keys()),
        new_labels=tuple(sorted(labels_of(come) - labels)),
    )


def _apart(
    units: Sequence[FunctionalUnit], others: Mapping[str, Videos]
) -> tuple[tuple[FunctionalUnit, ...], tuple[ShownUnit, ...]]:
    """Return the units that no other video shows, and those that ``others`` do, with these videos."""
    alone = tuple(unit for unit in units if not others.get(unit.key))
    return alone, tuple(ShownUnit(unit, others[unit.key]) for unit in units if others.get(unit.key))


def differences(subgraphs: Iterable[Subgraph], foon: Iterable[Subgraph]) -> tuple[VideoDifference, ...]:
    """Return for each of ``subgraphs`` what loading it into the ``foon`` of these videos would change."""
    there = {subgraph.name: subgraph for subgraph in foon}
    shown: dict[str, set[str]] = {}
    for video in there.values():
        for key in _units(video):
            shown.setdefault(key, set()).add(video.name)
    videos = {key: tuple(sorted(names)) for key, names in shown.items()}
    labels = frozenset(labels_of([a.unit for video in there.values() for a in video.annotations]))
    return tuple(difference(s.name, there.get(s.name), s, videos, labels) for s in subgraphs)


def labels_of(units: Sequence[FunctionalUnit]) -> set[str]:
    """Return the labels of all nodes of ``units``."""
    return {node.label for unit in units for node in (*unit.input_nodes, *unit.output_nodes)}


def _units(subgraph: Subgraph | None) -> dict[str, FunctionalUnit]:
    """Return the distinct units by their keys, in the order of the video."""
    return {annotation.unit.key: annotation.unit for annotation in subgraph.annotations} if subgraph else {}


def _status(before: Subgraph | None, after: Subgraph | None) -> Status:
    if before is None:
        return Status.NEW
    if after is None:
        return Status.REMOVED
    return Status.UNCHANGED if before.content_key == after.content_key else Status.CHANGED
