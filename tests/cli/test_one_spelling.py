"""A name with accents is one, whether they are parts of their letters (NFC) or stand behind them (NFD)."""

from __future__ import annotations

import json
import shutil
import unicodedata

import pytest
from cli.test_read_and_written import TABLE
from contract.test_drafts import COOKIE
from typer.testing import CliRunner

from foon_kg import Foon
from foon_kg.cli import app
from foon_kg.cli.exported_trees import read_exported_trees
from foon_kg.cli.tree_files import read_trees
from foon_kg.evaluation.reading import names_in
from foon_kg.foon.demo import demo_folder
from foon_kg.language.recipe_text import read_narration
from foon_kg.loaders import read_paths
from foon_kg.loaders.draft_tables import read_draft
from foon_kg.loaders.video_tables import read_video_text
from foon_kg.model import Recipe, Subgraph
from foon_kg.model.collected import CollectedRecipe
from foon_kg.model.drafted import DraftedRecipe
from foon_kg.model.nodes import name_of_file, one_spelling
from foon_kg.planning.batch import Question
from foon_kg.planning.settings import PlanSettings

NAME = "crème_brûlée"
FORMS = [unicodedata.normalize(form, NAME) for form in ("NFC", "NFD")]
VIDEO = (demo_folder() / "greek_salad.txt").read_text(encoding="utf-8")
RECIPE = {
    "type": "salad",
    "ingredients": [{"object": "onion", "state": "chopped"}, {"object": "olive oil", "state": ""}],
}


def foon(*words):
    ran = CliRunner().invoke(app, list(map(str, words)))
    return ran.exit_code, ran.stdout, ran.stderr


def test_both_forms_are_one_name():
    assert len(set(FORMS)) == 2
    assert {one_spelling(name) for name in FORMS} == {FORMS[0]}
    assert one_spelling(one_spelling(FORMS[1])) == FORMS[0]


@pytest.mark.parametrize("name", FORMS, ids=["NFC", "NFD"])
def test_what_is_read_of_a_file_has_the_one_name(name, tmp_path):
    video, words, recipe, draft = (tmp_path / f"{name}{ending}" for ending in (".txt", ".md", ".json", ".csv"))
    video.write_text(VIDEO, encoding="utf-8")
    words.write_text("Chop the onion.\nServe the onion.\n", encoding="utf-8")
    recipe.write_text(json.dumps(RECIPE), encoding="utf-8")
    draft.write_text(COOKIE.table, encoding="utf-8")
    read = {
        "name_of_file": name_of_file(video),
        "load": next(read_paths([video])).subgraph.name,
        "check": next(read_trees(video)).tree.name,
        "export": read_exported_trees(video, print)[0].name,
        "draft text": read_narration(words, print).name,
        "draft table": read_draft(draft).subgraph.name,
        "recipe": Question(recipe).stand_in.id,
    }
    assert set(read.values()) == {FORMS[0]}, read


@pytest.mark.parametrize("name", FORMS, ids=["NFC", "NFD"])
def test_what_is_named_in_a_file_or_asked_has_the_one_name(name, tmp_path):
    key = tmp_path / "read.json"
    key.write_text(json.dumps([name]), encoding="utf-8")
    head, *rows = TABLE.splitlines()
    table = "\n".join([f"video,{head}", *(f"{name},{row}" for row in rows)])
    named = [
        Subgraph(name, ()).name, Recipe("salad", (), name).id, CollectedRecipe(name, "", (), "").id,
        DraftedRecipe(name, "", "", "").id, PlanSettings(after=name).after, *names_in(key),
        read_video_text(table, "other")[0].subgraph.name,
    ]  # fmt: skip
    assert set(named) == {FORMS[0]}


@pytest.mark.parametrize("name", FORMS, ids=["NFC", "NFD"])
def test_a_dish_is_made_after_the_video_of_either_form(name, tmp_path):
    shutil.copytree(demo_folder(), tmp_path / "videos")
    (tmp_path / "videos" / "greek_salad.txt").rename(tmp_path / "videos" / f"{FORMS[1]}.txt")
    plan = Foon.from_files(tmp_path / "videos").plan("salad", ["chopped onion", "olive oil"], after=name)
    assert plan.to_json()["reference"]["videos"][0] == FORMS[0]


def test_two_files_of_one_name_are_two_of_one_video(tmp_path):
    for folder, name in zip("ab", FORMS, strict=True):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / f"{name}.txt").write_text(VIDEO, encoding="utf-8")
    read = list(read_paths([tmp_path / "a", tmp_path / "b"]))
    assert [one.subgraph.name for one in read if one.subgraph is not None] == [FORMS[0]]


def test_answers_are_there_already_though_the_file_of_the_recipe_is_spelled_otherwise(tmp_path):
    out, (first, second) = tmp_path / "plans.jsonl", (tmp_path / f"{name}.json" for name in FORMS)
    second.write_text(json.dumps(RECIPE), encoding="utf-8")
    asked = ("--files", demo_folder(), "--output", out)
    assert foon("plan", second, *asked)[0] == 0
    written = out.read_bytes()
    second.rename(first)
    code, _, said = foon("plan", first, *asked)
    assert (code, "has 1 of 1 answers already" in said) == (0, True)
    assert out.read_bytes() == written


@pytest.mark.neo4j
def test_videos_and_recipes_of_the_graph_are_found_by_either_form(empty_graph, tmp_path):
    for stored, typed in (FORMS, reversed(FORMS)):
        video, recipe = tmp_path / f"{stored}.txt", tmp_path / "recipes.json"
        video.write_text(VIDEO, encoding="utf-8")
        recipe.write_text(json.dumps([RECIPE | {"id": stored, "title": "x"}]), encoding="utf-8")
        assert foon("load", "foon", video)[0] == 0
        assert foon("load", "recipes", recipe)[0] == 0
        assert foon("recipes", "--id", typed, "--json")[0] == 0
        code, said, why = foon("remove", typed, "--json")
        assert (code, FORMS[0] in said) == (0, True), why
        video.unlink()
