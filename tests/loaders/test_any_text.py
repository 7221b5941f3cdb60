"""Whatever stands in a file, it loads or is refused with file, line and reason; and what is odd is said at its line."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from foon_kg.loaders import NoticeKind, ReadResult, Severity, read_json, read_path, read_text, write_json, write_text

unhurried = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture])

ROWS = """\
# Source:\thttp://example.org/omelette.mp4
//
O\tegg\t1
S\twhole
S\tin\t[carton]
O\tbowl\t0
S\tempty
M\tcrack\t<0:10-0:14>
O\tegg\t0
S\tcracked
S\tin\t[bowl]
O\tbowl\t0
S\tcontains\t{egg}
//
O46\tbowl\t0
S23\tcontains\t{egg,salt}
O157\tegg\t0
S12\tcracked
S81\twith\t[shell]
S65\tin\t[bowl]
M4\tbeat*\tAssumed\tAssumed
O46\tbowl\t0\t23
S9\tgreased\t{butter}
S23\tcontains\t{egg,salt}
//
""".splitlines()
PIECES = ["O", "S", "M", "//", "#", "\t", "egg", "0", "1", "23", "<1:10-1:11>", "in", "[", "]", "{", "}", ",", "*", " "]

pieces = st.lists(st.sampled_from(PIECES), max_size=8).map("".join)
rows = st.sampled_from(ROWS) | pieces | st.text(max_size=6)
texts = st.one_of(
    st.lists(rows, max_size=40).map("\n".join),
    st.permutations(ROWS).map("\n".join),
    st.lists(st.sampled_from(ROWS), max_size=30).map("\r\n".join),
    st.text(),
)


def check(result: ReadResult, text: str) -> None:
    line_count = len(re.split("\r\n|\r|\n", text))
    for notice in result.notices:
        assert notice.file == "v.txt"
        assert notice.message
        assert notice.action
        assert notice.line is None or 1 <= notice.line <= line_count
        notice.message.encode()
    assert [n.line or 0 for n in result.notices] == sorted(n.line or 0 for n in result.notices)
    if result.subgraph is None:
        assert result.rejected > 0


def blocks_with_content(text: str) -> int:
    """An independent count of the units that a text tries to say."""
    blocks: list[list[str]] = [[]]
    for line in re.split("\r\n|\r|\n", text):
        if line.startswith("//"):
            blocks.append([])
        elif line.strip() and not line.startswith("#"):
            blocks[-1].append(line)
    return sum(map(bool, blocks))


@unhurried
@given(texts)
def test_every_unit_of_a_text_is_read_or_rejected_with_its_line(text: str):
    result = read_text(text, "v", "v.txt")
    check(result, text)
    kept = len(result.subgraph.annotations) if result.subgraph else 0
    rejected = [n for n in result.notices if n.severity is Severity.REJECTED and n.kind is not NoticeKind.NO_UNITS]
    assert kept + len(rejected) == blocks_with_content(text)
    assert all(notice.line for notice in rejected)


@unhurried
@given(texts)
def test_whatever_was_read_from_text_can_be_written_and_read_again(text: str):
    subgraph = read_text(text, "v").subgraph
    if subgraph is not None:
        assert read_text(write_text(subgraph), "v").subgraph == subgraph
        if not re.search("[\x00-\x1f\x7f-\x9f]", write_text(subgraph).replace("\t", "").replace("\n", "")):
            assert read_json(write_json(subgraph), "v").subgraph == subgraph


SPOILERS = {
    "what is this": NoticeKind.UNKNOWN_LINE,
    "S\tin\tbowl": NoticeKind.BAD_BRACKETS,
    "O\t\t1": NoticeKind.MISSING_NAME,
}
REMARKABLE = {
    "S\tunder [pan]": NoticeKind.MISSING_TAB,
    "S\tcontains\t{salt,salt}": NoticeKind.NAME_TWICE,
    "S\tsalted\t{salt}": NoticeKind.STATE_WITH_BRACES,
    "S\ton\t": NoticeKind.EMPTY_STATE_COLUMN,
}
UNIT = [row for row in ROWS[2:14] if row != "//"]


@unhurried
@given(st.data(), st.integers(1, 12))
def test_a_defect_is_reported_at_its_own_line_wherever_it_stands(data: st.DataObject, count: int):
    good = [row for _ in range(count) for row in (*UNIT, "//")]
    at = data.draw(st.sampled_from([place for place, row in enumerate(good) if row.startswith("S\t")]))
    bad = data.draw(st.sampled_from([*SPOILERS, *REMARKABLE]))
    blank = data.draw(st.lists(st.sampled_from(["", "# a remark", "  "]), max_size=3))
    text = data.draw(st.sampled_from(["\n", "\r\n"])).join([*blank, *good[: at + 1], bad, *good[at + 1 :]])
    result = read_text(text, "v", "v.txt")
    kind = (SPOILERS | REMARKABLE)[bad]
    assert (len(blank) + at + 2, kind) in [(notice.line, notice.kind) for notice in result.notices]
    assert (len(result.subgraph.annotations) if result.subgraph else 0) == count - (bad in SPOILERS)


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5) | st.just("egg"),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=8,
)


@st.composite
def json_texts(draw: st.DrawFn) -> str:
    """The JSON of a good subgraph with one value replaced, cut off, or garbled."""
    subgraph = read_text("\n".join(ROWS), "v").subgraph
    assert subgraph is not None
    document = json.loads(write_json(subgraph))
    place = document
    while isinstance(place, dict | list) and place:
        key = draw(st.sampled_from(sorted(place) if isinstance(place, dict) else range(len(place))))
        if draw(st.integers(0, 2)) == 0 or not isinstance(place[key], dict | list) or not place[key]:
            place[key] = draw(json_values)
            break
        place = place[key]
    text = json.dumps(document, indent=draw(st.sampled_from([None, 1])))
    return text[: draw(st.integers(0, len(text)))] if draw(st.integers(0, 3)) == 0 else text


@unhurried
@given(json_texts() | st.text() | json_values.map(json.dumps))
def test_every_json_is_read_or_refused_with_its_line(text: str):
    result = read_json(text, "v", "v.txt")
    check(result, text)
    if result.subgraph is not None:
        assert read_json(write_json(result.subgraph), "v").subgraph == result.subgraph


@unhurried
@pytest.mark.parametrize("ending", ["txt", "json"])
@given(data=st.binary(max_size=60) | texts.map(str.encode) | texts.map(lambda text: text.encode("utf-16")))
def test_every_file_of_bytes_is_read_or_refused(tmp_path: Path, ending: str, data: bytes):
    path = tmp_path / f"v.{ending}"
    path.write_bytes(data)
    (result,) = read_path(path)
    assert result.path == str(path)
    assert (result.subgraph is not None) or result.rejected > 0
