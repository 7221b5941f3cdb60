"""EPIC-KITCHENS-100, ActivityNet Captions and YouCook2 files: what they tell, and what is wrong with broken ones."""

from __future__ import annotations

import json
import tracemalloc

import pytest
from drafting.kitchen_foon import EPIC_ROWS, YOUCOOK, activitynet, epic
from hypothesis import given, settings
from hypothesis import strategies as st

from foon_kg.loaders.captions import is_captions, read_captions
from foon_kg.loaders.epic_kitchens import is_epic_kitchens, read_epic_kitchens
from foon_kg.loaders.json_document import stream_fields
from foon_kg.loaders.narrations import is_narrated, read_narrations
from foon_kg.loaders.notices import NoticeKind, UnreadableFile
from foon_kg.loaders.text_blocks import text_blocks
from foon_kg.model import Timing
from foon_kg.model.errors import ReadError
from foon_kg.model.narration import Mention, Place


def actions(*rows):
    (narration,) = read_epic_kitchens(epic(*rows), "epic.csv").narrations
    return narration.actions


def notices(*rows):
    return [(one.line, one.kind) for one in read_epic_kitchens(epic(*rows), "epic.csv").notices]


def test_a_row_is_an_action_with_its_roles_and_its_time():
    peel, chop, put = actions()
    assert (peel.verb, peel.objects, peel.timing) == ("peel", (Mention("onion"),), Timing(((1.0, 3.5),)))
    assert (chop.objects, chop.instruments) == ((Mention("onion"),), ("knife",))
    assert put.places == (Place("into", "bowl"),)
    assert put.said == "put onion into bowl"


def test_a_noun_with_its_kind_is_said_as_people_say_it():
    (action,) = actions("1,v,,,pour oil,pour,oil:olive,['oil:olive']")
    assert action.objects == (Mention("olive oil"),)
    (action,) = actions("1,v,,,pour it,pour,liquid:washing:up,['liquid:washing:up']")
    assert action.objects == (Mention("washing up liquid"),)


def test_a_noun_without_a_word_is_passed_over():
    (action,) = actions("1,v,,,chop onion,chop,onion,\"['onion', '_', ' : ', 'board']\"")
    assert action.objects == (Mention("onion"), Mention("board"))


def test_actions_come_by_their_start_and_without_time_behind_the_one_before():
    rows = ("1,v,00:00:09,00:00:10,a,chop,a,['a']", "2,v,,,b,chop,b,['b']", "3,v,00:00:01,00:00:02,c,chop,c,['c']")
    assert [action.said for action in actions(*rows)] == ["c", "a", "b"]


@pytest.mark.parametrize(
    ("row", "kind"),
    [
        ("1,v,,,,,,", NoticeKind.NO_NARRATION),
        ("1,v,,,chop it,,it,", NoticeKind.UNIT_WITHOUT_MOTION),
        ("1,../../etc/passwd,,,chop it,chop,it,", NoticeKind.ODD_NAME),
        ("1,,,,chop it,chop,it,", NoticeKind.ODD_NAME),
        ("1,v,-00:00:01,00:00:02,chop,chop,onion,", NoticeKind.ODD_TIME),
        ("1,v,00:00:05,00:00:02,chop,chop,onion,", NoticeKind.ODD_TIME),
        ("1,v,soon,later,chop,chop,onion,", NoticeKind.ODD_TIME),
        ("1,v,,,chop,chop,onion,['onion'", NoticeKind.BAD_FIELD),
        ("1,v,,,chop,chop,onion,__import__('os')", NoticeKind.BAD_FIELD),
        ("1,v,,,chop,chop,onion," + "[" * 500, NoticeKind.BAD_FIELD),
    ],
)
def test_what_is_wrong_with_a_row_is_told_with_its_line(row, kind):
    assert {found for line, found in notices(row) if line == 2} == {kind}


def test_a_quote_that_never_ends_rejects_the_table():
    assert notices('1,v,,,"chop') == [(2, NoticeKind.UNREADABLE_FILE)]


@pytest.mark.slow
@given(st.text())
def test_any_text_under_the_header_is_read_or_told(text):
    found = read_epic_kitchens(epic(text), "epic.csv")
    assert all(narration.actions for narration in found.narrations)


