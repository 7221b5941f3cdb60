"""``foon plan``: the task tree of a recipe, or of many."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import (
    Files,
    Json,
    Quiet,
    Say,
    examples,
    json_line,
    print_view,
    progress_bar,
    sayer,
    show_error,
)
from foon_kg.errors import UsageError
from foon_kg.model import DISH_TYPES

if TYPE_CHECKING:
    from foon_kg.batch import Answer, Question, Wishes
    from foon_kg.cli.answer_file import AnswerFile
    from foon_kg.knowledge import KnowledgeView
    from foon_kg.likeness import Substitute

EXAMPLES = examples(
    'foon plan --dish salad "chopped onion" "whole prune" "olive oil"',
    "foon plan recipe.json --json",
    "foon plan recipes/ --files subgraphs/ --output plans.jsonl",
    "foon plan recipe.json --substitute capers=olives --avoid nuts --explain",
)


def _dish_types(incomplete: str) -> list[str]:
    return [dish_type for dish_type in DISH_TYPES if dish_type.startswith(incomplete)]


def plan(
    wanted: Annotated[
        list[str],
        typer.Argument(
            metavar="INGREDIENT|RECIPE...",
            help="With --dish ingredients, state first (“chopped onion”); otherwise recipe files (JSON) or folders.",
        ),
    ],
    *,
    dish: Annotated[
        str | None,
        typer.Option("--dish", metavar="TYPE", help="The dish type: salad, soup, …", autocompletion=_dish_types),
    ] = None,
    as_json: Json = False,
    foon: Annotated[bool, typer.Option("--foon", help="Print the tree as FOON text.")] = False,
    explain: Annotated[
        bool, typer.Option("--explain", help="Say for every ingredient why it is made as it is.")
    ] = False,
    substitute: Annotated[
        list[str] | None,
        typer.Option("--substitute", metavar="FOOD=KNOWN", help="Handle this food like one that FOON knows."),
    ] = None,
    avoid: Annotated[
        list[str] | None,
        typer.Option("--avoid", metavar="FOOD", help="Leave out this food, or all foods of this kind (nuts, dairy)."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="FILE", help="Write JSON lines to this file, and go on where it ends."),
    ] = None,
    jobs: Annotated[
        int | None, typer.Option("--jobs", "-j", metavar="N", min=1, help="Plan in N processes; as a rule all cores.")
    ] = None,
    files: Files = None,
    quiet: Quiet = False,
) -> None:
    """Plan the task tree that makes a dish from these ingredients.

    The answer is the steps in order, what has to be in the kitchen, what FOON has not seen so and which equivalent
    stands for it, and the progress of each ingredient.

    A recipe file is {"id", "title", "type", "ingredients": [{"object", "state"}]}. With --json every recipe is one
    line, in order; one that has no tree is a line with an "error". With several recipes the exit code is the highest.
    With --output a run that was stopped, started again with the same command, does only what is still missing.

    A food that --substitute names is handled like the known one, however unlike they are; the answer says how unlike.
    What --avoid names is matched with care, kinds of food and parts of names included; what is left out is said.
    --explain is for reading and has no JSON.
    """
    from foon_kg.batch import Wishes

    _one_form({"--json": as_json or output is not None, "--foon": foon, "--explain": explain})
    questions = _question_in_words(dish, wanted) if dish is not None else _questions_in_files(wanted, one_only=foon)
    wishes = Wishes(tuple(map(_substitute, substitute or ())), tuple(avoid or ()), explain)
    say = sayer(quiet=quiet)
    with _knowledge(files, len(questions), say) as view:
        done = None if output is None else _answered_before(output, questions, view, wishes)
        there = 0 if done is None else len(done.lines)
        if there:
            say(f"{output} has {there} of {len(questions)} answers already")
        show = _shows_text if foon else _shows_line if as_json else _shows_view
        writing = nullcontext(show) if done is None else _writes_to(done)
        with _answering(questions[there:], view, wishes, jobs) as answers, writing as write:
            beside_data = output is None and _stdout_is_terminal()
            shown = answers if quiet or beside_data else progress_bar(answers, len(questions), there)
            codes = [_show(answer, write, say) for answer in shown]
    code = max([*codes, 0 if done is None else done.exit_code])
    if code:
        raise typer.Exit(code)


def _one_form(asked: dict[str, bool]) -> None:
    forms = [option for option, chosen in asked.items() if chosen]
    if len(forms) > 1:
        raise UsageError(f"{' and '.join(forms)} ask for two forms of one answer", hint="Choose one of them.")


def _substitute(text: str) -> Substitute:
    from foon_kg.likeness import Substitute

    food, equals, like = (part.strip() for part in text.partition("="))
    if not (food and equals and like):
        raise UsageError(f"“{text}” is no substitute", hint="Write the food and the known one: capers=olives.")
    return Substitute(food, like)


def _question_in_words(dish_type: str, texts: Sequence[str]) -> list[Question]:
    from foon_kg.batch import Question

    return [Question(dish_type=dish_type, texts=tuple(texts))]


def _questions_in_files(names: Sequence[str], *, one_only: bool) -> list[Question]:
    from foon_kg.batch import Question
    from foon_kg.recipes import recipe_files

    paths = list(recipe_files(Path(name) for name in names))
    if one_only and len(paths) > 1:
        raise UsageError(f"--foon prints one tree, and these are {len(paths)} recipes", hint="Ask for them one by one.")
    return [Question(path) for path in paths]


@contextmanager
def _knowledge(files: Sequence[Path] | None, count: int, say: Say) -> Iterator[KnowledgeView]:
    """Open the FOON: for many recipes all of it at once, as it stands now."""
    from foon_kg.batch import MANY
    from foon_kg.cli.knowledge import open_knowledge, whole_foon

    if count >= MANY:
        yield whole_foon(files, say)
        return
    with open_knowledge(files, say) as view:
        yield view


def _answered_before(path: Path, questions: Sequence[Question], view: KnowledgeView, wishes: Wishes) -> AnswerFile:
    from foon_kg.cli.answer_file import AnswerFile
    from foon_kg.kitchen import Kitchen
    from foon_kg.model_json import recipe_to_json
    from foon_kg.recipes import IngredientWords

    done = AnswerFile.read(path)
    if done.lines:
        words = IngredientWords(view.vocabulary(), Kitchen.default())
        first = questions[: len(done.lines)]
        done.check([recipe_to_json(question.as_planned(words, wishes.avoided)) for question in first])
    return done


def _answering(
    questions: Sequence[Question], view: KnowledgeView, wishes: Wishes, jobs: int | None
) -> AbstractContextManager[Iterable[Answer]]:
    from foon_kg.batch import MANY, Cook, answering, cores
    from foon_kg.snapshot import Snapshot

    units = view.units if isinstance(view, Snapshot) and len(questions) > 1 else None
    processes = cores() if jobs is None else jobs
    if units is not None and len(questions) >= MANY and processes > 1:
        return answering(questions, view, wishes, units, processes)
    return nullcontext(map(Cook(view, wishes, units).answer, questions) if questions else ())


def _stdout_is_terminal() -> bool:
    from foon_kg.cli.console import data

    return data().is_terminal


def _show(answer: Answer, write: Callable[[Answer], None], say: Say) -> int:
    """Write one answer; return the exit code that it stands for."""
    for note in answer.notes:
        say(note)
    write(answer)
    if answer.error is None:
        return 0
    show_error(answer.error, about=answer.outcome.recipe.id)
    return answer.error.exit_code


@contextmanager
def _writes_to(done: AnswerFile) -> Iterator[Callable[[Answer], None]]:
    with done.going_on() as add:
        yield lambda answer: add(json_line(answer.outcome.to_json()))


def _shows_line(answer: Answer) -> None:
    typer.echo(json_line(answer.outcome.to_json()))


def _shows_text(answer: Answer) -> None:
    from foon_kg.loaders import write_text
    from foon_kg.result import PlanResult

    if isinstance(answer.outcome, PlanResult):
        typer.echo(write_text(answer.outcome.to_subgraph()), nl=False)


def _shows_view(answer: Answer) -> None:
    from foon_kg.result import PlanResult
    from foon_kg.views.explanation import explanation_view
    from foon_kg.views.tree import plan_view

    if isinstance(answer.outcome, PlanResult):
        print_view(plan_view(answer.outcome))
        if answer.explanations:
            print_view(explanation_view(answer.explanations))
