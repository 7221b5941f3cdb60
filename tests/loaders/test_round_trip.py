"""What is written is read back as the same, or is not written at all."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from foon_kg.loaders import NoticeKind, Severity, read_json, read_text, write_json, write_text
from foon_kg.model import (
    DISH_TYPES,
    Annotation,
    FunctionalUnit,
    Measures,
    ObjectNode,
    Participant,
    Sighting,
    Subgraph,
    Timing,
)
from foon_kg.model.errors import FormatError

unhurried = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])

PLAIN = st.text(st.sampled_from("abcxyzÄé中🍳09-'()/.*#!"), min_size=1, max_size=8)
names = st.lists(PLAIN, min_size=1, max_size=2).map(" ".join)
"""Words with single blanks: what both formats can say anywhere."""
motions = names.filter(lambda name: not name.endswith("*"))
any_text = st.text(max_size=12) | st.text(st.sampled_from("ab \t\n\r[]{},*#/\x00\x0b\x85\u2028\ufeff"), max_size=8)
seconds = st.one_of(st.integers(0, 10**5).map(float), st.floats(0, 10**5).map(lambda value: round(value, 3)))
any_seconds = seconds | st.floats()


def subgraphs(
    names: st.SearchStrategy[str], motions: st.SearchStrategy[str], seconds: st.SearchStrategy[float]
) -> st.SearchStrategy[Subgraph]:
    few = st.lists(names, max_size=2).map(tuple)
    place = names | st.none()
    nodes = st.builds(ObjectNode, names, few, few, place, place)
    participants = st.builds(Participant, nodes, st.booleans(), st.sampled_from(DISH_TYPES) | st.none())
    side = st.lists(participants, min_size=1, max_size=2).map(tuple)
    units = st.builds(FunctionalUnit, side, motions, side, st.booleans())
    times = st.builds(Timing, st.lists(st.tuples(seconds, seconds), max_size=3).map(tuple), st.booleans())
    seen = st.builds(Sighting, names, st.integers(0, 99), names | st.none(), seconds | st.none(), seconds | st.none())
    seen_in = st.none() | st.lists(seen, max_size=2).map(tuple)
    noted = st.builds(Annotation, units, times, seen_in=seen_in)
    annotations = st.lists(noted, min_size=1, max_size=2).map(tuple)
    return st.builds(Subgraph, st.just("video"), annotations, few)


def only_expected(subgraph: Subgraph) -> set[NoticeKind]:
    """What the readers rightly remark on in a model that holds it."""
    kinds = set()
    for annotation in subgraph.annotations:
        if any(end < start for start, end in annotation.timing.spans):
            kinds.add(NoticeKind.ODD_TIME)
        if any(one.dish_type for one in annotation.unit.inputs):
            kinds.add(NoticeKind.CLASS_ON_INPUT)
        for one in (*annotation.unit.inputs, *annotation.unit.outputs):
            if one.node.relation is not None and one.node.container is None:
                kinds.add(NoticeKind.EMPTY_PLACE)
    return kinds


@pytest.mark.slow
@unhurried
@given(subgraphs(names, motions, seconds))
def test_text_is_read_back_as_the_same_with_nothing_to_remark_on(subgraph: Subgraph):
    result = read_text(write_text(subgraph), "video")
    assert result.subgraph == subgraph
    assert {notice.kind for notice in result.notices} <= only_expected(subgraph)


@pytest.mark.slow
@unhurried
@given(subgraphs(names, names, seconds))
def test_json_is_read_back_as_the_same_with_nothing_to_remark_on(subgraph: Subgraph):
    result = read_json(write_json(subgraph), "video")
    assert result.subgraph == subgraph
    assert {notice.kind for notice in result.notices} <= only_expected(subgraph)


@unhurried
@given(subgraphs(any_text, any_text, any_seconds))
def test_text_that_would_be_read_as_something_else_is_not_written(subgraph: Subgraph):
    try:
        text = write_text(subgraph)
    except FormatError:
        return
    assert read_text(text, "video").subgraph == subgraph


@unhurried
@given(subgraphs(any_text, any_text, any_seconds))
def test_json_that_would_be_read_as_something_else_is_not_written(subgraph: Subgraph):
    try:
        text = write_json(subgraph)
    except FormatError:
        return
    assert read_json(text, "video").subgraph == subgraph


def subgraph_of(node: ObjectNode, motion: str = "mix", *, sources: tuple[str, ...] = ()) -> Subgraph:
    good = Annotation(FunctionalUnit((Participant(ObjectNode("egg")),), "crack", (Participant(ObjectNode("bowl")),)))
    unit = FunctionalUnit((Participant(node),), motion, (Participant(ObjectNode("egg")),))
    return Subgraph("video", (good, Annotation(unit)), sources)


TEXT_CANNOT = {
    "a tab": ObjectNode("a\tb"),
    "a line end": ObjectNode("egg\n//\nO\tegg"),
    "a blank at the end": ObjectNode("egg "),
    "two blanks": ObjectNode("egg", ("very  raw",)),
    "no label": ObjectNode(""),
    "an empty state": ObjectNode("egg", ("",)),
    "a comma in an ingredient": ObjectNode("bowl", (), ("salt, fine",)),
    "a brace in an ingredient": ObjectNode("bowl", (), ("salt}",)),
    "a bracket in a container": ObjectNode("egg", (), (), "in", "bowl]"),
    "an empty container": ObjectNode("egg", (), (), "in", ""),
    "a state that is its place": ObjectNode("egg", ("in [bowl]",), (), "in", "bowl"),
    "a state in braces": ObjectNode("egg", ("greased {oil}",)),
}


@pytest.mark.parametrize("case", TEXT_CANNOT)
def test_a_name_that_text_cannot_carry_is_refused_with_the_unit_it_is_in(case: str):
    with pytest.raises(FormatError, match=r"video: unit 1 \('mix' of .*cannot be written as FOON text") as refused:
        write_text(subgraph_of(TEXT_CANNOT[case]))
    assert "write JSON" in refused.value.hint


@pytest.mark.parametrize("motion", ["", "mix*", " mix", "mix\tpour"])
def test_a_motion_that_text_cannot_carry_is_refused(motion: str):
    with pytest.raises(FormatError, match="unit 1"):
        write_text(subgraph_of(ObjectNode("egg"), motion))


@pytest.mark.parametrize("source", ["", " x", "a\nb"])
def test_a_source_that_text_cannot_carry_is_refused(source: str):
    with pytest.raises(FormatError, match="one of the sources"):
        write_text(subgraph_of(ObjectNode("egg"), sources=(source,)))


JSON_CANNOT = ["a tab", "a line end", "a blank at the end", "two blanks", "no label", "an empty state"]


@pytest.mark.parametrize("case", JSON_CANNOT)
def test_a_name_that_json_cannot_carry_is_refused(case: str):
    with pytest.raises(FormatError, match="cannot be written as JSON: video"):
        write_json(subgraph_of(TEXT_CANNOT[case]))


@pytest.mark.parametrize("case", [case for case in TEXT_CANNOT if case not in JSON_CANNOT and "empty" not in case])
def test_json_carries_what_text_cannot(case: str):
    subgraph = subgraph_of(TEXT_CANNOT[case])
    assert read_json(write_json(subgraph), "video").subgraph == subgraph


@pytest.mark.parametrize("write", [write_text, write_json])
def test_a_subgraph_without_units_is_not_written(write):
    with pytest.raises(FormatError, match=r"without units|no functional unit"):
        write(Subgraph("video", ()))


@pytest.mark.parametrize(
    "node",
    [
        ObjectNode("lime", ("with [rind]",), (), "in", "bowl"),
        ObjectNode("lime", ("with [rind]", "on [board]", "cut"), ("salt",), "in", "bowl"),
        ObjectNode("stove", ("under [pan]",)),
        ObjectNode("stove", ("[pan]", "[]"), (), None, "kitchen"),
        ObjectNode("lime", (), (), None, "bowl"),
        ObjectNode("lime", (), (), "on", None),
        ObjectNode("lime", (), (), "contains", "bowl"),
        ObjectNode("oven", ("on", "contains", "// off", "# hot", "with")),
        ObjectNode("O\u00a0x".replace("\u00a0", " "), ("M mix",)),
        ObjectNode("[lime]", (), ("// a", "# b")),
    ],
    ids=str,
)
def test_unusual_nodes_are_written_in_both_formats(node: ObjectNode):
    subgraph = subgraph_of(node)
    assert read_text(write_text(subgraph), "video").subgraph == subgraph
    assert read_json(write_json(subgraph), "video").subgraph == subgraph


def test_json_keeps_measures_and_text_has_no_place_for_them():
    measures = Measures(("200 g flour", "3 piece egg"), 3600.0, 165.5)
    unit = FunctionalUnit((Participant(ObjectNode("egg")),), "bake", (Participant(ObjectNode("cake")),))
    subgraph = Subgraph("video", (Annotation(unit, measures=measures), Annotation(unit)))
    assert read_json(write_json(subgraph), "video").subgraph == subgraph
    assert read_text(write_text(subgraph), "video").subgraph == replace(subgraph, annotations=(Annotation(unit),) * 2)
    assert subgraph.content_key != replace(subgraph, annotations=(Annotation(unit),) * 2).content_key


@pytest.mark.parametrize(
    "measures",
    ['{"seconds": -1}', '{"celsius": "hot"}', '{"seconds": NaN}', '{"amounts": 3}', '{"amounts": [" "]}', "7"],
)
def test_measures_that_are_none_are_told_with_their_unit(measures):
    nodes = '"input_nodes": [{"label": "egg"}], "motion_node": "bake", "output_nodes": [{"label": "cake"}]'
    result = read_json(f'{{"units": [{{{nodes}, "measures": {measures}}}]}}', "video")
    assert [notice.severity for notice in result.notices if notice.severity is Severity.REJECTED] != []


def test_text_is_written_in_one_way():
    lime = ObjectNode("lime", ("peeled", "cut"), ("salt", "oil"), "in", "bowl")
    dish = Participant(ObjectNode("salad"), dish_type="salad")
    unit = FunctionalUnit((Participant(lime, moving=True),), "mix", (dish,), accepts_any=True)
    subgraph = Subgraph("video", (Annotation(unit, Timing(((70.0, 71.5),))),), ("http://example.org",))
    assert write_text(subgraph).split("\n") == [
        "# Source:\thttp://example.org",
        "//",
        "O\tlime\t1",
        "S\tcut",
        "S\tpeeled",
        "S\tcontains\t{oil,salt}",
        "S\tin\t[bowl]",
        "M\tmix*\t<1:10-1:11.5>",
        "O\tsalad\t0\t15",
        "//",
        "",
    ]
