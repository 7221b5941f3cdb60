"""Where the tables of cooking and a FOON disagree: what its own counts tell, to be read and judged by a person.

    python benchmarks/food_table.py [--files FOLDER] [--least N] [--share S]

Five questions are asked of every video. Each prints the rows in which table and FOON differ, the most often seen first:

- cooking: foods that nearly all videos heat (a share of at least S) and the table does not want cooked, and foods that
  the table wants cooked and fewer videos heat.
- forms: kinds of food that join others cut nearly always and owe no cut, and kinds that owe one and join uncut.
- power: motions that mostly happen with something on or hot and need no source, and motions that need one and mostly
  happen without.
- tools: motions that need a tool and are mostly done without one that could do it.
- states: states that foods get by a motion and the motion cannot give.

A row is no mistake of the table: cheddar is heated nearly always and need not be. Rows with fewer than N videos
(units, for motions) are left out.
"""

import argparse
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from foon_kg.food import Level, Match, motions, singular, tables
from foon_kg.loaders import read_paths
from foon_kg.model import FunctionalUnit, ObjectNode, Subgraph

SHARED = Path(__file__).parents[1].parent / "shared" / "data"
TABLES = tables()
CUTS = frozenset({"cut", "grate", "grind", "blend", "mash"})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", type=Path, default=SHARED / "foon-111" / "TXT")
    parser.add_argument("--least", type=int, default=3)
    parser.add_argument("--share", type=float, default=0.9)
    options = parser.parse_args()
    videos = [result.subgraph for result in read_paths([options.files]) if result.subgraph is not None]
    units = [one.unit for video in videos for one in video.annotations]
    print(f"{len(videos)} videos, {len(units)} units")
    for title, rows in (
        ("cooking", cooking(videos, options.share)),
        ("forms", forms(videos, options.share)),
        ("power", power(units)),
        ("tools", tools(units)),
        ("states", states(units)),
    ):
        shown = sorted((row for row in rows if row[0] >= options.least), key=lambda row: (-row[0], row[1]))
        print(f"\n{title}: {len(shown)} rows")
        for count, said in shown:
            print(f"{count:>5}  {said}")


def cooking(videos: Sequence[Subgraph], share: float) -> Iterator[tuple[int, str]]:
    """Return how many videos heat a food, where the table says something else of it as it comes into them."""
    there: Counter[tuple[str, str]] = Counter()
    heated: Counter[tuple[str, str]] = Counter()
    for video in videos:
        units = units_of(video)
        hot = heated_in(units)
        for name, kind in kinds_in(units).items():
            there[name, kind] += 1
            heated[name, kind] += name in hot
    for (name, kind), count in there.items():
        row = TABLES.foods.kinds[kind]
        if row.traits & {"made", "stock", "liquid", "remains"}:
            continue
        owed, part = row.owes.get("cook") or row.owes.get("boil"), heated[name, kind] / count
        if part >= share and owed is None:
            yield count, f"{name} ({kind}): heated in {part:.0%} of the videos, and need not be cooked"
        if part < share and owed in {Level.FATAL, Level.MINOR}:
            yield count, f"{name} ({kind}): heated in {part:.0%} of the videos, and owes cooking ({owed})"


def kinds_in(units: Sequence[FunctionalUnit]) -> dict[str, str]:
    """Return the foods of a video with their kinds, by the first states that are told of each; unknown ones not."""
    found: dict[str, str] = {}
    for unit in units:
        for node in unit.input_nodes:
            if TABLES.utensil(node.label) is None and node.states:
                known = TABLES.foods.food(node.label, node.states)
                if known.match is not Match.UNKNOWN:
                    found.setdefault(singular(node.label), known.kind)
    return found


def heated_in(units: Sequence[FunctionalUnit]) -> set[str]:
    """Return the foods of a video that are heated, alone or in what was made of them."""
    made_of: defaultdict[str, set[str]] = defaultdict(set)
    hot: set[str] = set()
    for unit in units:
        names = {name for node in unit.input_nodes for name in foods(node)}
        names |= {food for name in names for food in made_of[name]}
        if motions.heats(unit.motion):
            hot |= names
        before = {singular(node.label) for node in unit.input_nodes}
        for node in unit.output_nodes:
            if singular(node.label) not in before and TABLES.utensil(node.label) is None:
                made_of[singular(node.label)] |= names
    return hot


def forms(videos: Sequence[Subgraph], share: float) -> Iterator[tuple[int, str]]:
    """Return in which form kinds of food join others, where the table says something else."""
    cut: Counter[str] = Counter()
    there: Counter[str] = Counter()
    motions_of: defaultdict[str, Counter[str]] = defaultdict(Counter)
    for video in videos:
        for name, (done, motion) in joins(units_of(video)).items():
            kind = TABLES.foods.find(name)[0]
            there[kind] += 1
            cut[kind] += done
            motions_of[kind][motion] += 1
    for kind, count in there.items():
        row = TABLES.foods.kinds.get(kind)
        part = cut[kind] / count
        owed = row.owes.get("cut") if row is not None else None
        usual = ", ".join(motion for motion, _ in motions_of[kind].most_common(3))
        if row is not None and owed is None and part >= share:
            yield count, f"{kind}: cut before it joins (by {usual}) in {part:.0%}, and owes no cut"
        if owed is Level.FATAL and part < share:
            yield count, f"{kind}: cut before it joins (by {usual}) in {part:.0%}, and owes a cut ({owed})"


