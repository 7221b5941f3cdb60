"""What the commands of ``foon evaluate`` have in common: their options, and where they work and write."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, TypeVar

import typer

from foon_kg.cli.console import Say
from foon_kg.model.written_files import write_file

if TYPE_CHECKING:
    from foon_kg.evaluation.comparison import Comparison
    from foon_kg.model.json_fields import JsonObject

T = TypeVar("T")
A = TypeVar("A")

Dish = Annotated[list[str] | None, typer.Option("--dish", metavar="TYPE", help="Only this dish type.")]
Seed = Annotated[int, typer.Option("--seed", metavar="S", help="The same seed draws the same samples.")]
Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="FILE", help="Keep the answers in this file, and go on where it ends."),
]
Html = Annotated[
    Path | None, typer.Option("--html", metavar="FILE.html", help="Write a report too: a page that stands on its own.")
]
Compare = Annotated[
    Path | None,
    typer.Option("--compare", metavar="OLD.json", help="Say what got better or worse since this (from --json)."),
]
Method = Annotated[
    Literal["frames", "paper"],
    typer.Option("--method", help="For comparison: paper is its four algorithms to the letter."),
]
Jobs = Annotated[
    int | None, typer.Option("--jobs", "-j", metavar="N", min=1, help="Plan in N processes; as a rule all cores.")
]


@dataclass(frozen=True)
class Run:
    """How a run works: the file that keeps its answers, its processes or its cluster, and where messages go."""

    output: Path | None
    jobs: int | None
    dask: str | None
    say: Say
    quiet: bool
    method: Literal["frames", "paper"] = "frames"

    def spread(self, make: Callable[[], Callable[[T], A]], items: Sequence[T]) -> AbstractContextManager[Iterator[A]]:
        """Open what works on ``items`` as ``make`` makes it: a cluster, processes, or for few items just this one."""
        from foon_kg.planning.batch import MANY, cores
        from foon_kg.planning.cluster import spread_over
        from foon_kg.planning.processes import spread

        if self.dask is not None:
            return spread_over(make, items, self.dask)
        processes = cores() if self.jobs is None else self.jobs
        if processes > 1 and len(items) >= MANY:
            return spread(make, items, processes)
        return nullcontext(map(make(), items) if items else iter(()))


def compared(before: JsonObject, after: JsonObject, where: str, seed: int) -> Comparison:
    """Return what changed from the evaluation ``before`` (JSON, read from ``where``) to that ``after``.

    ``seed`` is that of the resampling.
    """
    from foon_kg.evaluation.comparison import compare, shares_of

    return compare(shares_of(before, where), shares_of(after, "this evaluation"), seed)


def write_text(path: Path, text: str, option: str) -> None:
    """Write ``text`` to the file at ``path`` that ``option`` names; raises UsageError where that cannot be."""
    write_file(path, text, f"{option} names a file that can be written.")
