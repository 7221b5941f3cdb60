"""How good are drafts? Each video of a FOON is told in words and drafted from the other videos, then compared.

    python benchmarks/drafts.py ../shared/data/foon-111/TXT --every 4

A video is told twice: as verb and noun rows (the motion, its main object, the foods that join it, the place), and as
sentences, which foon-kg writes of units (``foon_kg.formats.exports.sentences``) and spaCy's parser reads again. A unit
counts as drafted when the draft has one with the same motion and main object (names compared as foon-kg does); "with
states" asks for the states of that object before and after, too. Of several foods that a unit changes, the one that its
annotators wrote first is the main one, which no sentence tells: "any of its foods" counts the units whose main object
is one of them. Both sides are multisets: a unit drafted twice counts once. Units that a draft adds as assumed are
counted like all others.

What the confidence is worth is printed as a reliability table and as Brier scores (mean squared error of a probability,
less is better): of the confidence as it is, of what a logistic curve makes of it, and of the share of right units.
Curve and share are cross-fitted: those of a video are learned from the other folds of videos. The curve over all videos
says how ``foon_kg.language.drafting.calibration`` should change: multiply its slope, multiply its height and add.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import exp, log
from pathlib import Path

import networkx as nx

from foon_kg.formats.exports.sentences import sentence
from foon_kg.language.drafting import draft
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.instructions import with_actions
from foon_kg.loaders import read_paths
from foon_kg.model import FunctionalUnit
from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place, Sentence
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()
BINS = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 1.01)
FOLDS = 10

Judged = tuple[float, bool]
"""The confidence of a drafted unit, and whether it was right with its states."""


def main_object(unit: FunctionalUnit):
    """Return the first food (else utensil) that is not the same after the unit, and what it becomes."""
    outputs = {node.label: node for node in unit.output_nodes}
    changed = [node for node in unit.input_nodes if node not in unit.output_nodes]
    foods = [node for node in changed if KITCHEN.is_food(node)]
    node = (foods or changed or list(unit.input_nodes))[0]
    return node, outputs.get(node.label)


def plain(unit: FunctionalUnit):
    return canonical(unit.motion), canonical(main_object(unit)[0].label)


def with_states(unit: FunctionalUnit):
    before, after = main_object(unit)
    return (*plain(unit), before.states, after.states if after else None)


def near_pairs(units, drafted):
    """Return how many pairs there are of a unit and a drafted one with its motion and one of the foods it changes."""
    pairs = nx.Graph()
    for place, unit in enumerate(units):
        motion = canonical(unit.motion)
        foods = {canonical(node.label) for node in unit.input_nodes if KITCHEN.is_food(node)} | {plain(unit)[1]}
        same = (number for number, (done, food) in enumerate(map(plain, drafted)) if done == motion and food in foods)
        pairs.add_edges_from(((0, place), (1, number)) for number in same)
    top = {node for node in pairs if node[0] == 0}
    return len(nx.bipartite.maximum_matching(pairs, top)) // 2


def as_rows(video):
    """Return verb and nouns of each unit, as a person would annotate them: no states, no tools."""
    actions = []
    for annotation in video.annotations:
        unit = annotation.unit
        node, after = main_object(unit)
        moved = [n for n in unit.input_nodes if KITCHEN.is_food(n) and n != node and n not in unit.output_nodes]
        place = after.container if after is not None else None
        if place is None:
            gained = [n.label for n in unit.output_nodes if node.label in n.ingredients and n.label != node.label]
            place = gained[0] if gained else None
        places = (Place("in", place),) if place else ()
        named = dict.fromkeys(Mention(n.label) for n in (node, *moved))
        actions.append(NarratedAction(unit.motion, tuple(named), places, said=unit.motion, timing=annotation.timing))
    return Narration(video.name, tuple(actions))


def as_text(video):
    return Narration(
        video.name, sentences=tuple(Sentence(sentence(annotation.unit, KITCHEN)) for annotation in video.annotations)
    )


class Score:
    """How many units of the held-out videos were drafted, and how often each confidence was right."""

    def __init__(self, name):
        self.name = name
        self.videos: list[list[Judged]] = []
        self.common, self.drafted, self.true, self.near = Counter(), 0, 0, 0

    def add(self, video, drafted):
        """Count one video."""
        units = [annotation.unit for annotation in video.annotations]
        self.true += len(units)
        self.drafted += len(drafted.units)
        for way in (plain, with_states):
            there = Counter(map(way, units))
            found = Counter(way(row.annotation.unit) for row in drafted.units)
            self.common[way] += (there & found).total()
        self.near += near_pairs(units, [row.annotation.unit for row in drafted.units])
        left = Counter(map(with_states, units))
        judged: list[Judged] = []
        for row in drafted.units:
            key = with_states(row.annotation.unit)
            judged.append((row.confidence, left[key] > 0))
            left[key] -= left[key] > 0
        self.videos.append(judged)

    def show(self):
        """Print the figures."""
        print(f"\n{self.name}: {self.true} units, {self.drafted} drafted")
        for way, what in ((plain, "motion and main object"), (with_states, "with states")):
            precision, recall = self.common[way] / max(self.drafted, 1), self.common[way] / self.true
            print(f"  {what:24} precision {precision:.2f}  recall {recall:.2f}")
        precision, recall = self.near / max(self.drafted, 1), self.near / self.true
        print(f"  {'any of its foods':24} precision {precision:.2f}  recall {recall:.2f}")
        judged = [one for video in self.videos for one in video]
        ways = (("as it is", judged), ("cross-fitted", cross_fitted(self.videos, logistic)))
        for what, pairs in (*ways, ("share alone", cross_fitted(self.videos, share))):
            print(f"  confidence {what:12} Brier {sum((sure - right) ** 2 for sure, right in pairs) / len(pairs):.3f}")
        for what, pairs in ways:
            print(f"  confidence {what}: " + "  ".join(reliability(pairs)))
        slope, height = curve(judged)
        print(f"  curve over all of it: slope {slope:.2f}, height {height:+.2f}")


def reliability(pairs: Sequence[Judged]) -> Iterator[str]:
    """Yield for each range of confidence: how many units, the mean confidence, and the share that was right."""
    for low, high in pairwise(BINS):
        here = [pair for pair in pairs if low <= pair[0] < high]
        if here:
            said, right = (sum(values) / len(here) for values in zip(*here, strict=True))
            yield f"{len(here)}: {said:.2f} → {right:.2f}"


def cross_fitted(
    videos: Sequence[Sequence[Judged]], fit: Callable[[Sequence[Judged]], Callable[[float], float]]
) -> list[Judged]:
    """Return every judged unit with what is fitted on the videos of the other folds in place of its confidence."""
    pairs: list[Judged] = []
    for fold in range(FOLDS):
        others = [pair for place, video in enumerate(videos) if place % FOLDS != fold for pair in video]
        fitted = fit(others)
        pairs += [(fitted(sure), right) for video in videos[fold::FOLDS] for sure, right in video]
    return pairs


def share(pairs: Sequence[Judged]) -> Callable[[float], float]:
    """Return one figure for every confidence: the share of right units."""
    right = sum(right for _, right in pairs) / len(pairs)
    return lambda _: right


def logistic(pairs: Sequence[Judged]) -> Callable[[float], float]:
    """Return the logistic curve over the log odds of a confidence that fits best."""
    slope, height = curve(pairs)
    return lambda sure: 1 / (1 + exp(-slope * odds(sure) - height))


def curve(pairs: Sequence[Judged]) -> tuple[float, float]:
    """Return slope and height of greatest likelihood, by Newton's method."""
    slope, height = 1.0, 0.0
    for _ in range(25):
        said = [(odds(sure), 1 / (1 + exp(-slope * odds(sure) - height)), right) for sure, right in pairs]
        down = [sum((p - right) * x for x, p, right in said), sum(p - right for _, p, right in said)]
        xx, x1, one = (sum(p * (1 - p) * x**power for x, p, _ in said) for power in (2, 1, 0))
        whole = xx * one - x1 * x1
        slope -= (one * down[0] - x1 * down[1]) / whole
        height -= (xx * down[1] - x1 * down[0]) / whole
    return slope, height


