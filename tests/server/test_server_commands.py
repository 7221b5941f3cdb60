import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli.server import app


@pytest.fixture
def foon(monkeypatch, tmp_path):
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "home"))
    return lambda *words: CliRunner().invoke(app, words)


def test_status_of_a_server_that_never_ran_says_where_it_would_keep_its_things(foon, tmp_path):
    answer = foon("status", "--json")
    assert answer.exit_code == 0
    told = json.loads(answer.stdout)
    assert told["running"] is False
    assert told["data"] == str(tmp_path / "home" / "data")
    assert told["idle_minutes"] == 30
    assert not (tmp_path / "home").exists()
    assert "is not running" in foon("status").stdout


def test_stopping_what_does_not_run_is_no_error(foon, tmp_path):
    assert foon("stop").exit_code == 0
    assert json.loads(foon("stop", "--json").stdout) == {"stopped": False}
    assert not (tmp_path / "home").exists()


@pytest.mark.parametrize("words", [("start", "--port", "80"), ("start", "--idle", "-1"), ("begin",)])
def test_what_cannot_be_meant_is_wrong_usage(foon, words):
    assert foon(*words).exit_code == 2


def test_an_error_is_a_line_and_a_hint(foon, monkeypatch, tmp_path):
    (tmp_path / "file").touch()
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "file" / "home"))
    answer = foon("start")
    assert answer.exit_code == 1
    assert str(tmp_path / "file" / "home") in answer.stderr
    assert "FOON_KG_HOME names another folder" in answer.stderr
    assert answer.stdout == ""
