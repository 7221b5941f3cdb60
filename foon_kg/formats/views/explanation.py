"""Why a plan makes every ingredient as it does, as lines of a terminal."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.text import Text

from foon_kg.formats.views.words import ASIDE, STATE
from foon_kg.planning.explanation import Explanation


def explanation_view(explanations: Sequence[Explanation]) -> RenderableType:
    """Return for each of the ``explanations`` where a food comes from, where it joins, and what was passed over."""
    parts: list[RenderableType] = [Text(), Text("Why each ingredient is made so", "bold")]
    for one in explanations:
        name = Text.assemble(one.want.object, " (", (one.want.state, STATE), ")")
        parts.append(Padding(name, (0, 0, 0, 2)))
        sentences = [*map(Text, one.reasons), *(Text(other, ASIDE) for other in one.others)]
        parts.append(Padding(Group(*sentences), (0, 0, 0, 4)))
    return Group(*parts)
