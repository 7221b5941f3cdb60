"""``foon draft``: from narrated videos and written instructions to drafts that a person reviews, edits and accepts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli import draft_recipes, draft_review
from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer, where_said
from foon_kg.cli.dish_types import check_dish_types
from foon_kg.cli.groups import CommandGroup
from foon_kg.model.errors import UsageError
from foon_kg.model.written_files import write_file, writing

if TYPE_CHECKING:
    from foon_kg.language.drafting import Draft
    from foon_kg.model import Subgraph
    from foon_kg.model.drafts import DraftFile
    from foon_kg.model.narration import Narration

_OTHER_WAYS = {
    ".csv": "foon draft videos reads narrations, foon load videos plain tables, foon draft recipes collections.",
    ".json": "foon draft recipes reads collections of recipes, foon draft videos captions, foon load foon subgraphs.",
}
"""What reads such a file, by how its name ends."""

app = CommandGroup(name="draft", help="Draft subgraphs of narrated videos and of text.")

Output = Annotated[
    Path, typer.Option("--output", "-o", metavar="FOLDER", help="Write a draft (VIDEO.csv) for every video here.")
]
Force = Annotated[bool, typer.Option("--force", help="Write over drafts that are there already.")]
Drafts = Annotated[list[Path], typer.Argument(metavar="FILE...", help="Drafts (.csv).")]
Dish = Annotated[str | None, typer.Option("--dish", metavar="TYPE", help="The dish type that it makes, as in: salad.")]


@app.callback()
def draft() -> None:
    """Draft subgraphs of narrated videos and of text."""


@app.command(
    epilog=examples(
        "foon draft videos EPIC_100_validation.csv --output drafts/",
        "foon draft videos youcookii.json --output drafts/ --files subgraphs/",
    )
)
def videos(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="PATH...", help="EPIC-KITCHENS-100 CSV, ActivityNet Captions, YouCook2 JSON."),
    ],
    *,
    output: Output = Path("drafts"),
    files: Files = None,
    force: Force = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Draft videos that are told in words.

    Verbs and nouns become units with the states that the FOON gives such motions. Each unit has a confidence and its
    doubts. Nothing is loaded: look at a draft with foon draft review, change it in any editor, load it with foon draft
    accept.
    """
    from foon_kg.loaders import Severity
    from foon_kg.loaders.narrations import read_narrations

    say = sayer(quiet=quiet)
    found = tuple(read_narrations(paths))
    for notice in (notice for file in found for notice in file.notices):
        if notice.severity is Severity.REJECTED or not quiet:
            say(str(notice))
    narrations = chain.from_iterable(file.narrations for file in found)  # one video after another, never all at once
    first = next(narrations, None)
    if first is None:
        raise UsageError("there is nothing to draft", hint=where_said(quiet=quiet))
    failed: list[str] = []
    free = _with_free_names(chain([first], narrations), output, force=force)
    _write(_drafts(free, files, say, failed=failed), output, as_json=as_json)
    if failed:
        raise typer.Exit(1)


@app.command(epilog=examples("foon draft text pancakes.txt --dish cake", "foon draft text salad.txt -o drafts/"))
def text(
    paths: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="Instructions: steps on lines, or running text.")
    ],
    *,
    output: Output = Path("drafts"),
    dish: Dish = None,
    files: Files = None,
    force: Force = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Draft recipes from their instructions.

    They are read by spaCy's parser (pip install 'foon-kg[text]'), with the ingredients where lines list them (below a
    heading, or at the top, each with its amount). Each action becomes units as those of a narrated
    video do: look at a draft with foon draft review, change it in any editor, load it with foon draft accept.
    Where a draft has no unit that is said, and the command fails (exit 1) when all are written.
    """
    from foon_kg.foon import Drafting

    check_dish_types([dish] if dish is not None else [])
    for path in paths:
        if (other := _OTHER_WAYS.get(path.suffix.lower())) is not None:
            raise UsageError(f"{path}: is no text that says what to do", hint=other)
    say = sayer(quiet=quiet)
    narrations = [Drafting.narration(path, say=say) for path in paths]
    free = list(_with_free_names(narrations, output, force=force))  # all, before the first is drafted
    empty = _write(_drafts(free, files, say, dish), output, as_json=as_json)
    for path in empty:
        say(f"{path}: no unit, so that there is nothing to load: none of its words was understood as a step.")
    if empty:
        raise typer.Exit(1)


@app.command(epilog=examples("foon draft accept drafts/P01_01.csv", "foon draft accept drafts/P01_01.csv --anyway"))
def accept(
    paths: Drafts,
    *,
    sure: Annotated[
        float,
        typer.Option(
            "--sure", metavar="SURE", min=0, max=1, help="Doubts of units less sure than this must be resolved."
        ),
    ] = 0.1,
    anyway: Annotated[
        bool, typer.Option("--anyway", help="Accept doubts, leave out rows that are no units, replace videos.")
    ] = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load reviewed drafts, all of them or none.

    Their doubts are dropped. A draft is refused while a row is no unit, or is doubtful and not sure: change the row and
    empty its doubt, or delete it. It is refused, too, where it would replace a video that has other units.
    """
    from foon_kg.loaders.draft_tables import read_draft

    say = sayer(quiet=quiet)
    drafts = [read_draft(path) for path in paths]
    subgraphs = _drafted(drafts)
    if not anyway:
        _refuse_doubts(drafts, sure, say)
    loaded = _accept(subgraphs, say, replacing=anyway)
    if as_json:
        print_json({"accepted": list(loaded), "units": sum(len(one.annotations) for one in subgraphs)})
    else:
        typer.echo("\n".join(f"{name}: in the FOON" for name in loaded))


