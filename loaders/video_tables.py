"""A video annotated as a plain table, which a person can write while watching.

One row is one functional unit, with the columns ``start``, ``end``, ``motion``, ``inputs`` and ``outputs``; ``dish``
(the dish type of a row that makes the goal) and ``video`` (where one table has several) may be left out::

    start,end,motion,inputs,outputs,dish
    0:12,0:31,chop,onion (peeled) on cutting board; knife,onion (chopped) on cutting board,
    0:40,0:44,mix *,bowl {onion; tomato}; spoon,bowl {salad}; salad (mixed) {onion; tomato} in bowl,salad

A thing is its name, then its states in round brackets, what is in it in braces, and where it is. Things are separated
by semicolons outside of brackets. A star before a thing says that it moves; a star after the motion, that any number of
ingredients may enter here. In a row with a dish the goal is the food that comes out of it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from foon_kg.food import tables
from foon_kg.loaders.csv_table import TableRow, columns_of, table_rows
from foon_kg.loaders.found import is_foreign
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, ReadResult, Remark, UnreadableFile
from foon_kg.loaders.paths import decode, read_paths
from foon_kg.loaders.times import counts_hours, read_timing
from foon_kg.model import DISH_TYPES, Annotation, FunctionalUnit, ObjectNode, Participant, Timing
from foon_kg.model.nodes import name_of_file, one_spelling
from foon_kg.model.regular_files import read_bytes

COLUMNS = ("start", "end", "motion", "inputs", "outputs")
RELATIONS = ("attached to", "covered with", "covered", "below", "under", "over", "with", "from", "on", "in")
"""The words that may stand before a place; the longest of those that fit counts."""

_THING = re.compile(
    r"(?P<star>\*\s*)?(?P<label>[^(){}*]*?)\s*"
    r"(?:\((?P<states>[^(){}]*)\)\s*)?"
    r"(?:\{(?P<foods>[^(){}]*)\}\s*)?"
    rf"(?:\b(?P<relation>{'|'.join(RELATIONS)})\s+(?P<container>[^(){{}}*]+?)\s*)?"
)
_IN_BRACKETS = re.compile("[;,]")


def read_videos(paths: Iterable[Path]) -> Iterator[ReadResult]:
    """Yield a result for every video that ``paths`` name: plain tables (``.csv``), FOON text and JSON, and folders.

    Raises ReadError for a path that does not exist or holds none of them.
    """
    tables, others = [], []
    for path in paths:
        found = _tables_at(path)
        tables += [file for file in found if path.exists() and not _is_hidden(file.relative_to(path))]
        if not found or not path.exists() or _has_subgraphs(path):
            others.append(path)
    for table in dict.fromkeys(tables):
        yield from read_video_table(table)
    if others:
        yield from read_paths(others)


def _tables_at(path: Path) -> list[Path]:
    """Return the tables below a folder, else the path itself where it is called like one."""
    if path.is_dir():
        return sorted(path.rglob("*.csv"))
    return [path] if path.suffix.lower() == ".csv" else []


def _has_subgraphs(path: Path) -> bool:
    files = (file for file in path.rglob("*") if file.suffix.lower() != ".csv")
    return any(file.suffix.lower() in {".txt", ".json"} or is_foreign(file) for file in files)


def _is_hidden(path: Path) -> bool:
    return any(part.startswith(".") for part in path.parts)


def is_video_table(text: str) -> bool:
    """Return whether the first line of ``text`` has the columns of a plain table of units."""
    return set(COLUMNS) <= set(columns_of(text))


def read_video_table(path: Path) -> tuple[ReadResult, ...]:
    """Return one result a video of the table in ``path``, in the order of their first rows.

    A row that is no unit is left out and told with its line; a time that cannot be is left out and told as well. A file
    that is no such table is one result without a subgraph. Never raises.
    """
    try:
        return read_video_text(decode(read_bytes(path)), name_of_file(path), str(path))
    except (UnreadableFile, OSError) as error:
        return (Journal(str(path)).reject_unread(error),)


def read_video_text(text: str, name: str, file: str = "") -> tuple[ReadResult, ...]:
    """Return what :func:`read_video_table` does of a ``text``; a row without ``video`` belongs to the video ``name``.

    Messages name the ``file``.
    """
    file = file or name
    try:
        rows = list(table_rows(text))
    except UnreadableFile as unreadable:
        return (Journal(file).reject_file(unreadable.line, unreadable.problem),)
    if not is_video_table(text):
        return (Journal(file).reject_file(1, Problem(NoticeKind.UNREADABLE_FILE, _wrong_with(text))),)
    videos: dict[str, list[TableRow]] = {}
    for row in rows:
        videos.setdefault(one_spelling(row.cells.get("video", "")) or name, []).append(row)
    hours = counts_hours(row.cells.get(column, "") for row in rows for column in ("start", "end"))
    return tuple(_video(video, listed, file, hours=hours) for video, listed in (videos or {name: []}).items())


def _wrong_with(text: str) -> str:
    """Return why the first line of ``text`` is not that of a plain table."""
    first = text.partition("\n")[0].lower()
    if not first.strip():
        return "there is nothing in its first line, which names the columns"
    for sign, name in ((";", "semicolons"), ("\t", "tabs")):
        if set(COLUMNS) <= {column.strip(' "\r\ufeff') for column in first.split(sign)}:
            return f"its columns are separated by {name}, and not by commas: save it as CSV with commas"
    missing = [column for column in COLUMNS if column not in columns_of(text)]
    return f"the first line does not have the columns {', '.join(COLUMNS)}: not there: {', '.join(missing)}"


def read_thing(text: str) -> Participant | None:
    """Return the participant that the ``text`` of a part of a cell names, ``None`` where it names none.

    >>> str(read_thing("*onion (chopped, peeled) on cutting board").node)
    'onion (chopped, peeled; on cutting board)'
    """
    match = _THING.fullmatch(" ".join(text.split()))
    if match is None or not match["label"]:
        return None
    node = ObjectNode(
        match["label"],
        tuple(_listed(match["states"])),
        tuple(_listed(match["foods"])),
        match["relation"],
        match["container"],
    )
    return Participant(node, moving=match["star"] is not None)


def between_semicolons(cell: str) -> list[str]:
    """Return the parts of ``cell`` between the semicolons that stand in no brackets; in one pass, however many.

    >>> between_semicolons("bowl {onion; leek}; knife")
    ['bowl {onion; leek}', ' knife']
    """
    parts, end, open_ones = [], len(cell), set[str]()
    for place in range(len(cell) - 1, -1, -1):  # from the end: whether a bracket closes behind is then known
        sign = cell[place]
        if sign in ")}":
            open_ones.add(sign)
        elif sign in "({":
            open_ones.discard(")" if sign == "(" else "}")
        elif sign == ";" and not open_ones:
            parts.append(cell[place + 1 : end])
            end = place
    return [cell[:end], *reversed(parts)]


def _listed(text: str | None) -> Iterator[str]:
    return (word.strip() for word in _IN_BRACKETS.split(text or "") if word.strip())


def _video(name: str, rows: Sequence[TableRow], file: str, *, hours: bool) -> ReadResult:
    journal = Journal(file)
    read = [(row.line, _annotation(row, journal, hours=hours)) for row in rows]
    units = [(line, annotation) for line, annotation in read if annotation is not None]
    return journal.result(name, [annotation for _, annotation in units], (), [line for line, _ in units])


def _annotation(told: TableRow, journal: Journal, *, hours: bool) -> Annotation | None:
    line, row = told.line, told.cells
    inputs, outputs = (_things(row.get(side, "")) for side in ("inputs", "outputs"))
    motion = row.get("motion", "")
    problem = told.problem or _problem(row, motion.rstrip("* "), inputs, outputs)
    if problem is not None:
        journal.reject(line, problem)
        return None
    timing, odd = row_timing(row.get("start", ""), row.get("end", ""), hours=hours)
    for remark in odd:
        journal.remark(line, remark)
    unit = FunctionalUnit(
        tuple(one for one in inputs if isinstance(one, Participant)),
        motion.rstrip("* "),
        tuple(_with_dish([one for one in outputs if isinstance(one, Participant)], row.get("dish", ""))),
        accepts_any=motion.endswith("*"),
    )
    return Annotation(unit, timing)


def row_timing(start: str, end: str, *, hours: bool) -> tuple[Timing, tuple[Remark, ...]]:
    """Return the time of a row by its ``start`` and ``end``; one that no video can have is left out and remarked on.

    ``hours`` says that 1:10 is an hour and ten minutes.
    """
    if early := [time for time in (start, end) if time.startswith("-")]:
        return Timing(), (
            Remark(NoticeKind.ODD_TIME, f"{early[0]} is before the video begins", "the time is left out"),
        )
    timing, odd = read_timing([start, end], hours=hours)
    if any(last < first for first, last in timing.spans):
        return Timing(), (Remark(NoticeKind.ODD_TIME, f"{start}-{end} ends before it starts", "the time is left out"),)
    return timing, odd


def _things(cell: str) -> list[Participant | str]:
    """Return the things that a cell names; what cannot be read as one stays text."""
    parts = (part.strip() for part in between_semicolons(cell))
    return [read_thing(part) or part for part in parts if part]


def _problem(
    row: Mapping[str, str], motion: str, inputs: Sequence[Participant | str], outputs: Sequence[Participant | str]
) -> Problem | None:
    unread = [one for one in (*inputs, *outputs) if isinstance(one, str)]
    if unread:
        message = f"“{unread[0]}” is no thing as in: onion (chopped) {{salt}} in bowl"
        return Problem(NoticeKind.BAD_BRACKETS, message)
    if not motion:
        return Problem(NoticeKind.UNIT_WITHOUT_MOTION, "a unit without a motion")
    if not inputs:
        return Problem(NoticeKind.UNIT_WITHOUT_INPUTS, "a unit without inputs")
    if not outputs:
        return Problem(NoticeKind.UNIT_WITHOUT_OUTPUTS, "a unit without outputs")
    return _odd_dish(row.get("dish", ""), [one for one in outputs if isinstance(one, Participant)])


def _odd_dish(dish: str, outputs: Sequence[Participant]) -> Problem | None:
    if dish and dish.lower() not in DISH_TYPES:
        return Problem(NoticeKind.ODD_CLASS, f"“{dish}” is none of the dish types: {', '.join(DISH_TYPES)}")
    if dish and _goal(outputs) is None:
        return Problem(NoticeKind.ODD_CLASS, f"the row makes a {dish}, and no food comes out of it")
    return None


def _with_dish(outputs: Sequence[Participant], dish: str) -> Iterator[Participant]:
    """Mark the goal of a row with a dish: of the foods that come out, the last one that has ingredients, else the last.

    What it lies in is named beside it ("bowl {salad}") and is no dish, wherever it stands.
    """
    goal = _goal(outputs)
    for place, one in enumerate(outputs):
        yield Participant(one.node, one.moving, dish.lower()) if dish and place == goal else one


def _goal(outputs: Sequence[Participant]) -> int | None:
    """Return the place of the dish among what comes out of a row, ``None`` where only utensils do."""
    foods = [place for place, one in enumerate(outputs) if tables().utensil(one.node.label) is None]
    made_of = [place for place in foods if outputs[place].node.ingredients]
    return next(reversed(made_of or foods), None)
