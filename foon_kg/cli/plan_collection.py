"""``foon plan --recipes``: a whole collection of the graph planned into a file in many processes, and gone on with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from foon_kg.cli.answer_file import check_tree, exit_code_of, value_of
from foon_kg.cli.blocks import adding, form_of, whole_blocks
from foon_kg.cli.console import Say, json_line
from foon_kg.cli.dish_types import check_dish_types
from foon_kg.cli.runs import progress_bar
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.foon import Foon, PlanSettings
    from foon_kg.model.json_fields import JsonObject

ALL = "all"


@dataclass(frozen=True)
class CollectionRun:
    """Where the plans go and where the FOON comes from, in how many processes or on which cluster, and who is told."""

    output: Path | None
    files: Sequence[Path] | None
    jobs: int | None
    dask: str | None
    say: Say
    quiet: bool


@dataclass(frozen=True)
class Done:
    """What a file holds already: so many plans, the last for the recipe ``last``, in so many bytes; its exit code.

    ``plan`` is the last of those that end a block and have a tree, with the number of its line.
    """

    count: int = 0
    last: str = ""
    size: int = 0
    code: int = 0
    plan: tuple[int, JsonObject] | None = None


def plan_collection(which: str, kitchen: Path | None, settings: PlanSettings, run: CollectionRun) -> int:
    """Plan all recipes of the graph, or those that surely are the dish type ``which``; return the exit code.

    They are planned with ``settings`` in the ``kitchen`` of a file, and written as ``run`` says. What is in the file
    already stays; recipes that were loaded among those it has are refused, and so is a file of which one tree, planned
    once more, is another one now. Nothing is held of all that is written: a collection may have millions of recipes.
    """
    from foon_kg.cli.kitchen import kitchen_of
    from foon_kg.cli.knowledge import front_door
    from foon_kg.foon import Foon, Question

    if run.output is None:
        raise UsageError("a collection is planned into a file", hint="Name it: --output plans.jsonl.zst")
    check_dish_types([which], besides=[ALL])
    form_of(run.output)  # what it needs is missing now, and not when all is planned
    dish_type = "" if which == ALL else which
    with Foon.connect(say=run.say) as collection:
        done, count = _still_ours(collection, dish_type, run)
        if done.count:
            run.say(f"{run.output} has {done.count} of {count} answers already")
        with front_door(run.files, run.say) as door:
            if kitchen is not None:
                settings = replace(settings, kitchen=kitchen_of(kitchen, door, run.say))
            if done.plan is not None:
                number, told = done.plan
                again = Question(given=collection.recipes.get(told["recipe"]["id"]).asked(dish_type))
                check_tree(run.output, number, told, door.answer(again, settings).outcome.to_json())
            if done.count == count:
                return done.code
            code = done.code
            questions = (
                Question(given=one.asked(dish_type)) for one in collection.recipes.all(dish_type, after=done.last)
            )
            with (
                door.answers(questions, settings, count=count - done.count, jobs=run.jobs, dask=run.dask) as answers,
                adding(run.output, done.size) as add,
            ):
                for answer in progress_bar(answers, "Planning recipes", count, done.count, quiet=run.quiet):
                    add(json_line(answer.outcome.to_json()))
                    code = max(code, 0 if answer.error is None else answer.error.exit_code)
        return code


def _still_ours(collection: Foon, dish_type: str, run: CollectionRun) -> tuple[Done, int]:
    """Return what the file holds and how many recipes there are; raises UsageError where it is of other recipes."""
    output = run.output or Path()
    found = [Done(), *_read(output)]
    count, until = collection.recipes.until(found[-1].last, dish_type)
    if not count:
        raise UsageError("the graph has no such recipe", hint="Load some: foon load recipes PATH", code="empty")
    if until != found[-1].count:
        raise UsageError(
            f"{output} has {found[-1].count} answers, and the graph {until} recipes up to the last of them",
            hint="It is of another collection, or recipes were loaded since. Name another file, or take this one away.",
        )
    done = found[-1]
    if done.count < count and len(found) > 1 and done.count - found[-2].count < form_of(output).lines:
        done = found[-2]  # its last block gets full now
    return done, count


def _read(output: Path) -> Iterator[Done]:
    """Yield what the file holds up to the end of each of its blocks; few of its lines are understood for it."""
    done = Done()
    for content, end in whole_blocks(output):
        lines = content.splitlines()
        here = done.count + len(lines)
        failed = (value_of(output, here, line) for line in lines if b'"error"' in line)
        value = value_of(output, here, lines[-1])
        recipe = value["recipe"]
        last = recipe.get("id") if isinstance(recipe, dict) else None
        plan = (here, value) if last and "units" in value else done.plan
        done = Done(here, str(last or ""), end, max(done.code, *map(exit_code_of, failed), 0), plan)
        yield done
