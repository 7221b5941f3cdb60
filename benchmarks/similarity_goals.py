"""Measure which way of comparing ingredient lists finds the right dish: Algorithm 2 as written, or a matching.

    python benchmarks/similarity_goals.py

A recipe is made of every goal of the public FOON that has four ingredients or more: foods for which an unseen one was
judged acceptable (tests/language/data, ../shared/data) are replaced by such a one, one of the rest is left out and two
foods of other goals are added. Right is the goal that the recipe was made of, among all goals of its dish type; where
several goals score the same, its share of them counts. Ten recipes a goal, with fixed seeds.
"""

import random
from collections.abc import Callable, Sequence

from similarity import SHARED, judgements

from foon_kg.loaders import read_paths
from foon_kg.model import Goal
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import Similarity, cosine_similarity, count_similar, food_similarity, matching
from foon_kg.store.snapshot import Snapshot

Score = Callable[[Sequence[str], Sequence[str]], float]
RECIPES = 10
FEWEST = 4


def unseen_for() -> dict[str, list[str]]:
    stands_for: dict[str, list[str]] = {}
    for foods in judgements().values():
        for unseen, accepted in sorted(foods.items()):
            for known in accepted:
                stands_for.setdefault(known, []).append(unseen)
    return stands_for


def recipe_of(goal: Goal, others: Sequence[str], stands_for: dict[str, list[str]], seed: int) -> list[str]:
    dice = random.Random(f"{goal.node.key} {seed}")
    foods = [dice.choice(stands_for.get(canonical(food), [food])) for food in goal.ingredients]
    foods.remove(dice.choice(foods))
    return sorted({*foods, *dice.sample(others, 2)})


def as_written(similarity: Similarity, threshold: float) -> Score:
    return lambda required, known: count_similar(required, known, similarity, threshold=threshold)


def as_matching(similarity: Similarity) -> Score:
    return lambda required, known: round(matching(required, known, similarity)[0], 2)


def share_right(goals: Sequence[Goal], score: Score, stands_for: dict[str, list[str]]) -> float:
    all_foods = sorted({food for goal in goals for food in goal.ingredients})
    right = total = 0.0
    for goal in goals:
        rivals = [other for other in goals if other.dish_type == goal.dish_type]
        for seed in range(RECIPES):
            recipe = recipe_of(goal, all_foods, stands_for, seed)
            scores = [score(recipe, rival.ingredients) for rival in rivals]
            best = [rival for rival, value in zip(rivals, scores, strict=True) if value == max(scores)]
            right += (goal in best) / len(best)
            total += 1
    return 100 * right / total


def main() -> None:
    results = list(read_paths([SHARED / "foon-111" / "TXT"]))
    snapshot = Snapshot.of([r.subgraph for r in results if r.subgraph is not None], Kitchen.default())
    goals = [goal for goal in snapshot.goals() if len(goal.ingredients) >= FEWEST]
    stands_for = unseen_for()
    ways = {
        "Algorithm 2 as written, raw cosine > 0.90": as_written(cosine_similarity(), 0.90),
        "Algorithm 2 as written, confidence > 0.90": as_written(food_similarity(), 0.90),
        "Algorithm 2 as written, confidence > 0.50": as_written(food_similarity(), 0.50),
        "matching, raw cosine": as_matching(cosine_similarity()),
        "matching, confidence": as_matching(food_similarity()),
    }
    print(f"{len(goals)} goals, {RECIPES} recipes each")
    for name, score in ways.items():
        print(f"{share_right(goals, score, stands_for):5.1f} %  {name}")


if __name__ == "__main__":
    main()
