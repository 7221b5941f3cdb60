"""``foon plan``: the task tree of a recipe, or of many."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from foon_kg.cli.console import AsText, Dask, Files, Json, Quiet, Say, examples, sayer
from foon_kg.cli.dish_types import dish_types_like
from foon_kg.cli.kitchen import KitchenFile
from foon_kg.model import Recipe
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.cli.answering import Show, Writing
    from foon_kg.foon import PlanSettings, Question, Substitute

EXAMPLES = examples(
    'foon plan --dish salad "chopped onion" "whole prune" "olive oil"',
    'foon plan "beaten egg" "chopped onion" --kitchen kitchen.txt',
    "foon plan recipe.json --json",
    "foon plan --recipe 000018c8a5 --recipe 000033e39b",
    "foon plan recipes/ --files subgraphs/ --output plans.jsonl",
    "foon plan --recipes all --output plans.jsonl.zst",
    "foon plan --recipes all --output plans.jsonl.zst --dask tcp://127.0.0.1:8786",
    "foon plan recipe.json --substitute leek=onion --avoid nuts --explain",
    "foon plan recipe.json --enumerate --limit 5000",
    "foon plan recipe.json --method paper",
)


_OTHER_FORMS = (
    ("--enumerate", "--foon", "--explain"),
    ("--json", "--foon", "--explain"),
    ("--output", "--foon", "--explain", "--enumerate"),
    ("--recipes", "--foon", "--explain", "--enumerate"),
)
"""Rows of options of which each asks for another form of the answer."""

_OURS = ("--explain", "--enumerate", "--kitchen", "--with-drafts", "--substitute", "--avoid", "--after")
"""Options of which the paper's own method knows nothing."""


Wanted = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="INGREDIENT|RECIPE...",
        help="Ingredients, state first (“chopped onion”), or recipe files (JSON) or folders.",
    ),
]
Dish = Annotated[
    str | None,
    typer.Option(
        "--dish",
        metavar="TYPE",
        help="The dish type (salad, soup, …) or a name (risotto); else the one most like these ingredients.",
        autocompletion=dish_types_like,
    ),
]
RecipeIds = Annotated[
    list[str] | None,
    typer.Option("--recipe", metavar="ID", help="Plan this recipe of those that foon load recipes brought in."),
]
Collection = Annotated[
    str | None,
    typer.Option(
        "--recipes",
        metavar="all|TYPE",
        help="Plan all recipes that foon load recipes brought in, or those of a dish type, into the file of --output.",
        autocompletion=dish_types_like,
    ),
]
Explain = Annotated[bool, typer.Option("--explain", help="Say for every ingredient why it is made as it is.")]
Substitutes = Annotated[
    list[str] | None,
    typer.Option("--substitute", metavar="FOOD=KNOWN", help="Handle this food like one that FOON knows."),
]
Avoided = Annotated[
    list[str] | None,
    typer.Option("--avoid", metavar="FOOD", help="Leave out this food, or all foods of this kind (nuts, dairy)."),
]
After = Annotated[
    str, typer.Option("--after", metavar="DISH|VIDEO", help="Make it after this recorded dish, or after this video.")
]
Title = Annotated[
    str | None,
    typer.Option("--title", metavar="TEXT", help="What the dish is called, which is read: “Cold tomato soup”."),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "--output", "-o", metavar="FILE", help="Write JSON lines to this file (.gz, .zst), and go on where it ends."
    ),
]
Jobs = Annotated[
    int | None,
    typer.Option(
        "--jobs",
        "-j",
        metavar="N",
        min=1,
        help="Plan in N processes; as a rule one for each 64 recipes, at most all cores.",
    ),
]
Enumerate = Annotated[
    bool, typer.Option("--enumerate", help="List the reference trees there are to choose from, and the choice.")
]
Method = Annotated[
    Literal["frames", "paper"],
    typer.Option("--method", help="For comparison: paper is its four algorithms to the letter, blind to the kitchen."),
]
WithDrafts = Annotated[
    bool,
    typer.Option("--with-drafts", help="Plan after drafts of recipes, too (foon draft recipes); the answer says so."),
]
Limit = Annotated[
    int, typer.Option("--limit", "-n", metavar="N", min=1, help="With --enumerate: look at N combinations at most.")
]


