"""Do drafts of recipes help to plan dishes that the videos lack? Each MUHAI recipe is planned without and with them.

    python benchmarks/draft_lessons.py ../shared/data/muhai ../shared/data/foon-111/TXT

The instructions of MUHAI's recipes (the quoted comments in its files, never the networks) are drafted with the FOON of
the second path. Then each recipe is planned, with its title, dish type and lines of ingredients: from the FOON alone;
with the drafts of all other recipes (its own is left out, and so are those of the same dish: "almond crescent cookies"
teach no other almond crescent cookies); and, for comparison, with MUHAI's networks in place of the drafts, of the same
recipes. A plan is accepted where there is a tree and the judge finds nothing that is not minor. A plan "after a draft"
was made after one. Dish types without a goal in the FOON are told apart.
"""

from __future__ import annotations

import argparse
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from drafted_recipes import Recipe as Told

from foon_kg.language.collection import CollectionReader, labels_of
from foon_kg.language.drafting.recipes import RecipeDrafter
from foon_kg.loaders import read_paths
from foon_kg.loaders.lessons import lesson_of
from foon_kg.loaders.muhai import read_muhai
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.collected import CollectedLine, CollectedRecipe
from foon_kg.model.drafted import Lesson, is_draft
from foon_kg.model.errors import FoonError
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.store.with_drafts import WithDrafts
from foon_kg.validation import KnownFoon, TaskTree, check


@dataclass(frozen=True)
class Asked:
    """A recipe to plan, and the dish that it is one of: what has the same name is no help of others."""

    recipe: Recipe
    dish: str


def collected(paths: Sequence[Path]) -> Iterator[CollectedRecipe]:
    """Yield MUHAI's recipes as a collection would have them."""
    for path in paths:
        try:
            told = Told.read(path)
        except ValueError:
            continue
        title = re.sub(r"-\d+$", "", path.stem).replace("-", " ")
        lines = tuple(CollectedLine(text) for text in told.ingredients)
        if lines and told.sentences:
            yield CollectedRecipe(path.stem, title, lines, str(path.name), instructions=told.sentences)


def outcome(view: object, known: KnownFoon, asked: Asked) -> tuple[bool, bool, str]:
    """Return whether a plan is accepted, whether it is made after a draft, and what stands against it."""
    try:
        result = Planner(view, PlanSettings(), view.units).plan(asked.recipe)
    except FoonError as error:
        return False, False, f"{error.code}: {error.message}"[:150]
    report = check(TaskTree.from_json(result.to_json()), known)
    return report.accepted, any(map(is_draft, result.reference.videos)), result.goal.label


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("muhai", type=Path)
    parser.add_argument("foon", type=Path)
    parser.add_argument("--show", action="store_true", help="Print every recipe.")
    given = parser.parse_args()
    kitchen = Kitchen.default()
    foon = Snapshot.of([one.subgraph for one in read_paths([given.foon]) if one.subgraph], kitchen)
    recipes = list(collected(sorted(given.muhai.glob("*.lisp"))))
    drafter = RecipeDrafter(foon.units, kitchen)
    reader = CollectionReader(labels_of(foon.vocabulary()))
    lessons: dict[str, Lesson] = {}
    problems = Counter()
    for recipe in recipes:
        made = drafter.draft(recipe)
        lesson = lesson_of(made)
        if lesson is not None:
            lessons[recipe.id] = lesson
        else:
            problems[made.problem or ("no dish type" if not made.dish_type else "no dish")] += 1
    networks = {one.subgraph.name: one.subgraph for one in read_muhai([given.muhai]) if one.subgraph}
    print(f"{len(recipes)} recipes, {len(lessons)} of them give a lesson; {dict(problems)}")
    frames = WithDrafts.of(foon, lessons.values()).drafts.methods().frames
    print(f"{len(frames)} frames, {sum(bool(frame.weak) for frame in frames)} of them weak")
    types = {goal.dish_type for goal in foon.goals()}
    figures: dict[str, Counter] = {"lacking": Counter(), "there": Counter()}
    for understood in reader.understand(recipes):
        recipe = understood.recipe
        dish_type = next((dish.name for dish in understood.dish_classes if dish.sure), "")
        if not dish_type or not understood.ingredients:
            continue
        wanted = tuple(RequiredIngredient(one.object, one.state) for one in understood.ingredients)
        asked = Asked(Recipe(dish_type, wanted, recipe.id, recipe.title), recipe.title)
        others = [one for one in recipes if one.title != recipe.title]
        taught = [lessons[one.id] for one in others if one.id in lessons]
        with_drafts = WithDrafts.of(foon, taught)
        shown = [networks[one.id] for one in others if one.id in networks]
        with_networks = Snapshot.of([*foon.subgraphs, *shown], kitchen)
        row = figures["there" if dish_type in types else "lacking"]
        row["recipes"] += 1
        told = [f"{recipe.id} ({dish_type})"]
        for name, view in (("alone", foon), ("drafts", with_drafts), ("networks", with_networks)):
            accepted, drafted, why = outcome(view, KnownFoon.of(view.units, view.goals()), asked)
            row[name] += accepted
            row["after a draft"] += drafted
            row["after a draft, accepted"] += drafted and accepted
            told.append(f"{name}: {'accepted' if accepted else 'no'}{' (draft)' if drafted else ''}, {why}")
        if given.show:
            print("\n  ".join(told))
    for name, row in figures.items():
        print(name, dict(row))


if __name__ == "__main__":
    main()