app.command(epilog=draft_recipes.EXAMPLES)(draft_recipes.recipes)
app.command(epilog=draft_review.EXAMPLES)(draft_review.review)


def _drafted(drafts: Sequence[DraftFile]) -> list[Subgraph]:
    """Return what ``drafts`` hold; raises UsageError where one has no unit."""
    subgraphs = [draft.subgraph for draft in drafts if draft.subgraph is not None]
    if len(subgraphs) < len(drafts):
        names = ", ".join(draft.path for draft in drafts if draft.subgraph is None)
        raise UsageError(f"no unit in {names}", hint="Fill in the rows: a motion, inputs and outputs.")
    return subgraphs


def _refuse_doubts(drafts: Sequence[DraftFile], sure: float, say: Say) -> None:
    doubtful = [(draft, row) for draft in drafts for row in draft.unresolved(sure)]
    for draft, row in doubtful:
        say(f"{draft.path}:{row.line}: {row.confidence:.2f} {'; '.join(row.doubts) or 'no unit'}")
    if doubtful:
        raise UsageError(
            f"{len(doubtful)} rows are doubtful; nothing was loaded",
            hint="Change them and empty their doubt, or delete them; or accept them with --anyway.",
        )


def _accept(subgraphs: Sequence[Subgraph], say: Say, *, replacing: bool) -> tuple[str, ...]:
    """Load everything in one transaction."""
    from foon_kg.foon import Foon
    from foon_kg.plans.difference import Status

    with Foon.connect(say=say) as foon:
        there = [one.name for one in foon.differences(subgraphs) if one.status is Status.CHANGED]
        if there and not replacing:
            hint = "foon diff shows what would change; rename the draft, or replace the video with --anyway."
            raise UsageError(f"the FOON has other units of {', '.join(there)}; nothing was loaded", hint=hint)
        report = foon.store(subgraphs, at_once=True)
    return tuple(sorted((*report.inserted, *report.replaced, *report.unchanged)))


def _drafts(
    narrations: Iterable[Narration],
    files: Sequence[Path] | None,
    say: Say,
    dish: str | None = None,
    *,
    failed: list[str] | None = None,
) -> Iterable[Draft]:
    """Yield the drafts; one that cannot be made is told and, where ``failed`` is given, only named there."""
    from foon_kg.cli.knowledge import whole_foon
    from foon_kg.foon import Foon

    def tell_odd(narration: Narration, error: Exception) -> None:
        if failed is None:
            raise error
        failed.append(narration.name)
        say(f"{narration.source}: {narration.name} could not be drafted: {error!r}. The others are.")

    with Foon(whole_foon(files, say)) as foon:  # no connection stays open while the drafts are made
        yield from foon.drafting.drafts(narrations, dish, tell_odd=tell_odd)


def _write(drafts: Iterable[Draft], folder: Path, *, as_json: bool) -> list[Path]:
    """Write each draft into ``folder``, say how many units it has, and return the files of those that have none."""
    from foon_kg.loaders.draft_tables import write_draft

    counts, empty = [], []
    for draft in drafts:
        path = _file_of(draft.name, folder)
        if not draft.units:
            empty.append(path)
        write_file(path, write_draft(draft), "Another --output.")
        counts.append({"file": str(path), "units": len(draft.units), "left_out": len(draft.left_out)})
        if not as_json:
            typer.echo(f"{path}: {len(draft.units)} units, {len(draft.left_out)} narrations left out")
    if as_json:
        print_json(counts)
    return empty


def _with_free_names(narrations: Iterable[Narration], folder: Path, *, force: bool) -> Iterator[Narration]:
    """Pass ``narrations`` on that can be written into ``folder``, which is made; raises UsageError at one that cannot.

    So nothing is drafted that is refused for its name.
    """
    names = set[str]()
    with writing(folder, "Another --output."):
        folder.mkdir(parents=True, exist_ok=True)
    for narration in narrations:
        path = _file_of(narration.name, folder)
        if narration.name in names:  # --force is for drafts of an earlier run
            raise UsageError(f"{path}: two of these drafts have this name", hint="Draft them into two folders.")
        names.add(narration.name)
        if path.exists() and not force:
            raise UsageError(f"{path}: is there already", hint="Another --output, or --force.")
        yield narration


def _file_of(name: str, folder: Path) -> Path:
    return folder / f"{name}.csv"
