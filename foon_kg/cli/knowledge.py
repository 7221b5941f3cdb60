"""Where a command takes its FOON from: the files that ``--files`` names, else Neo4j."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from foon_kg.cli.console import Say
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.foon import Foon, Snapshot
    from foon_kg.loaders.notices import ReadResult
    from foon_kg.model import Subgraph
    from foon_kg.model.drafted import Lesson


def front_door(files: Sequence[Path] | None, say: Say) -> Foon:
    """Return the FOON that a command asks: of ``files``, else of the environment's Neo4j or the local one.

    Where a local Neo4j has to be started, ``say`` takes the lines that tell so.
    """
    from foon_kg.foon import Foon

    return Foon.of_subgraphs(subgraphs_of(files, say), _lessons_in(files)) if files else Foon.connect(say=say)


def _lessons_in(files: Sequence[Path]) -> Sequence[Lesson]:
    """Return what the files of drafted recipes among ``files`` teach."""
    from foon_kg.loaders.lessons import is_drafts_file, lessons_of, read_drafted
    from foon_kg.model.drafted import surest

    return surest(lessons_of(read_drafted(filter(is_drafts_file, files))))


def whole_foon(files: Sequence[Path] | None, say: Say) -> Snapshot:
    """Return a whole FOON in memory: of ``files``, else from Neo4j; ``say`` takes the lines that tell of its start."""
    with front_door(files, say) as foon:
        return foon.snapshot()


def subgraphs_of(paths: Sequence[Path], say: Say) -> list[Subgraph]:
    """Return the subgraphs of the files and folders at ``paths``.

    What their files have wrong is counted for ``say``, and so are words of which no table knows anything. Raises
    UsageError where there is no such path, or no subgraph in any.
    """
    from foon_kg.cli.runs import counting
    from foon_kg.loaders.lessons import is_drafts_file
    from foon_kg.loaders.video_tables import read_videos

    for path in paths:
        if not path.exists():
            raise UsageError(f"there is no file or folder {path}", hint="--files names subgraph files or folders.")
    subgraph_paths = [path for path in paths if not is_drafts_file(path)]
    with counting("Reading files", closing=False, quiet=bool(getattr(say, "quiet", False))) as advance:
        results = []
        for result in read_videos(subgraph_paths):
            results.append(result)
            advance(1)
    subgraphs = [result.subgraph for result in results if result.subgraph is not None]
    if not subgraphs:
        names = ", ".join(map(str, paths))
        raise UsageError(f"no subgraph in {names}", hint="--files names folders with FOON text or JSON files.")
    if odd := _oddities(results, subgraphs):
        say(f"{odd} in these files (foon load foon --report FILE lists them)")
    return subgraphs


def _oddities(results: Sequence[ReadResult], subgraphs: Sequence[Subgraph]) -> str:
    """Return in short how many lines were left out or mended, and how many words no table knows; ``""`` for none."""
    from foon_kg.cli.loading import in_short
    from foon_kg.food.unknown import unknown_words

    units = [one.unit for subgraph in subgraphs for one in subgraph.annotations]
    nodes = (node for unit in units for node in (*unit.input_nodes, *unit.output_nodes))
    words = unknown_words(nodes, [unit.motion for unit in units])
    notices = [notice for result in results for notice in result.notices]
    skipped = sum(str(notice.severity) == "rejected" for notice in notices)
    return in_short(skipped, len(notices) - skipped, sum(not word.nearly for word in words))
