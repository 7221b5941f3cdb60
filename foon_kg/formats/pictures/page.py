"""A plan as a page that stands on its own: one file, nothing fetched, light and dark, by mouse, touch and keyboard."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from importlib import resources

from foon_kg.formats.pictures.progress import progress_svg
from foon_kg.formats.pictures.svg import writable
from foon_kg.formats.pictures.tree import tree_svg
from foon_kg.formats.substitution import done_like, handled
from foon_kg.formats.video_address import is_web_address, video_address
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.words import UNSEEN_SIGN, shown_inputs, shown_outputs
from foon_kg.model import ObjectNode, Sighting
from foon_kg.model.claims import Substitution
from foon_kg.model.tree import Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.shopping import shopping_list

_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
_KEYS = "Arrow keys move the picture, + and - zoom, 0 shows all of it."
_HINTS = {
    "fine": f"Drag to move, Ctrl and the wheel zoom. {_KEYS}",
    "coarse": "Two fingers move and zoom; after a tap one finger moves.",
}
_BUTTONS = (
    ("larger", "Larger", "+"),
    ("smaller", "Smaller", "\N{MINUS SIGN}"),
    ("all", "All of it", "All"),
    ("own", "Its own size", "1:1"),
)


def page_of(tree: ShownTree, kitchen: Kitchen, *, folded: bool = True) -> str:
    """Return the text of an HTML file: the ``tree`` as a picture to move and zoom, steps, lists and progress lines.

    ``kitchen`` tells foods from utensils; see :func:`~foon_kg.formats.pictures.scene.scene_of` for ``folded``.
    """
    style, stage, script = (_file(name) for name in ("page.css", "stage.js", "page.js"))
    return (
        f'<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{_text(tree.title)}</title>\n<style>\n{style}</style>\n</head>\n"
        f"<body>\n<main>\n<h1>{_text(tree.title)}</h1>{''.join(_sections(tree, kitchen, folded=folded))}</main>\n"
        f'<script type="module">\n{stage}{script}</script>\n</body>\n</html>\n'
    )


def _sections(tree: ShownTree, kitchen: Kitchen, *, folded: bool) -> Iterator[str]:
    """Yield what stands on the page below its title; of lists those that have something in them."""
    yield _section("tree", "Task tree", _stage(tree_svg(tree, kitchen, folded=folded)))
    yield _section("steps", f"{len(tree.units)} steps", steps_list(tree))
    shopping = shopping_list(tree.kitchen, kitchen)
    yield _section("shopping", "Shopping list", _list(_node(node, tree) for node in shopping))
    if tree.substitutions:
        yield _section("substitutions", "Substitutions", _list(map(_substitution, tree.substitutions)))
    if tree.result and tree.result.assumptions:
        told = (f"{_node(one.node, tree)}: {_text(one.why)}" for one in tree.result.assumptions)
        yield _section("assumptions", "Assumptions", _list(told))
    if tree.result and tree.result.passed_over:
        nearer = (
            f"<b>{one.similarity:.2f}</b> {_text(one.goal.label)}: {_text(one.why)}" for one in tree.result.passed_over
        )
        yield _section("passed-over", "Nearer by their foods, and passed over", _list(nearer))
    if tree.lines:
        drawn = f'<div class="wide">{progress_svg(tree.told_once())}</div>'
        yield _section("progress", "Progress of each ingredient", drawn)


def steps_list(tree: ShownTree) -> str:
    """Return the steps of ``tree`` as an HTML list, each with a link to the second of a video where it was seen."""
    return _list((_step(unit, tree) for unit in tree.units), ordered=True)


def _stage(svg: str) -> str:
    buttons = "".join(
        f'<button type="button" data-do="{do}" aria-label="{label}">{sign}</button>' for do, label, sign in _BUTTONS
    )
    hints = "".join(f'<span class="aside {who}">{hint}</span>' for who, hint in _HINTS.items())
    stage = f'<div id="stage" tabindex="0" role="group" aria-label="The task tree. {_KEYS}">{svg}</div>'
    return f'<div class="bar">{buttons}{hints}</div>{stage}'


def _step(unit: Step, tree: ShownTree) -> str:
    taken = " + ".join(_node(node, tree) for node in shown_inputs(unit.input_nodes))
    made = " + ".join(_node(node, tree) for node in shown_outputs(unit.output_nodes))
    seen = unit.seen_in[0] if unit.seen_in else None
    origin = f' <span class="origin {unit.origin}">{_sighting(seen)}</span>' if seen else ""
    return f"{taken} → {_span('motion', unit.motion)} → {made}{origin}"


def _sighting(seen: Sighting) -> str:
    when = "" if seen.start is None else f" at {int(seen.start) // 60}:{int(seen.start) % 60:02}"
    text = _text(f"{seen.video}{when}")
    if seen.source is None or not is_web_address(seen.source):
        return text
    return f'<a href="{_text(video_address(seen.source, seen.start))}" rel="noreferrer">{text}</a>'


def _node(node: ObjectNode, tree: ShownTree) -> str:
    words = [_span("state", state) for state in node.states]
    words += [_span("aside", f"{node.relation or 'at'} {node.container}")] if node.container else []
    name = _text(node.label)
    if node.label in tree.unseen:
        like = tree.unseen[node.label]
        name = _span("unseen", UNSEEN_SIGN + node.label, f"like {like.equivalent} {like.confidence:.2f}")
    return f"{name} ({', '.join(words)})" if words else name


def _span(kind: str, text: str, title: str = "") -> str:
    told = f' title="{_text(title)}"' if title else ""
    return f'<span class="{kind}"{told}>{_text(text)}</span>'


def _substitution(one: Substitution) -> str:
    if one.kind == "object":
        told = f"{'! ' if one.for_want else ''}{_span('unseen', UNSEEN_SIGN + one.required)} {_text(handled(one))}"
    else:
        told = _text(done_like(one))
    others = ", ".join(f"{_text(other.name)} {other.confidence:.2f}" for other in one.alternatives)
    return f"<b>{one.confidence:.2f}</b> {told}" + (f' <span class="aside">or {others}</span>' if others else "")


def _section(name: str, title: str, body: str) -> str:
    return f'<section id="{name}-section"><h2>{title}</h2>{body}</section>\n'


def _list(items: Iterator[str] | map[str], *, ordered: bool = False) -> str:
    kind = "ol" if ordered else "ul"
    return f"<{kind}>{''.join(f'<li>{item}</li>' for item in items)}</{kind}>"


def _text(text: str) -> str:
    return escape(writable(text))


def _file(name: str) -> str:
    return resources.files("foon_kg.formats.pictures").joinpath(name).read_text(encoding="utf-8")
