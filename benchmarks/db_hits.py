"""What foon-kg asks of Neo4j in db hits, for FOONs of growing size with one shape (see big_foon.py).

    python benchmarks/db_hits.py [--units N ...] [--recipes N] [--loaded] [--keep FILE] [--only NAME ...]

Needs the public subgraphs and recipes beside the checkout. The Neo4j is the one that NEO4J_URI names, else the local
server; it gets the FOONs, each on top of the smaller one (``--loaded``: it has the only size already). Each statement
of an operation runs under PROFILE, and what that counts is added up: db hits depend neither on the machine nor on what
else it does. For each operation, in the mean of what it was asked: db hits for the smallest FOON, for each larger one,
and the ratio; below it those of its statements that grew most. Programs have read nothing before ("cold") or what the
same program asked before ("warm"). Round trips are the statements that were sent, one after another. Each operation is
told when it is done, with the seconds that it took, PROFILE included. ``--keep`` adds what was counted to a JSON file,
and compares with all that it has: so sizes are measured on different days. ``--only`` does the operations whose names
begin so. At the end the most memory that this process had:
where ``--loaded`` is not given, of making the FOON as well.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

import neo4j
from big_foon import SHARED, big_foon, real_subgraphs

from foon_kg import Foon
from foon_kg.cypher import explore_queries
from foon_kg.model import Subgraph
from foon_kg.model.errors import FoonError, NoTreeError
from foon_kg.planning.batch import Question
from foon_kg.planning.recipes import recipe_files
from foon_kg.planning.settings import PlanSettings
from foon_kg.store.graph import Connection, load, remove
from foon_kg.store.server import connection_settings
from foon_kg.web.graph_words import GraphWords
from foon_kg.web.sources import SAMPLE

QUERIES = SHARED.parents[1] / "queries"
FOODS = ("caper", "leek", "prune", "tofu")
AT_HAND = ("egg", "onion", "grated cheddar")
DISHES = ("omelette", "greek salad", "coffee")
SHOWN = 4

Costs = dict[str, Counter[str]]
"""By operation, then by statement: db hits."""


class Profiler:
    """Has every statement of a transaction run under PROFILE while it is ``on``; ``hits`` counts by statement."""

    def __init__(self) -> None:
        self.hits: Counter[str] = Counter()
        self.trips = 0
        self._run = neo4j.Transaction.run

    @contextmanager
    def on(self) -> Iterator[Counter[str]]:
        """Count anew; yield the counter, which is full once the block ends."""
        self.hits, self.trips, run = Counter(), 0, self._run

        def profiled(transaction, query, parameters=None, **more):  # type: ignore[no-untyped-def]
            result = run(transaction, f"PROFILE {query}", parameters, **more)
            rows, keys = list(result), result.keys()
            self.trips += 1
            self.hits[_name_of(query)] += _db_hits(result.consume().profile)
            return _Rows(rows, keys)

        base = neo4j.Transaction.__mro__[1]
        base.run = profiled  # type: ignore[attr-defined]
        try:
            yield self.hits
        finally:
            base.run = self._run  # type: ignore[attr-defined]


class _Rows(list):  # type: ignore[type-arg]
    def __init__(self, rows: Sequence[neo4j.Record], keys: Sequence[str]) -> None:
        super().__init__(rows)
        self._keys = keys

    def keys(self) -> Sequence[str]:
        return self._keys


def _db_hits(plan: dict[str, object] | None) -> int:
    if plan is None:
        return 0
    children = plan.get("children") or ()
    return int(plan.get("dbHits") or 0) + sum(map(_db_hits, children))  # type: ignore[call-overload, arg-type]


def _name_of(query: str) -> str:
    """Return the first words of what the header says a statement does."""
    return query.splitlines()[0].removeprefix("// ")[:70]


def costs(paths: Sequence[Path], video: Subgraph, only: Sequence[str] = ("",)) -> Costs:
    """Return the mean db hits of every operation on the FOON that is there; ``video`` goes and comes back."""
    profiler, found = Profiler(), {}

    def count(name: str, asked: Sequence[Callable[[Foon], object]], *, times: int = 1) -> None:
        if not name.startswith(tuple(only)):
            return
        started = time.perf_counter()
        try:
            found[name], trips = _counted(profiler, asked, times)
        except FoonError as error:
            found[name], trips = _not_answered(name, error), 0
        _told(name, found[name], started, trips)

    planned = [_planned(path) for path in paths]
    count("plan, cold", planned)
    count("plan, its tree is kept", planned)
    count("plan, warm", planned, times=2)
    count("similar", [lambda foon, food=food: foon.similar(food) for food in FOODS])
    count("retrieve", [lambda foon, dish=dish: foon.retrieve(dish) for dish in DISHES])
    count("suggest", [lambda foon: foon.suggest(AT_HAND)])
    count("suggest, warm", [lambda foon: foon.suggest(AT_HAND)], times=2)
    count("statistics", [lambda foon: foon.statistics()])
    count("recipes", [lambda foon: foon.recipe_counts()])
    count("unseen foods of recipes", [lambda foon: foon.wanted_foods()])
    count("page, its first view", [lambda foon: GraphWords(foon).summary()])
    count("page, videos for its examples", [lambda foon: foon.sample(SAMPLE)])
    found |= _named(profiler, only)
    with Connection(connection_settings()) as connection:
        for name, change in (
            ("remove one video", lambda: remove(connection, [video.name])),
            ("load one video", lambda: load(connection, [video])),
            ("load it again", lambda: load(connection, [video])),
        ):
            if name.startswith(tuple(only)):
                started = time.perf_counter()
                with profiler.on() as hits:
                    change()
                found[name] = hits
                _told(name, hits, started, profiler.trips)
    return found


def _told(name: str, hits: Counter[str], started: float, trips: float) -> None:
    seconds = time.perf_counter() - started
    print(f"{name}: {sum(hits.values()):,} db hits, {trips:.1f} round trips, {seconds:.1f} s", flush=True)


def _counted(profiler: Profiler, asked: Sequence[Callable[[Foon], object]], times: int) -> tuple[Counter[str], float]:
    """Return the mean of what is asked and of its round trips: of the last of ``times`` that one program asks it."""
    whole: Counter[str] = Counter()
    trips = 0
    for ask in asked:
        with tempfile.TemporaryDirectory() as cache:
            os.environ["FOON_KG_CACHE"] = cache
            with Foon(server=connection_settings()) as foon:
                for _ in range(times - 1):
                    _ask(foon, ask)
                with profiler.on() as hits:
                    _ask(foon, ask)
        whole.update(hits)
        trips += profiler.trips
    return Counter({name: round(hits / len(asked)) for name, hits in whole.items()}), trips / len(asked)


def _not_answered(name: str, error: FoonError) -> Counter[str]:
    """Say that the server does not answer what is asked, as for want of memory; it counts as nothing."""
    print(f"{name}: {error}", flush=True)
    return Counter()


def _ask(foon: Foon, ask: Callable[[Foon], object]) -> None:
    with suppress(NoTreeError):
        ask(foon)


def _planned(path: Path) -> Callable[[Foon], object]:
    return lambda foon: foon.answer(Question(path), PlanSettings())


def _named(profiler: Profiler, only: Sequence[str]) -> Costs:
    """Return what the named questions cost, each asked as its example says."""
    found: Costs = {}
    with Connection(connection_settings()) as connection:
        for query in explore_queries():
            if not f"named: {query.name}".startswith(tuple(only)):
                continue
            started = time.perf_counter()
            given = (query.defaults | query.examples).items()
            values = {name: _value(text, query.parameters[name]) for name, text in given}
            try:
                with profiler.on() as hits, connection.session() as session, session.begin_transaction() as transaction:
                    transaction.run(query.text, values)
            except FoonError as error:
                found[f"named: {query.name}"] = _not_answered(query.name, error)
                continue
            found[f"named: {query.name}"] = Counter({query.name: sum(hits.values())})
            _told(f"named: {query.name}", found[f"named: {query.name}"], started, profiler.trips)
    return found


def _value(text: str, kind: str) -> object:
    if kind.startswith("LIST"):
        return [part.strip() for part in text.split(",")]
    return text if kind == "STRING" else json.loads(text)


def table(sizes: Sequence[int], measured: Sequence[Costs]) -> Iterator[str]:
    """Yield the lines that compare every size with the smallest."""
    yield f"{'db hits':44}" + "".join(f"{size:>13,}" for size in sizes) + f"{'ratio':>8}"
    for name in (name for name in measured[0] if all(name in costs for costs in measured)):
        every = [sum(costs[name].values()) for costs in measured]
        yield _line(name, every)
        if len(every) == 1:
            for text, hits in measured[0][name].most_common(SHOWN):
                yield _line(f"  {text}", [hits])
        elif every[-1] > 2 * every[0]:
            grown = Counter({text: hits - measured[0][name][text] for text, hits in measured[-1][name].items()})
            for text, more in grown.most_common(SHOWN):
                if more > every[0] / 10 and text != name.removeprefix("named: "):
                    yield _line(f"  {text}", [costs[name][text] for costs in measured])


def _line(name: str, every: Sequence[int]) -> str:
    return f"{name[:43]:44}" + "".join(f"{hits:>13,}" for hits in every) + f"{every[-1] / max(every[0], 1):>8.1f}"


def _read(file: Path) -> dict[int, Costs]:
    """Return what was counted before, by the size of the FOON."""
    if not file.exists():
        return {}
    held = json.loads(file.read_text(encoding="utf-8"))
    return {int(units): {name: Counter(hits) for name, hits in costs.items()} for units, costs in held.items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--units", type=int, nargs="*", default=[2_400, 20_000])
    parser.add_argument("--recipes", type=int, default=6)
    parser.add_argument("--loaded", action="store_true")
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--only", nargs="*", default=[""])
    options = parser.parse_args()
    real = real_subgraphs()
    paths = list(recipe_files([QUERIES]))
    paths = paths[:: len(paths) // options.recipes]
    kept: dict[int, Costs] = _read(options.keep) if options.keep else {}
    for units in options.units:
        if not options.loaded:
            with Connection(connection_settings()) as connection:
                load(connection, big_foon(real, units))
            print(f"{units:,} units are loaded", flush=True)
        kept[units] = kept.get(units, {}) | costs(paths, real[len(real) // 2], options.only)
        print("\n".join(table([units], [kept[units]])), flush=True)
        if options.keep:
            options.keep.write_text(json.dumps(kept, indent=1), encoding="utf-8")
    print("\n".join(table(sorted(kept), [kept[units] for units in sorted(kept)])))
    print(f"this process had {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:,.0f} MB at most")


if __name__ == "__main__":
    try:
        main()
    except FoonError as error:
        raise SystemExit(f"{error} ({error.hint})") from error
