"""The annotations of EPIC-KITCHENS-100: a row is one narrated action, with its verb, its nouns and its time.

The columns ``video_id``, ``start_timestamp``, ``stop_timestamp``, ``narration``, ``verb`` and ``noun`` must be there;
``all_nouns`` (a list as Python writes it) may be, and any others are passed over. A noun with its kind behind a colon
has its first part last ("oil:olive", "liquid:washing:up"). The narration tells which noun is a place or an instrument
("put onion in bowl").
"""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence

from foon_kg.loaders.csv_table import columns_of, table_rows
from foon_kg.loaders.narrated import NarratedFile, is_video_name, ordered
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, Remark, UnreadableFile
from foon_kg.loaders.video_tables import row_timing
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place

COLUMNS = ("video_id", "start_timestamp", "stop_timestamp", "narration", "verb", "noun")

_BEFORE_A_NOUN = r"\b({words})\s+(?:(?:the|a|an|some|of)\s+)*(?:[\w-]+\s+){{0,2}}?{noun}\b"
_TO = "into|onto|inside|in|on|to|over|under"
_FROM = "from|off|out of"
_WITH = "with|using"


def is_epic_kitchens(text: str) -> bool:
    """Return whether the first line of ``text`` has the columns of EPIC-KITCHENS-100 annotations."""
    return set(COLUMNS) <= set(columns_of(text))


def read_epic_kitchens(text: str, file: str) -> NarratedFile:
    """Return a narration for every video of a table, in the order of their first rows, actions by their start.

    ``text`` is that of the CSV ``file``, which the notes name. A row that cannot be used is left out and told with its
    line. Never raises.
    """
    journal = Journal(file)
    missing = dict.fromkeys(COLUMNS, "")
    videos: defaultdict[str, list[NarratedAction]] = defaultdict(list)
    try:
        for told in table_rows(text):
            row = {**missing, **told.cells}
            if problem := told.problem or _problem(row):
                journal.reject(told.line, problem)
            else:
                videos[row["video_id"]].append(_action(told.line, row, journal))
    except UnreadableFile as unreadable:
        journal.reject_file(unreadable.line, unreadable.problem)
        return NarratedFile(file, (), journal.notices())
    narrations = tuple(Narration(name, ordered(actions), source=file) for name, actions in videos.items())
    return NarratedFile(file, narrations, journal.notices())


def _action(line: int, row: Mapping[str, str], journal: Journal) -> NarratedAction:
    timing, odd = row_timing(row["start_timestamp"], row["stop_timestamp"], hours=True)
    for remark in odd:
        journal.remark(line, remark)
    nouns = _nouns(line, row, journal)
    said = row["narration"] or " ".join((row["verb"], *nouns))
    roles = {noun: role for noun in nouns[1:] if (role := _role(noun, said.lower())) is not None}
    objects = (*nouns[:1], *(noun for noun in nouns[1:] if noun not in roles))
    return NarratedAction(
        row["verb"],
        tuple(map(Mention, objects)),
        tuple(Place(roles[noun][1], noun) for noun in _in_role("to", roles)),
        next(iter(_in_role("from", roles)), None),
        tuple(_in_role("with", roles)),
        said=said,
        timing=timing,
    )


def _in_role(role: str, roles: Mapping[str, tuple[str, str]]) -> list[str]:
    """Return the nouns that are told in a ``role``: to, from or with."""
    return [noun for noun, (own, _) in roles.items() if own == role]


def _problem(row: Mapping[str, str]) -> Problem | None:
    if not is_video_name(row["video_id"]):
        return Problem(NoticeKind.ODD_NAME, f"{row['video_id'][:40]!a} can be the name of no video")
    if not row["narration"] and not row["verb"]:
        return Problem(NoticeKind.NO_NARRATION, "neither a narration nor a verb")
    if not row["verb"]:
        return Problem(NoticeKind.UNIT_WITHOUT_MOTION, f"no verb beside the narration {row['narration'][:40]!a}")
    return None


def _nouns(line: int, row: Mapping[str, str], journal: Journal) -> Sequence[str]:
    """Return the nouns as they are spoken, the main one first, each once."""
    nouns = [row["noun"]] if row["noun"] else []
    listed = row.get("all_nouns", "")
    if listed:
        try:
            value = ast.literal_eval(listed)
        except (ValueError, SyntaxError, MemoryError, RecursionError):
            value = None
        if isinstance(value, list) and all(isinstance(noun, str) for noun in value):
            nouns += value
        else:
            message = f"all_nouns {listed[:40]!a} is no list of names"
            journal.remark(line, Remark(NoticeKind.BAD_FIELD, message, "only noun counts"))
    return tuple(dict.fromkeys(noun for noun in map(_spoken, nouns) if noun))


def _spoken(noun: str) -> str:
    """Return "olive oil" for "oil:olive", "washing up liquid" for "liquid:washing:up": the first part comes last."""
    head, *kind = (" ".join(part.replace("_", " ").split()) for part in noun.split(":"))
    return " ".join(part for part in (*kind, head) if part)


def _role(noun: str, narration: str) -> tuple[str, str] | None:
    """Return whether the narration has ``noun`` as the place to, the place from or the instrument, and its word."""
    ending = re.escape(noun.lower().split()[-1])
    for role, words in (("to", _TO), ("from", _FROM), ("with", _WITH)):
        match = re.search(_BEFORE_A_NOUN.format(words=words, noun=ending), narration)
        if match is not None:
            return role, match[1]
    return None
