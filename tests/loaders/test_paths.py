from __future__ import annotations

import os
from pathlib import Path

import pytest

from foon_kg.loaders import NoticeKind, ReadResult, Severity, read_path, read_paths, read_text, write_json, write_text
from foon_kg.model.errors import ReadError

UNIT = "O\tonion\t1\nM\tchop\nO\tonion\t0\nS\tchopped\n//\n"
OTHER = UNIT.replace("onion", "carrot")


def write(path: Path, text: str | bytes) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def as_json(text: str) -> str:
    subgraph = read_text(text, "any").subgraph
    assert subgraph is not None
    return write_json(subgraph)


def names(results: list[ReadResult]) -> list[str | None]:
    return [result.subgraph.name if result.subgraph else None for result in results]


def test_a_folder_gives_its_files_at_any_depth_by_name(tmp_path: Path):
    write(tmp_path / "b" / "0001-z.txt", UNIT)
    write(tmp_path / "a" / "deep" / "0003.x.JSON", as_json(UNIT))
    write(tmp_path / "0002.TXT", UNIT)
    write(tmp_path / "LICENSE", "free")
    write(tmp_path / "picture.png", b"\x89")
    write(tmp_path / ".hidden.txt", UNIT)
    write(tmp_path / ".git" / "0004.txt", UNIT)
    results = list(read_path(tmp_path))
    assert names(results) == ["0001-z", "0002", "0003.x"]
    assert [result.notices for result in results] == [(), (), ()]
    assert results[0].path == str(tmp_path / "b" / "0001-z.txt")


def test_the_order_of_the_paths_does_not_matter(tmp_path: Path):
    one, two = write(tmp_path / "x" / "1.txt", UNIT), write(tmp_path / "2.txt", OTHER)
    assert list(read_paths([two, one, tmp_path])) == list(read_paths([tmp_path / "x", two]))


def test_one_bad_file_does_not_stop_the_others(tmp_path: Path):
    write(tmp_path / "1.txt", b"O\tegg\t1\r\nS\tsm\xe9\t\n")
    write(tmp_path / "2.json", "[")
    write(tmp_path / "3.txt", UNIT)
    first, second, third = read_path(tmp_path)
    assert (first.subgraph, second.subgraph) == (None, None)
    assert third.subgraph is not None
    assert [str(notice) for notice in (*first.notices, *second.notices)] == [
        f"{tmp_path / '1.txt'}:2: byte 13 (0xe9) is not UTF-8: file rejected",
        f"{tmp_path / '2.json'}:1: not JSON: Expecting value: file rejected",
    ]


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-32"])
def test_another_encoding_is_refused_with_its_byte(tmp_path: Path, encoding: str):
    (result,) = read_path(write(tmp_path / "1.txt", UNIT.encode(encoding)))
    assert result.subgraph is None
    assert [(n.line, n.kind, n.severity) for n in result.notices] == [
        (1, NoticeKind.UNREADABLE_FILE, Severity.REJECTED)
    ]
    assert "byte " in result.notices[0].message


def test_a_control_character_is_refused_with_line_and_byte(tmp_path: Path):
    (result,) = read_path(write(tmp_path / "1.txt", "O\tä\t1\r\nS\ta\x07b\n"))
    assert [str(notice) for notice in result.notices] == [
        f"{tmp_path / '1.txt'}:2: byte 11 is the control character U+0007: file rejected"
    ]


@pytest.mark.parametrize(("name", "text"), [("1.txt", UNIT), ("1.json", as_json(UNIT))])
def test_a_byte_order_mark_is_left_out_and_reported(tmp_path: Path, name: str, text: str):
    plain, marked = write(tmp_path / "a" / name, text), write(tmp_path / "b" / name, "\ufeff" + text)
    (expected,), (result,) = read_path(plain), read_path(marked)
    assert result.subgraph == expected.subgraph
    assert [(n.line, n.kind) for n in result.notices] == [(1, NoticeKind.BYTE_ORDER_MARK)]


def test_of_two_files_of_one_video_the_text_counts_and_the_other_is_rejected(tmp_path: Path):
    write(tmp_path / "TXT" / "1.txt", UNIT)
    write(tmp_path / "JSON" / "1.json", as_json(OTHER))
    text, other = read_path(tmp_path)
    assert text.subgraph == read_text(UNIT, "1").subgraph
    assert text.notices == ()
    assert other.subgraph is None
    assert [(n.kind, n.severity) for n in other.notices] == [(NoticeKind.SAME_VIDEO, Severity.REJECTED)]
    assert text.path in other.notices[0].message


def test_two_files_that_say_the_same_are_read_once(tmp_path: Path):
    write(tmp_path / "1.txt", UNIT)
    write(tmp_path / "1.json", as_json(UNIT))
    text, other = read_path(tmp_path)
    assert text.subgraph is not None
    assert other.subgraph is None
    assert [(n.kind, n.severity) for n in other.notices] == [(NoticeKind.SAME_VIDEO, Severity.ASSUMED)]


def test_of_two_files_of_one_video_a_broken_text_does_not_hide_the_json(tmp_path: Path):
    write(tmp_path / "1.txt", "nothing")
    write(tmp_path / "1.json", as_json(UNIT))
    text, other = read_path(tmp_path)
    assert text.subgraph is None
    assert other.subgraph is not None
    assert other.subgraph.name == "1"


def test_a_path_that_is_not_there_is_an_error(tmp_path: Path):
    with pytest.raises(ReadError, match="no such file or folder"):
        read_path(tmp_path / "nowhere")


def test_a_folder_without_foon_files_is_an_error(tmp_path: Path):
    write(tmp_path / "notes.md", "hello")
    with pytest.raises(ReadError, match="no FOON file in this folder"):
        read_path(tmp_path)


def test_a_file_that_is_named_and_is_no_text_or_json_is_an_error(tmp_path: Path):
    with pytest.raises(ReadError, match=r"neither \*.txt nor \*.json"):
        read_path(write(tmp_path / "notes.md", "hello"))


def test_a_file_that_cannot_be_opened_is_reported(tmp_path: Path):
    (tmp_path / "1.txt").symlink_to(tmp_path / "nowhere")
    (result,) = read_path(tmp_path)
    assert [n.message for n in result.notices] == ["cannot be opened: No such file or directory"]


def test_a_file_name_that_is_not_utf_8_is_reported(tmp_path: Path):
    path = os.fsencode(tmp_path) + b"/\xff.txt"
    try:
        Path(os.fsdecode(path)).write_text(UNIT)
    except OSError as error:
        pytest.skip(f"this file system keeps no such names: {error}")
    (result,) = read_path(tmp_path)
    assert result.subgraph is None
    assert [n.file for n in result.notices] == [f"{tmp_path}/\\xff.txt"]


def test_what_was_written_to_files_is_read_back(tmp_path: Path):
    (result,) = read_path(write(tmp_path / "salad.txt", UNIT + OTHER))
    assert result.subgraph is not None
    write(tmp_path / "again" / "salad.txt", write_text(result.subgraph))
    (again,) = read_path(tmp_path / "again")
    assert again.subgraph == result.subgraph
