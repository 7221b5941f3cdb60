"""One write transaction on the graph.

Writers take turns: making a :class:`Writer` waits until no other is at work. So counts are never added to twice, and no
unit is swept away while another program refers to it.
"""

from __future__ import annotations

import dataclasses
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import chain
from typing import Any

from foon_kg.food import singular
from foon_kg.model import Subgraph
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.points import indexed_points
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph import statements as cypher
from foon_kg.store.graph.learning import Learner
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.schema import kitchen_key, schema_version
from foon_kg.store.graph.statements import Ask
from foon_kg.store.graph.taught import Taught, taught_by
from foon_kg.store.graph.values import bare_unit_of, subgraph_of
from foon_kg.store.graph.video_rows import VideoRows, movement_rows, objects_together, unit_rows, units_together
from foon_kg.store.vocabulary import UnitWords, WordCounts


class Writer:
    """Adds and forgets subgraphs; :meth:`finish` brings everything derived up to date.

    ``ask`` runs statements: in one transaction, or on what is staged for an import (:mod:`foon_kg.store.offline`).
    ``teach`` says what a video teaches by itself, where that was worked out before.
    ``state`` is what the graph said about itself when our turn came; ``None`` where there is no graph (any more).

    Units that lost a sighting are looked at only at the end, so that what the new content of a video shows again is
    never deleted in between.
    """

    def __init__(self, ask: Ask, kitchen: Kitchen, teach: Callable[[Subgraph], Taught] | None = None) -> None:
        self._ask = ask
        self._kitchen = kitchen
        self._counts = WordCounts(kitchen.is_utensil)
        self._teach = teach or partial(taught_by, kitchen=kitchen)
        self._learner = Learner(self._ask)
        self._doubtful: set[str] = set()
        self._states: Counter[str] = Counter()
        self._words: set[str] = set()
        """Names of what comes, which may be foods without a point, and of what goes, which nobody may use any more."""
        self.state = next(iter(self._ask(cypher.WRITING_TURN)), None)

    def add(self, subgraphs: Sequence[Subgraph]) -> None:
        """Write the videos ``subgraphs``, of which the graph has no sightings (any more)."""
        if not subgraphs:
            return
        taught = [self._teach(subgraph) for subgraph in subgraphs]
        rows = [one.rows for one in taught]
        self._ask(cypher.LOAD_VIDEOS, videos=[one.video for one in rows])
        self._add_nodes(objects_together(rows))
        fresh = self._add_units(units_together(one.units for one in rows))
        self._add_sightings(rows)
        self._counts.add(_words_of_units(rows, fresh))
        self._learner.learn(sorted(fresh), taught)

    def _add_units(self, units: Mapping[str, Mapping[str, Any]]) -> set[str]:
        """Write units, and what moves in those that were there; return the keys of those that are new."""
        rows = self._ask(cypher.LOAD_UNITS, units=list(units.values()))
        fresh = set(chain.from_iterable(row.keys for row in rows))
        self._add_movements(row for key, row in units.items() if key not in fresh)
        return fresh

    def _add_movements(self, units: Iterable[Mapping[str, Any]], weight: int = 1) -> None:
        """Add what moves in ``units``, which the graph has; where their sightings go, ``weight`` is -1."""
        if rows := list(movement_rows(units, weight)):
            self._ask(cypher.LOAD_MOVEMENTS, rows=rows)

    def _add_nodes(self, nodes: Mapping[str, Mapping[str, Any]]) -> None:
        """Write object nodes, and remember the states of those that are new and the words of all."""
        for row in self._ask(cypher.LOAD_OBJECTS, objects=list(nodes.values())):
            self._states.update(state for key in row.keys for state in nodes[key]["states"])
        self._words.update(name for row in nodes.values() for name in row["ingredients"])

    def _add_sightings(self, videos: Sequence[VideoRows]) -> None:
        """Write where units are seen, in which order, and which goals they make."""
        self._ask(cypher.LOAD_SIGHTINGS, videos=[one.sightings for one in videos])
        self._ask(cypher.LOAD_GOALS, goals=[row for one in videos for row in one.goals])

    def forget(self, names: Sequence[str]) -> None:
        """Take away what the named videos say, but not the videos."""
        if names:
            going = [subgraph_of(row) for row in self._ask(cypher.SUBGRAPHS, names=names)]
            self._words.update(word for subgraph in going for word in _words_of(subgraph))
            self._add_movements(units_together(map(unit_rows, going)).values(), weight=-1)
            self._ask(cypher.FORGET_GOALS, names=names)
            self._doubtful |= {row.key for row in self._ask(cypher.FORGET_SIGHTINGS, names=names)}
            self._learner.forget(names)

    def drop_videos(self, names: Sequence[str]) -> None:
        """Take away the forgotten videos called ``names``."""
        self._ask(cypher.FORGET_VIDEOS, names=names)

    def finish(self) -> None:
        """Sweep what no video shows any more, and bring the counts of words up to date."""
        rows = self._ask(cypher.UNSUPPORTED_UNITS, keys=sorted(self._doubtful)) if self._doubtful else []
        gone = list(map(bare_unit_of, rows))
        self._counts.count(gone, weight=-1)
        self._learner.unlearn(gone, self._doubtful)
        if gone:
            for swept in self._ask(cypher.SWEEP_UNITS, keys=[row.key for row in rows]):
                self._states.subtract(swept.states)
        self._count_states()
        self._count_words()
        self._learner.finish(self._doubtful)
        if self._doubtful:
            self._ask(cypher.SWEEP_WORDS, words=sorted(self._words))
        self._write_vectors()

    def _count_words(self) -> None:
        """Bring the counts of foods, motions and verbs up to date, and remember what they are called."""
        foods, motions = list(self._counts.seen_as()), list(self._counts.made_by())
        verbs = list(self._counts.gatherings())
        self._words.update(chain.from_iterable((row.label, row.state) for row in foods))
        self._words.update(chain.from_iterable((row.state, row.motion) for row in motions))
        self._words.update(row.motion for row in verbs)
        if foods or motions or verbs:
            self._ask(cypher.COUNT_FOODS, rows=[row._asdict() for row in foods])
            self._ask(cypher.COUNT_MOTIONS, rows=list(map(dataclasses.asdict, motions)))
            self._ask(cypher.COUNT_VERBS, rows=list(map(dataclasses.asdict, verbs)))

    def _count_states(self) -> None:
        if rows := [{"state": state, "count": count} for state, count in sorted(self._states.items()) if count]:
            self._ask(cypher.COUNT_STATES, rows=rows)

    def write_anew(self) -> None:
        """Write the whole FOON again, for another kitchen than the one that the graph was written with."""
        names = [row.name for row in self._ask(cypher.VIDEO_NAMES)]
        subgraphs = [subgraph_of(row) for row in self._ask(cypher.SUBGRAPHS, names=names)]
        self._ask(cypher.CLEAR)
        self.add(subgraphs)
        self.finish()
        self.recount()
        self.record(methods_key())

    def recount(self) -> None:
        """Count what each load adds to, where nobody counted it yet, or what was counted is gone."""
        self._ask(cypher.RECOUNT_WORDS)

    def forget_methods(self, most: int) -> bool:
        """Take away some of what was learnt, at ``most`` so many nodes; return whether there was any."""
        return any(row.gone for row in self._ask(cypher.FORGET_METHODS, most=most))

    def learn(self, names: Sequence[str]) -> None:
        """Learn from the videos called ``names``, which are there, and from their units.

        Some of these may be learnt from already.
        """
        subgraphs = [subgraph_of(row) for row in self._ask(cypher.SUBGRAPHS, names=names)]
        taught = [self._teach(subgraph) for subgraph in subgraphs]
        units = {key for one in taught for key in one.units}
        rows = self._ask(cypher.ATTESTED, keys=sorted(units))
        known = {unit for row in rows for unit, *_ in row.attested}
        self._learner.learn(sorted(units - known), taught)
        self._learner.unlearn((), ())
        self._learner.finish(())
        self._write_vectors()

    def record(self, methods: str) -> None:
        """Write down which kitchen the graph is written with, and by which ``methods`` it was learnt from."""
        kitchen = kitchen_key(self._kitchen)
        self._ask(cypher.SCHEMA_RECORD, version=schema_version(), kitchen=kitchen, methods=methods)

    def _write_vectors(self) -> None:
        """Give every food its point in the vector index; all of them anew where the word lists are others."""
        words = word_lists_key()
        if self.state is None or self.state.words != words:
            self._ask(cypher.FORGET_VECTORS, words=words)
            found = self._ask(cypher.FOODS_WITHOUT_VECTOR)
        else:
            found = self._ask(cypher.FOODS_NEW, names=sorted(self._words | self._learner.matters))
        names = sorted(row.name for row in found)
        if names:
            rows = zip(names, indexed_points(names), strict=True)
            self._ask(
                cypher.LOAD_VECTORS,
                rows=[
                    {"name": name, "canonical": canonical(name), "singular": singular(name), "vector": vector}
                    for name, vector in rows
                ],
            )


def _words_of_units(videos: Iterable[VideoRows], keys: Collection[str]) -> Iterator[UnitWords]:
    """Yield what the units of ``videos`` with these ``keys`` add to the counts of words, each once."""
    found: dict[str, UnitWords] = {}
    for video in videos:
        found.update(video.words)
    yield from map(found.__getitem__, keys)


def _words_of(subgraph: Subgraph) -> Iterator[str]:
    """Yield the labels, ingredients, states and motions of a video, each as often as it says them."""
    for annotation in subgraph.annotations:
        yield annotation.unit.motion
        for node in (*annotation.unit.input_nodes, *annotation.unit.output_nodes):
            yield from (node.label, *node.ingredients, *node.states)
