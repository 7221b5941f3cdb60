"""The report of ``foon evaluate recipes`` as one HTML file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from foon_kg.evaluation.agreement import Agreement
from foon_kg.evaluation.comparison import Comparison
from foon_kg.evaluation.figures import DishFigures, RecipeEvaluation, RecipeFigures
from foon_kg.evaluation.verdicts import RuleCount
from foon_kg.formats.pictures.charts import curve_chart, histogram_chart, interval_chart
from foon_kg.formats.pictures.report import (
    WORST,
    agreement_section,
    charts,
    comparison_section,
    left_out_section,
    page,
    paragraph,
    section,
    table,
    tree_picture,
    unfolded,
    without_tree_section,
    words,
)
from foon_kg.formats.views.evaluation import interval_words, per_cent
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.plans.kitchen import Kitchen
from foon_kg.validation import FORM, TABLE, WORLD

_QUOTED = (100, 95, 90, 85, 75, 50)


def recipes_report(
    evaluation: RecipeEvaluation, agreement: Agreement | None = None, comparison: Comparison | None = None
) -> str:
    """Return the text of an HTML file about an ``evaluation``: tables, charts, and the worst recipes with their trees.

    People's ``agreement`` with the rule, and a ``comparison`` with an earlier evaluation, are told where there are any.
    """
    dishes = [*evaluation.dishes, *([evaluation.all] if len(evaluation.dishes) > 1 else [])]
    every = evaluation.all
    parts = [
        paragraph(
            f"{len(every.recipes)} recipes, {every.lines} required ingredients. FOON {evaluation.foon[:12]}, seed "
            f"{evaluation.seed}. Each ingredient scores 2 when its line starts in the kitchen, reaches the asked state "
            "by motions that make it in the FOON, and ends in the dish; 1 when only its preparation is missing; else 0."
        ),
        _correct(dishes),
        _accepted(dishes),
        *([comparison_section(comparison)] if comparison else []),
        *([agreement_section(agreement)] if agreement else []),
        _curves(dishes),
        _confidences(dishes),
        _rules(dishes),
        _reasons(dishes),
        _worst(every),
        _without_tree(every),
        left_out_section(evaluation.left_out),
    ]
    return page("How good the task trees are: recipes", parts)


def worst(recipes: Sequence[RecipeFigures]) -> tuple[RecipeFigures, ...]:
    """Return the recipes with a tree that are least correct; of equals those that break more rules, then by name."""

    def rank(recipe: RecipeFigures) -> tuple[object, ...]:
        fatal = len(recipe.report.fatal) if recipe.report else 0
        return round(recipe.correct, 9), -fatal, -len(_broken(recipe)), recipe.recipe.dish_type, recipe.name

    return tuple(sorted((recipe for recipe in recipes if recipe.result is not None), key=rank)[:WORST])


def _correct(dishes: Sequence[DishFigures]) -> str:
    head = ("", "recipes", "lines", "correct", "95 % interval", "at 85 %", "no tree")
    rows = [
        (
            words(dish.name),
            str(len(dish.recipes)),
            str(dish.lines),
            f"<b>{per_cent(dish.correct.mean)}</b>",
            interval_words(dish.correct),
            per_cent(dish.curve[85]),
            str(len(dish.without_tree)),
        )
        for dish in dishes
    ]
    chart = interval_chart([(dish.name, dish.correct) for dish in dishes], "Share correct by dish type")
    told = "Share correct with its 95 % interval (recipes drawn again)."
    return section("correct", "Correct, by the rule", table(head, rows), charts((chart, told)))


def _accepted(dishes: Sequence[DishFigures]) -> str:
    head = ("", "recipes", "robot", "cook", "accepted", "form kept", "no tree")
    rows = []
    for dish in dishes:
        found = dish.verdicts
        counts = [f"{count} ({per_cent(found.share(count))})" for count in found.named.values()]
        counts[2] = f"<b>{counts[2]}</b>"
        rows.append((words(dish.name), str(len(dish.recipes)), *counts, str(len(dish.without_tree))))
    told = (
        "Robot: it can be carried out (W1 to W5, K4). Cook: what comes of it would be served (K1 to K7). Accepted: "
        "both. Shares are of all recipes asked: one without a tree is not accepted."
    )
    return section("accepted", "Accepted by the judge", table(head, rows), paragraph(told))


def _curves(dishes: Sequence[DishFigures]) -> str:
    chart = curve_chart(
        {dish.name: dish.curve for dish in dishes}, "Recipes at least so correct", "correct, at least", "recipes"
    )
    head = ("", *(f"{threshold} %" for threshold in _QUOTED))
    rows = [(words(dish.name), *(per_cent(dish.curve[threshold]) for threshold in _QUOTED)) for dish in dishes]
    told = "Share of the recipes by how correct they are at least."
    return section("curve", "Recipes at least so correct", charts((chart, told)), table(head, rows))


def _confidences(dishes: Sequence[DishFigures]) -> str:
    figures = [
        (
            histogram_chart(dish.confidences, f"Confidence of substitutions: {dish.name}", "confidence"),
            f"{dish.name}: {sum(dish.confidences)} substitutions",
        )
        for dish in dishes
    ]
    return section("confidences", "Substitutions by confidence", charts(*figures))


def _rules(dishes: Sequence[DishFigures]) -> str:
    parts = []
    for title, rules in (("form", FORM), ("world", WORLD), ("table", TABLE)):
        rows = [(rule, *(_found(dish.verdicts.rules[rule]) for dish in dishes)) for rule in rules]
        parts.append(table((title, *(dish.name for dish in dishes)), rows))
    told = "Trees with a fatal finding / with any. foon check --rule W3 tells what a rule asks."
    return section("rules", "Trees that break each rule", paragraph(told), *parts)


def _found(count: RuleCount) -> str:
    if not count.asked:
        return '<span class="aside">not asked</span>'
    return f'<span class="{"broken" if count.fatal else "kept"}">{count.fatal}</span> / {count.broken}'


def _broken(recipe: RecipeFigures) -> tuple[str, ...]:
    return recipe.report.broken if recipe.report else ()


def _reasons(dishes: Sequence[DishFigures]) -> str:
    rows = [
        (words(reason.value), str(reason.score), *(str(dish.reasons.get(reason, 0)) for dish in dishes))
        for reason in dishes[-1].reasons
    ]
    return section("reasons", "Why lines have their score", table(("", "score", *(d.name for d in dishes)), rows))


def _worst(every: DishFigures) -> str:
    return section("worst", "The worst recipes, with their trees", *_trees(worst(every.recipes)))


def _trees(recipes: Sequence[RecipeFigures]) -> Iterator[str]:
    kitchen = Kitchen.default()
    for place, recipe in enumerate(recipes):
        if recipe.result is None:
            continue
        tree = ShownTree.of_result(recipe.result)
        foods = kitchen.with_foods(want.object for want in recipe.recipe.ingredients)
        lines = [
            (words(s.ingredient.object), words(s.ingredient.state), str(s.score), words(s.reason.value))
            for s in recipe.scores
        ]
        broken = f"; breaks {', '.join(_broken(recipe))}" if _broken(recipe) else ""
        which = recipe.recipe.dish_type + (f" {recipe.name}" if recipe.name != tree.title else "")
        told = f"{which}: {per_cent(recipe.correct)} correct, {len(tree.units)} units{broken}"
        yield unfolded(
            f'<b>{words(tree.title)}</b> <span class="aside">{words(told)}</span>',
            table(("ingredient", "asked", "score", "why"), lines, "words"),
            tree_picture(tree, foods, f"worst-{place}"),
        )


def _without_tree(every: DishFigures) -> str:
    rows = [(recipe.name, recipe.recipe.dish_type, recipe.error) for recipe in every.without_tree]
    return without_tree_section("recipe", rows)
