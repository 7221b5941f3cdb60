import json

import pytest
import typer
from typer.testing import CliRunner

from foon_kg.cli import similar
from foon_kg.cli.console import ErrorsAtTheEdge

TOSS = """# Source:\tdemo
O\tgreen olive\t1
S\twhole
O\tonion\t1
S\tchopped
O\tbowl\t0
S\tempty
M\tpour\tAssumed
O\tsalad\t0\t15
S\tcontains\t{green olive,onion}
S\tin\t[bowl]
//
"""


@pytest.fixture
def foon(tmp_path):
    app = typer.Typer(cls=ErrorsAtTheEdge)
    app.command()(similar.similar)
    app.callback()(lambda: None)
    (tmp_path / "toss.txt").write_text(TOSS, encoding="utf-8")
    return lambda *words: CliRunner().invoke(app, ["similar", *words, "--files", str(tmp_path), "-q"])


def test_json_is_one_object_a_name_best_first(foon):
    answer = foon("caper", "shallot", "--json")
    assert answer.exit_code == 0
    caper, shallot = map(json.loads, answer.stdout.splitlines())
    assert (caper["name"], shallot["name"]) == ("caper", "shallot")
    assert [other["name"] for other in caper["nearest"]] == ["green olive"]
    assert shallot["nearest"][0]["name"] == "onion"
    confidences = [other["confidence"] for other in caper["nearest"]]
    assert confidences == sorted(confidences, reverse=True)


def test_utensils_are_no_foods(foon):
    assert json.loads(foon("bowl", "--json", "--limit", "99").stdout) == {"name": "bowl", "nearest": []}


def test_where_nothing_is_like_a_word_that_is_said(foon):
    answer = foon("qwxyz")
    assert answer.exit_code == 0
    assert answer.stdout == "qwxyz: nothing like it is known\n"


def test_what_does_the_same_in_a_dish_is_told_with_as(foon):
    told = json.loads(foon("butter", "--as", "fat", "--json").stdout)
    assert told == {"name": "butter", "nearest": []}
    refused = foon("butter", "--as", "colour")
    assert refused.exit_code == 2
    assert "liquid" in refused.stderr


def test_the_limit_is_kept(foon):
    assert len(json.loads(foon("caper", "--json", "--limit", "1").stdout)["nearest"]) == 1


def test_people_are_told_why(foon):
    answer = foon("caper")
    assert "green olive" in answer.stdout
    assert "pickled and briny" in " ".join(answer.stdout.split())


def test_a_known_food_is_itself_whatever_it_is_called(foon):
    first = json.loads(foon("Onions", "--json").stdout)["nearest"][0]
    assert first == {"name": "onion", "confidence": 1.0}


def test_an_empty_name_is_wrong_usage(foon):
    answer = foon(" ")
    assert answer.exit_code == 2
    assert "hint" in answer.stderr


def test_an_unknown_pipeline_is_wrong_usage(foon):
    answer = foon("caper", "--vectors", "no_such_pipeline")
    assert answer.exit_code == 2
    assert answer.stdout == ""
