from __future__ import annotations

import pytest

from foon_kg.loaders import NoticeKind, ReadResult, Severity, read_text
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Timing

UNIT = "O\tonion\t1\nS\twhole\nM\tchop\t<0:10-0:15>\nO\tonion\t0\nS\tchopped\n//\n"


def lines(*rows: str) -> str:
    return "\n".join(rows) + "\n"


def unit(*input_lines: str, motion: str = "M\tmix", output: str = "O\tsalad\t0") -> str:
    """The unit's own lines begin at line 2."""
    return lines("//", *input_lines, motion, output, "//")


def first_input(result: ReadResult) -> Participant:
    assert result.subgraph is not None
    return result.subgraph.annotations[0].unit.inputs[0]


def said(result: ReadResult) -> list[tuple[int | None, NoticeKind]]:
    return [(notice.line, notice.kind) for notice in result.notices]


def test_a_unit_is_its_inputs_its_motion_and_its_outputs_in_order():
    text = lines(
        "# Source:\thttp://example.org/a.mp4",
        "# Source:\thttp://example.org/b",
        "//",
        "O\tbowl\t0",
        "S\tempty",
        "O\tonion\t1",
        "S\tchopped",
        "S\ton\t[cutting board]",
        "M\tadd*\t<1:10-1:11>",
        "O\tbowl\t0\t15",
        "S\tcontains\t{onion,carrot}",
        "//",
    )
    result = read_text(text, "salad")
    bowl, onion = ObjectNode("bowl", ("empty",)), ObjectNode("onion", ("chopped",), (), "on", "cutting board")
    full = ObjectNode("bowl", (), ("carrot", "onion"))
    expected = FunctionalUnit(
        (Participant(bowl), Participant(onion, moving=True)),
        "add",
        (Participant(full, dish_type="salad"),),
        accepts_any=True,
    )
    assert result.notices == ()
    assert result.subgraph is not None
    assert result.subgraph.name == "salad"
    assert result.subgraph.sources == ("http://example.org/a.mp4", "http://example.org/b")
    assert result.subgraph.annotations == (Annotation(expected, Timing(((70.0, 71.0),))),)


def test_the_dialect_with_ids_and_crlf_reads_the_same_as_the_plain_one():
    plain = read_text("# Source:\tx\n//\n" + UNIT * 2, "a")
    indexed = "# Source:\tx\n//\n" + UNIT.replace("O\t", "O278\t").replace("S\t", "S41\t").replace("M\t", "M92\t") * 2
    assert read_text(indexed.replace("\n", "\r\n"), "a") == plain
    assert read_text(indexed.replace("\n", "\r"), "a") == plain
    assert plain.notices == ()


def test_the_first_and_the_last_separator_may_be_missing():
    without, with_both = (read_text(text, "a") for text in (UNIT.removesuffix("//\n"), "//\n" + UNIT))
    assert without.subgraph == with_both.subgraph
    assert with_both.lines == tuple(line + 1 for line in without.lines)


def test_white_space_is_folded_and_names_stay_as_written_otherwise():
    result = read_text(
        unit("O\t Choppped  onion \t1", "S\t half  done ", "S\tin\t[ big  bowl]", "S\tcontains\t{ b c , a}"), "a"
    )
    assert first_input(result).node == ObjectNode("Choppped onion", ("half done",), ("a", "b c"), "in", "big bowl")
    assert result.notices == ()


def test_states_of_an_object_are_a_set():
    result = read_text(unit("O\tonion\t1", "S\tsliced", "S\tpeeled", "S\tsliced"), "a")
    assert first_input(result).node.states == ("peeled", "sliced")


READ_ALL_THE_SAME = {
    NoticeKind.MISSING_TAB: (["O\tx\t0", "S\tunder [cooking pan]"], ObjectNode("x", (), (), "under", "cooking pan")),
    NoticeKind.EMPTY_STATE_COLUMN: (["O\tx\t0", "S\toff\t"], ObjectNode("x", ("off",))),
    NoticeKind.EXTRA_COLUMN: (["O\tx\t0", "S\tin\t[bowl]\tmore"], ObjectNode("x", (), (), "in", "bowl")),
    NoticeKind.NAME_TWICE: (["O\tx\t0", "S\tcontains\t{salt,oil,salt}"], ObjectNode("x", (), ("oil", "salt"))),
    NoticeKind.EMPTY_NAME: (["O\tx\t0", "S\tcontains\t{salt,oil,}"], ObjectNode("x", (), ("oil", "salt"))),
    NoticeKind.EMPTY_PLACE: (["O\tx\t0", "S\ton\t[]"], ObjectNode("x", (), (), "on", None)),
    NoticeKind.EMPTY_STATE: (["O\tx\t0", "S\t"], ObjectNode("x")),
    NoticeKind.CONTAINS_PLACE: (["O\tx\t0", "S\tcontains\t[bowl]"], ObjectNode("x", (), (), "contains", "bowl")),
    NoticeKind.CONTAIN: (["O\tx\t0", "S\tcontain\t{butter}"], ObjectNode("x", (), ("butter",))),
    NoticeKind.RELATION_WITH_BRACES: (["O\tx\t0", "S\tin\t{packet}"], ObjectNode("x", (), (), "in", "packet")),
    NoticeKind.STATE_WITH_BRACES: (["O\tx\t0", "S\tgreased\t{butter}"], ObjectNode("x", ("greased",), ("butter",))),
}


