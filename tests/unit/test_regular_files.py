"""What is no regular file is refused wherever a person names a file, and at once."""

from __future__ import annotations

import os
import socket
from pathlib import Path

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.model.regular_files import open_regular, read_bytes, read_text

FILES = ("--files", str(demo_folder()))  # else a command would start the Neo4j of whoever runs the tests
COMMANDS = {
    "plan": ("plan", "@", *FILES),
    "plan with a kitchen": ("plan", "--dish", "salad", "onion", "--kitchen", "@", *FILES),
    "check": ("check", "@", *FILES),
    "show": ("show", "@"),
    "a FOON of files": ("stats", "--files", "@"),
    "similar": ("similar", "caper", "--files", "@"),
}


@pytest.fixture(params=["pipe", "socket", "zero"])
def special(request, tmp_path):
    """The path of something that is no regular file."""
    if request.param == "zero":
        yield Path("/dev/zero")
        return
    path = tmp_path / "special.json"
    with socket.socket(socket.AF_UNIX) as listener:
        if request.param == "pipe":
            os.mkfifo(path)
        else:
            listener.bind(str(path))
        yield path


@pytest.mark.parametrize("read", [read_bytes, read_text, open_regular])
def test_what_is_no_regular_file_is_not_read(special, read):
    with pytest.raises(OSError, match=r"not a file|No such device"):
        read(special)


def test_a_file_is_read_whole_up_to_a_size(tmp_path):
    path = tmp_path / "some.txt"
    path.write_bytes(b"\xef\xbb\xbfone\r\ntwo")
    assert read_text(path) == "one\ntwo"
    assert read_bytes(path, most=11) == path.read_bytes()
    with pytest.raises(OSError, match="are the most"):
        read_bytes(path, most=10)


@pytest.mark.slow
@pytest.mark.parametrize("words", COMMANDS.values(), ids=COMMANDS)
def test_a_command_that_is_given_a_pipe_says_so_and_ends(tmp_path, words):
    pipe = tmp_path / "pipe.json"
    os.mkfifo(pipe)
    done = CliRunner().invoke(app, [str(pipe) if word == "@" else word for word in words])
    assert done.exit_code != 0
    assert pipe.name in done.output
