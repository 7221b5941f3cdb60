"""Progress lines against those that the FOON's authors printed: how many agree, and where they differ, who is right.

    python benchmarks/progress_lines.py ../shared/data --show 20

A line is judged by its motions: does a chain of the subgraph's units, each taking what the one before put out, have
just these motions, begin with a node that is or holds the ingredient and end with the goal? The states of a stage are
compared only where the motions agree.
"""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from foon_kg.food import singular
from foon_kg.loaders.paths import read_paths
from foon_kg.model import FunctionalUnit, ObjectNode, RequiredIngredient
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.progress import ProgressLine, progress_lines
from foon_kg.store.snapshot import goals_of

KITCHEN = Kitchen.default()


def pairs(data: Path) -> Iterator[tuple[str, Sequence[FunctionalUnit], ObjectNode, dict[str, Any], ProgressLine]]:
    """Yield every printed line with its subgraph, and ours of the same ingredient to the same end product."""
    read = read_paths([data / "foon-111" / "TXT"])
    subgraphs = {result.subgraph.name: result.subgraph for result in read if result.subgraph}
    for path in sorted((data / "progress-lines").glob("*.json")):
        subgraph = subgraphs.get(path.stem)
        if subgraph is None:
            continue
        tree = [note.unit for note in subgraph.annotations]
        goals = {goal.label: goal for goal, _ in goals_of(subgraph, KITCHEN)}
        for theirs in json.loads(path.read_text(encoding="utf-8")):
            goal = goals.get(theirs["end_product"]) or next(iter(goals.values()), None)
            if goal is not None:
                (ours,) = progress_lines(tree, goal, [RequiredIngredient(theirs["ingredient"], "")], KITCHEN)
                yield subgraph.name, tree, goal, theirs, ours


def is_or_holds(node: ObjectNode, food: str) -> bool:
    return singular(node.label) == food or any(singular(name) == food for name in node.ingredients)


def reached(tree: Sequence[FunctionalUnit], food: str, motions: Sequence[str]) -> set[tuple[int, ObjectNode]]:
    """Return where a chain of units with these motions may end: a unit's place, and a node it puts out."""
    ends = {
        (place, node)
        for place, unit in enumerate(tree)
        if motions and unit.motion == motions[0] and any(is_or_holds(taken, food) for taken in unit.input_nodes)
        for node in unit.output_nodes
    }
    for motion in motions[1:]:
        ends = {
            (place, node)
            for before, taken in ends
            for place in range(before + 1, len(tree))
            if tree[place].motion == motion and taken in tree[place].input_nodes
            for node in tree[place].output_nodes
        }
    return ends


def verdict(tree: Sequence[FunctionalUnit], goal: ObjectNode, theirs: dict[str, Any], ours: ProgressLine) -> str:
    motions = [step.motion for step in ours.steps]
    if theirs["motion"] == motions:
        return "the same motions"
    if KITCHEN.is_utensil(theirs["ingredient"]) or theirs["end_product"] is None:
        return "theirs is the line of a utensil or an intermediate, which ours leaves to the foods"
    dishes = [place for place, step in enumerate(ours.steps) if step.object == theirs["end_product"]]
    if dishes and theirs["motion"] == motions[: dishes[0]]:
        return "the same up to where the dish first has its name; ours goes on to the goal"
    ends = reached(tree, singular(theirs["ingredient"]), theirs["motion"])
    if not ends:
        return "theirs is no chain of units"
    if all(node != goal and node.label != theirs["end_product"] for _, node in ends):
        return "theirs breaks off before the end product"
    return "both are chains to the end product" if ours.steps else "ours has no line and theirs is a chain"


def stages_agree(theirs: dict[str, Any], ours: ProgressLine) -> Counter[str]:
    """Count the stages of a line whose states and places agree, given that the motions do."""
    count: Counter[str] = Counter()
    for stage, step in zip(theirs["state"], ours.steps, strict=False):
        words = [word for word in stage["physical_state"].split(",") if word]
        count["stages"] += 1
        count["the same states"] += sorted(words) == list(step.states)
        count["states repeated or split by theirs"] += len(words) != len(set(words))
        count["the same place"] += (stage["location"] or None) == step.container
    return count


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="the folder with foon-111 and progress-lines")
    parser.add_argument("--show", type=int, default=0, help="print so many lines of each kind of difference")
    arguments = parser.parse_args()
    verdicts: Counter[str] = Counter()
    stages: Counter[str] = Counter()
    for name, tree, goal, theirs, ours in pairs(arguments.data):
        kind = verdict(tree, goal, theirs, ours)
        verdicts[kind] += 1
        if kind == "the same motions":
            stages += stages_agree(theirs, ours)
        elif verdicts[kind] <= arguments.show:
            print(f"{kind}: {name}, {theirs['ingredient']} to {theirs['end_product']}")
            print("   theirs", " > ".join(theirs["motion"]))
            print("   ours  ", " > ".join(step.motion for step in ours.steps))
    total = sum(verdicts.values())
    for kind, count in verdicts.most_common():
        print(f"{count:5} {count / total:6.1%}  {kind}")
    for kind, count in stages.most_common():
        print(f"{count:5} {count / stages['stages']:6.1%}  {kind}")


if __name__ == "__main__":
    main()
