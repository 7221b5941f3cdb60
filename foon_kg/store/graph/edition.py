"""What was read of one edition of the FOON: true as long as nobody writes, so the next view need not ask again."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.integration.methods import Methods
from foon_kg.model import Goal, KnownUnit
from foon_kg.model.knowledge import LikelyGoals, SeenAs, Vocabulary
from foon_kg.model.recent import Recent
from foon_kg.store.graph.methods import CommonMethods, LearntDishes
from foon_kg.store.graph.near_matters import KnownMatters
from foon_kg.store.graph.words_for import WordsFound

MOST_UNITS = 20_000
"""Bounds the memory that units read before may take: some 60 MB."""

MOST_MATTERS = 4_000
"""Bounds what is known of operators: some 60 MB."""

MOST_QUESTIONS = 256
"""For so many recipes it is kept which words and goals matter to them: some 40 kB each."""

Asked = tuple[tuple[str, ...], tuple[str, ...]]


@dataclass
class Edition:
    """The answers that one edition of the FOON gave so far; views of the same edition share it.

    ``rows_of`` has what the vocabulary has about the foods in ``units``.
    ``name`` is ``None`` where the graph does not tell editions apart: then every view begins with nothing.
    """

    name: str | None = None
    vocabulary: Vocabulary | None = None
    goals: dict[str, tuple[Goal, ...]] = field(default_factory=dict)
    methods: Methods | None = None
    dishes: LearntDishes | None = None
    common: CommonMethods | None = None
    matters: KnownMatters = field(default_factory=KnownMatters)
    units: dict[str, KnownUnit] = field(default_factory=dict)
    rows_of: dict[str, tuple[SeenAs, ...]] = field(default_factory=dict)
    words: Recent[Asked, WordsFound | None] = field(default_factory=lambda: Recent(MOST_QUESTIONS))
    likely: Recent[tuple[str | None, tuple[str, ...], int], LikelyGoals] = field(
        default_factory=lambda: Recent(MOST_QUESTIONS)
    )

    def still(self, name: str | None) -> Edition:
        """Return this edition where it has its ``name`` still and is not too large, else a new one without answers."""
        same = name is not None and name == self.name
        small = len(self.units) <= MOST_UNITS and len(self.matters.rows) <= MOST_MATTERS
        return self if same and small else Edition(name)
