"""EPIC-KITCHENS-100, ActivityNet Captions and YouCook2 files: what they tell, and what is wrong with broken ones."""

from __future__ import annotations

import json

import pytest
from drafting.kitchen_foon import ACTIVITYNET, EPIC_ROWS, YOUCOOK, activitynet, epic
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.errors import ReadError
from foon_kg.loaders.captions import is_captions, read_captions
from foon_kg.loaders.epic_kitchens import is_epic_kitchens, read_epic_kitchens
from foon_kg.loaders.narrations import is_narrated, read_narrations
from foon_kg.loaders.notices import NoticeKind
from foon_kg.model import Timing
from foon_kg.narration import Mention, Place


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
    assert notices('1,v,,,"chop') == [(None, NoticeKind.UNREADABLE_FILE)]


@given(st.text())
def test_any_text_under_the_header_is_read_or_told(text):
    found = read_epic_kitchens(epic(text), "epic.csv")
    assert all(narration.actions for narration in found.narrations)


def told(value, video="v"):
    return read_captions(json.dumps({video: value}), "captions.json")


def test_both_forms_of_captions_give_sentences_with_times():
    (soup,) = read_captions(activitynet(), "a.json").narrations
    assert [(one.text, one.timing.spans) for one in soup.sentences] == [
        ("Peel an onion.", ((0.0, 4.5),)),
        ("Chop it.", ((5.0, 9.0),)),
    ]
    (video,) = read_captions(json.dumps(YOUCOOK), "y.json").narrations
    assert video.name == "GLd3aX16zBg"
    assert [one.text for one in video.sentences] == ["peel the onion", "chop the onion on a cutting board"]


@pytest.mark.parametrize(
    ("value", "kind", "sentences"),
    [
        (5, NoticeKind.BAD_FIELD, 0),
        ({"sentences": "Chop.", "timestamps": []}, NoticeKind.BAD_FIELD, 0),
        ({"sentences": [7, "Chop."], "timestamps": [[0, 1], [1, 2]]}, NoticeKind.NO_NARRATION, 1),
        ({"sentences": ["  ", "Chop."], "timestamps": [[0, 1], [1, 2]]}, NoticeKind.NO_NARRATION, 1),
        ({"sentences": ["Chop."], "timestamps": []}, NoticeKind.ODD_TIME, 1),
        ({"sentences": ["Chop."], "timestamps": [[4, 2]]}, NoticeKind.ODD_TIME, 1),
        ({"sentences": ["Chop."], "timestamps": [[-4, 2]]}, NoticeKind.ODD_TIME, 1),
        ({"sentences": ["Chop."], "timestamps": [["0", True]]}, NoticeKind.ODD_TIME, 1),
        ({"annotations": ["chop"]}, NoticeKind.NO_NARRATION, 0),
    ],
)
def test_what_is_wrong_with_a_video_is_told_and_the_rest_kept(value, kind, sentences):
    found = told(value)
    assert found.notices[0].kind is kind
    assert "video v" in found.notices[0].message
    assert sum(len(narration.sentences) for narration in found.narrations) == sentences


def test_truncated_json_is_told_with_its_line():
    found = read_captions(json.dumps(ACTIVITYNET, indent=1)[:-40], "captions.json")
    assert found.narrations == ()
    assert found.notices[0].kind is NoticeKind.UNREADABLE_FILE
    assert found.notices[0].line


def test_a_video_named_like_a_path_is_refused():
    assert told({"sentences": ["Chop."], "timestamps": [[0, 1]]}, "../x").notices[0].kind is NoticeKind.ODD_NAME


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
    assert [len(one.narrations) for one in found] == [1, 1, 0, 0]
    assert [[str(notice.kind) for notice in one.notices] for one in found[2:]] == [["unreadable-file"]] * 2
    assert is_epic_kitchens(epic())
    assert is_captions(activitynet())


def test_a_path_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ReadError):
        list(read_narrations([tmp_path / "nothing.csv"]))
    with pytest.raises(ReadError):
        list(read_narrations([tmp_path]))


def test_every_row_of_one_table_is_in_one_video():
    assert len(actions(*EPIC_ROWS)) == len(EPIC_ROWS)
