"""Videos told in sentences with times: ActivityNet Captions and YouCook2.

ActivityNet Captions: ``{video: {"duration": s, "timestamps": [[start, end], …], "sentences": […]}}``. YouCook2:
``{"database": {video: {"annotations": [{"segment": [start, end], "sentence": …}], …}}}``. Times are in seconds.

The files are read as streams, one video after another: once to the end, so that a broken one gives nothing, and again
for whoever wants the videos.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from foon_kg.loaders.json_document import stream_fields
from foon_kg.loaders.narrated import NarratedFile, is_video_name, ordered
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, Remark, UnreadableFile
from foon_kg.loaders.text_blocks import odd_character, text_blocks
from foon_kg.loaders.times import is_time
from foon_kg.model import Timing
from foon_kg.model.errors import ReadError
from foon_kg.model.narration import Narration, Sentence

_DATABASE = "database"
_FORMS = (('"timestamps"', '"sentences"'), ('"database"', '"annotations"'))
_LONGEST_NAME = max(len(name) for form in _FORMS for name in form)
_PAIR = 2


def is_captions(path: Path) -> bool:
    """Return whether ``path`` is JSON of one of the two forms, by its names alone: a truncated file may be one, too."""
    seen: set[str] = set()
    tail = ""
    try:
        for number, block in enumerate(text_blocks(path)):
            if number == 0 and not block.lstrip().startswith("{"):
                return False
            text = tail + block
            seen |= {name for form in _FORMS for name in form if name in text}
            if any(seen.issuperset(form) for form in _FORMS):
                return True
            tail = text[-_LONGEST_NAME:]
    except (UnreadableFile, OSError):
        return False
    return False


@dataclass(frozen=True)
class Captions(Iterable[Narration]):
    """The videos of a file that was read to its end before, each a narration of sentences, read again each time."""

    path: Path

    def __iter__(self) -> Iterator[Narration]:
        """Yield one video after another. Raises ReadError where the file is not what it was any more."""
        try:
            yield from _narrations(self.path, Journal(str(self.path)))
        except (UnreadableFile, OSError) as error:
            raise ReadError(f"{self.path}: changed while it was read", hint="Try again.") from error


def read_captions(path: Path) -> NarratedFile:
    """Return the videos of the JSON file ``path``, the sentences of each sorted by their starts. Never raises.

    A sentence that cannot be used is left out and told with its video; a time that cannot be is left out and told.
    """
    journal, file = Journal(str(path)), str(path)
    try:
        videos = sum(1 for _ in _narrations(path, journal))
    except (UnreadableFile, OSError) as error:
        journal.reject_unread(error)
        return NarratedFile(file, (), journal.notices())
    if not videos and not journal.notices():
        journal.reject_file(None, Problem(NoticeKind.NO_UNITS, "no sentence in it"))
    return NarratedFile(file, Captions(path) if videos else (), journal.notices())


def _narrations(path: Path, journal: Journal) -> Iterator[Narration]:
    names: set[str] = set()
    for line, name, value in stream_fields(text_blocks(path), _DATABASE):
        if problem := _name_problem(name, names):
            journal.reject(line, problem)
            continue
        names.add(name)
        if sentences := _sentences(line, name, value, journal):
            yield Narration(name, sentences=ordered(sentences), source=str(path))


def _name_problem(name: str, names: set[str]) -> Problem | None:
    if not is_video_name(name):
        return Problem(NoticeKind.ODD_NAME, f"{name[:40]!a} can be the name of no video")
    return Problem(NoticeKind.SAME_VIDEO, f"a second video {name}") if name in names else None


def _sentences(line: int, video: str, value: object, journal: Journal) -> list[Sentence]:
    told = _told(value)
    if told is None:
        message = f"video {video}: neither timestamps with sentences nor annotations"
        journal.reject(line, Problem(NoticeKind.BAD_FIELD, message))
        return []
    found: list[Sentence] = []
    for number, (text, segment) in enumerate(told, start=1):
        where = f"video {video}, sentence {number}"
        if not isinstance(text, str) or not any(letter.isalpha() for letter in text):
            journal.reject(line, Problem(NoticeKind.NO_NARRATION, f"{where}: no words in it"))
            continue
        if odd := odd_character(text):
            journal.reject(line, Problem(NoticeKind.NO_NARRATION, f"{where}: {odd} in it"))
            continue
        timing = _timing(segment)
        if timing is None:
            message = f"{where}: {str(segment)[:40]} is no start and end in seconds"
            journal.remark(line, Remark(NoticeKind.ODD_TIME, message, "the time is left out"))
        found.append(Sentence(" ".join(text.split()), timing or Timing()))
    return found


def _told(value: object) -> list[tuple[object, object]] | None:
    """Return each sentence of one video with its time; one without has ``None``."""
    if not isinstance(value, Mapping):
        return None
    annotations, sentences, times = (value.get(name) for name in ("annotations", "sentences", "timestamps"))
    if isinstance(annotations, list):
        return [_of_row(row) for row in annotations]
    if not isinstance(sentences, list) or not isinstance(times, list):
        return None
    return [(text, times[place] if place < len(times) else None) for place, text in enumerate(sentences)]


def _of_row(row: object) -> tuple[object, object]:
    return (row.get("sentence"), row.get("segment")) if isinstance(row, Mapping) else (None, None)


def _timing(segment: object) -> Timing | None:
    if not isinstance(segment, list) or len(segment) != _PAIR:
        return None
    start, end = segment
    if not is_time(start) or not is_time(end) or end < start:
        return None
    return Timing(((float(start), float(end)),))
