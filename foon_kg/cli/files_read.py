"""What a load tells of subgraph files, kept by their bytes: what is in the graph already is not parsed again."""

from __future__ import annotations

import hashlib
import json
import os
import pickle
import tempfile
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import astuple, dataclass, field
from importlib import resources
from pathlib import Path
from typing import IO, TYPE_CHECKING, Self

from foon_kg.food.unknown import UnknownWord, WordKind, by_one_another, unknown_words
from foon_kg.loaders.notices import Notice, NoticeKind, Severity
from foon_kg.model import ObjectNode, kept
from foon_kg.model.json_text import compact_json
from foon_kg.model.regular_files import read_bytes
from foon_kg.model.written_files import writing

if TYPE_CHECKING:
    from foon_kg.loaders.notices import ReadResult
    from foon_kg.model import FunctionalUnit, Subgraph

Where = tuple[str, int | None]
"""A file, and a line of it where that is known."""

MOST_HELD = 10_000
"""So many units of files that were read are in memory until they are loaded, some 2 kB each."""

_TEMPORARY = "Let TMPDIR name a folder that can be written."

_FOLDER = "files"
_FORM = "4"
"""Of what is kept; another one is none."""

_READ_BY = ("food", "model")
_VARIABLES = ("FOON_KG_FOODS", "FOON_KG_UTENSILS", "FOON_KG_ALIASES")
"""What names files of a user's own that the answer may depend on."""


@dataclass(frozen=True)
class FilesRead:
    """How many ``files`` there are and in how many something is ``bad``; their videos' hashes by name; what is odd.

    ``words`` are those that no table has, each with the first file that has it and its line there.
    """

    files: int
    bad: int
    units: int
    contents: Mapping[str, str]
    notices: tuple[Notice, ...]
    words: Mapping[UnknownWord, Where]

    @property
    def rejected(self) -> int:
        """How many units were left out; an unusable file counts as one."""
        return sum(notice.severity is Severity.REJECTED for notice in self.notices)

    @classmethod
    def of(cls, results: Iterable[ReadResult]) -> FilesRead:
        """Return what is to be told of ``results``."""
        gathered = Gathered()
        for result in results:
            gathered.add(result)
        return gathered.read()


@dataclass
class Gathered:
    """What is to be told of files, gathered while they are read: of each only that is kept."""

    files: int = 0
    bad: int = 0
    units: int = 0
    contents: dict[str, str] = field(default_factory=dict)
    notices: list[Notice] = field(default_factory=list)
    words: dict[UnknownWord, Where] = field(default_factory=dict)
    having: Counter[UnknownWord] = field(default_factory=Counter)
    """How many files have each word."""
    own: Collection[UnknownWord] = ()
    """Words that no table has, and that the FOON has already."""

    def add(self, result: ReadResult) -> None:
        """Add the ``result`` of one file."""
        self.files += 1
        self.bad += result.rejected > 0
        self.notices += result.notices
        if result.subgraph is None:
            return
        self.units += len(result.subgraph.annotations)
        self.contents[result.subgraph.name] = result.subgraph.content_key
        for word, place in _odd_words(result).items():
            self.words.setdefault(word, place)
            self.having[word] += 1

    def read(self) -> FilesRead:
        """Return all that was gathered."""
        told = by_one_another(self.having | dict.fromkeys(self.own, self.files + 1))
        words = dict(sorted(((told[word], place) for word, place in self.words.items()), key=lambda one: one[0]))
        return FilesRead(self.files, self.bad, self.units, self.contents, tuple(self.notices), words)


class Spool:
    """Subgraphs between being read and being loaded, in their order: beyond ``most`` units in a temporary file.

    So no more than a part of a large FOON is in memory. To read it from there costs a sixth of parsing it once more.
    """

    def __init__(self, most: int = MOST_HELD) -> None:
        self._most = most
        self._units = 0
        self._held: list[Subgraph] = []
        self._file: IO[bytes] | None = None

    @property
    def is_empty(self) -> bool:
        """Whether nothing was added."""
        return not self._held and self._file is None

    def add(self, result: ReadResult) -> None:
        """Add the subgraph of a ``result``, if it has one; raises FoonError where the temporary files have no room."""
        if result.subgraph is None:
            return
        if self._units < self._most:
            self._held.append(result.subgraph)
            self._units += len(result.subgraph.annotations)
            return
        with writing(Path(tempfile.gettempdir()), _TEMPORARY):
            if self._file is None:
                self._file = tempfile.TemporaryFile(prefix="foon-kg-")  # noqa: SIM115 - closed with the spool
            pickle.dump(result.subgraph, self._file, pickle.HIGHEST_PROTOCOL)
            self._file.flush()  # a full disk is told here

    def __iter__(self) -> Iterator[Subgraph]:
        """Yield the subgraphs that were added, in their order."""
        yield from self._held
        if self._file is not None:
            self._file.seek(0)
            with suppress(EOFError):
                while True:
                    yield pickle.load(self._file)  # noqa: S301 - this program wrote it, and nobody else finds it

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._file is not None:
            with suppress(OSError):  # what a full disk did not take is tried once more
                self._file.close()


