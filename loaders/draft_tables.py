"""A draft as a file: the plain table of an annotated video, with what is doubtful about each row.

The columns of :mod:`foon_kg.loaders.video_tables` come first, then ``confidence``, ``doubt``, ``said`` and ``source``.
Any editor changes it. A row whose ``doubt`` a person has emptied counts as reviewed; a row without a motion stands for
a part of the narration that gave no unit, and is either filled in or deleted.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from foon_kg.loaders.csv_table import TableRow, columns_of, table_rows
from foon_kg.loaders.notices import ReadResult, Severity, UnreadableFile
from foon_kg.loaders.paths import decode
from foon_kg.loaders.times import write_timing
from foon_kg.loaders.video_tables import is_video_table, read_thing, read_video_text
from foon_kg.model import Annotation, ObjectNode, Participant, Timing
from foon_kg.model.drafts import Draft, DraftFile, DraftRow, DraftUnit, LeftOut
from foon_kg.model.errors import ReadError
from foon_kg.model.nodes import name_of_file
from foon_kg.model.regular_files import read_bytes

UNIT_COLUMNS = ("start", "end", "motion", "inputs", "outputs", "dish")
DRAFT_COLUMNS = ("confidence", "doubt", "said", "source")
BETWEEN_DOUBTS = " | "


def is_draft(text: str) -> bool:
    """Return whether ``text`` is a table of units with confidences and doubts."""
    return is_video_table(text) and {"confidence", "doubt"} <= set(columns_of(text))


def is_draft_file(path: Path) -> bool:
    """Return whether ``path`` is the file of a draft; no for what cannot be read."""
    if path.suffix.lower() != ".csv" or not path.is_file():
        return False
    try:
        return is_draft(decode(read_bytes(path)))
    except (UnreadableFile, OSError):
        return False


def write_draft(draft: Draft) -> str:
    """Return the table of ``draft``; a unit that no table can say is written as one that is left out."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow((*UNIT_COLUMNS, *DRAFT_COLUMNS))
    for row in draft.rows:
        cells = _unit_cells(row) if isinstance(row, DraftUnit) else None
        writer.writerow((*(cells or _left_out_cells(row)), f"“{_one_line(row.said)}”", _one_line(draft.source)))
    return stream.getvalue()


def read_draft(path: Path) -> DraftFile:
    """Return the draft in ``path``; raises :class:`~foon_kg.model.errors.ReadError` where it is none."""
    try:
        text = decode(read_bytes(path))
    except UnreadableFile as unreadable:
        raise ReadError(
            f"{path}:{unreadable.line or 1}: {unreadable.problem.message}", hint="Save it as UTF-8."
        ) from None
    except OSError as error:
        raise ReadError(f"{path}: cannot be opened: {error.strerror}", hint="Name the file of a draft.") from error
    if not is_draft(text):
        hint = "foon draft videos and foon draft text write drafts; foon load videos takes tables of finished units."
        raise ReadError(f"{path}:1: no draft: it lacks the columns confidence and doubt", hint=hint)
    try:
        rows = tuple(table_rows(text))
    except UnreadableFile as broken:
        raise ReadError(f"{path}:{broken.line or 1}: {broken.problem.message}", hint="Mend the table.") from None
    results = read_video_text(text, name_of_file(path), str(path))
    if len(results) != 1:
        raise ReadError(f"{path}: it has {len(results)} videos", hint="A draft is one video: split the table.")
    return _with_doubts(path, rows, results[0])


def _with_doubts(path: Path, told: Sequence[TableRow], result: ReadResult) -> DraftFile:
    """Return the draft of the table ``told``, of which ``result`` has the units, in the order of their rows."""
    rejected = _rejected_lines(path, result)
    units = iter(result.subgraph.annotations if result.subgraph else ())
    rows = tuple(_draft_row(path, one, None if one.line in rejected else next(units)) for one in told)
    source = next(filter(None, (one.cells.get("source", "") for one in told)), "")
    subgraph = result.subgraph and replace(result.subgraph, sources=(source,) if source else ())
    return DraftFile(str(path), rows, subgraph, tuple(map(str, result.notices)))


