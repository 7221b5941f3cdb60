"""How the answers of ``foon plan`` are made and written: one or many, as JSON, FOON text or for reading."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from foon_kg.cli.console import Say, json_line, print_view, show_error
from foon_kg.cli.runs import progress_bar, waited

if TYPE_CHECKING:
    from foon_kg.cli.answer_file import AnswerFile
    from foon_kg.foon import Answer, Foon, PlanSettings, Question

Show = Callable[["Answer"], None]


@dataclass(frozen=True)
class Writing:
    """Where answers go: to the file ``output`` or to stdout, there as ``show`` shows them, with messages to ``say``.

    ``collected`` says that ``show`` prints nothing yet: a progress bar is in nobody's way.
    """

    show: Show
    output: Path | None
    say: Say
    quiet: bool
    collected: bool = False


def answer_all(
    questions: Sequence[Question],
    foon: Foon,
    settings: PlanSettings,
    jobs: int | None,
    writing: Writing,
    *,
    dask: str | None = None,
) -> int:
    """Answer ``questions`` and write the answers, but for those that the output file has already; return the exit code.

    They are planned of ``foon`` with ``settings`` in ``jobs`` processes, or on the cluster of the scheduler at
    ``dask``; ``writing`` says where to, and in which form.
    """
    done = _answered_before(questions, foon, settings, writing)
    there = 0 if done is None else len(done.lines)
    if there:
        writing.say(f"{writing.output} has {there} of {len(questions)} answers already")
    to = nullcontext(writing.show) if done is None else _writes_to(done)
    with foon.answers(questions[there:], settings, jobs=jobs, dask=dask) as answers, to as write:
        shown = _with_progress(answers, writing, len(questions), there)
        codes = [_write(answer, write, writing.say) for answer in shown]
    return max([*codes, 0 if done is None else done.exit_code])


def _with_progress(answers: Iterable[Answer], writing: Writing, total: int, there: int) -> Iterator[Answer]:
    """Pass answers on under a bar; where it would stand in the way of what is printed, tell that one is waited for."""
    beside_data = writing.output is None and not writing.collected and _stdout_is_terminal()
    if beside_data or total == 1:
        return waited(answers, "Planning", quiet=writing.quiet)
    return progress_bar(answers, "Planning recipes", total, there, quiet=writing.quiet)


def show_line(answer: Answer) -> None:
    """Print an answer as one line of JSON."""
    typer.echo(json_line(answer.outcome.to_json()))


def show_text(answer: Answer) -> None:
    """Print the tree of an ``answer`` as FOON text; nothing where there is none."""
    from foon_kg.loaders import write_text
    from foon_kg.plans.result import PlanResult

    if isinstance(answer.outcome, PlanResult):
        typer.echo(write_text(answer.outcome.to_subgraph()), nl=False)


def show_view(answer: Answer) -> None:
    """Print the tree of an ``answer`` for reading, with its explanations; nothing where there is none."""
    from foon_kg.formats.views.explanation import explanation_view
    from foon_kg.formats.views.tree import plan_view
    from foon_kg.plans.result import PlanResult

    if isinstance(answer.outcome, PlanResult):
        print_view(plan_view(answer.outcome))
        if answer.explanations:
            print_view(explanation_view(answer.explanations))


def _answered_before(
    questions: Sequence[Question], foon: Foon, settings: PlanSettings, writing: Writing
) -> AnswerFile | None:
    """Return what the output file holds of the answers to ``questions``: recipes that were mended are planned anew.

    One of its trees is planned once more: of another FOON, in another kitchen or with other wishes it is another one,
    and the file is refused. What could not be read before and was mended is planned and written first.
    """
    if writing.output is None:
        return None
    from foon_kg.cli.answer_file import AnswerFile
    from foon_kg.model.node_json import recipe_to_json

    done = AnswerFile.read(writing.output, len(questions))
    if not done.lines:
        return done
    words = replace(foon.words(), there=settings.kitchen)
    first = questions[: len(done.lines)]
    mended = done.mended([recipe_to_json(question.as_planned(words, settings.avoided)) for question in first])
    surest = done.surest(mended)
    if surest is not None:
        done.check_tree(surest, foon.answer(questions[surest], settings).outcome.to_json())
    if not mended:
        return done
    writing.say(f"{writing.output}: {len(mended)} recipes could not be read before, and are planned now")
    return done.with_lines({place: foon.answer(questions[place], settings).outcome.to_json() for place in mended})


def _stdout_is_terminal() -> bool:
    from foon_kg.cli.streams import data

    return data().is_terminal


def _write(answer: Answer, write: Show, say: Say) -> int:
    """Write one answer; return the exit code that it stands for."""
    from foon_kg.foon import NO_FOOD, NO_STATE

    for note in answer.notes:
        say(f"warning: {note}" if note.startswith((NO_FOOD, NO_STATE)) else note)
    write(answer)
    if answer.error is None:
        return 0
    show_error(answer.error, about=answer.outcome.recipe.id)
    return answer.error.exit_code


@contextmanager
def _writes_to(done: AnswerFile) -> Iterator[Show]:
    with done.going_on() as add:
        yield lambda answer: add(json_line(answer.outcome.to_json()))
