"""Whenever a program is killed that puts one folder of data in the place of another, one of the two is there, whole."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from foon_kg.store.server.exchange import exchange, restore
from foon_kg.store.server.home import Home

FILES = ("databases/neo4j/neostore", "databases/system/neostore", "transactions/neo4j/log.0")


class KilledError(BaseException):
    """What no program catches."""


def filled(root, content):
    home = Home(root)
    for name in FILES:
        file = home.data / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content, encoding="utf-8")
    return home


def contents(home):
    return {(home.data / name).read_text(encoding="utf-8") for name in FILES}


def killed_at(patch, number, *, after):
    """Let the program be killed at the step of that number on the disk, before it or ``after`` it."""
    steps = []

    def counted(step):
        def run(*words, **named):
            steps.append(step)
            if len(steps) > number:
                if after:
                    step(*words, **named)
                raise KilledError
            return step(*words, **named)

        return run

    patch.setattr(Path, "rename", counted(Path.rename))
    patch.setattr(shutil, "rmtree", counted(shutil.rmtree))


@pytest.mark.parametrize("after", [False, True])
@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_kill_leaves_the_old_graph_or_the_new_one(tmp_path, number, after):
    place, made = filled(tmp_path / "place", "old"), filled(tmp_path / "made", "new")
    with pytest.MonkeyPatch.context() as patch:
        killed_at(patch, number, after=after)
        with pytest.raises(KilledError):
            exchange(place, made)
    restore(place)
    assert contents(place) == ({"new"} if number == 2 or (number == 1 and after) else {"old"})
    assert not place.data_before.exists()


def test_a_kill_while_the_old_data_are_taken_away_leaves_the_new_graph(tmp_path):
    place, made = filled(tmp_path / "place", "old"), filled(tmp_path / "made", "new")
    exchange(place, made)
    half = place.data_before / FILES[0]
    half.parent.mkdir(parents=True)
    half.write_text("old", encoding="utf-8")
    restore(place)
    assert contents(place) == {"new"}
    assert not place.data_before.exists()


def test_a_home_without_data_gets_those_that_were_made(tmp_path):
    place, made = Home(tmp_path / "place"), filled(tmp_path / "made", "new")
    place.root.mkdir()
    exchange(place, made)
    assert contents(place) == {"new"}