def odds(sure: float) -> float:
    """Return the log odds of a confidence in hundredths."""
    sure = min(max(sure, 0.005), 0.995)
    return log(sure / (1 - sure))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("foon", type=Path)
    parser.add_argument("--every", type=int, default=1, help="hold out every N-th video only")
    parser.add_argument("--wrong", type=int, default=0, help="show so many units that were not drafted")
    asked = parser.parse_args()
    videos = [result.subgraph for result in read_paths([asked.foon]) if result.subgraph is not None]
    scores = (Score("verb and noun rows"), Score("sentences"))
    missed = Counter()
    began = time.process_time()
    for video in videos[:: asked.every]:
        rest = Snapshot.of([other for other in videos if other.name != video.name], KITCHEN)
        precedents = FoonPrecedents(rest.units, KITCHEN)
        told = (as_rows(video), with_actions(as_text(video), precedents.verbs, precedents.names))
        for score, narration in zip(scores, told, strict=True):
            drafted = draft(narration, precedents)
            score.add(video, drafted)
            if score is scores[1]:
                there = Counter(plain(a.unit) for a in video.annotations)
                missed += there - Counter(plain(u.annotation.unit) for u in drafted.units)
    for score in scores:
        score.show()
    print(f"\n{len(videos[:: asked.every])} of {len(videos)} videos held out, {time.process_time() - began:.0f} s CPU")
    for (motion, label), count in missed.most_common(asked.wrong):
        print(f"  not drafted {count} times: {motion} {label}")


if __name__ == "__main__":
    main()
