"""Videos told in sentences with times: ActivityNet Captions and YouCook2.

ActivityNet Captions: ``{video: {"duration": s, "timestamps": [[start, end], …], "sentences": […]}}``. YouCook2:
``{"database": {video: {"annotations": [{"segment": [start, end], "sentence": …}], …}}}``. Times are in seconds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from foon_kg.loaders.json_document import parse_fields
from foon_kg.loaders.narrated import NarratedFile, is_video_name, ordered
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, Remark, UnreadableFile
from foon_kg.loaders.times import is_time
from foon_kg.model import Timing
from foon_kg.narration import Narration, Sentence

_DATABASE = "database"
_PAIR = 2


def is_captions(text: str) -> bool:
    """Answer whether ``text`` is JSON of one of the two forms, by its names alone: truncated text may be one, too."""
    head = text.lstrip("\ufeff \t\r\n")[:1]
    return head == "{" and (
        ('"timestamps"' in text and '"sentences"' in text) or ('"database"' in text and '"annotations"' in text)
    )


def read_captions(text: str, file: str) -> NarratedFile:
    """Answer a narration of sentences for every video of a JSON text, sorted by their starts. Never raises.

    A sentence that cannot be used is left out and told with its video; a time that cannot be is left out and told.
    """
    journal = Journal(file)
    try:
        fields = parse_fields(text.removeprefix("\ufeff"))
    except UnreadableFile as unreadable:
        journal.reject_file(unreadable.line, unreadable.problem)
        return NarratedFile(file, (), journal.notices())
    narrations = tuple(_narrations(fields, file, journal))
    if not narrations and not journal.notices():
        journal.reject_file(None, Problem(NoticeKind.NO_UNITS, "no sentence in it"))
    return NarratedFile(file, narrations, journal.notices())


def _narrations(fields: Sequence[tuple[int, str, object]], file: str, journal: Journal) -> Iterator[Narration]:
    for line, name, value in fields:
        if name == _DATABASE and isinstance(value, Mapping):
            yield from _narrations([(line, video, told) for video, told in value.items()], file, journal)
            continue
        if not is_video_name(name):
            journal.reject(line, Problem(NoticeKind.ODD_NAME, f"{name[:40]!a} can be the name of no video"))
            continue
        sentences = _sentences(line, name, value, journal)
        if sentences:
            yield Narration(name, sentences=ordered(sentences), source=file)


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
        timing = _timing(segment)
        if timing is None:
            message = f"{where}: {str(segment)[:40]} is no start and end in seconds"
            journal.remark(line, Remark(NoticeKind.ODD_TIME, message, "the time is left out"))
        found.append(Sentence(" ".join(text.split()), timing or Timing()))
    return found


def _told(value: object) -> list[tuple[object, object]] | None:
    """Answer each sentence of one video with its time; one without has ``None``."""
    if not isinstance(value, Mapping):
        return None
    annotations, sentences, times = (value.get(name) for name in ("annotations", "sentences", "timestamps"))
    if isinstance(annotations, list):
        rows = [row if isinstance(row, Mapping) else {} for row in annotations]
        return [(row.get("sentence"), row.get("segment")) for row in rows]
    if not isinstance(sentences, list) or not isinstance(times, list):
        return None
    return [(text, times[place] if place < len(times) else None) for place, text in enumerate(sentences)]


def _timing(segment: object) -> Timing | None:
    if not isinstance(segment, list) or len(segment) != _PAIR:
        return None
    start, end = segment
    if not is_time(start) or not is_time(end) or end < start:
        return None
    return Timing(((float(start), float(end)),))
