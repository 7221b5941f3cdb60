"""Videos taken out one by one: the truth is out of reach, and the answer depends on nothing but FOON and seed."""

from __future__ import annotations

import json

import pytest
from kitchen_stories import subgraph
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.evaluation.leave_one_out import asking_without
from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.evaluation.methods import METHODS, OURS, SameName
from foon_kg.evaluation.tree_overlap import Overlap
from foon_kg.loaders import write_text
from foon_kg.planning.batch import MANY
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()


def salad(name, food, cut="chop", cut_so="chopped"):
    """A salad of tomato and another food, which is cut."""
    return subgraph(
        name,
        "salad",
        f"{food}(whole); knife > {cut} > {food}({cut_so})",
        f"{food}({cut_so}); bowl(empty) > pour > bowl{{{food}}}",
        f"bowl{{{food}}}; tomato(whole) > place > bowl{{{food},tomato}}",
        f"bowl{{{food},tomato}} > mix > salad(mixed){{{food},tomato}}@in bowl",
    )


COMPARED = tuple(METHODS)
SALADS = (
    salad("onions", "onion"),
    salad("twin", "onion"),
    salad("carrots", "carrot", "slice", "sliced"),
    salad("leeks", "leek"),
)


def figures(video, foon, names=COMPARED):
    return asking_without(foon, KITCHEN, names)(left_out_video(video, KITCHEN))


def test_a_foon_without_a_video_teaches_what_the_others_teach():
    whole = Snapshot.of(SALADS, KITCHEN)
    for left_out in ("leeks", "twin", "no such video"):
        rest = Snapshot.of((one for one in SALADS if one.name != left_out), KITCHEN)
        without = whole.without(left_out)
        assert without == rest
        assert without.methods().frames == rest.methods().frames
        assert without.methods().goals == rest.methods().goals
        assert {frame.video for frame in without.methods().frames} == {one.name for one in rest.subgraphs}


def test_a_video_with_a_twin_is_its_own_nearest_recipe():
    found = figures(SALADS[0], SALADS)
    assert found.failed == {}
    assert found.overlaps["nearest recipe"] == Overlap(1, 1, 1, 1)
    assert all(each.units > 0 for each in found.overlaps.values())


def test_a_video_itself_is_not_in_the_foon_that_is_asked():
    found = figures(SALADS[2], SALADS, (OURS, "nearest recipe"))
    assert found.overlaps["nearest recipe"].units < 1


def test_no_method_finds_a_tree_where_the_only_video_is_left_out():
    found = figures(SALADS[0], SALADS[:1])
    assert set(found.failed) == set(COMPARED)
    assert {each.units for each in found.overlaps.values()} == {0.0}


def test_the_similarity_of_names_knows_no_other_food():
    similarity = SameName()
    assert similarity.matrix(["Onions", "leek"], ["onion", "garlic"]).tolist() == [[1, 0], [0, 0]]
    assert similarity.matrix(["leek"], []).shape == (1, 0)
    assert similarity.nearest("onions", ["leek", "onion"], limit=1)[0].name == "onion"
    assert (similarity.why("onions", "onion"), similarity.why("leek", "onion")) == (("the same food",), ())


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("foon")
    for video in (*SALADS, subgraph("pie", "pie", "apple(whole) > bake > pie{apple}")):
        (folder / f"{video.name}.txt").write_text(write_text(video), encoding="utf-8")
    return folder


def evaluate(folder, *arguments, jobs=1):
    words = ["evaluate", "leave-one-out", "--files", folder, "--jobs", jobs, *arguments]
    return CliRunner().invoke(app, list(map(str, words)))


@pytest.mark.slow
def test_figures_are_the_means_of_the_videos_and_a_comparison_with_itself_changes_nothing(folder, tmp_path):
    answer = evaluate(folder, "--json")
    assert answer.exit_code == 0, answer.output
    value = json.loads(answer.stdout)
    assert evaluate(folder, "--json").stdout_bytes == answer.stdout_bytes
    ours = value["dish_types"][-1]["methods"][OURS]["units"]["mean"]
    assert ours == pytest.approx(sum(video["units"] for video in value["videos"]) / 4, abs=1e-6)
    assert [video["id"] for video in value["videos"]] == ["carrots", "leeks", "onions", "twin"]
    assert [(dish["dish_type"], dish["goals"]) for dish in value["left_out"]] == [("pie", 1)]
    old = tmp_path / "old.json"
    old.write_bytes(answer.stdout_bytes)
    shown = evaluate(folder, "--compare", old)
    assert "nothing changed" in shown.stdout
    assert f"{100 * ours:.1f} %" in shown.stdout


@pytest.mark.slow
def test_two_processes_find_the_figures_that_one_finds(folder):
    assert len(SALADS) >= MANY  # of fewer they would be found in this process
    assert evaluate(folder, "--json", jobs=2).stdout_bytes == evaluate(folder, "--json").stdout_bytes


def test_a_sample_is_drawn_from_each_dish_type(folder):
    answer = json.loads(evaluate(folder, "--json", "--sample", 2, "--seed", 1).stdout)
    assert len(answer["videos"]) == 2


def test_a_dish_type_that_nobody_knows_is_refused_by_its_name(folder):
    answer = evaluate(folder, "--dish", "salat")
    assert (answer.exit_code, "“salat” is no dish type" in answer.stderr) == (2, True)


def test_a_dish_type_of_too_few_goals_has_nothing_to_leave_out(folder):
    answer = evaluate(folder, "--dish", "pie")
    assert answer.exit_code == 2
    assert "no video to leave out" in answer.stderr


@pytest.mark.slow
def test_a_run_that_was_stopped_goes_on_where_it_ended_and_answers_the_same_bytes(folder, tmp_path):
    kept = tmp_path / "videos.jsonl"
    whole = evaluate(folder, "--json").stdout_bytes
    assert evaluate(folder, "--json", "--output", kept).stdout_bytes == whole
    lines = kept.read_bytes()
    kept.write_bytes(lines[: len(lines) * 2 // 3])  # killed in the middle of a line
    gone_on = evaluate(folder, "--json", "--output", kept)
    assert gone_on.stdout_bytes == whole
    assert "answers already" in gone_on.stderr
    assert kept.read_bytes() == lines


def test_a_file_of_another_run_is_refused(folder, tmp_path):
    kept = tmp_path / "videos.jsonl"
    evaluate(folder, "--output", kept)
    before = kept.read_bytes()
    for other in (["--sample", "1", "--seed", "3"],):
        answer = evaluate(folder, "--output", kept, *other)
        assert answer.exit_code == 2
        assert "another" in answer.stderr
        assert kept.read_bytes() == before
