"""A task tree as a recipe in Markdown: what is needed, and what to do in plain English, with links to the videos."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from urllib.parse import quote

from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.exports.tree import ExportedTree, best_sighting
from foon_kg.formats.substitution import handled
from foon_kg.formats.video_address import is_web_address, video_address
from foon_kg.model import ObjectNode, RequiredIngredient, Sighting
from foon_kg.model.claims import Substitution
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen, is_place
from foon_kg.plans.result import PlanResult

_MARKUP = frozenset("\\`*_[]<>#|~&!")
_IN_LINKS = "/:?=&%#+,;@~-._"


def write_recipe(tree: ExportedTree, amounts: Mapping[RequiredIngredient, str] | None = None) -> str:
    """Return ``tree`` as a recipe that a person can cook from, in Markdown.

    ``amounts`` says how much of an ingredient the recipe wants ("2 cups") instead of what was asked with the plan.
    """
    kitchen = Kitchen.default()
    parts = [[f"# {_plain(_capital(tree.title))}"], list(_introduction(tree))]
    parts += [["## Ingredients"], list(_ingredients(tree, kitchen, amounts or {}))]
    parts += [["## Utensils"], list(_utensils(tree, kitchen))]
    parts += [["## Steps"], list(_steps(tree, kitchen))]
    if tree.result is not None:
        parts += _notes(tree.result)
    return "\n\n".join("\n".join(part) for part in parts if part) + "\n"


def _introduction(tree: ExportedTree) -> Iterator[str]:
    if tree.recipe is not None and tree.goal is not None and tree.goal.label != tree.title:
        yield f"A {_plain(tree.recipe.dish_type)}, made like {_plain(tree.goal.label)}."


def _ingredients(tree: ExportedTree, kitchen: Kitchen, amounts: Mapping[RequiredIngredient, str]) -> Iterator[str]:
    """Yield what the recipe asks for, in its order, then what else the kitchen has to have (water)."""
    wanted = tuple(dict.fromkeys(tree.recipe.ingredients)) if tree.recipe is not None else ()
    for one in wanted:
        words = ", ".join(filter(None, (one.object, one.state)))
        yield f"- {_plain(' '.join(filter(None, (amounts.get(one) or one.amount, words))))}"
    named = {canonical(one.object) for one in wanted}
    others = [node for node in tree.kitchen if kitchen.is_food(node) and canonical(node.label) not in named]
    for words in dict.fromkeys(", ".join((node.label, *_states(node))) for node in others):
        yield f"- {_plain(words)}"


def _utensils(tree: ExportedTree, kitchen: Kitchen) -> Iterator[str]:
    for label in dict.fromkeys(node.label for node in tree.kitchen if not kitchen.is_food(node)):
        yield f"- {_plain(label)}"


def _steps(tree: ExportedTree, kitchen: Kitchen) -> Iterator[str]:
    for number, (known, annotation) in enumerate(zip(tree.units, tree.subgraph.annotations, strict=True), 1):
        seen = best_sighting(known)
        shown = f" {_link(seen)}" if seen is not None else ""
        yield f"{number}. {_plain(sentence(known.unit, kitchen, annotation.measures))}{shown}"


def _notes(result: PlanResult) -> list[list[str]]:
    notes = [f"- {_plain(_substituted(one))}" for one in result.substitutions]
    notes += [f"- {_plain(f'{one.node}: {one.why}')}" for one in result.assumptions]
    return [["## Notes"], notes] if notes else []


def _substituted(one: Substitution) -> str:
    if one.kind == "object":
        return f"{one.required} {handled(one)} (confidence {one.confidence:.2f})"
    if one.kind == "state":
        said = f"{one.object} is {one.required}"
    else:
        said = f"{one.required} the {one.object}" if one.kind == "motion" else f"{one.object}: the {one.required}"
    return f"{said} where the video has {one.equivalent} (confidence {one.confidence:.2f})"


def _link(sighting: Sighting) -> str:
    """Return a link to the second in which the step is seen, or the name of a video without an address."""
    source, start = sighting.source, sighting.start
    if source is None or not is_web_address(source):
        return f"({_plain(sighting.video)})"
    at = f" at {int(start) // 60}:{int(start) % 60:02}" if start is not None else ""
    return f"([video{at}]({quote(video_address(source, start), safe=_IN_LINKS)}))"


def _states(node: ObjectNode) -> tuple[str, ...]:
    return tuple(state for state in node.states if not is_place(state))


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _plain(text: str) -> str:
    """Return ``text`` on one line, without anything that Markdown or HTML would take for markup."""
    return "".join(f"\\{c}" if c in _MARKUP else c for c in " ".join(text.split()))
