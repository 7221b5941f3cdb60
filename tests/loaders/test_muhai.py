"""MUHAI's networks become units; what cannot be played is told with its line, and gives no dish."""

from __future__ import annotations

from pathlib import Path

import pytest

from foon_kg.loaders.muhai import read_muhai, read_muhai_text
from foon_kg.loaders.notices import NoticeKind, ReadResult, Severity
from foon_kg.loaders.paths import read_path
from foon_kg.model import Measures
from foon_kg.model.errors import ReadError

BREAD = """(defparameter *recipe* '((get-kitchen ?k)
 (fetch-and-proportion ?butter ?k1 ?k ?c1 butter 60 g)
 (fetch-and-proportion ?flour ?k2 ?k1 ?c2 self-rising-flour 200 g)
 (transfer-contents ?x ?r1 ?k3 ?k2 ?bowl ?butter ?q1 ?u1)
 (transfer-contents ?y ?r2 ?k4 ?k3 ?x ?flour ?q2 ?u2)
 (mix ?batter ?k5 ?k4 ?y ?mixing-tool)
 (spread ?pan-with-batter ?k6 ?k5 ?pan ?batter ?scraper)
 (bake ?bread ?k7 ?k6 ?pan-with-batter ?oven 60 minute 165 degrees-celsius)))"""


def units(result: ReadResult) -> list[tuple[list[str], str, list[str]]]:
    assert result.subgraph is not None
    return [
        ([str(n) for n in a.unit.input_nodes], a.unit.motion, [str(n) for n in a.unit.output_nodes])
        for a in result.subgraph.annotations
    ]


def dishes(result: ReadResult) -> list[tuple[str, str]]:
    found = result.subgraph.annotations if result.subgraph else ()
    return [(p.node.label, p.dish_type) for a in found for p in a.unit.outputs if p.dish_type]


def test_each_primitive_is_a_unit_that_goes_on_where_the_last_one_ended() -> None:
    told = units(read_muhai_text(BREAD, "butter-bread"))

    motions = [motion for _, motion, _ in told]
    assert motions == ["pour", "pour", "pour", "pour", "mix", "spread", "turn on", "bake"]
    assert told[3][2] == [
        "mixing bowl ({butter, self rising flour})",
        "self rising flour (in mixing bowl)",
        "bowl (empty)",
    ]
    assert "batter (mixed; {butter, self rising flour}; in mixing bowl)" in told[4][2]
    assert "batter (mixed; {butter, self rising flour}; in mixing bowl)" in told[5][0]


def test_how_much_how_long_and_how_hot_is_kept_on_the_units() -> None:
    result = read_muhai_text(BREAD, "butter-bread")
    assert result.subgraph is not None

    told = [(one.unit.motion, one.measures) for one in result.subgraph.annotations if one.measures]
    assert told == [
        ("pour", Measures(("60 g butter",))),
        ("pour", Measures(("200 g self rising flour",))),
        ("turn on", Measures(celsius=165)),
        ("bake", Measures(seconds=3600, celsius=165)),
    ]


def test_what_is_baked_is_baked_as_hot_as_the_oven_was_heated() -> None:
    text = BREAD.replace("60 minute 165 degrees-celsius", "0.5 hour ?t ?u")
    text = text.replace("(bake", "(preheat-oven ?hot ?k8 ?k6 ?oven 180 degrees-celsius)\n (bake")
    result = read_muhai_text(text, "butter-bread")
    assert result.subgraph is not None

    told = [(one.unit.motion, one.measures) for one in result.subgraph.annotations[-2:]]
    assert told == [("turn on", Measures(celsius=180)), ("bake", Measures(seconds=1800, celsius=180))]


def test_a_variable_that_was_used_up_stands_for_what_became_of_it_and_that_is_told() -> None:
    """MUHAI's oatmeal cookies pour the eggs onto the bowl from which the flour was sifted."""
    stale = BREAD.replace("(mix ?batter ?k5 ?k4 ?y ?mixing-tool)", "(mix ?batter ?k5 ?k4 ?butter ?mixing-tool)")
    result = read_muhai_text(stale, "butter-bread")

    (told,) = [notice for notice in result.notices if notice.kind is NoticeKind.NOT_PLAYED]
    assert (told.line, told.message) == (6, "?butter was used up by a primitive before")
    assert told.action == "taken for what became of it, ?y"
    assert units(result)[4] == units(read_muhai_text(BREAD, "butter-bread"))[4]


def test_a_name_that_is_bound_again_is_what_it_was_bound_to_last() -> None:
    twice = BREAD.replace("?y", "?x")
    result = read_muhai_text(twice, "butter-bread")

    assert units(result) == units(read_muhai_text(BREAD, "butter-bread"))
    assert result.notices == ()


