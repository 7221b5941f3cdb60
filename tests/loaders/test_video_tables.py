"""Plain tables of annotated videos: what a person writes while watching becomes units, and every slip is told."""

from __future__ import annotations

import csv
import io
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.loaders.notices import NoticeKind, Severity
from foon_kg.loaders.video_tables import (
    COLUMNS,
    between_semicolons,
    read_thing,
    read_video_table,
    read_video_text,
    read_videos,
)
from foon_kg.model import ObjectNode, Participant, Timing
from foon_kg.model.errors import ReadError

HEADER = ",".join((*COLUMNS, "dish"))
CHOP = "0:12,0:31,chop,onion (peeled) on cutting board; knife,onion (chopped) on cutting board,"
MIX = '0:40,0:44,mix *,"bowl {onion, tomato}; *spoon","salad (mixed) {onion, tomato} in bowl; spoon",salad'


def read(*rows, header=HEADER):
    (result,) = read_video_text("\n".join((header, *rows)), "video")
    return result


def units(*rows):
    return [annotation.unit for annotation in read(*rows).subgraph.annotations]


@pytest.mark.parametrize(
    ("text", "node"),
    [
        ("onion", ObjectNode("onion")),
        ("red onion (chopped, peeled)", ObjectNode("red onion", ("chopped", "peeled"))),
        ("bowl {onion, salt}", ObjectNode("bowl", (), ("onion", "salt"))),
        ("bowl (hot) {onion; salt} on stove", ObjectNode("bowl", ("hot",), ("onion", "salt"), "on", "stove")),
        ("lid attached to pot", ObjectNode("lid", (), (), "attached to", "pot")),
        ("bread covered with butter", ObjectNode("bread", (), (), "covered with", "butter")),
        ("onion in mixing bowl", ObjectNode("onion", (), (), "in", "mixing bowl")),
        ("onionring", ObjectNode("onionring")),
    ],
)
def test_a_thing_is_a_name_with_states_foods_and_place(text, node):
    assert read_thing(text) == Participant(node)


@pytest.mark.parametrize(
    "text", ["", "*", "(chopped)", "onion (", "onion )", "a {b", "a (b) (c)", "in bowl (", "a } b"]
)
def test_what_is_no_thing_is_none(text):
    assert read_thing(text) is None


def test_a_star_before_a_thing_says_that_it_moves():
    assert read_thing("* spoon") == Participant(ObjectNode("spoon"), moving=True)


words = st.sampled_from(("onion", "red onion", "salt", "crème", "cutting board"))
nodes = st.builds(
    ObjectNode,
    words,
    st.lists(words, max_size=3).map(tuple),
    st.lists(words, max_size=3).map(tuple),
)


@given(nodes, st.sampled_from(("", "in", "on", "attached to")), words, st.booleans())
def test_any_thing_that_is_written_so_is_read_so(node, relation, container, moving):
    text = "*" if moving else ""
    text += node.label
    text += f" ({'; '.join(node.states)})" if node.states else ""
    text += f" {{{', '.join(node.ingredients)}}}" if node.ingredients else ""
    text += f" {relation} {container}" if relation else ""
    place = (relation, container) if relation else (None, None)
    expected = ObjectNode(node.label, node.states, node.ingredients, *place)
    assert read_thing(text) == Participant(expected, moving=moving)


@given(st.text("a;(){}", max_size=12))
def test_a_cell_is_divided_at_semicolons_that_stand_in_no_brackets(cell):
    assert between_semicolons(cell) == re.split(r";(?![^(]*\))(?![^{]*\})", cell)


def test_rows_are_units_in_their_order_with_times_and_goal():
    chop, mix = read(CHOP, MIX).subgraph.annotations
    assert chop.unit.motion == "chop"
    assert [node.label for node in chop.unit.input_nodes] == ["onion", "knife"]
    assert chop.timing == Timing(((12.0, 31.0),))
    assert (mix.unit.motion, mix.unit.accepts_any) == ("mix", True)
    assert [p.moving for p in mix.unit.inputs] == [False, True]
    assert [(p.node.label, p.dish_type) for p in mix.unit.outputs] == [("salad", "salad"), ("spoon", None)]


@pytest.mark.parametrize(
    "outputs",
    [
        "salad {leek; onion} in bowl; bowl {salad}",
        "bowl {salad}; salad {leek; onion} in bowl",
        "bowl {salad}; salad; spoon",
    ],
)
def test_the_dish_is_the_food_and_never_what_it_lies_in(outputs):
    (mix,) = read(f"1,2,mix,onion; leek; bowl,{outputs},salad").subgraph.annotations
    assert [(p.node.label, p.dish_type) for p in mix.unit.outputs if p.dish_type] == [("salad", "salad")]


def test_empty_rows_and_columns_of_ones_own_do_not_matter():
    result = read(",,,,,", "1,2,cut,a,b,,mine", "", header=f"{HEADER},remark")
    assert len(result.subgraph.annotations) == 1
    assert result.notices == ()


def test_one_table_may_have_several_videos():
    rows = ["video," + HEADER, "one," + CHOP, "two," + MIX, "one," + CHOP]
    results = read_video_text("\n".join(rows), "file")
    assert [(r.subgraph.name, len(r.subgraph.annotations)) for r in results] == [("one", 2), ("two", 1)]


