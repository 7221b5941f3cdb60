"""How often the similarity is right, and how honest its confidence is; ``--write`` fits and stores its weights.

    python benchmarks/similarity.py [--write]

Judged are sets of foods that the FOON does not know, each with the known ones that a cook would accept: the public
one beside the checkout, and three of our own in tests/language/data. Every set is measured twice: as it is, and
*strange*, with each wanted food struck from the table of groups first (what a food gets that nobody listed). Weights
are fitted on every other food of the sets and measured on the rest, both ways round; the weights that ship are fitted
on everything but the set "judged afterwards", which neither the weights nor the groups were made with. Printed
besides: the raw cosine, what is wrong, reliability, Brier scores and the time of one product.
"""

import argparse
import dataclasses
import json
import time
from pathlib import Path

import numpy as np

from foon_kg.loaders.text_reader import read_text
from foon_kg.model.knowledge import UNLIKE
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import cosine_similarity
from foon_kg.similarity.evidence import KINDS, Evidence
from foon_kg.similarity.food import FoodSimilarity
from foon_kg.similarity.groups import FoodGroups, food_groups
from foon_kg.similarity.roles import roles_of
from foon_kg.similarity.taxonomy import food_taxonomy
from foon_kg.similarity.vectors import food_vectors
from foon_kg.store.snapshot import Snapshot

ROOT = Path(__file__).parents[1]
SHARED = ROOT.parent / "shared" / "data"
WEIGHTS = ROOT / "foon_kg" / "similarity" / "similarity.json"
DECIMALS = 4
RIDGE = 1.0
AFTERWARDS = "judged afterwards"
NOTHING = "no foods"
OBSCURE = KINDS.index("unknown word")
TOLD = 5


@dataclasses.dataclass(frozen=True)
class Judged:
    """Judged foods: evidence (kind, food, known), whether a cook accepts (food, known), which pairs count."""

    set_name: str
    strange: bool
    foods: list[str]
    evidence: np.ndarray
    accepted: np.ndarray
    counts: np.ndarray

    def half(self, which: int) -> "Judged":
        """Return every other food, from the first (0) or the second (1)."""
        places = range(which, len(self.foods), 2)
        foods = [self.foods[place] for place in places]
        kept = (self.evidence[:, places], self.accepted[places], self.counts[places])
        return Judged(self.set_name, self.strange, foods, *kept)


def known_foods() -> list[str]:
    files = sorted((SHARED / "foon-111" / "TXT").glob("*.txt"))
    subgraphs = [read_text(file.read_text(encoding="utf-8"), file.stem).subgraph for file in files]
    vocabulary = Snapshot.of(subgraphs, Kitchen.default()).vocabulary()
    return sorted({canonical(row.label) for row in vocabulary.foods})


def unknown_words() -> dict[str, set[str]]:
    own = json.loads((ROOT / "tests" / "language" / "data" / "accepted.json").read_text(encoding="utf-8"))
    return {canonical(food): set(map(canonical, accepted)) for food, accepted in own["unknown words"].items()}


def no_foods() -> list[str]:
    own = json.loads((ROOT / "tests" / "language" / "data" / "accepted.json").read_text(encoding="utf-8"))
    return list(own["no foods"])


def judgements() -> dict[str, dict[str, set[str]]]:
    own = json.loads((ROOT / "tests" / "language" / "data" / "accepted.json").read_text(encoding="utf-8"))
    own["public"] = json.loads((SHARED / "substitutes.json").read_text(encoding="utf-8"))
    return {
        name: {canonical(food): set(map(canonical, accepted)) for food, accepted in foods.items()}
        for name, foods in own.items()
        if name not in {"about", "no foods", "unknown words", "in a slot"}
    }


def without(groups: FoodGroups, food: str) -> FoodGroups:
    kept = [place for place, name in enumerate(groups.foods) if name != food]
    foods = tuple(groups.foods[place] for place in kept)
    places = {name: place for place, name in enumerate(foods)}
    return dataclasses.replace(groups, foods=foods, listed=groups.listed[kept], places=places)


def judge(name: str, accepted: dict[str, set[str]], known: list[str], *, strange: bool) -> Judged:
    foods = sorted(accepted)
    whole = Evidence(food_vectors(), food_taxonomy(), food_groups())
    columns = []
    about = whole.about(known)
    for food in foods:
        evidence = dataclasses.replace(whole, food_groups=without(food_groups(), food)) if strange else whole
        columns.append(whole.between(evidence.about([food]), about))
    truth = np.array([[other in accepted[food] for other in known] for food in foods])
    counts = np.array([[other != food for other in known] for food in foods])
    return Judged(name, strange, foods, np.concatenate(columns, axis=1), truth, counts)