def plan(  # noqa: PLR0917 - each parameter is an option of its own
    wanted: Wanted = None,
    dish: Dish = None,
    title: Title = None,
    recipe: RecipeIds = None,
    recipes: Collection = None,
    kitchen: KitchenFile = None,
    as_json: Json = False,
    foon: AsText = False,
    explain: Explain = False,
    enumerate_all: Enumerate = False,
    limit: Limit = 1_000,
    method: Method = "frames",
    substitute: Substitutes = None,
    avoid: Avoided = None,
    after: After = "",
    output: Output = None,
    jobs: Jobs = None,
    dask: Dask = None,
    with_drafts: WithDrafts = False,
    files: Files = None,
    quiet: Quiet = False,
) -> None:
    """Plan the task tree that makes a dish from these ingredients.

    The answer is the steps in order, what has to be in the kitchen, what FOON has not seen so and which equivalent
    stands for it, and the progress of each ingredient.

    A recipe file is {"id", "title", "type", "ingredients": [{"object", "state"}]}. With --json every recipe is one
    line, in order; one that has no tree is a line with an "error". With several recipes the exit code is the highest.
    With --output a run that was stopped, started again with the same command, does only what is still missing, and what
    could not be read and was mended. Of a file whose name ends in .gz or .zst it keeps all but the last 63 lines.

    What --kitchen names is all that is at hand: utensils ("knife", "oven, preheated"), foods ("egg", "onion,
    chopped", "egg in carton"), or both; of a kind that it does not name, everything. A tree takes nothing else; where
    there is none, the answer says what is missing.

    A food that --substitute names is handled like the known one, however unlike they are; the answer says how unlike.
    What --avoid names is matched with care, kinds of food and parts of names included; what is left out is said. Of the
    usual allergens (egg, gluten, milk …) what is as a rule made with them is left out, too; what a packet says counts.
    --title is read for ingredients in words: a creamy soup is blended, a lasagna laid in layers.
    --after says which recorded dish to follow, instead of the one that suits best.
    --with-drafts takes dishes, too, that were drafted from the words of recipes: those that foon load drafts brought
    in, or of files that --files names (.jsonl, .jsonl.gz, .jsonl.zst). What is made after one says so.
    --explain is for reading and has no JSON. --enumerate is Algorithm 3 as the paper has it, beside the exact search.
    --method paper makes trees that nobody can cook from: it is there to compare foon-kg with.
    """
    forms = {"--explain": explain, "--enumerate": enumerate_all, "--json": as_json, "--foon": foon}
    wishes = {"--kitchen": kitchen, "--with-drafts": with_drafts, "--substitute": substitute, "--avoid": avoid}
    _refuse(forms | wishes | {"--after": after, "--output": output, "--recipes": recipes is not None}, method)
    settings = replace(_wished(substitute, avoid), after=after, explain=explain, method=method, with_drafts=with_drafts)
    run = _Run(files, kitchen, jobs, dask, limit if enumerate_all else None)
    say = sayer(quiet=quiet)
    if recipes is not None:
        _alone(wanted, recipe, dish, title)
        _finish(_collected(recipes, settings, run, output, say, quiet=quiet))
        return
    questions = _called(_questions(wanted, dish, recipe, say), title)
    _one_only(questions, {"--foon": foon, "--enumerate": enumerate_all}, output)
    shown = _shown_as(foon=foon, as_json=as_json)
    _finish(_answered(questions, settings, run, _writing(shown, output, say, quiet=quiet), as_json=as_json))


@dataclass(frozen=True)
class _Run:
    """Of which FOON and in which kitchen is planned, in how many processes, on which cluster.

    ``limit`` is how many combinations of producers are looked at, where that is asked and no plan.
    """

    files: Sequence[Path] | None
    kitchen: Path | None
    jobs: int | None
    dask: str | None
    limit: int | None


def _answered(
    questions: Sequence[Question], settings: PlanSettings, run: _Run, writing: Writing, *, as_json: bool
) -> int:
    """Answer ``questions`` and write the answers; return the exit code."""
    from foon_kg.cli.answering import answer_all
    from foon_kg.cli.candidates import show_candidates
    from foon_kg.cli.kitchen import kitchen_of
    from foon_kg.cli.knowledge import front_door

    with front_door(run.files, writing.say) as door:
        settings = replace(settings, kitchen=kitchen_of(run.kitchen, door, writing.say))
        if run.limit is None:
            return answer_all(questions, door, settings, run.jobs, writing, dask=run.dask)
        show_candidates(questions[0], door, settings, run.limit, as_json=as_json, say=writing.say)
        return 0


def _collected(which: str, settings: PlanSettings, run: _Run, output: Path | None, say: Say, *, quiet: bool) -> int:
    """Plan the recipes of the graph that are ``which`` into ``output``; return the exit code."""
    from foon_kg.cli.plan_collection import CollectionRun, plan_collection

    return plan_collection(
        which, run.kitchen, settings, CollectionRun(output, run.files, run.jobs, run.dask, say, quiet)
    )


def _writing(show: Show, output: Path | None, say: Say, *, quiet: bool) -> Writing:
    """Return where answers go."""
    from foon_kg.cli.answering import Writing

    return Writing(show, output, say, quiet)