TWICE = """(defparameter *recipe* '((get-kitchen ?k)
 (fetch-and-proportion ?flour ?k1 ?k ?c1 flour 60 g)
 (fetch-and-proportion ?both ?k2 ?k1 ?flour sugar 50 g)
 (fetch-and-proportion ?more ?k3 ?k2 ?c2 flour 20 g)
 (transfer-contents ?all ?r1 ?k4 ?k3 ?both ?more ?q1 ?u1)))"""


def test_what_is_fetched_into_a_bowl_joins_what_is_in_it() -> None:
    assert units(read_muhai_text(TWICE, "sweet-flour"))[1][2] == ["bowl ({flour, sugar})", "sugar (in bowl)"]


def test_of_a_food_that_the_bowl_has_already_it_is_that_food_that_comes() -> None:
    made = units(read_muhai_text(TWICE, "sweet-flour"))[-1][2]
    assert made == ["bowl ({flour, sugar})", "flour (in bowl)", "bowl (empty)"]


def test_all_that_is_cracked_comes_into_the_bowl() -> None:
    text = """(defparameter *recipe* '((get-kitchen ?k)
     (fetch-and-proportion ?a ?k1 ?k ?c1 egg 2 piece)
     (fetch-and-proportion ?eggs ?k1 ?k ?a quail-egg 2 piece)
     (crack ?cracked ?k2 ?k1 ?eggs ?c2 ?u)))"""
    made = units(read_muhai_text(text, "eggs"))[-1][2]
    assert made[1:3] == ["egg (cracked; in bowl)", "quail egg (cracked; in bowl)"]


def test_a_tin_that_was_lined_is_lined_still_when_its_cover_is_off() -> None:
    text = """(defparameter *recipe* '((get-kitchen ?k)
     (line ?tin ?k1 ?k ?pan ?paper)
     (fetch-and-proportion ?filled ?k2 ?k1 ?tin flour 60 g)
     (cover ?covered ?k3 ?k2 ?filled ?lid)
     (uncover ?open ?k4 ?k3 ?lid ?covered)))"""
    assert units(read_muhai_text(text, "tin"))[-1][2][0] == "baking tray (lined; {flour})"


def test_each_unit_has_the_line_of_its_primitive() -> None:
    assert read_muhai_text(BREAD, "butter-bread").lines == (2, 3, 4, 5, 6, 7, 8, 8)


def test_the_last_food_is_the_dish_that_the_title_names() -> None:
    assert dishes(read_muhai_text(BREAD, "butter-bread-2")) == [("butter bread", "bread")]


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("(bake ", "(conjure ", 8),
        ("?y ?mixing-tool", "?nothing ?mixing-tool", 6),
        ("?c2 self-rising-flour 200 g", "", 3),
    ],
)
def test_a_primitive_that_cannot_be_played_is_told_and_no_dish_is_marked(old: str, new: str, line: int) -> None:
    result = read_muhai_text(BREAD.replace(old, new), "butter-bread")

    assert line in [notice.line for notice in result.notices if notice.severity is Severity.REJECTED]
    assert dishes(result) == []


@pytest.mark.parametrize("text", ["", "(defparameter *a* '((mix ?a ?b ?c ?d ?e)))", "(("])
def test_a_file_without_a_network_is_rejected(text: str) -> None:
    result = read_muhai_text(text, "none")

    assert result.subgraph is None
    assert [notice.severity for notice in result.notices] == [Severity.REJECTED]


def test_a_folder_without_recipes_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ReadError, match="no MUHAI recipe"):
        list(read_muhai([tmp_path]))
    with pytest.raises(ReadError, match=r"there is no file or folder .*nowhere"):
        list(read_muhai([tmp_path / "nowhere"]))


def test_degree_signs_of_another_encoding_are_read(tmp_path: Path) -> None:
    (tmp_path / "butter-bread.lisp").write_bytes(b"; 165\xb0C\n" + BREAD.encode())

    assert [dishes(result) for result in read_path(tmp_path)] == [[("butter bread", "bread")]]


@pytest.mark.shared_data
def test_all_of_muhai_is_read_and_all_but_the_unfinished_one_is_a_dish(shared_data: Path) -> None:
    results = list(read_muhai([shared_data / "muhai"]))

    rejected = [(Path(n.file).stem, n.line) for r in results for n in r.notices if n.severity is Severity.REJECTED]
    assert len(results) == 31
    assert sum(len(r.subgraph.annotations) for r in results if r.subgraph) == 905
    assert (len(rejected), {name for name, _ in rejected}) == (13, {"linguine-lentils-pancetta"})
    assert [Path(r.path).stem for r in results if len(dishes(r)) != 1] == ["linguine-lentils-pancetta"]
    assert [n.line for r in results for n in r.notices if n.kind is NoticeKind.BAD_BRACKETS] == [7]
    (oatmeal,) = [r.subgraph for r in results if r.subgraph and r.subgraph.name == "easy-oatmeal-cookies"]
    assert {"flour", "oats"} <= set(oatmeal.annotations[-1].unit.outputs[-1].node.ingredients)
