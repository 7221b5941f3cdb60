"""How good are drafts? Each video of a FOON is told in words and drafted from the other videos, then compared.

    python benchmarks/drafts.py ../shared/data/foon-111/TXT --every 4

A video is told twice: as verb and noun rows (the motion, its main object, the foods that join it, the place), and as
sentences, which foon-kg writes of units (``foon_kg.exports.sentences``) and spaCy's parser reads again. A unit counts
as drafted when the draft has one with the same motion and main object (names compared as foon-kg does); "with states"
asks for the states of that object before and after, too. Both sides are multisets: a unit drafted twice counts once.
Units that a draft adds as assumed are counted like all others.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from pathlib import Path

from foon_kg.drafting import draft
from foon_kg.drafting.precedents import FoonPrecedents
from foon_kg.exports.sentences import sentence
from foon_kg.instructions import with_actions
from foon_kg.kitchen import Kitchen
from foon_kg.loaders import read_paths
from foon_kg.model import FunctionalUnit
from foon_kg.names import canonical
from foon_kg.narration import Mention, NarratedAction, Narration, Place, Sentence
from foon_kg.snapshot import Snapshot

KITCHEN = Kitchen.default()
BINS = (0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 1.01)


def main_object(unit: FunctionalUnit):
    """Answer the first food (else utensil) that is not the same after the unit, and what it becomes."""
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


def as_rows(video):
    """Answer verb and nouns of each unit, as a person would annotate them: no states, no tools."""
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
        self.name, self.bins = name, {low: [0, 0] for low in BINS[:-1]}
        self.common, self.drafted, self.true = Counter(), 0, 0

    def add(self, video, drafted):
        """Count one video."""
        units = [annotation.unit for annotation in video.annotations]
        self.true += len(units)
        self.drafted += len(drafted.units)
        for way in (plain, with_states):
            there = Counter(map(way, units))
            found = Counter(way(row.annotation.unit) for row in drafted.units)
            self.common[way] += (there & found).total()
        left = Counter(map(with_states, units))
        for row in drafted.units:
            key = with_states(row.annotation.unit)
            low = max(b for b in BINS[:-1] if b <= row.confidence)
            self.bins[low][1] += 1
            if left[key] > 0:
                left[key] -= 1
                self.bins[low][0] += 1

    def show(self):
        """Print the figures."""
        print(f"\n{self.name}: {self.true} units, {self.drafted} drafted")
        for way, what in ((plain, "motion and main object"), (with_states, "with states")):
            precision, recall = self.common[way] / max(self.drafted, 1), self.common[way] / self.true
            print(f"  {what:24} precision {precision:.2f}  recall {recall:.2f}")
        for low, (right, count) in self.bins.items():
            share = f"{right / count:.2f}" if count else "   -"
            print(f"  confidence from {low:.1f}: {count:4} units, right with states {share}")


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
        told = (as_rows(video), with_actions(as_text(video), precedents.verbs))
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
