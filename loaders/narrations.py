"""From files and folders to narrated videos: EPIC-KITCHENS-100 tables, ActivityNet Captions and YouCook2 JSON."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from foon_kg.loaders.captions import is_captions, read_captions
from foon_kg.loaders.epic_kitchens import is_epic_kitchens, read_epic_kitchens
from foon_kg.loaders.narrated import NarratedFile
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, UnreadableFile
from foon_kg.loaders.paths import decode
from foon_kg.model.errors import ReadError
from foon_kg.model.regular_files import read_bytes

_ENDINGS = (".csv", ".json")
_FORMS = "an EPIC-KITCHENS-100 table, ActivityNet Captions or YouCook2 JSON"


def read_narrations(paths: Iterable[Path]) -> Iterator[NarratedFile]:
    """Yield what each file narrates that ``paths`` name or, being folders, hold (``*.csv``, ``*.json``), by path.

    A file that is none of the forms, or cannot be read, narrates nothing and says why. Raises ReadError for a path
    that does not exist, or a folder without such files.
    """
    for file in sorted({file for path in paths for file in _files(path)}):
        yield _read(file)


def is_narrated(path: Path) -> bool:
    """Return whether the file in ``path`` narrates videos in one of the forms; no for what cannot be read."""
    if path.suffix.lower() not in _ENDINGS or not path.is_file():
        return False
    if path.suffix.lower() == ".json":
        return is_captions(path)
    try:
        return is_epic_kitchens(decode(read_bytes(path)))
    except (UnreadableFile, OSError):
        return False


def _files(path: Path) -> list[Path]:
    if not path.exists():
        raise ReadError(f"{path}: no such file or folder", hint="Check the path.")
    if not path.is_dir():
        return [path]
    found = [file for file in path.rglob("*") if file.suffix.lower() in _ENDINGS and not file.name.startswith(".")]
    if not found:
        raise ReadError(f"{path}: no file in this folder narrates a video", hint=f"It should hold {_FORMS}.")
    return found


def _read(path: Path) -> NarratedFile:
    if is_captions(path):
        return read_captions(path)
    journal, file = Journal(str(path)), str(path)
    try:
        text = decode(read_bytes(path))
    except (UnreadableFile, OSError) as error:
        journal.reject_unread(error)
        return NarratedFile(file, (), journal.notices())
    if path.suffix.lower() == ".csv" and is_epic_kitchens(text):
        return read_epic_kitchens(text, file)
    journal.reject_file(1, Problem(NoticeKind.UNREADABLE_FILE, f"it is not {_FORMS}"))
    return NarratedFile(file, (), journal.notices())
