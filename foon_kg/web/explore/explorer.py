"""Everything that one FOON answers to who wanders through it."""

from __future__ import annotations

from foon_kg.foon import Snapshot
from foon_kg.web.explore.about import Telling
from foon_kg.web.explore.neighbourhood import Neighbours
from foon_kg.web.explore.network import Network
from foon_kg.web.explore.searching import Search
from foon_kg.web.explore.ways import Ways


class Explorer:
    """The search, the neighbours, the ways and the words of one FOON. Any number of threads may ask."""

    def __init__(self, snapshot: Snapshot) -> None:
        self.network = Network(snapshot)
        self.search = Search(self.network)
        self.neighbours = Neighbours(self.network)
        self.ways = Ways(self.network)
        self.telling = Telling(self.network)
