"""What the reports of evaluations are made of: a page that stands on its own, tables, charts and trees.

Nothing is fetched and no script runs: the page's policy refuses both.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from importlib import resources

from foon_kg.evaluation.agreement import Agreement
from foon_kg.evaluation.comparison import Change, Comparison
from foon_kg.evaluation.sampling import FEWEST_GOALS, LeftOut
from foon_kg.formats.pictures.svg import writable
from foon_kg.formats.pictures.tree import tree_svg
from foon_kg.formats.views.evaluation import per_cent
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.plans.kitchen import Kitchen

WORST = 10
"""How many of the worst answers are shown with their trees."""

_POLICY = "default-src 'none'; style-src 'unsafe-inline'"
_MOST_CHANGES = 10


def page(title: str, parts: Iterable[str]) -> str:
    """Return the text of an HTML file called ``title``, with its ``parts`` one below the other."""
    style = resources.files("foon_kg.formats.pictures").joinpath("report.css").read_text(encoding="utf-8")
    return (
        f'<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{words(title)}</title>\n<style>\n{style}</style>\n</head>\n"
        f"<body>\n<main>\n<h1>{words(title)}</h1>\n{''.join(parts)}</main>\n</body>\n</html>\n"
    )


def section(name: str, title: str, *parts: str) -> str:
    """Return a part of the page under a title; ``name`` is where a link leads to it."""
    return f'<section id="{name}">\n<h2>{words(title)}</h2>\n{"".join(parts)}</section>\n'


def paragraph(text: str) -> str:
    """Return a paragraph of plain text."""
    return f"<p>{words(text)}</p>\n"


def table(head: Sequence[str], rows: Iterable[Sequence[str]], kind: str = "") -> str:
    """Return a table with a ``head`` and ``rows`` of cells that are HTML already; ``kind`` is ``words`` or figures."""
    top = "".join(f'<th scope="col">{words(name)}</th>' for name in head)
    body = "".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>\n" for row in rows)
    marked = f' class="{kind}"' if kind else ""
    return f'<div class="wide"><table{marked}><thead><tr>{top}</tr></thead>\n<tbody>\n{body}</tbody></table></div>\n'


def charts(*figures: tuple[str, str]) -> str:
    """Return charts beside one another, each with what it shows in words."""
    shown = (f"<figure>{svg}<figcaption>{words(told)}</figcaption></figure>\n" for svg, told in figures)
    return f'<div class="charts">\n{"".join(shown)}</div>\n'


def unfolded(summary: str, *parts: str) -> str:
    """Return what is shown when its ``summary`` (HTML already) is clicked."""
    return f"<details>\n<summary>{summary}</summary>\n{''.join(parts)}</details>\n"


def tree_picture(tree: ShownTree, kitchen: Kitchen, name: str) -> str:
    """Return a ``tree`` of a ``kitchen`` as a picture.

    ``name`` keeps its arrow heads apart from those of other pictures of the page.
    """
    svg = tree_svg(tree, kitchen).replace('id="way-end"', f'id="way-end-{name}"')
    svg = svg.replace("url(#way-end)", f"url(#way-end-{name})")
    return f'<div class="tree" tabindex="0" role="group" aria-label="{words(tree.title)}">{svg}</div>\n'


def comparison_section(comparison: Comparison) -> str:
    """Return a ``comparison`` in HTML: what changed since another evaluation, and whether by more than chance."""
    difference = comparison.difference
    told = (
        f"{comparison.verdict}: {100 * difference.mean:+.1f} points [{100 * difference.low:+.1f}, "
        f"{100 * difference.high:+.1f}] over {len(comparison.changes)} asked by both"
    )
    parts = [paragraph(told)]
    for title, changes in (("Better", comparison.better), ("Worse", comparison.worse)):
        if changes:
            rows = map(_change, changes[:_MOST_CHANGES])
            parts += [f"<h3>{title}: {len(changes)}</h3>", table(("", "", "before", "now"), rows, "words")]
    return section("compared", "Compared with before", *parts)


def agreement_section(agreement: Agreement) -> str:
    """Return the ``agreement`` of people and the rule in HTML."""
    kappa = "not defined" if agreement.kappa is None else f"{agreement.kappa:.2f}"
    told = (
        f"Linearly weighted Cohen's kappa {kappa}; the same score for {per_cent(agreement.same)} of "
        f"{agreement.lines} lines."
    )
    rows = [(str(score), *map(str, counts)) for score, counts in enumerate(agreement.table)]
    return section(
        "people", "People and the rule", paragraph(told), table(("rule", "people 0", "people 1", "people 2"), rows)
    )


def left_out_section(left_out: Sequence[LeftOut]) -> str:
    """Return the dish types ``left_out``, of which the FOON knows too little; nothing where there are none."""
    if not left_out:
        return ""
    rows = [(words(dish.dish_type or "no dish type"), str(dish.goals), str(dish.asked)) for dish in left_out]
    return section("left-out", f"Left out: fewer than {FEWEST_GOALS} goals", table(("", "goals", "asked"), rows))


def without_tree_section(asked: str, failed: Sequence[tuple[str, str, str]]) -> str:
    """Return of what was ``asked`` (recipes, videos) those that ``failed``; nothing where there are none.

    Each has its name, its dish and why it has no tree.
    """
    if not failed:
        return ""
    rows = [tuple(map(words, one)) for one in failed]
    return section("without-tree", "Without a tree, counted as 0", table((asked, "dish", "why"), rows, "words"))


def words(text: str) -> str:
    """Return text as HTML."""
    return escape(writable(text))


def _change(change: Change) -> tuple[str, ...]:
    return words(change.name), words(change.dish_type), per_cent(change.before), per_cent(change.after)
