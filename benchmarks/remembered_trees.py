"""What remembering reference trees spares: the search for every goal beside taking its tree from memory again.

    python benchmarks/remembered_trees.py [FOLDER]

FOLDER holds the subgraphs, by default those beside the checkout. CPU milliseconds of each goal with its own ingredients
as the wanted foods: searched; searched and remembered; taken again, which still collects and names what lies behind it.
Where the memory is Neo4j, asking it is one round trip more, and keeping a tree a transaction after the answer.
"""

from __future__ import annotations

import argparse
import gc
import statistics
import time
from pathlib import Path

from foon_kg.loaders import read_paths
from foon_kg.model.knowledge import RetrievedTree
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import NoWayError, SearchProblem, UnitIndex, retrieve, retrieve_once
from foon_kg.search.gaps import gap_cost, mixtures
from foon_kg.store.snapshot import Snapshot

SHARED = Path(__file__).parents[1].parent / "shared" / "data" / "foon-111" / "TXT"


class Memory(dict[str, RetrievedTree]):
    """Trees by their questions."""

    remembered = dict.get

    def remember(self, tree: RetrievedTree) -> None:
        """Keep ``tree``."""
        self[tree.question] = tree


def main(folder: Path) -> None:
    gc.set_threshold(100_000, 50, 100)
    kitchen, memory = Kitchen.default(), Memory()
    snapshot = Snapshot.of([r.subgraph for r in read_paths([folder]) if r.subgraph is not None], kitchen)
    costs = gap_cost(kitchen, snapshot.units, mixtures(kitchen, snapshot.vocabulary()))
    index = UnitIndex.of(snapshot.units, at_hand=kitchen.has, gap_cost=costs)
    assert all(node.key for node in index.nodes)  # units from the graph come with their keys
    times: dict[str, list[float]] = {"searched": [], "searched and remembered": [], "taken again": []}
    for goal in snapshot.goals():
        problem = SearchProblem(index, (goal.node,), {name: place for place, name in enumerate(goal.ingredients)})
        ways = (lambda p: retrieve(p, time_limit=None), *[lambda p: retrieve_once(p, memory, time_limit=None)] * 2)
        trees = []
        for taken, way in zip(times.values(), ways, strict=True):
            started = time.process_time()
            try:
                trees.append(way(problem))
            except NoWayError:
                break
            taken.append((time.process_time() - started) * 1000)
        assert all(tree == trees[0] for tree in trees)
    for what, taken in times.items():
        print(f"{what:24} {len(taken)} goals, median {statistics.median(taken):6.1f} ms, most {max(taken):6.1f} ms")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?", default=SHARED)
    main(parser.parse_args().folder)
