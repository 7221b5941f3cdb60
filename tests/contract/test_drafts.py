"""Drafts of recipes stand apart from videos: the same in memory and in Neo4j, and unseen by whoever does not ask."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from demo_foon import demo_subgraphs
from typer.testing import CliRunner

from foon_kg import Foon
from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders.lessons import lesson_of, lessons_of
from foon_kg.model.drafted import DraftedRecipe, surest
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.store.graph import load
from foon_kg.store.graph.drafts import load_drafts, remove_drafts
from foon_kg.store.graph.free_cypher import ask_freely

HEADER = "start,end,motion,inputs,outputs,dish,confidence,doubt,said,source\n"
COOKIES = HEADER + (
    ",,pour,flour in bag; bowl (empty),flour in bowl; bowl {flour},,0.6,,“Put the flour in a bowl.”,site\n"
    ",,pick-and-place,butter in bowl; bowl {flour},butter in bowl; bowl {flour; butter},,0.6,,,site\n"
    ",,pour,sugar in bowl; bowl {flour; butter},sugar in bowl; bowl {flour; butter; sugar},,0.5,sugar?,,site\n"
    ",,mix *,flour in bowl; butter in bowl; sugar in bowl; spoon; bowl {flour; butter; sugar},"
    "cookie dough (mixed) {flour; butter; sugar} in bowl; bowl {cookie dough},,0.5,,,site\n"
    ",,pick-and-place,cookie dough (mixed) {flour; butter; sugar} in bowl; baking sheet (empty),"
    "cookie dough (mixed) {flour; butter; sugar} on baking sheet; baking sheet {cookie dough},,0.5,,,site\n"
    ",,bake,cookie dough (mixed) {flour; butter; sugar} on baking sheet; baking sheet {cookie dough}; oven (on),"
    "cookie (baked) {flour; butter; sugar} on baking sheet; baking sheet {cookie},cookie,0.4,,“Bake.”,site\n"
)  # fmt: skip
SALADS = tuple(
    DraftedRecipe(
        f"s{number}",
        "Onion Salad",
        "salad",
        HEADER
        + f",,mix,onion (chopped) in bowl; salt{number} in bowl,onion salad (mixed) {{onion}} in bowl,salad,0.3,,,\n",
        1,
        0,
        sure,
    )
    for number, sure in enumerate((0.3, 0.5, 0.5, 0.1))
)
COOKIE = DraftedRecipe("c1", "Butter Cookies", "cookie", COOKIES, 6, 0, 0.52)
DRAFTS = (COOKIE, *SALADS)
TEACHES_NOTHING = DraftedRecipe("n", "Nothing", "salad", HEADER, 0, 3, 0.0, "no step")

SALAD = ("salad", ["chopped onion", "diced tomato", "olive oil"])
BISCUITS = ("cookie", ["flour", "butter", "sugar"])


def videos():
    return list(demo_subgraphs())


@pytest.fixture
def drafts_file(tmp_path):
    path = tmp_path / "drafts.jsonl"
    path.write_text("".join(json.dumps(one.to_json()) + "\n" for one in (*DRAFTS, TEACHES_NOTHING)))
    return path


def planned(foon, asked, **wishes):
    try:
        return json.dumps(foon.plan(*asked, **wishes).to_json())
    except NoTreeError as error:
        return json.dumps([error.code, error.message, error.hint])


def test_only_the_surest_of_each_dish_type_teach():
    names = [lesson.subgraph.name for lesson in surest(lessons_of(DRAFTS), most=2)]
    assert names == ["draft:c1", "draft:s1", "draft:s2"]
    assert surest(lessons_of(DRAFTS)) == lessons_of(DRAFTS)
    assert lesson_of(TEACHES_NOTHING) is None
    assert lesson_of(replace(COOKIE, dish_type="")) is None
    assert lesson_of(replace(COOKIE, table=COOKIES.replace(",cookie,", ",,"))) is None


def test_a_draft_teaches_a_dish_that_no_video_makes_and_the_answer_says_so(drafts_file):
    foon = Foon.from_files(demo_folder(), drafts=[drafts_file])
    with pytest.raises(NoTreeError) as alone:
        foon.plan(*BISCUITS)
    assert alone.value.code == "no-goal"
    plan = foon.plan(*BISCUITS, with_drafts=True)
    reference = plan.to_json()["reference"]
    assert reference["videos"] == ["draft:c1"]
    assert reference["draft_confidence"] == 0.52
    assert "a draft that nobody has reviewed (0.52 sure)" in plan.notes[-1]
    shown = {one.video for step in plan for one in step.seen_in}
    assert "draft:c1" in shown, "no video bakes such a dough"
    assert len(shown) > 1, "what videos show is evidence before a draft"
    assert plan.check().accepted


def test_a_video_that_suits_as_well_is_taken_before_a_draft(drafts_file):
    foon = Foon.from_files(demo_folder(), drafts=[drafts_file])
    plan = foon.plan(*SALAD, with_drafts=True)
    assert plan.to_json()["reference"]["videos"] == ["greek_salad"]
    assert "draft_confidence" not in plan.to_json()["reference"]
    assert plan.notes == foon.plan(*SALAD).notes


def test_without_the_flag_files_answer_the_same_bytes(drafts_file):
    alone, beside = Foon.from_files(demo_folder()), Foon.from_files(demo_folder(), drafts=[drafts_file])
    for asked in (SALAD, BISCUITS):
        assert planned(beside, asked) == planned(alone, asked)


@pytest.mark.slow
def test_the_command_says_that_it_planned_after_a_draft(drafts_file, tmp_path):
    words = ["plan", "--dish", "cookie", *BISCUITS[1], "--files", str(demo_folder()), "--files", str(drafts_file)]
    alone = CliRunner().invoke(app, words)
    assert alone.exit_code == 3
    told = CliRunner().invoke(app, [*words, "--with-drafts"])
    assert told.exit_code == 0, told.output
    assert "drafted from a recipe's words, not reviewed, 0.52 sure" in " ".join(told.stdout.split())
    assert "a draft that nobody has reviewed" in told.stderr
    as_json = CliRunner().invoke(app, [*words, "--with-drafts", "--json", "--quiet"])
    (tmp_path / "plan.jsonl").write_text(as_json.stdout)
    checked = CliRunner().invoke(
        app, ["check", str(tmp_path / "plan.jsonl"), "--files", str(demo_folder()), "--files", str(drafts_file)]
    )
    assert checked.exit_code == 0, checked.output


@pytest.mark.neo4j
def test_the_graph_keeps_the_same_lessons_as_memory(connection, graph):
    load(connection, videos())
    load_drafts(connection, (*DRAFTS, TEACHES_NOTHING), per_transaction=2)
    for most in (1, 2, 100):
        with graph.reading() as view:
            assert view.lessons(most) == surest(lessons_of(DRAFTS), most)


@pytest.mark.neo4j
def test_what_videos_say_is_the_same_bytes_with_and_without_drafts(connection, empty_graph):
    def whole():
        rows = ask_freely(
            connection, "MATCH (n) WHERE NOT n:Draft AND NOT n:Plan RETURN labels(n), properties(n)", limit=100_000
        ).rows
        return sorted(json.dumps([labels, properties], sort_keys=True) for labels, properties in rows)

    load(connection, videos())
    there = whole()
    settings = (empty_graph.uri, empty_graph.user, empty_graph.password, empty_graph.database)
    with Foon.connect(*settings) as foon:
        before = [planned(foon, asked) for asked in (SALAD, BISCUITS)]
    load_drafts(connection, DRAFTS)
    assert whole() == there
    with Foon.connect(*settings) as foon:
        assert [planned(foon, asked) for asked in (SALAD, BISCUITS)] == before
        in_files = Foon.from_files(demo_folder())
        in_files._lessons = lessons_of(DRAFTS)
        drafted = [planned(foon, asked, with_drafts=True) for asked in (SALAD, BISCUITS)]
        assert drafted == [planned(in_files, asked, with_drafts=True) for asked in (SALAD, BISCUITS)]
        assert drafted[1] != before[1]


@pytest.mark.neo4j
def test_drafts_are_loaded_once_replaced_and_removed(connection, graph):
    load(connection, videos())
    report = load_drafts(connection, (*DRAFTS, TEACHES_NOTHING))
    assert (report.inserted, report.replaced, report.unchanged, report.left_out) == (5, 0, 0, 1)
    report = load_drafts(connection, DRAFTS)
    assert (report.inserted, report.replaced, report.unchanged) == (0, 0, 5)
    other = replace(SALADS[0], confidence=0.9)
    report = load_drafts(connection, [other, COOKIE])
    assert (report.inserted, report.replaced, report.unchanged) == (0, 1, 1)
    report = load_drafts(connection, [SALADS[0], other, COOKIE])  # of two drafts of one recipe the last counts
    assert (report.inserted, report.replaced, report.unchanged, report.left_out) == (0, 1, 2, 0)
    with graph.reading() as view:
        assert {one.subgraph.name: one.confidence for one in view.lessons()}["draft:s0"] == 0.9
    barren = replace(SALADS[1], table=TEACHES_NOTHING.table, confidence=0.3)
    report = load_drafts(connection, [SALADS[1], barren])  # made anew, it teaches no dish any more
    assert (report.inserted, report.replaced, report.unchanged, report.left_out) == (0, 1, 0, 1)
    with graph.reading() as view:
        assert "draft:s1" not in {one.subgraph.name for one in view.lessons()}
    load_drafts(connection, [SALADS[1]])
    with pytest.raises(UsageError, match="no draft “draft:onions”"):
        remove_drafts(connection, ["draft:s0", "draft:onions"])
    remove_drafts(connection, ["draft:s0", "draft:c1"])
    with graph.reading() as view:
        assert [one.subgraph.name for one in view.lessons()] == ["draft:s1", "draft:s2", "draft:s3"]


@pytest.mark.neo4j
def test_the_commands_load_and_remove_drafts(connection, empty_graph, drafts_file, monkeypatch):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))

    def foon(*words, code=0):
        result = CliRunner().invoke(app, list(map(str, words)))
        assert result.exit_code == code, result.output
        return result.output

    load(connection, videos())
    assert "5 drafts, 1 left out" in foon("load", "drafts", drafts_file, "--dry-run")
    assert "5 inserted, 0 replaced, 0 unchanged, 1 left out" in foon("load", "drafts", drafts_file)
    assert "no draft “draft:x”" in foon("remove", "draft:x", code=2)
    assert "1 drafts gone" in foon("remove", "draft:c1")
    assert "videos and drafts cannot be removed together" in foon("remove", "draft:s0", "greek_salad", code=2)
    foon("plan", "--dish", "cookie", *BISCUITS[1], "--with-drafts", code=3)
