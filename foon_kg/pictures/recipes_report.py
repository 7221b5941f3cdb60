"""The report of ``foon evaluate recipes`` as one HTML file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from foon_kg.evaluation.agreement import Agreement
from foon_kg.evaluation.comparison import Comparison
from foon_kg.evaluation.figures import DishFigures, RecipeEvaluation, RecipeFigures
from foon_kg.form import CONTRACT, SENSE
from foon_kg.kitchen import Kitchen
from foon_kg.pictures.charts import curve_chart, histogram_chart, interval_chart
from foon_kg.pictures.report import (
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
from foon_kg.views.evaluation import interval_words, per_cent
from foon_kg.views.shown_tree import ShownTree

_QUOTED = (100, 95, 90, 85, 75, 50)
_CALLED = (
    "executable, goal, connected, complete, nothing else, kitchen, honest, grounded, repeatable, "
    "fresh, in time, opened, thrifty, close, true name, state kept, kept"
)
_NAMES = dict(zip((*CONTRACT, *SENSE), _CALLED.split(", "), strict=True))
"""What the rules of contract and sense are called."""


def recipes_report(
    evaluation: RecipeEvaluation, agreement: Agreement | None = None, comparison: Comparison | None = None
) -> str:
    """Answer the text of an HTML file: tables, charts, and the worst recipes with their trees."""
    dishes = [*evaluation.dishes, *([evaluation.all] if len(evaluation.dishes) > 1 else [])]
    every = evaluation.all
    parts = [
        paragraph(
            f"{len(every.recipes)} recipes, {every.lines} required ingredients. FOON {evaluation.foon[:12]}, seed "
            f"{evaluation.seed}. Each ingredient scores 2 when its line starts in the kitchen, reaches the asked state "
            "by motions that make it in the FOON, and ends in the dish; 1 when only its preparation is missing; else 0."
        ),
        _correct(dishes),
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
    """Answer the recipes with a tree that are least correct; of equals those that break more rules, then by name."""

    def rank(recipe: RecipeFigures) -> tuple[object, ...]:
        return round(recipe.correct, 9), -len(recipe.broken), recipe.recipe.dish_type, recipe.name

    return tuple(sorted((recipe for recipe in recipes if recipe.result is not None), key=rank)[:WORST])


def _correct(dishes: Sequence[DishFigures]) -> str:
    head = ("", "recipes", "lines", "correct", "95 % interval", "at 85 %", "sound", "clean", "no tree")
    rows = [
        (
            words(dish.name),
            str(len(dish.recipes)),
            str(dish.lines),
            f"<b>{per_cent(dish.correct.mean)}</b>",
            interval_words(dish.correct),
            per_cent(dish.curve[85]),
            str(dish.sound),
            str(dish.clean),
            str(len(dish.without_tree)),
        )
        for dish in dishes
    ]
    chart = interval_chart([(dish.name, dish.correct) for dish in dishes], "Share correct by dish type")
    told = "Share correct with its 95 % interval (recipes drawn again). Sound: no rule of the contract is broken."
    return section("correct", "Correct, by the rule", table(head, rows), charts((chart, told)))


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
    for title, rules in (("contract", CONTRACT), ("sense", SENSE)):
        rows = [(f"{rule} {_NAMES[rule]}", *(_kept(*dish.rules[rule]) for dish in dishes)) for rule in rules]
        parts.append(table((title, *(dish.name for dish in dishes)), rows))
    return section("rules", "Trees that keep each rule", *parts)


def _kept(kept: int, asked: int) -> str:
    if not asked:
        return '<span class="aside">not asked</span>'
    return f'<span class="{"kept" if kept == asked else "broken"}">{kept}</span> of {asked}'


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
        broken = f"; breaks {', '.join(recipe.broken)}" if recipe.broken else ""
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