@pytest.fixture
def captions(tmp_path):
    def read(text):
        path = tmp_path / "captions.json"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return read_captions(path)

    return read


def test_both_forms_of_captions_give_sentences_with_times(captions):
    (soup,) = captions(activitynet()).narrations
    assert [(one.text, one.timing.spans) for one in soup.sentences] == [
        ("Peel an onion.", ((0.0, 4.5),)),
        ("Chop it.", ((5.0, 9.0),)),
    ]
    (video,) = captions(json.dumps(YOUCOOK)).narrations
    assert video.name == "GLd3aX16zBg"
    assert [one.text for one in video.sentences] == ["peel the onion", "chop the onion on a cutting board"]


@pytest.mark.parametrize(
    ("value", "kind", "sentences"),
    [
        (5, NoticeKind.BAD_FIELD, 0),
        ({"sentences": "Chop.", "timestamps": []}, NoticeKind.BAD_FIELD, 0),
        ({"sentences": [7, "Chop."], "timestamps": [[0, 1], [1, 2]]}, NoticeKind.NO_NARRATION, 1),
        ({"sentences": ["  ", "Chop."], "timestamps": [[0, 1], [1, 2]]}, NoticeKind.NO_NARRATION, 1),
        ({"sentences": ["Chop \ud83d", "Chop."], "timestamps": [[0, 1], [1, 2]]}, NoticeKind.NO_NARRATION, 1),
        ({"sentences": ["Chop.\0", "Chop."], "timestamps": [[0, 1], [1, 2]]}, NoticeKind.NO_NARRATION, 1),
        ({"sentences": ["Chop."], "timestamps": []}, NoticeKind.ODD_TIME, 1),
        ({"sentences": ["Chop."], "timestamps": [[4, 2]]}, NoticeKind.ODD_TIME, 1),
        ({"sentences": ["Chop."], "timestamps": [[-4, 2]]}, NoticeKind.ODD_TIME, 1),
        ({"sentences": ["Chop."], "timestamps": [["0", True]]}, NoticeKind.ODD_TIME, 1),
        ({"annotations": ["chop"]}, NoticeKind.NO_NARRATION, 0),
    ],
)
def test_what_is_wrong_with_a_video_is_told_and_the_rest_kept(captions, value, kind, sentences):
    found = captions(json.dumps({"v": value}))
    assert found.notices[0].kind is kind
    assert "video v" in found.notices[0].message
    assert sum(len(narration.sentences) for narration in found.narrations) == sentences


ONE = {"sentences": ["Chop."], "timestamps": [[0, 1]]}


def test_a_broken_file_gives_nothing_and_is_told_with_its_line(captions):
    whole = json.dumps({"first": ONE, "second": ONE}, indent=1)
    for text in (whole[:-40], whole + "]", whole.replace('"second": {', '"second": '), whole.encode() + b"\xff"):
        found = captions(text)
        assert found.narrations == ()
        (broken,) = [notice for notice in found.notices if notice.kind is NoticeKind.UNREADABLE_FILE]
        assert broken.line >= 9


def test_a_field_that_is_there_twice_is_refused(captions):
    text = '{"v": {"sentences": ["a"], "sentences": ["b"], "timestamps": []}}'
    assert "is there twice" in captions(text).notices[0].message


def test_a_video_named_like_a_path_or_like_another_is_refused(captions):
    found = captions(f'{{"../x": {json.dumps(ONE)}, "v": {json.dumps(ONE)}, "v": {json.dumps(ONE)}}}')
    assert [notice.kind for notice in found.notices] == [NoticeKind.ODD_NAME, NoticeKind.SAME_VIDEO]
    assert [narration.name for narration in found.narrations] == ["v"]


@pytest.mark.slow
def test_captions_of_any_length_are_read_in_bounded_memory(captions):
    sentence = {"sentences": ["Chop the onion very finely. " * 20], "timestamps": [[0, 1]]}
    text = json.dumps({f"v{number}": sentence for number in range(2_500)})
    assert len(text) > 1_250_000
    found = captions(text)
    tracemalloc.start()
    assert sum(len(narration.sentences) for narration in found.narrations) == 2_500
    assert tracemalloc.get_traced_memory()[1] < 900_000
    tracemalloc.stop()