def remembered(files: Sequence[Path]) -> FilesRead | None:
    """Return what was kept of files with just these names and bytes, ``None`` where nothing was."""
    asked = _asked(files)
    body = None if asked is None else kept.find(_FOLDER, asked)
    if body is None:
        return None
    count, bad, units, contents, notices, words = json.loads(body)
    return FilesRead(
        count,
        bad,
        units,
        contents,
        tuple(
            Notice(file, line, NoticeKind(kind), message, action, Severity(severity))
            for file, line, kind, message, action, severity in notices
        ),
        {UnknownWord(WordKind(kind), *about): (file, line) for (kind, *about), (file, line) in words},
    )


def remember(files: Sequence[Path], read: FilesRead) -> None:
    """Keep what was ``read`` of ``files``."""
    asked = _asked(files)
    if asked is not None:
        notices = [astuple(notice) for notice in read.notices]
        words = [(astuple(word), where) for word, where in read.words.items()]
        values = (read.files, read.bad, read.units, dict(read.contents), notices, words)
        kept.keep(_FOLDER, asked, compact_json(values))


def _asked(files: Sequence[Path]) -> str | None:
    """Return a hash of the files, with their names, and of the program that reads them."""
    digest = hashlib.blake2b(digest_size=16)
    package, loaders = resources.files("foon_kg"), resources.files("foon_kg.loaders")
    digest.update(f"{_FORM} {kept.code_key([loaders, *map(package.joinpath, _READ_BY)])}".encode())
    own = [Path(os.environ[variable]) for variable in _VARIABLES if os.environ.get(variable)]
    try:
        for file in (*own, *files):
            content = hashlib.blake2b(read_bytes(file), digest_size=16).hexdigest()
            digest.update(json.dumps([str(file), content]).encode())
    except OSError:
        return None
    return digest.hexdigest()


def odd_words(results: Iterable[ReadResult], labels: Iterable[str] = ()) -> Mapping[UnknownWord, Where]:
    """Return the words of ``results`` that no table has, or only as a typing error of another, with where they are.

    What one of them may mean is sought in the tables, among ``labels``, which the FOON has, and in what more files say.
    """
    gathered = Gathered(own=unknown_words(map(ObjectNode, labels)))
    for result in results:
        gathered.add(result)
    return gathered.read().words


def _odd_words(result: ReadResult) -> dict[UnknownWord, Where]:
    """Return the odd words of one file, each with its place."""
    if result.subgraph is None:
        return {}
    units = [one.unit for one in result.subgraph.annotations]
    found = _words_of(units)
    lines = dict[UnknownWord, int]()
    for unit, line in zip(units, result.lines, strict=False) if found else ():  # some formats have no lines
        for word in _words_of([unit]):
            lines.setdefault(word, line)
    return {word: (result.path, line) for word, line in _where_they_stand(result.path, found, lines).items()}


def _where_they_stand(
    path: str, found: Iterable[UnknownWord], lines: Mapping[UnknownWord, int]
) -> dict[UnknownWord, int | None]:
    """Return the lines of the words ``found`` in the file at ``path``: ``lines`` has those of their units."""
    if not lines:
        return dict.fromkeys(found)
    from foon_kg.loaders.text_reader import line_with, lines_of

    written = lines_of(_text_of(path))
    return {word: line_with(written, lines[word], word.word) if word in lines else None for word in found}


def _text_of(path: str) -> str:
    """Return the text of a file that was just read; nothing where it is none any more."""
    try:
        return read_bytes(Path(path)).decode("utf-8-sig", errors="replace")
    except OSError:
        return ""


def _words_of(units: Sequence[FunctionalUnit]) -> tuple[UnknownWord, ...]:
    nodes = (node for unit in units for node in (*unit.input_nodes, *unit.output_nodes))
    return unknown_words(nodes, [unit.motion for unit in units])
