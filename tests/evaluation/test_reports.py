"""The reports of both evaluations in a real Chromium: nothing is fetched or refused, and figures are those of JSON."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import pytest
from chromium import chromium
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.evaluation.figures import RecipeEvaluation, RecipeFigures
from foon_kg.evaluation.resampling import Interval
from foon_kg.evaluation.scores import without_tree
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import UsageError
from foon_kg.model.written_files import check_place

pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
from foon_kg.formats.pictures.charts import curve_chart, histogram_chart, interval_chart
from foon_kg.formats.pictures.recipes_report import recipes_report, worst

COLD = [path for path in sorted(demo_recipes()) if not path.stem.endswith(("omelette", "soup"))][:4]


def evaluate(report, *arguments):
    places = ["--files", str(demo_folder()), "--jobs", "1", "--html", str(report), "--json"]
    answer = CliRunner().invoke(app, ["evaluate", *map(str, arguments), *places])
    assert answer.exit_code == 0, answer.output
    return json.loads(answer.stdout)


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    """Both reports, and what JSON says in the same runs."""
    folder = tmp_path_factory.mktemp("reports")
    recipes, videos = folder / "recipes.html", folder / "videos.html"
    found = evaluate(recipes, "recipes", *COLD)
    return {recipes: found, videos: evaluate(videos, "leave-one-out", "--sample", 1)}


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    with chromium(tmp_path_factory.mktemp("profile")) as driver:
        yield driver


def every(value):
    return value["dish_types"][-1]


@pytest.mark.slow
def test_the_report_of_recipes_says_what_json_says_and_shows_a_tree_for_each_of_the_worst(reports):
    (path, value), _ = reports.items()
    html = path.read_text(encoding="utf-8")
    assert f"<b>{100 * every(value)['correct']['mean']:.1f} %</b>" in html
    assert html.count('<div class="tree"') == html.count("<summary>") == len(value["recipes"])
    for recipe in value["recipes"]:
        assert recipe["id"] in html
    accepted = every(value)["accepted"]
    assert f"<b>{accepted} ({100 * accepted / every(value)['recipes']:.1f} %)</b>" in html
    for rule in every(value)["rules"]:
        assert f"<td>{rule}</td>" in html


@pytest.mark.slow
def test_the_report_of_videos_shows_both_trees_of_each_of_the_worst(reports):
    _, (path, value) = reports.items()
    html = path.read_text(encoding="utf-8")
    for method, figures in every(value)["methods"].items():
        assert method in html
        assert f"{100 * figures['units']['mean']:.1f} %" in html
    shown = html.count("<summary>")
    assert 0 < shown <= 10
    assert html.count('<div class="tree"') == 2 * shown


@pytest.mark.slow
def test_a_report_is_the_same_to_the_byte(reports, tmp_path):
    (path, _), _ = reports.items()
    evaluate(tmp_path / "again.html", "recipes", *reversed(COLD))
    assert (tmp_path / "again.html").read_bytes() == path.read_bytes()


def test_chromium_fetches_and_refuses_nothing_and_no_page_is_wider_than_the_screen(reports, browser):
    for path in reports:
        browser.get(path.as_uri())
        assert browser.get_log("browser") == []
        assert browser.execute_script("return performance.getEntriesByType('resource').length") == 0
        for width in (360, 1200):
            screen = {"width": width, "height": 700, "deviceScaleFactor": 1, "mobile": False}
            browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
            browser.execute_script("document.querySelectorAll('details').forEach(one => { one.open = true })")
            assert browser.execute_script("return document.documentElement.scrollWidth") <= width
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


@pytest.mark.slow
def test_every_picture_has_arrow_heads_of_its_own(reports):
    for path in reports:
        heads = re.findall(r'<marker id="([^"]+)"', path.read_text(encoding="utf-8"))
        assert heads
        assert len(heads) == len(set(heads))


def test_a_tree_is_folded_until_its_summary_is_clicked(reports, browser):
    path = next(iter(reports))
    browser.get(path.as_uri())
    tree = browser.find_element("css selector", "details .tree")
    assert not tree.is_displayed()
    browser.find_element("css selector", "summary").click()
    assert tree.is_displayed()


def test_charts_draw_what_they_are_given():
    curve = curve_chart({"salad": {0: 1.0, 50: 0.5, 100: 0.0}}, "title", "correct", "recipes")
    assert "salad: 50 % at 50 %" in curve
    heights = [float(y) for _, y in re.findall(r'cx="([\d.]+)" cy="([\d.]+)"', curve)]
    assert heights == sorted(heights)
    assert heights[1] == pytest.approx((heights[0] + heights[2]) / 2)
    bars = [float(h) for h in re.findall(r'height="([\d.]+)" fill', histogram_chart([1, 4, 0, 2], "t", "x"))]
    assert bars == pytest.approx([max(bars) * count / 4 for count in (1, 4, 0, 2)], abs=0.2)
    means = interval_chart([("ours", Interval(0.9, 0.85, 0.95)), ("theirs", Interval(0.8, 0.75, 0.85))], "title")
    assert "ours: 90.0 % [85.0, 95.0]" in means
    assert ">70 %<" in means
    assert ">0 %<" not in means


def test_hostile_names_stay_words_and_the_worst_are_those_with_a_tree():
    recipe = Recipe("salad", (RequiredIngredient("<script>x</script>", "raw"),), id='"><img src=x>')
    failed = RecipeFigures(recipe, without_tree(recipe.ingredients), error="<b>no</b>")
    html = recipes_report(RecipeEvaluation("key", 0, (failed,)))
    assert "<script" not in html
    assert "<img" not in html
    assert "&lt;b&gt;no&lt;/b&gt;" in html
    assert worst((failed, replace(failed, error=""))) == ()


def test_a_place_is_refused_that_lies_in_no_folder(tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    for place, why in (("file/report", "Not a directory"), ("none/report", "No such file"), (".", "Is a directory")):
        with pytest.raises(UsageError, match=why):
            check_place(tmp_path / place, "Name another.")
    for place in ("file", "new"):
        check_place(tmp_path / place, "Name another.")
    assert not (tmp_path / "new").exists()


@pytest.mark.parametrize("asked", [["recipes", "--html"], ["recipes", "--scores-to"], ["leave-one-out", "--html"]])
def test_a_place_that_cannot_be_written_is_refused_before_anything_is_planned(tmp_path, asked):
    # no FOON is there either: that is told first where planning had begun
    places = (str(tmp_path / "not there" / "report"), "--files", str(tmp_path / "no foon"))
    done = CliRunner().invoke(app, ["evaluate", *asked, *places])
    assert done.exit_code == 2
    assert "cannot be written: No such file or directory" in done.stderr
    assert f"{asked[-1]} names a file that can be written" in done.stderr