PLAIN = st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | st.text()
DOCUMENTS = st.dictionaries(
    st.text(max_size=3) | st.just("in"),
    PLAIN | st.lists(PLAIN, max_size=3) | st.dictionaries(st.text(max_size=3), PLAIN, max_size=3),
    min_size=1,
    max_size=4,
)


@pytest.mark.slow
@given(DOCUMENTS, st.integers(1, 40), st.sampled_from([None, 1]))
def test_a_document_in_blocks_has_the_fields_that_it_has_as_a_whole(document, size, indent):
    text = json.dumps(document, indent=indent, ensure_ascii=False)
    blocks = [text[at : at + size] for at in range(0, len(text), size)]
    expected = list(document.items())
    if isinstance(inner := document.get("in"), dict):
        place = [name for name, _ in expected].index("in")
        expected[place : place + 1] = inner.items()
    assert [(name, value) for _, name, value in stream_fields(blocks, "in")] == expected
    assert list(stream_fields(blocks, "in")) == list(stream_fields([text], "in"))


@given(DOCUMENTS, st.integers(1, 40), st.data())
def test_a_document_that_ends_early_is_refused_wherever_it_ends(document, size, data):
    text = json.dumps(document)
    text = text[: data.draw(st.integers(0, len(text) - 1))]
    with pytest.raises(UnreadableFile):
        list(stream_fields([text[at : at + size] for at in range(0, len(text), size)], "in"))


@given(st.integers(65_530, 65_536), st.binary() | st.text().map(str.encode), st.sampled_from([b"", b"\xef\xbb\xbf"]))
@settings(max_examples=50)
def test_blocks_of_text_are_the_text(tmp_path_factory, before, data, mark):
    path = tmp_path_factory.mktemp("text") / "any.json"
    for tail in (data, b"a\n" * (before // 2) + data):
        path.write_bytes(mark + tail)
        try:
            expected = (mark + tail).decode("utf-8-sig")
        except UnicodeDecodeError as error:
            with pytest.raises(UnreadableFile) as refused:
                list(text_blocks(path))
            good = (mark + tail)[: len(mark) + error.start]
            assert refused.value.line == good.count(b"\n") + 1
            assert f"byte {len(good)} " in refused.value.problem.message
        else:
            assert "".join(text_blocks(path)) == expected


@pytest.mark.parametrize(
    ("row", "kind"),
    [
        (f"1,v,,,{'x' * 140_000},chop,a,['a']", NoticeKind.LONG_CELL),
        ("1,v,,,chop a,chop,a,['a', 'knife']", NoticeKind.EXTRA_COLUMN),
    ],
)
def test_a_row_that_no_table_has_costs_itself_alone(row, kind):
    found = read_epic_kitchens(epic(EPIC_ROWS[0], row, EPIC_ROWS[2]), "epic.csv")
    assert [(notice.line, notice.kind) for notice in found.notices] == [(3, kind)]
    assert [action.said for narration in found.narrations for action in narration.actions] == [
        "peel onion",
        "put onion into bowl",
    ]


def test_files_are_told_by_what_is_in_them(tmp_path):
    (tmp_path / "a.csv").write_text(epic())
    (tmp_path / "b.json").write_text(activitynet())
    (tmp_path / "c.csv").write_text("start,end,motion,inputs,outputs\n")
    (tmp_path / "d.json").write_bytes(b'{"timestamps": "\xff"')
    assert [is_narrated(tmp_path / name) for name in ("a.csv", "b.json", "c.csv", "d.json")] == [
        True,
        True,
        False,
        False,
    ]
    found = list(read_narrations([tmp_path]))
    assert [len(list(one.narrations)) for one in found] == [1, 1, 0, 0]
    assert [[str(notice.kind) for notice in one.notices] for one in found[2:]] == [["unreadable-file"]] * 2
    assert is_epic_kitchens(epic())
    assert is_captions(tmp_path / "b.json")


def test_a_path_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ReadError):
        list(read_narrations([tmp_path / "nothing.csv"]))
    with pytest.raises(ReadError):
        list(read_narrations([tmp_path]))


def test_every_row_of_one_table_is_in_one_video():
    assert len(actions(*EPIC_ROWS)) == len(EPIC_ROWS)
