"""Do drafts of recipes help to plan dishes that the videos lack? Each MUHAI recipe is planned without and with them.

    python benchmarks/draft_lessons.py ../shared/data/muhai ../shared/data/foon-111/TXT

The instructions of MUHAI's recipes (the quoted comments in its files, never the networks) are drafted with the FOON of
the second path. Then each recipe is planned, with its title, dish type and lines of ingredients: from the FOON alone;
with the drafts of the other recipes (its own is left out, and so are those of the same title: almond crescent cookies
teach no other almond crescent cookies); and, for comparison, with MUHAI's networks of the same recipes in place of the
drafts. The FOON has videos of nearly every dish type, so all of this is done twice: with the whole FOON, and with one
from which every video with a goal of the asked dish type is taken out ("lacking"). Then drafts are made with that FOON,
too. A plan is accepted where there is a tree and the judge finds nothing against it.
"""

from __future__ import annotations

import argparse
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from muhai_networks import Recipe as Told

from foon_kg.language.collection import CollectionReader, labels_of
from foon_kg.language.recipe_drafts import RecipeDrafter
from foon_kg.loaders import read_paths
from foon_kg.loaders.lessons import lesson_of
from foon_kg.loaders.muhai import read_muhai
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.collected import CollectedLine, CollectedRecipe, UnderstoodRecipe
from foon_kg.model.drafted import Lesson, is_draft
from foon_kg.model.errors import FoonError
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.store.with_drafts import WithDrafts
from foon_kg.validation import KnownFoon, check, tree_from_json


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
    report = check(tree_from_json(result.to_json()), known)
    return report.accepted, any(map(is_draft, result.reference.videos)), result.goal.label


def without(foon: Snapshot, dish_type: str) -> Snapshot:
    """Return a FOON without the videos that make a dish of a type."""
    goals = {video for goal in foon.goals(dish_type) for video in goal.videos}
    return Snapshot.of([one for one in foon.subgraphs if one.name not in goals], foon.kitchen)


def lessons_from(foon: Snapshot, recipes: Sequence[CollectedRecipe]) -> dict[str, Lesson]:
    """Return what each recipe teaches, drafted with a FOON."""
    drafter = RecipeDrafter(foon.units, foon.kitchen)
    found = {recipe.id: lesson_of(drafter.draft(recipe)) for recipe in recipes}
    return {name: lesson for name, lesson in found.items() if lesson is not None}


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
    networks = {one.subgraph.name: one.subgraph for one in read_muhai([given.muhai]) if one.subgraph}
    reader = CollectionReader(labels_of(foon.vocabulary()))
    asked = [one for one in map(asked_of, reader.understand(recipes)) if one is not None]
    types = sorted({one.recipe.dish_type for one in asked})
    foons = {"": foon} | {dish_type: without(foon, dish_type) for dish_type in types}
    lessons = {name: lessons_from(one, recipes) for name, one in foons.items()}
    print(
        f"{len(recipes)} recipes, {len(lessons[''])} of them give a lesson; asked are {len(asked)}: {', '.join(types)}"
    )
    figures: dict[str, Counter[str]] = {"lacking": Counter(), "whole": Counter()}
    for one in asked:
        others = [recipe.id for recipe in recipes if recipe.title != one.dish]
        for case, name in (("whole", ""), ("lacking", one.recipe.dish_type)):
            taught = [lessons[name][other] for other in others if other in lessons[name]]
            shown = [networks[other] for other in others if other in networks]
            views = {
                "alone": foons[name],
                "with drafts": WithDrafts.of(foons[name], taught),
                "with networks": Snapshot.of([*foons[name].subgraphs, *shown], kitchen),
            }
            figures[case]["recipes"] += 1
            for told, view in views.items():
                accepted, drafted, why = outcome(view, KnownFoon.of(view.units, view.goals()), one)
                figures[case][told] += accepted
                figures[case]["after a draft"] += drafted
                figures[case]["after a draft, accepted"] += drafted and accepted
                if given.show:
                    verdict = f"{'accepted' if accepted else 'no'}{' (draft)' if drafted else ''}"
                    print(f"{one.recipe.id} ({one.recipe.dish_type}) {case}, {told}: {verdict}, {why}", flush=True)
    for name, row in figures.items():
        print(name, dict(row))


def asked_of(understood: UnderstoodRecipe) -> Asked | None:
    """Return what is asked of a recipe; ``None`` where its dish type or its foods are not understood."""
    recipe = understood.recipe
    dish_type = next((dish.name for dish in understood.dish_classes if dish.sure), "")
    if not dish_type or not understood.ingredients:
        return None
    wanted = tuple(RequiredIngredient(one.object, one.state) for one in understood.ingredients)
    return Asked(Recipe(dish_type, wanted, recipe.id, recipe.title), recipe.title)


if __name__ == "__main__":
    main()