@pytest.mark.parametrize("kind", READ_ALL_THE_SAME)
def test_an_unclear_state_line_is_read_and_reported_at_its_line(kind: NoticeKind):
    rows, node = READ_ALL_THE_SAME[kind]
    result = read_text(unit(*rows), "a")
    assert said(result) == [(3, kind)]
    assert result.notices[0].severity is Severity.ASSUMED
    assert result.rejected == 0
    assert first_input(result).node == node


def test_of_several_places_the_last_counts_and_the_others_are_kept_as_states():
    result = read_text(unit("O\tlime\t0", "S\twith\t[rind]", "S\ton\t[board]", "S\twith\t[rind]", "S\tin\t[bowl]"), "a")
    assert first_input(result).node == ObjectNode("lime", ("on [board]", "with [rind]"), (), "in", "bowl")
    assert said(result) == [(6, NoticeKind.SEVERAL_PLACES)]


def test_the_same_place_twice_is_one_place():
    result = read_text(unit("O\tlime\t0", "S\tin\t[bowl]", "S\tin\t[bowl]"), "a")
    assert first_input(result).node == ObjectNode("lime", (), (), "in", "bowl")
    assert result.notices == ()


def test_a_place_may_stand_without_its_relation():
    result = read_text(unit("O\tlime\t0", "S\t\t[bowl]"), "a")
    assert first_input(result).node == ObjectNode("lime", (), (), None, "bowl")
    assert result.notices == ()


@pytest.mark.parametrize(
    ("flag", "moving"), [("00", False), ("01", True), ("2", True), ("", False), ("yes", False), ("-1", False)]
)
def test_an_odd_flag_is_read_as_a_number_and_reported(flag: str, moving: bool):
    result = read_text(unit(f"O\tx\t{flag}"), "a")
    assert said(result) == [(2, NoticeKind.ODD_FLAG)]
    assert first_input(result).moving is moving


@pytest.mark.parametrize("number", ["30", "-1", "007", "salad", "1.5"])
def test_a_class_that_no_dish_type_has_is_reported(number: str):
    result = read_text(unit("O\tx\t0", output=f"O\tsalad\t0\t{number}"), "a")
    assert said(result) == [(4, NoticeKind.ODD_CLASS)]
    assert "a number from 0 to 29" in result.notices[0].message
    assert result.subgraph is not None
    assert result.subgraph.annotations[0].unit.outputs[0].dish_type is None


def test_a_class_on_an_input_is_kept_there_and_reported():
    result = read_text(unit("O\tsandwich\t0\t4"), "a")
    assert said(result) == [(2, NoticeKind.CLASS_ON_INPUT)]
    assert first_input(result).dish_type == "sandwich"


def test_an_odd_time_is_reported_at_the_line_of_its_motion():
    result = read_text(unit("O\tx\t0", "S\tdry", motion="M\tmix\t1:00\t0:30"), "a")
    assert said(result) == [(4, NoticeKind.ODD_TIME)]


def test_a_file_that_mostly_writes_hours_is_read_so():
    rows = [("0:01:20", "0:02:00"), ("0:02:00", "1:00:10"), ("0:59", "1:01")]
    text = "//\n" + "".join(f"O\tx\t0\nM\tmix\t{start}\t{end}\nO\ty\t0\n//\n" for start, end in rows)
    result = read_text(text, "a")
    assert result.subgraph is not None
    assert [a.timing.spans for a in result.subgraph.annotations] == [((80, 120),), ((120, 3610),), ((59, 61),)]
    assert result.notices == ()


def test_an_empty_unit_is_reported_where_it_ends():
    result = read_text("//\n" + UNIT + "\n# a remark\n//\n" + UNIT, "a")
    assert said(result) == [(10, NoticeKind.EMPTY_UNIT)]
    assert result.subgraph is not None
    assert len(result.subgraph.annotations) == 2


