"""What an evaluation found, as tables of a terminal."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from foon_kg.evaluation.agreement import Agreement
from foon_kg.evaluation.comparison import Change, Comparison
from foon_kg.evaluation.figures import DishFigures, RecipeEvaluation
from foon_kg.evaluation.resampling import Interval
from foon_kg.evaluation.sampling import FEWEST_GOALS, LeftOut
from foon_kg.evaluation.trees import TreesEvaluation
from foon_kg.evaluation.verdicts import Verdicts
from foon_kg.formats.views.words import ASIDE, section
from foon_kg.validation import RULES

_QUOTED = (100, 95, 90, 85, 75, 50)
_MOST_CHANGES = 10
_BROKEN = "Trees with a fatal finding of each rule, and with any"


def recipe_evaluation_view(evaluation: RecipeEvaluation) -> RenderableType:
    """Return what an ``evaluation`` says: correct, accepted, the curve, confidences, rules broken, left out."""
    dishes = [*evaluation.dishes, *([evaluation.all] if len(evaluation.dishes) > 1 else [])]
    verdicts = [(dish.name, dish.verdicts) for dish in dishes]
    parts = [
        section("Correct, by the rule", _correct(dishes)),
        section("Accepted, of all recipes asked", accepted_table("recipes", verdicts)),
        section("Recipes at least so correct", _curve(dishes)),
        section("Why lines have their score", _reasons(dishes)),
        section("Substitutions by confidence", _confidences(dishes)),
        section(_BROKEN, broken_table(verdicts)),
    ]
    failed = evaluation.all.without_tree
    if failed:
        rows = [(recipe.name, recipe.recipe.dish_type, recipe.error) for recipe in failed]
        parts.append(section("Without a tree, counted as 0", grid(rows)))
    return Group(*parts, *left_out_view(evaluation.left_out))


def trees_evaluation_view(evaluation: TreesEvaluation) -> RenderableType:
    """Return what an ``evaluation`` says: accepted by robot and cook for each dish type, rules broken, the rest."""
    verdicts = evaluation.verdicts if len(evaluation.verdicts) > 2 else evaluation.verdicts[-1:]  # noqa: PLR2004
    parts = [section("Accepted", accepted_table("trees", verdicts)), section(_BROKEN, broken_table(verdicts[-1:]))]
    if evaluation.without_tree:
        rows = [(tree.name, tree.dish_type, tree.error) for tree in evaluation.without_tree]
        parts.append(section("Without a tree, accepted by nobody", grid(rows)))
    return Group(*parts)


def accepted_table(asked: str, verdicts: Sequence[tuple[str, Verdicts]]) -> Table:
    """Return by dish type, of its ``verdicts``, how many (and what share) of those ``asked`` robot and cook accept."""
    table = columns("", asked, "robot", "cook", "accepted", "form kept", "no tree")
    table.columns[0].no_wrap = True
    for name, found in verdicts:
        counts = (f"{count} ({100 * found.share(count):.0f} %)" for count in found.named.values())
        table.add_row(name, str(len(found.reports)), *counts, str(len(found.reports) - len(found.trees)))
    return table


def broken_table(verdicts: Sequence[tuple[str, Verdicts]]) -> Table:
    """Return for each rule how many trees have a fatal finding by dish type; the last row says how many have any.

    ``verdicts`` are those of each dish type, of all in the end.
    """
    table = columns("", *(name for name, _ in verdicts), "with any", "asked")
    table.columns[0].no_wrap = True
    for rule in RULES:
        counts = [found.rules[rule] for _, found in verdicts]
        every = counts[-1]
        if every.asked:
            table.add_row(rule, *(str(count.fatal) for count in counts), str(every.broken), str(every.asked))
        else:
            table.add_row(rule, *("" for _ in counts), "", "not asked")
    return table


def left_out_view(left_out: Sequence[LeftOut]) -> list[RenderableType]:
    """Return a section that names the dish types ``left_out``: the FOON knows too little of them; nothing for none."""
    if not left_out:
        return []
    rows = [(dish.dish_type or "no dish type", f"{dish.goals} goals", f"{dish.asked} asked") for dish in left_out]
    return [section(f"Left out: fewer than {FEWEST_GOALS} goals in the FOON", grid(rows))]


def comparison_view(comparison: Comparison) -> RenderableType:
    """Return the ``comparison`` with another evaluation: what got better or worse."""
    both, difference = len(comparison.changes), comparison.difference
    head = Text.assemble(
        (comparison.verdict, "bold"),
        f": {100 * difference.mean:+.1f} points [{100 * difference.low:+.1f}, {100 * difference.high:+.1f}]",
        (f" over {both} asked by both", ASIDE),
    )
    parts: list[RenderableType] = [section("Compared with before", head)]
    for title, changes in (("Better", comparison.better), ("Worse", comparison.worse)):
        if changes:
            parts.append(section(f"{title}: {len(changes)}", grid([_change(c) for c in changes[:_MOST_CHANGES]])))
    only = [("only before", comparison.gone), ("only now", comparison.new)]
    parts += [section(f"Asked {when}: {len(names)}", Text(", ".join(names))) for when, names in only if names]
    return Group(*parts)


def agreement_view(agreement: Agreement, left_open: int) -> RenderableType:
    """Return the ``agreement`` of people and the rule, and how many lines were ``left_open``."""
    kappa = "not defined: both gave one score throughout" if agreement.kappa is None else f"{agreement.kappa:.2f}"
    rows = [
        ("linearly weighted Cohen's kappa", kappa),
        ("the same score", f"{per_cent(agreement.same)} of {agreement.lines} lines"),
        *([("left open", f"{left_open} lines")] if left_open else []),
    ]
    table = columns("the rule", "people 0", "people 1", "people 2")
    for score, counts in enumerate(agreement.table):
        table.add_row(str(score), *map(str, counts))
    return Group(section("People and the rule", grid(rows)), Padding(table, (1, 0, 0, 2)))


def columns(first: str, *others: str) -> Table:
    """Return an empty table: the first column names, the others are figures."""
    table = Table(box=None, pad_edge=False, header_style=ASIDE)
    table.add_column(first)
    for name in others:
        table.add_column(name, justify="right", no_wrap=True)
    return table


def grid(rows: Sequence[tuple[str, ...]]) -> Table:
    """Return rows without a heading."""
    table = Table.grid(padding=(0, 2))
    for row in rows:
        table.add_row(*map(Text, row))
    return table


def per_cent(share: float) -> str:
    """Return a ``share`` (0 to 1) in per cent, as the paper gives it."""
    return f"{100 * share:.1f} %"


def interval_words(interval: Interval) -> str:
    """Return the bounds of an interval of shares, in per cent."""
    return f"{100 * interval.low:.1f} to {100 * interval.high:.1f}"


def _correct(dishes: Sequence[DishFigures]) -> Table:
    table = columns("", "recipes", "lines", "correct", "95 % interval", "at 85 %", "no tree")
    for dish in dishes:
        row = (len(dish.recipes), dish.lines, per_cent(dish.correct.mean), interval_words(dish.correct))
        table.add_row(dish.name, *map(str, row), per_cent(dish.curve[85]), str(len(dish.without_tree)))
    return table


def _curve(dishes: Sequence[DishFigures]) -> Table:
    table = columns("", *(f"{threshold} %" for threshold in _QUOTED))
    for dish in dishes:
        table.add_row(dish.name, *(f"{100 * dish.curve[threshold]:.0f} %" for threshold in _QUOTED))
    return table


def _reasons(dishes: Sequence[DishFigures]) -> Table:
    table = columns("", "score", *(dish.name for dish in dishes))
    for reason in dishes[-1].reasons if len(dishes) > 1 else dishes[0].reasons:
        table.add_row(reason.value, str(reason.score), *(str(dish.reasons.get(reason, 0)) for dish in dishes))
    return table


def _confidences(dishes: Sequence[DishFigures]) -> Table:
    bins = len(dishes[0].confidences)
    table = columns("", *(f"{place / bins:.1f}+" for place in range(bins)))
    for dish in dishes:
        table.add_row(dish.name, *map(str, dish.confidences))
    return table


def _change(change: Change) -> tuple[str, ...]:
    return change.name, change.dish_type, f"{per_cent(change.before)} → {per_cent(change.after)}"