def _wished(substitute: Sequence[str] | None, avoid: Sequence[str] | None) -> PlanSettings:
    """Return the settings of who wishes so: what stands for what, and what is left out."""
    from foon_kg.foon import PlanSettings

    return PlanSettings(substitutes=tuple(map(_substitute, substitute or ())), avoided=tuple(avoid or ()))


def _finish(code: int) -> None:
    if code:
        raise typer.Exit(code)


def _alone(*others: object) -> None:
    if any(others):
        raise UsageError("--recipes names all that is to be planned", hint="Leave out other recipes and --dish.")


def _shown_as(*, foon: bool, as_json: bool) -> Show:
    from foon_kg.cli.answering import show_line, show_text, show_view

    return show_text if foon else show_line if as_json else show_view


def _refuse(asked: Mapping[str, object], method: str) -> None:
    """Refuse options that exclude one another, and those that mean nothing for a ``method``."""
    _one_form(asked)
    if method == "paper":
        _ours_only(asked)


def _one_form(asked: Mapping[str, object]) -> None:
    """Refuse what is ``asked`` where two of the options of one row are."""
    for row in _OTHER_FORMS:
        forms = [option for option in row if asked[option]]
        if len(forms) > 1:
            raise UsageError(f"{' and '.join(forms)} ask for two forms of one answer", hint="Choose one of them.")


def _ours_only(asked: Mapping[str, object]) -> None:
    option = next((option for option in _OURS if asked[option]), None)
    if option is not None:
        raise UsageError(f"the paper's method knows nothing of {option}", hint="Leave --method paper or that out.")


def _substitute(text: str) -> Substitute:
    from foon_kg.foon import Substitute

    food, equals, like = (part.strip() for part in text.partition("="))
    if not (food and equals and like):
        raise UsageError(f"“{text}” is no substitute", hint="Write the food and the known one: capers=olives.")
    return Substitute(food, like)


def _questions(
    wanted: Sequence[str] | None, dish_type: str | None, ids: Sequence[str] | None, say: Say
) -> list[Question]:
    """Return what is asked: with ``--dish`` ingredients in words, else files where any of ``wanted`` looks like one."""
    from foon_kg.foon import Question, recipe_files

    if bool(wanted) == bool(ids):
        raise UsageError("say what to plan: ingredients, recipe files or --recipe ID", hint="See foon plan --help.")
    if ids:
        return [Question(given=recipe) for recipe in _stored_recipes(ids, dish_type, say)]
    wanted = wanted or ()
    if dish_type is None and any(map(_looks_like_a_file, wanted)):
        return [Question(path) for path in recipe_files(Path(name) for name in wanted)]
    _refuse_files(wanted)
    return [Question(dish_type=dish_type or "", texts=tuple(wanted))]


def _refuse_files(texts: Sequence[str]) -> None:
    """Raise UsageError where one of ``texts``, ingredients in words, is the name of a file."""
    for text in texts:
        if Path(text).suffix and _is_there(text) and Path(text).is_file():
            hint = "Name each with --files: --files A --files B; recipe files are planned without --dish."
            raise UsageError(f"{text} is a file, and no ingredient", hint=hint)


def _called(questions: list[Question], title: str | None) -> list[Question]:
    """Return questions in words with the title of the dish; recipes from files and of the graph have their own."""
    if title is not None and not all(question.texts for question in questions):
        raise UsageError("--title is for ingredients in words", hint="A recipe has its own title.")
    return [replace(question, title=title) for question in questions] if title is not None else questions


def _stored_recipes(ids: Sequence[str], dish_type: str | None, say: Say) -> list[Recipe]:
    """Return recipes of the graph: as the asked dish type, else as their sure one, else as any."""
    from foon_kg.foon import Foon

    with Foon.connect(say=say) as foon:
        return [foon.recipes.get(recipe_id).asked(dish_type or "") for recipe_id in ids]


def _looks_like_a_file(name: str) -> bool:
    return name.endswith(".json") or os.sep in name or _is_there(name)


def _is_there(name: str) -> bool:
    try:
        return Path(name).exists()
    except OSError:  # words that are too long for the name of a file
        return False


def _one_only(questions: Sequence[Question], alone: dict[str, bool], output: Path | None) -> None:
    """Refuse what makes no sense of many recipes, or of one whose dish type is only found by answering it."""
    option = next((option for option, asked in alone.items() if asked), None)
    if option is not None and len(questions) > 1:
        raise UsageError(
            f"{option} prints one tree, and these are {len(questions)} recipes", hint="Ask for them one by one."
        )
    if output is not None and any(not question.stand_in.dish_type and question.path is None for question in questions):
        raise UsageError("--output needs to know the dish type", hint="Say --dish TYPE.")
