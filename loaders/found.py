"""Which files hold FOONs, and in which order they are read."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from foon_kg.model.errors import ReadError
from foon_kg.model.nodes import name_of_file
from foon_kg.model.plugins import LOADERS, names

_ENDINGS = (".txt", ".json", ".lisp")
_SPREADSHEET = "Save the table as CSV with commas: foon load videos reads that."
_OTHER_TABLES = {
    ".csv": "A plain table (.csv) is loaded by foon load videos.",
    ".ods": _SPREADSHEET,
    ".xlsx": _SPREADSHEET,
}
"""What to do with a table that is no subgraph, by how its file ends."""


def is_foreign(path: Path) -> bool:
    """Return whether a plug-in reads files with the ending of ``path``, and not foon-kg itself."""
    ending = path.suffix.lower()
    return ending not in _ENDINGS and ending.removeprefix(".") in names(LOADERS)


def foon_files(paths: Iterable[Path]) -> list[Path]:
    """Return the FOON files that ``paths`` name or, being folders, hold at any depth, by the name of the video.

    Hidden files and folders are passed over. Raises ``ReadError`` for a path that does not exist or holds none.
    """
    return sorted({file for path in paths for file in _foon_files(path)}, key=_file_order)


def _foon_files(path: Path) -> list[Path]:
    if path.is_dir():
        return _foon_files_below(path)
    if not path.exists():
        raise ReadError(f"{path}: no such file or folder", hint="Check the path.")
    if path.suffix.lower() not in _ENDINGS and not is_foreign(path):
        hint = _OTHER_TABLES.get(path.suffix.lower(), "A subgraph is a FOON text or its JSON.")
        raise ReadError(f"{path}: neither *.txt nor *.json", hint=hint)
    return [path]


def _foon_files_below(folder: Path) -> list[Path]:
    below = list(_below(folder))
    files = [file for file in below if file.suffix.lower() in _ENDINGS]
    if len(files) < len(below):  # plug-ins are looked for only where there is something for them
        foreign = {f".{name}" for name in names(LOADERS)} - set(_ENDINGS)
        files += [file for file in below if file.suffix.lower() in foreign]
    if not files:
        raise ReadError(f"{folder}: no FOON file in this folder", hint=_hint_for(below))
    return files


def _hint_for(files: Iterable[Path]) -> str:
    """Return what to do with a folder of ``files`` that are no subgraphs."""
    others = (_OTHER_TABLES.get(file.suffix.lower()) for file in files)
    return next(filter(None, others), "It should hold *.txt or *.json subgraphs.")


def _below(folder: Path) -> Iterator[Path]:
    for place, folders, files in os.walk(folder, onerror=_refuse_folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        yield from (Path(place, name) for name in files if not name.startswith("."))


def _refuse_folder(error: OSError) -> None:
    raise ReadError(f"{error.filename}: cannot be opened: {error.strerror}", hint="Check its permissions.") from error


def _file_order(path: Path) -> tuple[str, bool, str]:
    return (name_of_file(path), path.suffix.lower() != ".txt", str(path))
