from __future__ import annotations

import json
from typing import Any

import pytest

from foon_kg.loaders import NoticeKind, ReadResult, Severity, read_json
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Timing

NODE = {"label": "onion", "states": ["whole"], "ingredients": [], "container": "bowl"}
UNIT = {"input_nodes": [NODE], "motion_node": "chop", "output_nodes": [NODE | {"states": ["chopped"]}]}


def read(document: object) -> ReadResult:
    return read_json(json.dumps(document, indent=1), "a", "a.json")


def said(result: ReadResult) -> list[tuple[int | None, NoticeKind]]:
    return [(notice.line, notice.kind) for notice in result.notices]


def test_the_authors_json_is_a_list_of_units_without_relations_flags_and_times():
    result = read([UNIT, UNIT | {"motion_node": "pour*"}])
    whole = Participant(ObjectNode("onion", ("whole",), (), None, "bowl"))
    chopped = Participant(ObjectNode("onion", ("chopped",), (), None, "bowl"))
    assert result.notices == ()
    assert result.subgraph is not None
    assert result.subgraph.annotations == (
        Annotation(FunctionalUnit((whole,), "chop", (chopped,))),
        Annotation(FunctionalUnit((whole,), "pour", (chopped,), accepts_any=True)),
    )


def test_our_own_json_carries_everything():
    full = NODE | {"relation": "in", "moving": True, "dish_type": None}
    dish = NODE | {"relation": None, "moving": False, "dish_type": "salad"}
    timing = {"spans": [[1, 2.5]], "assumed": True}
    unit = {
        "input_nodes": [full],
        "motion_node": "mix",
        "accepts_any": True,
        "output_nodes": [dish],
        "timing": timing,
    }
    result = read({"sources": ["http://example.org"], "units": [unit]})
    inputs = (Participant(ObjectNode("onion", ("whole",), (), "in", "bowl"), moving=True),)
    outputs = (Participant(ObjectNode("onion", ("whole",), (), None, "bowl"), dish_type="salad"),)
    assert result.notices == ()
    assert result.subgraph is not None
    assert result.subgraph.sources == ("http://example.org",)
    assert result.subgraph.annotations == (
        Annotation(FunctionalUnit(inputs, "mix", outputs, accepts_any=True), Timing(((1.0, 2.5),), assumed=True)),
    )


TWO_LEVELS = {"a": {"b": 1}}
BAD_UNITS: dict[str, tuple[Any, NoticeKind]] = {
    "no object": (7, NoticeKind.BAD_FIELD),
    "null": (None, NoticeKind.BAD_FIELD),
    "field missing": ({"input_nodes": [NODE], "output_nodes": [NODE]}, NoticeKind.BAD_FIELD),
    "motion no text": (UNIT | {"motion_node": 3}, NoticeKind.BAD_FIELD),
    "motion empty": (UNIT | {"motion_node": " "}, NoticeKind.BAD_FIELD),
    "only a star": (UNIT | {"motion_node": "*"}, NoticeKind.UNIT_WITHOUT_MOTION),
    "no inputs": (UNIT | {"input_nodes": []}, NoticeKind.UNIT_WITHOUT_INPUTS),
    "no outputs": (UNIT | {"output_nodes": []}, NoticeKind.UNIT_WITHOUT_OUTPUTS),
    "nodes no list": (UNIT | {"input_nodes": NODE}, NoticeKind.BAD_FIELD),
    "node no object": (UNIT | {"input_nodes": ["onion"]}, NoticeKind.BAD_FIELD),
    "label empty": (UNIT | {"input_nodes": [NODE | {"label": ""}]}, NoticeKind.BAD_FIELD),
    "label with a null character": (UNIT | {"input_nodes": [NODE | {"label": "a\0b"}]}, NoticeKind.BAD_FIELD),
    "label with half a character": (UNIT | {"input_nodes": [NODE | {"label": "a\ud800"}]}, NoticeKind.BAD_FIELD),
    "states no list": (UNIT | {"input_nodes": [NODE | {"states": "raw"}]}, NoticeKind.BAD_FIELD),
    "state no text": (UNIT | {"input_nodes": [NODE | {"states": [TWO_LEVELS]}]}, NoticeKind.BAD_FIELD),
    "flag no truth": (UNIT | {"input_nodes": [NODE | {"moving": 1}]}, NoticeKind.BAD_FIELD),
    "unknown dish type": (UNIT | {"output_nodes": [NODE | {"dish_type": "brunch"}]}, NoticeKind.BAD_FIELD),
    "timing no object": (UNIT | {"timing": []}, NoticeKind.BAD_FIELD),
    "spans missing": (UNIT | {"timing": {"assumed": True}}, NoticeKind.BAD_FIELD),
    "span of three": (UNIT | {"timing": {"spans": [[1, 2, 3]], "assumed": False}}, NoticeKind.BAD_FIELD),
    "negative time": (UNIT | {"timing": {"spans": [[-1, 2]], "assumed": False}}, NoticeKind.BAD_FIELD),
    "time too late": (UNIT | {"timing": {"spans": [[1, 10**400]], "assumed": False}}, NoticeKind.BAD_FIELD),
    "time no number": (UNIT | {"timing": {"spans": [["1:10", "1:11"]], "assumed": False}}, NoticeKind.BAD_FIELD),
    "time true": (UNIT | {"timing": {"spans": [[True, True]], "assumed": False}}, NoticeKind.BAD_FIELD),
}


