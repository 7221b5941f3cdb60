"""Work on a real Dask cluster of two workers on this machine: the same answers as here, in the same order."""

from __future__ import annotations

import pytest
from extras import needs
from typer.testing import CliRunner

from foon_kg import Foon
from foon_kg.cli import app
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.model.errors import UsageError
from foon_kg.planning.batch import Question
from foon_kg.planning.cluster import spread_over
from foon_kg.planning.settings import PlanSettings
from foon_kg.store.graph import load

pytestmark = [pytest.mark.slow, needs("distributed")]


@pytest.fixture(scope="module")
def address():
    from distributed import LocalCluster

    settings = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": ":0"}
    with LocalCluster(host="127.0.0.1", **settings) as cluster:
        yield cluster.scheduler_address


class Adding:
    """Adds what it was made with, and counts how often it was made: by each worker once."""

    made = 0

    def __init__(self, number=100):
        self.number = number
        Adding.made += 1

    def __call__(self, item):
        if item < 0:
            raise UsageError(f"{item} is below zero")
        return item + self.number, Adding.made


def test_answers_come_in_the_order_of_the_items_and_every_worker_makes_its_tools_once(address):
    with spread_over(Adding, range(50), address) as answers:
        found = list(answers)
    assert [number for number, _ in found] == list(range(100, 150))
    assert {made for _, made in found} == {1}


def test_what_the_work_raises_is_raised_here(address):
    with spread_over(Adding, [1, -2], address) as answers, pytest.raises(UsageError, match="-2 is below zero"):
        list(answers)


def evaluate(*arguments):
    answer = CliRunner().invoke(app, ["evaluate", *map(str, arguments), "--files", str(demo_folder()), "--json"])
    assert answer.exit_code == 0, answer.output
    return answer.stdout_bytes


def test_recipes_get_the_same_bytes_from_a_cluster(address):
    recipes = sorted(demo_recipes())[:5]
    assert evaluate("recipes", *recipes, "--dask", address) == evaluate("recipes", *recipes, "--jobs", 1)


def test_left_out_videos_get_the_same_bytes_from_a_cluster(address):
    asked = ("leave-one-out", "--dish", "salad")
    assert evaluate(*asked, "--dask", address) == evaluate(*asked, "--jobs", 1)


@pytest.mark.neo4j
def test_of_a_large_foon_each_worker_asks_the_graph_and_nobody_reads_the_whole(address, connection, monkeypatch):
    load(connection, demo_subgraphs())
    asked = [Question(path=path) for path in sorted(demo_recipes())[:5]]
    with Foon(server=connection.settings) as foon, foon.answers(asked, PlanSettings(), jobs=1) as answers:
        expected = [answer.outcome for answer in answers]
    monkeypatch.setattr("foon_kg.foon.answering.WHOLE", 0)
    monkeypatch.setattr("foon_kg.store.graph.Neo4jGraph.snapshot", None)
    with Foon(server=connection.settings) as foon, foon.answers(asked, PlanSettings(), dask=address) as answers:
        assert [answer.outcome for answer in answers] == expected


def test_a_scheduler_that_does_not_answer_is_named(monkeypatch):
    monkeypatch.setattr("foon_kg.planning.cluster.PATIENCE", 0.2)
    asked = ["evaluate", "leave-one-out", "--files", str(demo_folder()), "--dask", "tcp://127.0.0.1:9"]
    answer = CliRunner().invoke(app, asked)
    assert answer.exit_code == 2
    assert "no Dask scheduler answers at tcp://127.0.0.1:9" in answer.stderr


def test_a_scheduler_without_workers_is_told():
    from distributed import LocalCluster

    nobody = LocalCluster(n_workers=0, host="127.0.0.1", dashboard_address=":0")
    refused = pytest.raises(UsageError, match="has no workers")
    with nobody as cluster, refused, spread_over(Adding, [1], cluster.scheduler_address):
        pass
