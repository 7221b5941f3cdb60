"""How good and how quick whole plans are: how many are accepted, their sizes, and the time a recipe takes.

    python benchmarks/plans.py [--files FOLDER] [--recipes PATH ...] [--every N] [--time-limit S] [--again] [--findings]
                               [--own]

Plans recipes from one snapshot in memory, by default those beside the checkout, and asks the judge about each tree
against the whole FOON. Printed, for each dish type and for all: recipes, mean, median, 95 % and worst ms of CPU
(planning alone; what is derived for one recipe serves the next; ``--again``: each was asked once before), shares that
a robot can carry out, that a cook would serve, that both accept, and that keep the form (a failure counts as none of
these), means of units, substitutions and assumptions; then how many trees break each rule. ``--findings`` prints every
finding, and why there is no tree. ``--own`` asks instead
for the dish of every video of the FOON itself, as its dish type with its own foods.
"""

import argparse
import statistics
import sys
import time
from collections import Counter, defaultdict
from dataclasses import dataclass
from pathlib import Path

from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.evaluation.verdicts import Verdicts
from foon_kg.loaders import read_paths
from foon_kg.model import Recipe
from foon_kg.model.errors import NoTreeError
from foon_kg.planning.planner import Planner
from foon_kg.planning.processes import collect_seldom, keep_for_good
from foon_kg.planning.recipes import IngredientWords, read_recipe, recipe_files
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanFailure, PlanResult
from foon_kg.store.snapshot import Snapshot
from foon_kg.validation import KnownFoon, Report, check, tree_from_json

SHARED = Path(__file__).parents[1].parent / "shared" / "data"
HEAD = (
    f"{'':<14}{'recipes':>8}{'mean':>9}{'median':>9}{'95 %':>9}{'worst':>9}"
    f"{'robot':>8}{'cook':>8}{'accepted':>10}{'form':>8}{'units':>7}{'subst.':>8}{'assumed':>9}"
)


@dataclass(frozen=True)
class Planned:
    """One recipe: its answer, how much CPU it took (seconds), and what the judge says of its tree."""

    recipe: Recipe
    answer: PlanResult | PlanFailure
    seconds: float
    report: Report | None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", type=Path, default=SHARED / "foon-111" / "TXT")
    parser.add_argument("--recipes", nargs="+", type=Path, default=[SHARED / "queries"])
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--time-limit", type=float, default=2.0)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--findings", action="store_true")
    parser.add_argument("--own", action="store_true")
    options = parser.parse_args()
    read = read_paths([options.files])
    snapshot = Snapshot.of([result.subgraph for result in read if result.subgraph is not None], Kitchen.default())
    recipes = own_dishes(snapshot) if options.own else asked(snapshot, options.recipes)
    done = plan_all(
        snapshot, recipes[:: options.every], PlanSettings(time_limit=options.time_limit), again=options.again
    )
    show(done)
    if options.findings:
        for planned in done:
            for told in told_of(planned):
                print(f"{planned.recipe.dish_type} {planned.recipe.id}: {told}")


def own_dishes(snapshot: Snapshot) -> list[Recipe]:
    videos = (left_out_video(subgraph, snapshot.kitchen) for subgraph in snapshot.subgraphs)
    return [video.recipe for video in videos if video is not None]


def asked(snapshot: Snapshot, paths: list[Path]) -> list[Recipe]:
    words = IngredientWords(snapshot.vocabulary(), snapshot.kitchen)
    return [read_recipe(path, words).recipe for path in recipe_files(paths)]


def plan_all(snapshot: Snapshot, recipes: list[Recipe], settings: PlanSettings, *, again: bool) -> list[Planned]:
    collect_seldom()  # as every process that plans many recipes does
    started = time.perf_counter()
    planner = Planner(snapshot, settings, snapshot.units)
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    keep_for_good()
    print(f"{len(snapshot.units)} units, ready in {time.perf_counter() - started:.2f} s")
    for recipe in recipes if again else ():
        answer_to(planner, recipe)
    done = []
    for number, recipe in enumerate(recipes):
        print(f"\r{number} of {len(recipes)}", end="", file=sys.stderr, flush=True)
        done.append(plan_one(planner, recipe, foon))
    print("\r", end="", file=sys.stderr)
    return done


def plan_one(planner: Planner, recipe: Recipe, foon: KnownFoon) -> Planned:
    started = time.process_time()
    answer = answer_to(planner, recipe)
    seconds = time.process_time() - started
    if isinstance(answer, PlanFailure):
        return Planned(recipe, answer, seconds, None)
    return Planned(recipe, answer, seconds, check(tree_from_json(answer.to_json()), foon))


def answer_to(planner: Planner, recipe: Recipe) -> PlanResult | PlanFailure:
    try:
        return planner.plan(recipe)
    except NoTreeError as error:
        return PlanFailure.of(recipe, error)


def told_of(planned: Planned) -> list[str]:
    if isinstance(planned.answer, PlanFailure):
        return [f"{planned.answer.code}: {planned.answer.message}"]
    return list(map(str, planned.report.findings if planned.report else ()))


def show(done: list[Planned]) -> None:
    by_dish: defaultdict[str, list[Planned]] = defaultdict(list)
    for planned in done:
        by_dish[planned.recipe.dish_type].append(planned)
    print(HEAD)
    for dish_type in sorted(by_dish):
        print(row(dish_type, by_dish[dish_type]))
    print(row("all", done))
    failures = Counter(planned.answer.code for planned in done if isinstance(planned.answer, PlanFailure))
    print("no tree: ", ", ".join(f"{code} {count}" for code, count in sorted(failures.items())) or "none")
    print("trees with a fatal finding / with any: ", end="")
    found = verdicts(done).rules.items()
    print(", ".join(f"{rule} {count.fatal} / {count.broken}" for rule, count in found if count.broken) or "none")


def verdicts(done: list[Planned]) -> Verdicts:
    return Verdicts(tuple(planned.report for planned in done))


def row(name: str, done: list[Planned]) -> str:
    times = sorted(1000 * planned.seconds for planned in done)
    trees = [planned.answer for planned in done if isinstance(planned.answer, PlanResult)]
    found = verdicts(done)
    robot, cook, accepted, form = map(found.share, found.named.values())
    means = [
        statistics.fmean(len(part(tree)) for tree in trees) if trees else 0.0
        for part in (lambda t: t.units, lambda t: t.substitutions, lambda t: t.assumptions)
    ]
    return (
        f"{name:<14}{len(done):>8}{statistics.fmean(times):>6.1f} ms{statistics.median(times):>6.1f} ms"
        f"{times[int(len(times) * 0.95)]:>6.1f} ms{times[-1]:>6.0f} ms"
        f"{robot:>8.1%}{cook:>8.1%}{accepted:>10.1%}{form:>8.1%}{means[0]:>7.1f}{means[1]:>8.2f}{means[2]:>9.2f}"
    )


if __name__ == "__main__":
    main()
