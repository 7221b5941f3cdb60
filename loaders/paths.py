"""From files and folders to subgraphs: which files, in which order, in which encoding."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from foon_kg.loaders.found import foon_files
from foon_kg.loaders.json_reader import read_json
from foon_kg.loaders.notices import Journal, Notice, NoticeKind, Problem, ReadResult, UnreadableFile
from foon_kg.loaders.text_blocks import CONTROL
from foon_kg.loaders.text_reader import TextReader
from foon_kg.model.errors import UsageError
from foon_kg.model.nodes import name_of_file
from foon_kg.model.plugins import LOADERS, plugin
from foon_kg.model.regular_files import read_bytes

_BYTE_ORDER_MARK = "\ufeff"
_LINE_END = re.compile(rb"\r\n|\r|\n")


def read_path(path: Path) -> Iterator[ReadResult]:
    """Return one result for ``path``, or for every ``*.txt`` and ``*.json`` below it if it is a folder.

    See :func:`read_paths`.
    """
    return read_paths([path])


def read_paths(paths: Iterable[Path]) -> Iterator[ReadResult]:
    """Return one result for every FOON file that ``paths`` name or, being folders, hold at any depth.

    Sorted by the name of the video, whatever the order of ``paths``. Where two files are of the same video, the
    text counts, then the first path; the other one gives no subgraph, and its file is rejected unless both say the
    same. Hidden files and folders are passed over. A file that cannot be used is a result without subgraph, never
    an exception. Raises ``ReadError`` for a path that does not exist or holds no FOON file.
    """
    found = foon_files(paths)
    copies = Counter(name_of_file(file) for file in found)
    return _read_all(found, {name for name, count in copies.items() if count > 1})


def _read_all(files: list[Path], with_copies: set[str]) -> Iterator[ReadResult]:
    reader = TextReader()
    usable: dict[str, ReadResult] = {}
    for file in files:
        result = _read_file(file, reader)
        if name_of_file(file) in usable:
            result = _copy(usable[name_of_file(file)], result)
        elif name_of_file(file) in with_copies and result.subgraph is not None:
            usable[name_of_file(file)] = result
        yield result


def _copy(first: ReadResult, second: ReadResult) -> ReadResult:
    """Return ``second``, of the same video as ``first``, without its subgraph."""
    if second.subgraph is None:
        return second
    if first.subgraph == second.subgraph:
        same = Notice(second.path, None, NoticeKind.SAME_VIDEO, f"says the same as {first.path}", "left out")
        return ReadResult(second.path, None, (same, *second.notices))
    message = f"the same video as {first.path}, with other units"
    return Journal(second.path).reject_file(None, Problem(NoticeKind.SAME_VIDEO, message))


def _read_file(path: Path, reader: TextReader) -> ReadResult:
    if path.suffix.lower() == ".lisp":
        from foon_kg.loaders.muhai import read_muhai_file  # noqa: PLC0415 - few read MUHAI's recipes

        return read_muhai_file(path)
    try:
        text = decode(read_bytes(path))
        name = _video_name(path)
    except (UnreadableFile, OSError) as error:
        return Journal(_printable(path)).reject_unread(error)
    bare = text.removeprefix(_BYTE_ORDER_MARK)
    result = _read_text(bare, name, path, reader)
    if len(bare) == len(text):
        return result
    mark = Notice(str(path), 1, NoticeKind.BYTE_ORDER_MARK, "a byte order mark before the first line", "left out")
    return replace(result, notices=(mark, *result.notices))


def _read_text(text: str, name: str, path: Path, reader: TextReader) -> ReadResult:
    ending = path.suffix.lower()
    if ending == ".json":
        return read_json(text, name, str(path))
    read = None if ending == ".txt" else plugin(LOADERS, ending.removeprefix("."))
    if read is None:
        return reader.read(text, name, str(path))
    result = read(text, name, str(path))
    if not isinstance(result, ReadResult):
        raise UsageError(f"the plug-in for {ending} files gave {type(result).__name__}", hint="It gives a ReadResult.")
    return result


def _video_name(path: Path) -> str:
    try:
        path.stem.encode()
    except UnicodeEncodeError as error:
        raise UnreadableFile("the name of the file is not UTF-8") from error
    return name_of_file(path)


def _printable(path: Path) -> str:
    return os.fsencode(path).decode("utf-8", "backslashreplace")


def decode(data: bytes) -> str:
    """Return ``data``, the bytes of a file, as text.

    Raises ``UnreadableFile`` with line and byte position where it is no UTF-8 text.
    """
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = _LINE_END.subn(b"", data[: error.start])[1] + 1
        raise UnreadableFile(f"byte {error.start} (0x{data[error.start]:02x}) is not UTF-8", line) from error
    if control := CONTROL.search(text):
        before = text[: control.start()].encode()
        line = _LINE_END.subn(b"", before)[1] + 1
        raise UnreadableFile(f"byte {len(before)} is the control character U+{ord(control[0]):04X}", line)
    return text