def fit(sets: list[Judged]) -> np.ndarray:
    """Return the weights of all kinds and the bias, by Newton's method with a small ridge on the weights."""
    rows = np.concatenate([judged.evidence[:, judged.counts].T for judged in sets])
    truth = np.concatenate([judged.accepted[judged.counts] for judged in sets]).astype(float)
    rows = np.c_[rows, np.ones(len(rows))]
    ridge = np.diag([RIDGE] * len(KINDS) + [0.0])
    weights = np.zeros(len(KINDS) + 1)
    for _ in range(30):
        guess = 1 / (1 + np.exp(-rows @ weights))
        slope = rows.T @ (guess - truth) + ridge @ weights
        weights -= np.linalg.solve((rows * (guess * (1 - guess))[:, None]).T @ rows + ridge, slope)
    return weights


def fit_told(sets: list[Judged]) -> np.ndarray:
    """Return weights by which of what is told (the first five of a food) at 0.4 four in ten are accepted.

    All pairs of foods have told nobody anything: most of them are unlike at a glance. So the weights are fitted on all,
    and then stretched by what is told of foods that they were not fitted on.
    """
    odds, truth = [], []
    for half in (0, 1):
        weights = fit([judged.half(half) for judged in sets])
        for judged in (judged.half(1 - half) for judged in sets):
            for _, row, place in told(judged, answer(judged, weights), least=0):
                odds.append(np.append(judged.evidence[:, row, place], 1) @ weights)
                truth.append(judged.accepted[row, place])
    slope, bias = _line(np.array(odds), np.array(truth, dtype=float))
    weights = slope * fit(sets)
    weights[-1] += bias
    return weights


def fit_unknown(judged: Judged, weights: np.ndarray) -> np.ndarray:
    """Return ``weights`` with that of a word that nobody ever read of food, fitted on what is told of such foods.

    It is 0 for every other judged food, so the other weights are kept.
    """
    weights = weights.copy()
    weights[OBSCURE] = 0
    places = [(row, place) for _, row, place in told(judged, answer(judged, weights), least=0)]
    odds = np.array([np.append(judged.evidence[:, row, place], 1) @ weights for row, place in places])
    truth = np.array([judged.accepted[row, place] for row, place in places], dtype=float)
    for _ in range(30):
        guess = 1 / (1 + np.exp(-(odds + weights[OBSCURE])))
        slope = (guess - truth).sum() + RIDGE * weights[OBSCURE]
        weights[OBSCURE] -= slope / ((guess * (1 - guess)).sum() + RIDGE)
    return weights


