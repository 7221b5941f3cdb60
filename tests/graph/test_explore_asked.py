"""The queries for people as they are asked: by name, with parameters in words, one at a time, each on its page."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.cli.named_queries import command, explore_query, values
from foon_kg.cypher import catalogue, explore_queries
from foon_kg.model.errors import UsageError

PAGE = Path(__file__).parents[2] / "docs" / "explore.md"


def test_it_only_looks_at_the_graph():
    assert {query.name: query.mode for query in explore_queries() if query.mode != "read"} == {}
    assert explore_queries()


def test_every_parameter_has_an_example_or_a_default():
    for query in explore_queries():
        assert query.examples.keys() | query.defaults.keys() == query.parameters.keys(), query.name
        assert not query.examples.keys() & query.defaults.keys(), query.name


def test_the_page_of_the_docs_has_it_with_its_command():
    page = PAGE.read_text(encoding="utf-8")
    for query in explore_queries():
        assert f"## {query.name}\n\n{query.answers}\n" in page, query.name
        assert command(query) in page, query.name


def test_no_name_is_also_one_of_the_catalogue():
    assert not {query.name for query in explore_queries()} & {query.name for query in catalogue()}


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"food": "onion"}, "motion_on_food also asks for motion"),
        ({"food": "onion", "motion": "chop", "video": "x"}, "motion_on_food has no parameter video"),
    ],
)
def test_a_missing_and_an_unknown_parameter_are_named(given, says):
    with pytest.raises(UsageError, match=says) as told:
        values(explore_query("motion_on_food"), given)
    assert "foon cypher --name motion_on_food -P food=onion -P motion=chop" in told.value.hint


@pytest.mark.parametrize("text", ["x", "1.5", "true", "[1]", ""])
def test_a_number_must_be_one(text):
    with pytest.raises(UsageError, match="should be a whole number"):
        values(explore_query("central_objects"), {"most": text})


@pytest.mark.parametrize("text", ["onion, tomato", "onion,tomato", '["onion", "tomato"]'])
def test_words_may_be_written_as_a_list_or_with_commas(text):
    assert values(explore_query("dishes_with_foods"), {"foods": text}) == {"foods": ["onion", "tomato"]}


def test_a_text_stays_text_even_if_it_looks_like_a_number():
    assert values(explore_query("states_of_food"), {"food": "7"}) == {"food": "7"}


def test_an_unknown_name_is_answered_with_the_nearest():
    with pytest.raises(UsageError, match=r"no query is called central_object$") as told:
        explore_query("central_object")
    assert "central_objects" in told.value.hint


@pytest.mark.parametrize("words", [[], ["RETURN 1", "--list"], ["RETURN 1", "--name", "central_objects"]])
def test_one_question_at_a_time(words):
    answer = CliRunner().invoke(app, ["cypher", *words])
    assert answer.exit_code == 2
    assert "--name or --list" in answer.stderr


def test_the_list_has_every_query_as_json_too():
    answer = CliRunner().invoke(app, ["cypher", "--list", "--json"])
    assert [row["name"] for row in json.loads(answer.stdout)] == [query.name for query in explore_queries()]
    shown = CliRunner().invoke(app, ["cypher", "--list"])
    assert all(query.name in shown.stdout for query in explore_queries())
