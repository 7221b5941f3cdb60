"""The candidates of algorithm 3 as lines of a terminal."""

from __future__ import annotations

from collections import Counter

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from foon_kg.formats.views.words import ASIDE, node_words
from foon_kg.model import Goal
from foon_kg.search import Enumeration, ReferenceTree

MOST_SHOWN = 10
_MOST_VIDEOS = 2


def candidates_view(goal: Goal, found: Enumeration, exact: ReferenceTree) -> RenderableType:
    """Return the best of the trees of ``goal`` that were ``found`` with their scores, and when looking ended.

    Beside it stands the ``exact`` tree of the search.
    """
    parts: list[RenderableType] = [Text.assemble("The reference trees of ", node_words(goal.node)), _table(found)]
    if found.found[MOST_SHOWN:]:
        parts.append(Text(f"… and {len(found.found) - MOST_SHOWN} more (--json has them all)", ASIDE))
    return Group(*parts, Text(), Text(_ended(found)), Text(_choice(found, exact)))


def _table(found: Enumeration) -> Table:
    table = Table(box=None, pad_edge=False, header_style=ASIDE)
    for title in ("", "overlap", "units", "gaps"):
        table.add_column(title, justify="right")
    table.add_column("steps from")
    for number, tree in enumerate(found.first(MOST_SHOWN), 1):
        figures = (number, tree.overlap, len(tree.units), len(tree.gaps))
        table.add_row(*map(str, figures), Text(_videos(tree), ASIDE))
    return table


def _videos(tree: ReferenceTree) -> str:
    """Return from how many units of which videos a tree is made, each unit counted for the first that has it."""
    counts = Counter(known.seen_in[0].video for known in tree.units if known.seen_in)
    ranked = sorted(counts.items(), key=lambda row: (-row[1], row[0]))
    rest = f", {len(ranked) - _MOST_VIDEOS} more" if ranked[_MOST_VIDEOS:] else ""
    return ", ".join(f"{video} {count}" for video, count in ranked[:_MOST_VIDEOS]) + rest


def _ended(found: Enumeration) -> str:
    trees = "1 tree" if len(found.found) == 1 else f"{len(found.found)} trees"
    if found.complete:
        return f"These are all: {trees} in {found.looked_at} combinations of producers."
    return f"Stopped after {found.looked_at} combinations of producers, with {trees} (--limit N looks at more)."


def _choice(found: Enumeration, exact: ReferenceTree) -> str:
    proven = "proven to be the best" if exact.exact else "the best one found in time"
    place = next((n for n, tree in enumerate(found.found, 1) if tree.rank == exact.rank), None)
    where = f"number {place}" if place else "none of these"
    figures = f"overlap {exact.overlap}, {len(exact.units)} units, {len(exact.gaps)} gaps"
    return f"The exact search chooses {where}: {figures}, {proven}."