def _line(odds: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """Return slope and bias by which odds become those that were seen (Platt, 1999)."""
    rows, line = np.c_[odds, np.ones(len(odds))], np.zeros(2)
    for _ in range(30):
        guess = 1 / (1 + np.exp(-rows @ line))
        line -= np.linalg.solve((rows * (guess * (1 - guess))[:, None]).T @ rows, rows.T @ (guess - truth))
    return float(line[0]), float(line[1])


def in_slots() -> dict[str, dict[str, set[str]]]:
    own = json.loads((ROOT / "tests" / "language" / "data" / "accepted.json").read_text(encoding="utf-8"))
    return {
        role: {canonical(food): set(map(canonical, accepted)) for food, accepted in foods.items()}
        for role, foods in own["in a slot"].items()
    }


def fit_slots(weights: np.ndarray, known: list[str]) -> tuple[float, float]:
    """Return how odds are stretched where one food stands for another by what it does in a dish, and print how well."""
    evidence = Evidence(food_vectors(), food_taxonomy(), food_groups())
    odds, truth = [], []
    for role, foods in in_slots().items():
        for food, accepted in foods.items():
            others = [other for other in known if role in roles_of(other) and other != food]
            between = evidence.between(evidence.about([food]), evidence.about(others))[:, 0]
            odds.append(weights[:-1] @ between + weights[-1])
            truth.append([other in accepted for other in others])
    halves = [(np.concatenate(odds[half::2]), np.concatenate(truth[half::2]).astype(float)) for half in (0, 1)]
    said = []
    for half in (0, 1):
        slope, bias = _line(*halves[half])
        said.append(1 / (1 + np.exp(-(slope * halves[1 - half][0] + bias))))
    print("in a slot:")
    reliability(np.concatenate(said), np.concatenate([halves[1][1], halves[0][1]]))
    slope, bias = _line(np.concatenate(odds), np.concatenate(truth).astype(float))
    return round(slope, DECIMALS), round(bias, DECIMALS)


def told(judged: Judged, answers: np.ndarray, least: float = UNLIKE) -> list[tuple[float, int, int]]:
    """Return the first :data:`TOLD` of each food: what is said, and where."""
    rows = []
    for row in range(len(judged.foods)):
        order = sorted((-answers[row, place], place) for place in np.flatnonzero(judged.counts[row]))[:TOLD]
        rows += [(-value, row, int(place)) for value, place in order if -value >= least]
    return rows


def answer(judged: Judged, weights: np.ndarray) -> np.ndarray:
    return 1 / (1 + np.exp(-(np.tensordot(weights[:-1], judged.evidence, axes=1) + weights[-1])))


def top(judged: Judged, answers: np.ndarray, known: list[str]) -> tuple[float, float, list[str]]:
    """Return top 1 and top 3 in percent, and what was wrong."""
    first = third = 0
    wrong = []
    for row, food in enumerate(judged.foods):
        order = sorted((-answers[row, place], known[place], place) for place in np.flatnonzero(judged.counts[row]))[:3]
        hits = [bool(judged.accepted[row, place]) for _, _, place in order]
        first, third = first + hits[0], third + any(hits)
        if not hits[0]:
            wrong.append(f"{food}: " + ", ".join(f"{name} {-value:.2f}" for value, name, _ in order))
    return 100 * first / len(judged.foods), 100 * third / len(judged.foods), wrong


def reliability(answers: np.ndarray, truth: np.ndarray) -> None:
    base = truth.mean()
    print(f"Brier {((answers - truth) ** 2).mean():.4f}; always answering the base rate: {base * (1 - base):.4f}")
    for low, high in ((0, 0.1), (0.1, 0.3), (0.3, 0.5), (0.5, 0.7), (0.7, 0.9), (0.9, 1.01)):
        inside = (answers >= low) & (answers < high)
        if inside.any():
            said, was = answers[inside].mean(), truth[inside].mean()
            print(f"  said {low:.1f}-{min(high, 1):.1f}: {inside.sum():6d} pairs, said {said:.2f}, was {was:.2f}")


def report(sets: list[Judged], known: list[str]) -> None:
    cosine = cosine_similarity()
    for judged in sets:
        if not judged.strange:
            first, third, _ = top(judged, cosine.matrix(judged.foods, known), known)
            print(f"raw cosine of the food vectors, {judged.set_name}: {first:.0f}/{third:.0f}")
    all_told: dict[bool, list[tuple[float, bool]]] = {False: [], True: []}
    for half in (0, 1):
        weights = fit_told([judged.half(half) for judged in sets])
        for judged in (judged.half(1 - half) for judged in sets):
            if judged.set_name == NOTHING:
                _report_nothing(judged, weights)
                continue
            answers = _report_half(judged, weights, known, f"half {2 - half}")
            rows = told(judged, answers)
            all_told[judged.strange] += [(value, bool(judged.accepted[row, place])) for value, row, place in rows]
    for strange, rows in all_told.items():
        print("of what is told,", "strange:" if strange else "listed:")
        reliability(np.array([value for value, _ in rows]), np.array([was for _, was in rows]))


def _report_nothing(judged: Judged, weights: np.ndarray) -> None:
    rows = told(judged, answer(judged, weights))
    like = len({row for _, row, _ in rows})
    most = max((value for value, _, _ in rows), default=0.0)
    print(f"no foods: nothing is like {len(judged.foods) - like} of {len(judged.foods)}; most that is said {most:.2f}")


def _report_half(judged: Judged, weights: np.ndarray, known: list[str], part: str) -> np.ndarray:
    answers = answer(judged, weights)
    first, third, wrong = top(judged, answers, known)
    kind = "strange" if judged.strange else "listed "
    print(f"{part}, {kind}, {judged.set_name}: {first:.0f}/{third:.0f} of {len(judged.foods)}")
    if not judged.strange:
        print("".join(f"    {line}\n" for line in wrong), end="")
    return answers


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--write", action="store_true", help="store weights fitted on everything")
    write = parser.parse_args().write
    known = known_foods()
    all_sets = [judge(name, foods, known, strange=s) for name, foods in judgements().items() for s in (False, True)]
    sets = [judged for judged in all_sets if judged.set_name != AFTERWARDS]
    sets.append(judge(NOTHING, {canonical(name): set() for name in no_foods()}, known, strange=False))
    report(sets, known)
    obscure = judge("unknown words", unknown_words(), known, strange=False)
    weights = fit_unknown(obscure, fit_told(sets)).round(DECIMALS).tolist()
    print("of foods with a word that nobody ever read of food, what is told (fitted on them):")
    rows = told(obscure, answer(obscure, np.array(weights)))
    reliability(np.array([v for v, _, _ in rows]), np.array([obscure.accepted[row, place] for _, row, place in rows]))
    for judged in (judged for judged in all_sets if judged.set_name == AFTERWARDS):
        answers = _report_half(judged, np.array(weights), known, "all")
        rows = told(judged, answers)
        reliability(
            np.array([v for v, _, _ in rows]), np.array([judged.accepted[row, place] for _, row, place in rows])
        )
    slot = fit_slots(np.array(weights), known)
    if write:
        document = {
            "about": "Weights of the evidence for one food standing for another; made by benchmarks/similarity.py.",
            "bias": weights[-1],
            "weights": dict(zip(KINDS, weights, strict=False)),
            "in a slot": dict(zip(("slope", "bias"), slot, strict=True)),
        }
        WEIGHTS.write_text(json.dumps(document, indent=2) + "\n", encoding="utf-8")
    similarity = FoodSimilarity(
        Evidence(food_vectors(), food_taxonomy(), food_groups()), np.array(weights[:-1]), weights[-1]
    )
    wanted = sorted({food for judged in sets for food in judged.foods})
    start = time.perf_counter()
    similarity.matrix(wanted, known)
    print(f"{len(wanted)} wanted x {len(known)} known: {time.perf_counter() - start:.2f} s")


if __name__ == "__main__":
    main()