def _rejected_lines(path: Path, result: ReadResult) -> set[int | None]:
    """Return the lines that are no units; raises ``ReadError`` where all of a file was rejected."""
    rejected = [notice for notice in result.notices if notice.severity is Severity.REJECTED]
    lines = {notice.line for notice in rejected}
    if None in lines:
        raise ReadError(f"{path}: {rejected[0].message}", hint="Mend the table.")
    return lines


def _draft_row(path: Path, told: TableRow, annotation: Annotation | None) -> DraftRow:
    cells = told.cells
    doubts = filter(None, map(str.strip, cells.get("doubt", "").split(BETWEEN_DOUBTS.strip())))
    confidence = _confidence(path, told.line, cells.get("confidence", ""))
    return DraftRow(told.line, annotation, confidence, tuple(doubts), cells.get("said", ""))


def _confidence(path: Path, line: int, text: str) -> float:
    """Return a confidence; an empty one is that of a row which a person wrote."""
    try:
        value = float(text) if text else 1.0
    except ValueError:
        value = -1.0
    if not 0 <= value <= 1:
        raise ReadError(
            f"{path}:{line}: the confidence {text[:20]!a} is no number from 0 to 1", hint="Mend or empty it."
        )
    return value


def _unit_cells(row: DraftUnit) -> tuple[str, ...] | None:
    """Return the cells of a unit; ``None`` where a table cannot say it, as what it reads again is another one."""
    unit = row.annotation.unit
    sides = (unit.inputs, unit.outputs)
    texts = [list(map(thing, side)) for side in sides]
    if not all(map(_are_read_again, texts, sides)):
        return None
    dish = next((one.dish_type for one in unit.outputs if one.dish_type), "")
    motion = unit.motion + (" *" if unit.accepts_any else "")
    start, end = _times(row.annotation.timing)
    doubts = BETWEEN_DOUBTS.join(map(_one_line, row.doubts))
    return (start, end, motion, *map("; ".join, texts), dish, f"{row.confidence:.2f}", doubts)


def _are_read_again(texts: Sequence[str], participants: Sequence[Participant]) -> bool:
    """Whether a table that has ``texts`` is read as having these participants, but for which of them is the dish."""
    plain = [Participant(one.node, moving=one.moving) for one in participants]
    return [read_thing(text) for text in texts] == plain and not any(map(_is_taken_apart, texts))


def _is_taken_apart(text: str) -> bool:
    """Whether a thing would be read as several: a semicolon is between things where it is not in brackets."""
    return ";" in text and "(" not in text and "{" not in text


def _left_out_cells(row: DraftUnit | LeftOut) -> tuple[str, ...]:
    """Return the cells of a row that is no unit: its time, how sure it is that it is none, and why."""
    timing = row.timing if isinstance(row, LeftOut) else row.annotation.timing
    reason = row.reason if isinstance(row, LeftOut) else f"a table cannot say: {row.annotation.unit.motion}"
    sure = "1.00" if isinstance(row, LeftOut) and row.settled else "0.00"
    return (*_times(timing), "", "", "", "", sure, _one_line(reason))


def thing(one: Participant) -> str:
    """Return how a table writes ``one`` participant: ``*onion (chopped; peeled) {salt} on cutting board``."""
    node: ObjectNode = one.node
    text = ("*" if one.moving else "") + node.label
    text += f" ({'; '.join(node.states)})" if node.states else ""
    text += f" {{{'; '.join(node.ingredients)}}}" if node.ingredients else ""
    return text + (f" {node.relation} {node.container}" if node.container else "")


def _times(timing: Timing) -> tuple[str, str]:
    if timing.assumed or not timing.spans:
        return ("Assumed" if timing.assumed else "", "")
    start, _, end = write_timing(Timing(timing.spans[:1])).strip("<>").partition("-")
    return start, end


def _one_line(text: str) -> str:
    return " ".join(text.replace("|", "/").split())