@pytest.mark.parametrize(
    ("row", "kind"),
    [
        ("1,2,,a,b,", NoticeKind.UNIT_WITHOUT_MOTION),
        ("1,2,*,a,b,", NoticeKind.UNIT_WITHOUT_MOTION),
        ("1,2,cut,,b,", NoticeKind.UNIT_WITHOUT_INPUTS),
        ("1,2,cut,a,,", NoticeKind.UNIT_WITHOUT_OUTPUTS),
        ("1,2,cut,a (,b,", NoticeKind.BAD_BRACKETS),
        ("1,2,cut,a,b,gruel", NoticeKind.ODD_CLASS),
        ("1,2,mix,a,bowl {salad},salad", NoticeKind.ODD_CLASS),
        ("1,2,cut", NoticeKind.UNIT_WITHOUT_INPUTS),
    ],
)
def test_a_row_that_is_no_unit_is_rejected_with_its_line_and_the_others_stay(row, kind):
    result = read(CHOP, row, MIX)
    (notice,) = result.notices
    assert (notice.line, notice.kind, notice.severity) == (3, kind, Severity.REJECTED)
    assert len(result.subgraph.annotations) == 2


@pytest.mark.parametrize("times", ["-4,3", "4,-3", "9,8", "1:10,0:59"])
def test_a_time_that_no_video_has_is_left_out_and_told(times):
    result = read(f"{times},cut,a,b,")
    assert [annotation.timing for annotation in result.subgraph.annotations] == [Timing()]
    assert [notice.kind for notice in result.notices] == [NoticeKind.ODD_TIME]


def test_a_row_without_times_is_a_unit_without_a_word():
    result = read(",,cut,a,b,")
    assert result.notices == ()
    assert result.subgraph.annotations[0].timing == Timing()


@pytest.mark.parametrize(
    "raw", [b"", b"a,b\n1,2\n", b"\xff\xfe", b"start,end,motion,inputs\n1,2,cut,a\n", HEADER.encode() + b'\n1,2,cut,"a']
)
def test_a_file_that_is_no_such_table_is_rejected_whole(tmp_path, raw):
    (tmp_path / "v.csv").write_bytes(raw)
    (result,) = read_video_table(tmp_path / "v.csv")
    assert result.subgraph is None
    assert [notice.severity for notice in result.notices] == [Severity.REJECTED]
    assert result.notices[0].file.endswith("v.csv")


@given(st.text(max_size=300))
def test_no_text_raises(text):
    for result in read_video_text(f"{HEADER}\n{text}", "v"):
        assert result.subgraph is None or result.subgraph.annotations


@given(st.lists(st.tuples(*[st.text(max_size=12)] * 6), max_size=4))
def test_every_row_is_a_unit_or_is_rejected(rows):
    stream = io.StringIO()
    csv.writer(stream).writerows([HEADER.split(","), *rows])
    (result,) = read_video_text(stream.getvalue(), "v")
    filled = sum(any(cell.strip() for cell in row) for row in rows)
    units = len(result.subgraph.annotations) if result.subgraph else 0
    if filled and result.notices[:1] and result.notices[0].kind is NoticeKind.UNREADABLE_FILE:
        return
    assert units + result.rejected == max(filled, 1)


def test_folders_hold_tables_and_subgraph_files_side_by_side(tmp_path):
    (tmp_path / "table.csv").write_text(f"{HEADER}\n{CHOP}", encoding="utf-8")
    (tmp_path / "text.txt").write_text("O\ta\t0\nM\tcut\nO\tb\t0\n//\n", encoding="utf-8")
    assert [result.subgraph.name for result in read_videos([tmp_path])] == ["table", "text"]
    assert [result.subgraph.name for result in read_videos([tmp_path / "table.csv"])] == ["table"]


@pytest.mark.parametrize(
    ("row", "kind"),
    [
        (f"0:01,0:02,chop,{'x' * 140_000},b,", NoticeKind.LONG_CELL),
        ("0:01,0:02,chop,onion, knife,onion,,salad", NoticeKind.EXTRA_COLUMN),
    ],
)
def test_a_row_that_no_table_has_costs_itself_alone(row, kind):
    result = read(CHOP, row, MIX)
    assert [(notice.line, notice.kind, notice.severity) for notice in result.notices] == [(3, kind, Severity.REJECTED)]
    assert [annotation.unit.motion for annotation in result.subgraph.annotations] == ["chop", "mix"]


def test_a_quote_that_never_ends_is_told_with_the_line_on_which_it_begins():
    assert [notice.line for notice in read(CHOP, '0:01,0:02,chop,"onion,a', MIX).notices] == [3]


@pytest.mark.parametrize("name", ["nowhere", "nowhere.csv", "nowhere.txt"])
def test_a_path_that_is_not_there_is_refused(tmp_path, name):
    with pytest.raises(ReadError, match=f"{name}: no such file"):
        list(read_videos([tmp_path / name]))


def test_says_on_which_line_each_unit_stands_also_behind_rows_that_are_left_out() -> None:
    table = (
        "start,end,motion,inputs,outputs\n"
        "0:01,0:02,chop,onion (whole); knife,onion (chopped)\n"
        "0:03,0:04,,onion (chopped),pan {onion}\n"
        "0:05,0:06,fry,pan {onion},pan {onion}; onion (fried) in pan\n"
    )
    (result,) = read_video_text(table, "onion")
    assert result.rejected == 1
    assert result.lines == (2, 4)