def test_text_beside_a_separator_is_reported():
    result = read_text(UNIT + "// the second unit\n" + UNIT, "a")
    assert said(result) == [(7, NoticeKind.EXTRA_COLUMN), (7, NoticeKind.EMPTY_UNIT)]


# The unit between two good ones; its first line is line 8.
SPOILED = {
    NoticeKind.UNIT_WITHOUT_MOTION: (10, ["O\tx\t0", "S\tdry", "//"]),
    NoticeKind.UNIT_WITHOUT_OUTPUTS: (10, ["O\tx\t0", "M\tmix\t<Assumed>", "//"]),
    NoticeKind.UNIT_WITHOUT_INPUTS: (10, ["M\tmix\t<Assumed>", "O\tx\t0", "//"]),
    NoticeKind.TWO_MOTIONS: (11, ["O\tx\t0", "M\tmix", "O\ty\t0", "M\tpour", "O\tz\t0", "//"]),
    NoticeKind.STRAY_STATE: (8, ["S\tdry", "O\tx\t0", "M\tmix", "O\ty\t0", "//"]),
    NoticeKind.UNKNOWN_LINE: (9, ["O\tx\t0", "S whole", "M\tmix", "O\ty\t0", "//"]),
    NoticeKind.MISSING_NAME: (10, ["O\tx\t0", "M\tmix", "O\t\t0", "//"]),
    NoticeKind.BAD_BRACKETS: (9, ["O\tx\t0", "S\tin\tbowl", "M\tmix", "O\ty\t0", "//"]),
}


@pytest.mark.parametrize("kind", SPOILED)
def test_a_spoiled_unit_is_left_out_and_the_rest_of_the_file_is_kept(kind: NoticeKind):
    line, rows = SPOILED[kind]
    result = read_text("//\n" + UNIT + lines(*rows) + UNIT, "a", "a.txt")
    assert result.subgraph is not None
    assert result.subgraph.annotations == read_text(UNIT * 2, "a").subgraph.annotations  # type: ignore[union-attr]
    assert [(n.file, n.line, n.kind, n.severity) for n in result.notices] == [("a.txt", line, kind, Severity.REJECTED)]
    assert result.rejected == 1


@pytest.mark.parametrize("column", ["[bowl", "bowl]", "{salt", "[a]b]", "{a}{b}", "[{a}]", "bowl"])
def test_brackets_that_cannot_be_understood_spoil_their_unit(column: str):
    result = read_text(UNIT + f"O\tx\t0\nS\tin\t{column}\nM\tmix\nO\ty\t0\n//\n", "a")
    assert said(result) == [(8, NoticeKind.BAD_BRACKETS)]


@pytest.mark.parametrize("motion", ["M\t\t<Assumed>", "M\t*\t<Assumed>"])
def test_a_motion_without_a_name_spoils_its_unit(motion: str):
    result = read_text(UNIT + f"O\tx\t0\n{motion}\nO\ty\t0\n//\n", "a")
    assert said(result) == [(8, NoticeKind.MISSING_NAME)]


def test_a_unit_with_many_faults_is_one_rejected_unit():
    result = read_text(UNIT + "S\tdry\nwhat\nO\t\t0\nM\tmix\nM\tmix\n//\n", "a")
    assert said(result) == [(7, NoticeKind.STRAY_STATE)]


def test_a_unit_cut_off_by_the_end_of_the_file_is_reported_at_its_last_line():
    result = read_text(UNIT + "O\tx\t0\nM\tmix\n\n", "a")
    assert said(result) == [(8, NoticeKind.UNIT_WITHOUT_OUTPUTS)]


@pytest.mark.parametrize("text", ["", "\n\n", "//\n", "# Source:\tx\n//\n"])
def test_a_text_without_units_is_no_foon(text: str):
    result = read_text(text, "a")
    assert result.subgraph is None
    assert [(n.line, n.kind, n.severity) for n in result.notices] == [(None, NoticeKind.NO_UNITS, Severity.REJECTED)]


def test_a_text_in_which_every_unit_is_spoiled_gives_no_subgraph():
    result = read_text("Chop the onion.\nServe.\n", "a")
    assert result.subgraph is None
    assert said(result) == [(1, NoticeKind.UNKNOWN_LINE)]


def test_equal_nodes_are_one_object_however_they_are_written():
    result = read_text(unit("O\tx\t0", "S\ta", "S\tb", "O\tx\t1", "S\tb", "S\ta"), "a")
    assert result.subgraph is not None
    one, other = result.subgraph.annotations[0].unit.inputs
    assert one.node is other.node
    assert (one.moving, other.moving) == (False, True)
