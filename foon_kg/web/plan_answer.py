"""A plan as the API answers it: what ``foon plan --json`` prints, and what else is asked of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict

from foon_kg.foon import Answer, Explanation
from foon_kg.formats.exports.formats import export_tree
from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.formats.pictures.gantt import schedule_svg
from foon_kg.formats.pictures.progress import progress_svg
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.model import KnownUnit
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.node_json import node_to_json, sighting_to_json, wanted_to_json
from foon_kg.plans.durations import Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult
from foon_kg.plans.schedule import Schedule, schedule
from foon_kg.plans.shopping import shopping_list
from foon_kg.validation import KnownFoon, check, tree_from_json
from foon_kg.web.evidence import Place, stands_in
from foon_kg.web.questions import PlanQuestion
from foon_kg.web.words import place_to_see, seen_at


def plan_to_json(
    answer: Answer,
    question: PlanQuestion,
    durations: Durations,
    foon: KnownFoon,
    places: Mapping[Place, KnownUnit],
) -> JsonObject:
    """Return the plan in an ``answer`` to ``question``, what to buy and where to look, and what else is asked.

    That may be why it is so, with what the judge says who compares it with ``foon``; when what is done, by
    ``durations`` (seconds); and pictures. ``places`` are the units of the FOON by where they are seen. Raises TypeError
    for an answer without a plan.
    """
    plan, kitchen = answer.outcome, Kitchen.default()
    if not isinstance(plan, PlanResult):
        raise TypeError("only a plan has steps")
    told: JsonObject = plan.to_json() | {
        "notes": list(answer.notes),
        "shopping": list(map(node_to_json, shopping_list(plan.kitchen, kitchen))),
        **_step_by_step(plan, kitchen, places),
        "amounts": [wanted.amount for wanted in plan.recipe.ingredients],
    }
    if question.export:
        told["files"] = [asdict(file) for file in export_tree(ExportedTree.of_plan(plan), question.export)]
    if question.explain:
        told |= _reasons(answer)
        told["judged"] = check(tree_from_json(plan.to_json()), foon, free=kitchen.free_foods).to_json()
    schedules = [schedule(plan.units, plan.kitchen, durations, kitchen, hands) for hands in question.hands]
    if schedules:
        told["schedules"] = [one.to_json() for one in schedules]
    if question.picture_width is not None:
        told["pictures"] = pictures_to_json(ShownTree.of_result(plan), schedules, question.picture_width)
    return told


def _step_by_step(plan: PlanResult, kitchen: Kitchen, places: Mapping[Place, KnownUnit]) -> JsonObject:
    """Return what is told of each step, as lists in their order: where to look, what stands there, the sentence."""
    looked_at = [place_to_see(unit.sightings, plan.reference.videos) for unit in plan.units]
    return {
        "seen": [seen and sighting_to_json(seen) for seen in looked_at],
        "videos": [seen and seen_at([seen]) for seen in looked_at],
        "stands": [stands_in(unit, plan.substitutions, places) for unit in plan.units],
        "sentences": [sentence(unit, kitchen, unit.measures) for unit in plan.units],
    }


def _reasons(answer: Answer) -> JsonObject:
    """Return why a plan is as it is: the other dishes that were considered, and each food."""
    return {
        "considered": [one.to_json() for one in answer.considered],
        "explanations": list(map(explanation_to_json, answer.explanations)),
    }


def pictures_to_json(shown: ShownTree, schedules: list[Schedule], width: int) -> JsonObject:
    """Return the pictures of a plan as SVG texts: what is ``shown``, and its ``schedules``, ``width`` pixels wide.

    Raises ModuleNotFoundError without what lays a tree out.
    """
    from foon_kg.formats.pictures.tree import tree_svg  # noqa: PLC0415 - agents ask for none, and need no layout

    return {
        "tree": tree_svg(shown, Kitchen.default(), headed=False),
        "progress": progress_svg(shown.told_once(), width),
        "schedules": [schedule_svg(shown, one, width) for one in schedules],
    }


def explanation_to_json(one: Explanation) -> JsonObject:
    """Return why one ingredient is made as it is, field by field; where it joins nothing, that is left out."""
    told: JsonObject = asdict(one) | {
        "want": wanted_to_json(one.want),
        "renamed": [{"asked": asked, "read_as": meant} for asked, meant in one.renamed],
    }
    joins = told.pop("joins")
    if joins is None:
        return told
    return told | {"joins": {name: value for name, value in joins.items() if value is not None}}