@pytest.mark.parametrize("case", BAD_UNITS)
def test_a_bad_unit_is_left_out_with_its_line_and_the_others_are_kept(case: str):
    bad, kind = BAD_UNITS[case]
    rows = ["[", json.dumps(UNIT) + ",", json.dumps(bad) + ",", json.dumps(UNIT), "]"]
    result = read_json("\n".join(rows), "a", "a.json")
    assert result.subgraph is not None
    assert result.subgraph.annotations == read([UNIT, UNIT]).subgraph.annotations  # type: ignore[union-attr]
    assert [(n.line, n.kind, n.severity) for n in result.notices] == [(3, kind, Severity.REJECTED)]
    assert "units[1]" in result.notices[0].message
    result.notices[0].message.encode()


READ_ALL_THE_SAME: dict[NoticeKind, dict[str, Any]] = {
    NoticeKind.NAME_TWICE: UNIT | {"input_nodes": [NODE | {"ingredients": ["salt", "salt"]}]},
    NoticeKind.EMPTY_NAME: UNIT | {"input_nodes": [NODE | {"ingredients": ["salt", " "]}]},
    NoticeKind.EMPTY_PLACE: UNIT | {"input_nodes": [NODE | {"container": ""}]},
    NoticeKind.UNKNOWN_FIELD: UNIT | {"input_nodes": [NODE | {"colour": "red"}]},
    NoticeKind.CLASS_ON_INPUT: UNIT | {"input_nodes": [NODE | {"dish_type": "soup"}]},
    NoticeKind.ODD_TIME: UNIT | {"timing": {"spans": [[2, 1]], "assumed": False}},
}


@pytest.mark.parametrize("kind", READ_ALL_THE_SAME)
def test_an_unclear_field_is_read_and_reported(kind: NoticeKind):
    result = read([UNIT, READ_ALL_THE_SAME[kind]])
    assert result.subgraph is not None
    assert len(result.subgraph.annotations) == 2
    assert [(n.kind, n.severity) for n in result.notices] == [(kind, Severity.ASSUMED)]


def test_unknown_fields_of_the_file_are_reported():
    result = read({"units": [UNIT], "author": "me"})
    assert said(result) == [(None, NoticeKind.UNKNOWN_FIELD)]
    assert "author" in result.notices[0].message


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("", 1),
        ("7", 1),
        ('"units"', 1),
        ("\n{}", 2),
        ('{"units": 7}', 1),
        ('{"units": {}}', 1),
        ("[1,\n2", 2),
        ("[1,\n2,]", 2),
        ("[1 2]", 1),
        ("[]\n[]", 2),
        ('{"units": []\n"sources": []}', 2),
        ('{"units": [],\n"units": []}', 2),
        ("{1: 2}", 1),
        ('[{"a": 1,\n"a": 2}]', 1),
        ('[\n{"a": NaN}]', 2),
        ('[\n{"a": ' + "9" * 5000 + "}]", 2),
        ("[" * 100_000, 1),
        ('[\n"\t"]', 2),
    ],
    ids=range(18),
)
def test_what_is_no_list_of_units_is_refused_with_its_line(text: str, line: int):
    result = read_json(text, "a", "a.json")
    assert result.subgraph is None
    assert [(n.line, n.kind, n.action) for n in result.notices] == [(line, NoticeKind.UNREADABLE_FILE, "file rejected")]


@pytest.mark.parametrize("text", ['{"units": [],\n"units": []}', '[{"a": 1, "units": 3,\n"b": 2, "units": 2}]'])
def test_a_field_that_is_there_twice_is_named(text: str):
    assert "'units' is there twice" in read_json(text, "a").notices[0].message


def test_sources_that_are_no_texts_spoil_the_file():
    result = read({"units": [UNIT], "sources": [7]})
    assert result.subgraph is None
    assert said(result) == [(None, NoticeKind.BAD_FIELD)]


@pytest.mark.parametrize("document", [[], {"units": []}, {"units": [], "sources": ["x"]}])
def test_a_list_without_units_is_no_foon(document: object):
    result = read(document)
    assert result.subgraph is None
    assert said(result) == [(None, NoticeKind.NO_UNITS)]


def test_a_unit_nested_as_deeply_as_can_be_decoded_is_refused_without_a_crash():
    for depth in range(800, 1100, 7):
        nested = "[" * depth + "]" * depth
        result = read_json(f"[\n{nested}]", "a")
        assert result.subgraph is None
        assert [n.line for n in result.notices] == [2]
