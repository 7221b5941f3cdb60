"""From files and folders to subgraphs: which files, in which order, in which encoding."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path

from foon_kg.errors import ReadError
from foon_kg.loaders.json_reader import read_json
from foon_kg.loaders.notices import Notice, NoticeKind, ReadResult, Severity
from foon_kg.loaders.text_reader import TextReader

_ENDINGS = (".txt", ".json")
_BYTE_ORDER_MARK = "\ufeff"
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]")


def read_path(path: Path) -> Iterator[ReadResult]:
    """Answer one result for ``path``, or for every ``*.txt`` and ``*.json`` below it if it is a folder.

    See :func:`read_paths`.
    """
    return read_paths([path])


def read_paths(paths: Iterable[Path]) -> Iterator[ReadResult]:
    """Answer one result for every FOON file that ``paths`` name or, being folders, hold at any depth.

    Sorted by the name of the video, whatever the order of ``paths``. Where two files are of the same video, the
    text counts, then the first path; the other one gives no subgraph, and its file is rejected unless both say the
    same. Hidden files and folders are passed over. A file that cannot be used is a result without subgraph, never
    an exception. Raises ``ReadError`` for a path that does not exist or holds no FOON file.
    """
    found = sorted({file for path in paths for file in _foon_files(path)}, key=_file_order)
    copies = Counter(file.stem for file in found)
    return _read_all(found, {name for name, count in copies.items() if count > 1})


def _foon_files(path: Path) -> list[Path]:
    if path.is_dir():
        files = [file for file in _below(path) if file.suffix.lower() in _ENDINGS]
        if not files:
            raise ReadError(f"{path}: no FOON file in this folder", hint="It should hold *.txt or *.json subgraphs.")
        return files
    if not path.exists():
        raise ReadError(f"{path}: no such file or folder", hint="Check the path.")
    if path.suffix.lower() not in _ENDINGS:
        raise ReadError(f"{path}: neither *.txt nor *.json", hint="A subgraph is a FOON text or its JSON.")
    return [path]


def _below(folder: Path) -> Iterator[Path]:
    for place, folders, files in os.walk(folder, onerror=_refuse_folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        yield from (Path(place, name) for name in files if not name.startswith("."))


def _refuse_folder(error: OSError) -> None:
    raise ReadError(f"{error.filename}: cannot be opened: {error.strerror}", hint="Check its permissions.") from error


def _file_order(path: Path) -> tuple[str, bool, str]:
    return (path.stem, path.suffix.lower() != ".txt", str(path))


def _read_all(files: list[Path], with_copies: set[str]) -> Iterator[ReadResult]:
    reader = TextReader()
    first: dict[str, ReadResult] = {}
    for file in files:
        result = _read_file(file, reader)
        if file.stem in with_copies:
            result = _beside(first.setdefault(file.stem, result), result)
        yield result


def _beside(first: ReadResult, second: ReadResult) -> ReadResult:
    """Answer ``second``, of the same video as ``first``, without its subgraph."""
    if second is first or second.subgraph is None:
        return second
    if first.subgraph == second.subgraph:
        message, action = f"says the same as {first.path}", "left out"
        severity = Severity.ASSUMED
    else:
        message, action = f"the same video as {first.path} with another content", "file rejected"
        severity = Severity.REJECTED
    notice = Notice(second.path, None, NoticeKind.SAME_VIDEO, message, action, severity)
    return ReadResult(second.path, None, (notice, *second.notices))


def _read_file(path: Path, reader: TextReader) -> ReadResult:
    try:
        text = decode(path.read_bytes(), str(path))
        name = _video_name(path)
        result = _read_text_or_json(path, text.removeprefix(_BYTE_ORDER_MARK), name, reader)
    except OSError as error:
        return _unreadable(path, f"cannot be opened: {error.strerror}")
    except ReadError as error:
        return _unreadable(path, error.message.removeprefix(f"{path}:").strip())
    if text.startswith(_BYTE_ORDER_MARK):
        mark = Notice(str(path), 1, NoticeKind.BYTE_ORDER_MARK, "a byte order mark before the first line", "left out")
        result = ReadResult(result.path, result.subgraph, (mark, *result.notices))
    return result


def _read_text_or_json(path: Path, text: str, name: str, reader: TextReader) -> ReadResult:
    if path.suffix.lower() == ".json":
        return read_json(text, name, str(path))
    return reader.read(text, name, str(path))


def _unreadable(path: Path, reason: str) -> ReadResult:
    notice = Notice(str(path), None, NoticeKind.UNREADABLE_FILE, reason, "file rejected", Severity.REJECTED)
    return ReadResult(str(path), None, (notice,))


def _video_name(path: Path) -> str:
    try:
        path.stem.encode()
    except UnicodeEncodeError as error:
        raise ReadError(f"{path!a}: the file name is not UTF-8", hint="Rename the file.") from error
    return path.stem


def decode(data: bytes, file: str) -> str:
    """Answer the text of a file. Raises ``ReadError`` with line and byte position where it is not UTF-8 text."""
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise ReadError(
            f"{file}:{line}: byte {error.start} (0x{data[error.start]:02x}) is not UTF-8",
            hint="Save the file as UTF-8.",
        ) from error
    if control := _CONTROL.search(text):
        line = text.count("\n", 0, control.start()) + 1
        position = len(text[: control.start()].encode())
        raise ReadError(
            f"{file}:{line}: a control character (U+{ord(control[0]):04X}) at byte {position}: not a text file",
            hint="Remove the character, or save the file as UTF-8 text.",
        )
    return text