def joins(units: Sequence[FunctionalUnit]) -> dict[str, tuple[bool, str]]:
    """Return for each food of a video whether it is cut when it first meets others, and by which motion it does.

    A food is cut where a motion that cuts took it, or where it is called so; the unit in which it joins counts too.
    """
    done: set[str] = set()
    found: dict[str, tuple[bool, str]] = {}
    for unit in units:
        own = {singular(node.label) for node in unit.input_nodes if TABLES.utensil(node.label) is None}
        if not TABLES.motion(unit.motion).does.isdisjoint(CUTS):
            done |= own
        for node in (*unit.input_nodes, *unit.output_nodes):
            if any("cut" in row.earns and not row.sold for row in map(TABLES.state, node.states)):
                done.add(singular(node.label))
        mixed = [foods(node) for node in unit.output_nodes if len(foods(node)) > 1]
        for name in own:
            if name not in found and any(name in names for names in mixed):
                found[name] = (name in done, unit.motion)
    return found


def power(units: Iterable[FunctionalUnit]) -> Iterator[tuple[int, str]]:
    """Return how often motions happen with an appliance on, where the table says something else."""
    there: Counter[str] = Counter()
    on: Counter[tuple[str, str]] = Counter()
    for unit in units:
        there[unit.motion] += 1
        on.update({(unit.motion, source) for node in unit.input_nodes if (source := source_of(node))})
    for motion, count in there.items():
        row = TABLES.motion(motion)
        if row.does & {"switch on", "switch off", "attach", "detach", "close", "uncover", "turn"}:
            continue
        for source in ("heat", "power"):
            part = on[motion, source] / count
            if part > 1 / 2 and not row.source:
                yield count, f"{motion}: {source} is on in {part:.0%} of its units, and it needs none"
            if part < 1 / 2 and row.source == source:
                yield count, f"{motion}: {source} is on in {part:.0%} of its units only, and it needs some"


def source_of(node: ObjectNode) -> str:
    """Return what a node of a unit lends: heat or power where it is on, heat where it is a hot vessel."""
    row = TABLES.utensil(node.label)
    told = {state.lower() for state in node.states}
    if row is None:
        return ""
    if told & TABLES.utensil_states["on"] and row.source in {"heat", "power"}:
        return row.source
    return "heat" if told & TABLES.utensil_states["hot"] and row.role == "vessel" else ""


def tools(units: Iterable[FunctionalUnit]) -> Iterator[tuple[int, str]]:
    """Return how often motions are done with a tool that can, where the table wants one and bare hands do not do."""
    there: Counter[str] = Counter()
    able: Counter[str] = Counter()
    used: defaultdict[str, Counter[str]] = defaultdict(Counter)
    for unit in units:
        rows = [row for node in unit.input_nodes if (row := TABLES.utensil(node.label)) is not None]
        there[unit.motion] += 1
        able[unit.motion] += all(any(need & row.can for row in rows) for need in TABLES.motion(unit.motion).tools)
        used[unit.motion].update(row.name for row in rows if row.role in {"tool", "lid"})
    for motion, count in there.items():
        needs = TABLES.motion(motion).tools
        if needs and not any("hand" in need for need in needs) and able[motion] / count < 1 / 2:
            usual = ", ".join(f"{name} {often}" for name, often in used[motion].most_common(3)) or "nothing"
            yield count, f"{motion}: a tool that can is there in {able[motion] / count:.0%}; used: {usual}"


def states(units: Iterable[FunctionalUnit]) -> Iterator[tuple[int, str]]:
    """Return the states that foods have after a motion and not before, and that the motion cannot give."""
    found: Counter[tuple[str, str]] = Counter()
    for unit in units:
        row = TABLES.motion(unit.motion)
        for state in fresh_states(unit):
            words = frozenset(state.split())
            if row.known and row.gives and not any(state == one or words & frozenset(one.split()) for one in row.gives):
                found[unit.motion, state] += 1
    for (motion, state), count in found.items():
        yield count, f"{motion} gives {state}, and cannot"


def fresh_states(unit: FunctionalUnit) -> Iterator[str]:
    """Return the states that a food of a unit has after it and had not before."""
    before: defaultdict[str, set[str]] = defaultdict(set)
    for node in unit.input_nodes:
        before[node.label].update(state.lower() for state in node.states)
    for node in unit.output_nodes:
        if node.label in before and TABLES.utensil(node.label) is None:
            told = {state.lower() for state in node.states if not state.endswith("]")}
            yield from sorted(told - before[node.label])


def units_of(video: Subgraph) -> list[FunctionalUnit]:
    return [one.unit for one in video.annotations]


def foods(node: ObjectNode) -> frozenset[str]:
    """Return the foods that a node is or holds, in the singular."""
    names = [*node.ingredients, *([] if TABLES.utensil(node.label) else [node.label])]
    return frozenset(singular(name) for name in names if TABLES.utensil(name) is None)


if __name__ == "__main__":
    main()
