"""``foon plan --recipes``: a whole collection of the graph planned into a file, on all cores, and gone on with."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from foon_kg.cli.answer_file import exit_code_of, value_of
from foon_kg.cli.blocks import adding, form_of, whole_blocks
from foon_kg.cli.console import Say, json_line
from foon_kg.cli.runs import progress_bar
from foon_kg.model import DISH_TYPES
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.foon import Foon
    from foon_kg.planning.batch import Answer, Question
    from foon_kg.planning.settings import PlanSettings
    from foon_kg.store.graph.connection import Connection
    from foon_kg.store.settings import ConnectionSettings
    from foon_kg.store.snapshot import Snapshot
    from foon_kg.store.with_drafts import WithDrafts

ALL = "all"

WHOLE = 50_000
"""A FOON of more units is held by no process: each asks the graph for the parts that a recipe needs."""


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
    """What a file holds already: so many plans, the last for the recipe ``last``, in so many bytes; its exit code."""

    count: int = 0
    last: str = ""
    size: int = 0
    code: int = 0


def plan_collection(which: str, kitchen: Path | None, settings: PlanSettings, run: CollectionRun) -> int:
    """Plan all recipes of the graph, or those that surely are the dish type ``which``; return the exit code.

    What is in the file already stays; recipes that were loaded among those it has are refused. Nothing is held of all
    that is written: a collection may have millions of recipes.
    """
    from foon_kg.cli.kitchen import kitchen_of
    from foon_kg.cli.knowledge import front_door
    from foon_kg.store.graph.connection import Connection
    from foon_kg.store.server import connection_settings

    if run.output is None:
        raise UsageError("a collection is planned into a file", hint="Name it: --output plans.jsonl.zst")
    if which not in {ALL, *DISH_TYPES}:
        raise UsageError(f"“{which}” is no dish type", hint=f"Say --recipes {ALL}, or one of {', '.join(DISH_TYPES)}.")
    form_of(run.output)  # what it needs is missing now, and not when all is planned
    dish_type = "" if which == ALL else which
    with Connection(connection_settings(run.say)) as connection:
        done, count = _still_ours(connection, dish_type, run)
        if done.count:
            run.say(f"{run.output} has {done.count} of {count} answers already")
        if done.count == count:
            return done.code
        with front_door(run.files, run.say) as door:
            foon = None if _is_too_large(connection, settings, run) else _whole(door, settings)
            if kitchen is not None:
                settings = replace(settings, kitchen=kitchen_of(kitchen, door, run.say))
        code = done.code
        questions = _questions(connection, done.last, dish_type)
        with _answering(questions, foon, settings, run) as answers, adding(run.output, done.size) as add:
            for answer in progress_bar(answers, "Planning recipes", count, done.count, quiet=run.quiet):
                add(json_line(answer.outcome.to_json()))
                code = max(code, 0 if answer.error is None else answer.error.exit_code)
        return code


def _questions(connection: Connection, last: str, dish_type: str) -> Iterator[Question]:
    from foon_kg.planning.batch import Question
    from foon_kg.store.graph.recipes import recipes_after

    return (Question(given=one.asked(dish_type)) for one in recipes_after(connection, last, dish_type))


def _is_too_large(connection: Connection, settings: PlanSettings, run: CollectionRun) -> bool:
    """Whether the FOON is in a graph, and too large to be held in memory by each process.

    The workers of a cluster may not reach the graph, and what drafts teach is read with the whole.
    """
    from foon_kg.store.graph.counting import unit_count

    if run.files or run.dask is not None or settings.with_drafts:
        return False
    return unit_count(connection) > WHOLE


def _whole(door: Foon, settings: PlanSettings) -> Snapshot | WithDrafts:
    return door.with_drafts() if settings.with_drafts else door.snapshot()


def _asking(server: ConnectionSettings, settings: PlanSettings) -> Callable[[Question], Answer]:
    """Return what answers questions from the graph, and reads of it what each of them needs."""
    from foon_kg.foon import Foon

    foon = Foon(server=server)
    return lambda question: foon.answer(question, settings)


def _answering(
    questions: Iterable[Question], foon: Snapshot | WithDrafts | None, settings: PlanSettings, run: CollectionRun
) -> AbstractContextManager[Iterable[Answer]]:
    from foon_kg.planning.batch import Cook, answering, answering_on, cores

    if foon is None:
        return _answering_in_parts(questions, settings, run)
    if run.dask is not None:
        return answering_on(run.dask, questions, foon, settings, foon.units)
    processes = cores() if run.jobs is None else run.jobs
    if processes > 1:
        return answering(questions, foon, settings, foon.units, processes)
    return nullcontext(map(Cook(foon, settings, foon.units).answer, questions))


@contextmanager
def _answering_in_parts(
    questions: Iterable[Question], settings: PlanSettings, run: CollectionRun
) -> Iterator[Iterable[Answer]]:
    from foon_kg.foon import Foon
    from foon_kg.planning.batch import cores
    from foon_kg.planning.processes import spread
    from foon_kg.store.server import connection_settings

    server = connection_settings(run.say)
    processes = cores() if run.jobs is None else run.jobs
    if processes > 1:
        with spread(partial(_asking, server, settings), questions, processes) as answers:
            yield answers
        return
    with Foon(server=server) as foon:
        yield (foon.answer(question, settings) for question in questions)


def _still_ours(connection: Connection, dish_type: str, run: CollectionRun) -> tuple[Done, int]:
    """Return what the file holds and how many recipes there are; raises UsageError where it is of other recipes."""
    from foon_kg.store.graph.recipes import recipes_until

    output = run.output or Path()
    found = [Done(), *_read(output)]
    count, until = recipes_until(connection, found[-1].last, dish_type)
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
        recipe = value_of(output, here, lines[-1])["recipe"]
        last = recipe.get("id") if isinstance(recipe, dict) else None
        done = Done(here, str(last or ""), end, max(done.code, *map(exit_code_of, failed), 0))
        yield done
