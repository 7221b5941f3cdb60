from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from foon_kg.loaders.times import counts_hours, read_timing, write_timing
from foon_kg.model import Timing

CLEAR = {
    ("<1:10-1:11>",): [(70, 71)],
    ("<1:10,1:11>",): [(70, 71)],
    ("<0:46-0:48,0:52-0:54,1:04-1:07>",): [(46, 48), (52, 54), (64, 67)],
    ("1:10", "1:11"): [(70, 71)],
    ("61:10", "61:11"): [(3670, 3671)],
    ("<1:10.5-1:11.25>",): [(70.5, 71.25)],
    ("9", "12"): [(9, 12)],
    ("61", "75"): [(61, 75)],
    (): [],
    ("",): [],
}


@pytest.mark.parametrize("columns", CLEAR)
def test_a_clear_time_is_read_without_a_word(columns: tuple[str, ...]):
    assert read_timing(columns) == (Timing(tuple(CLEAR[columns])), ())


@pytest.mark.parametrize("columns", [("<Assumed>",), ("Assumed", "Assumed"), ("assumed", "assumed"), ("Assumed",)])
def test_an_assumed_action_has_no_time(columns: tuple[str, ...]):
    assert read_timing(columns) == (Timing(assumed=True), ())


def test_an_assumed_action_may_have_been_seen_as_well():
    assert read_timing(("<Assumed,1:10-1:11>",)) == (Timing(((70, 71),), assumed=True), ())


ODD = {
    ("<Assumed",): Timing(assumed=True),
    ("<Assumed,Ass>",): Timing(assumed=True),
    ("<Assumed,Assume>",): Timing(assumed=True),
    ("19:05", "Assumed"): Timing(((1145, 1145),), assumed=True),
    ("<1:35,1:38:50>",): Timing(((95, 98.5),)),
    ("<0:39-0:42:50>",): Timing(((39, 42.5),)),
    ("<1:16-1:20,1:37-1:43->",): Timing(((76, 80), (97, 103))),
    ("1:32", "1:35]"): Timing(((92, 95),)),
    ("2:57", "3:0s7"): Timing(((177, 177),)),
    ("1:10", ""): Timing(((70, 70),)),
    ("", "1:10"): Timing(((70, 70),)),
    ("<-1:10>",): Timing(((70, 70),)),
    ("<1:10,1:11,1:12>",): Timing(((70, 71), (72, 72))),
    ("1:116", "1:57"): Timing(((176, 117),)),
    ("2:37", "2:28"): Timing(((157, 148),)),
    ("later",): Timing(),
    ("<>",): Timing(),
    ("<->",): Timing(),
    ("999999999:00", "1:00"): Timing(((60, 60),)),
}


@pytest.mark.parametrize("columns", ODD)
def test_an_odd_time_is_read_as_far_as_it_can_be_and_remarked_on(columns: tuple[str, ...]):
    timing, remarks = read_timing(columns)
    assert timing == ODD[columns]
    assert remarks


def test_a_remark_shows_what_is_odd_and_what_was_done():
    _, remarks = read_timing(("2:37", "2:28"))
    assert [(remark.message, remark.action) for remark in remarks] == [
        ("'2:37-2:28' ends before it starts", "kept as written")
    ]


@pytest.mark.parametrize(
    ("columns", "hours", "seconds", "message"),
    [
        (("1:75", "2:30"), False, (135, 150), "'1:75' has 60 or more of a unit"),
        (("0:75:00", "2:00:00"), True, (4500, 7200), "'0:75:00' has 60 or more of a unit"),
        (("1:10", "1:11:50"), False, (70, 71.5), "'1:11:50' has three parts"),
    ],
)
def test_each_odd_thing_is_remarked_on_once(
    columns: tuple[str, ...], hours: bool, seconds: tuple[float, float], message: str
):
    timing, remarks = read_timing(columns, hours=hours)
    assert timing.spans == (seconds,)
    assert [remark.message for remark in remarks] == [message]


def test_more_times_than_two_without_a_dash_are_read_in_pairs():
    _, remarks = read_timing(("1:10", "1:11", "1:12"))
    assert remarks[0].message == "3 times without a dash"


def test_three_parts_are_hours_where_the_file_counts_hours():
    assert read_timing(("0:01:20", "1:02:03"), hours=True) == (Timing(((80, 3723),)), ())
    assert read_timing(("0:59", "1:01"), hours=True) == (Timing(((59, 61),)), ())


@pytest.mark.parametrize(
    ("columns", "hours"),
    [
        (["0:01:20", "0:01:22"], True),
        (["0:01:20", "0:01:22", "0:10"], True),
        (["0:10", "0:42:50"], False),
        (["<0:39-0:42:50>", "<1:10-1:12>"], False),
        (["Assumed"], False),
        ([], False),
    ],
)
def test_a_file_counts_hours_when_most_of_its_times_have_three_parts(columns: list[str], hours: bool):
    assert counts_hours(columns) is hours


@pytest.mark.parametrize(
    ("timing", "written"),
    [
        (Timing(), ""),
        (Timing(assumed=True), "<Assumed>"),
        (Timing(((70, 71.5), (0, 9.25))), "<1:10-1:11.5,0:00-0:09.25>"),
        (Timing(((4000, 4001),), assumed=True), "<Assumed,66:40-66:41>"),
    ],
)
def test_times_are_written_as_minutes_and_seconds(timing: Timing, written: str):
    assert write_timing(timing) == written


seconds = st.one_of(st.integers(0, 10**6).map(float), st.floats(0, 10**6).map(lambda value: round(value, 3)))


@settings(deadline=None)
@given(st.lists(st.tuples(seconds, seconds).map(sorted).map(tuple), max_size=4), st.booleans())
def test_every_time_is_read_back_as_it_was_written(spans: list[tuple[float, float]], assumed: bool):
    timing = Timing(tuple(spans), assumed)
    assert read_timing((write_timing(timing),)) == (timing, ())


@settings(deadline=None)
@given(st.lists(st.text(st.sampled_from("0123456789:,-<>[]. Assumedx"), max_size=20), max_size=3), st.booleans())
def test_whatever_stands_for_a_time_is_read_to_one_that_can_be_written(columns: list[str], hours: bool):
    timing, remarks = read_timing(columns, hours=hours)
    assert read_timing((write_timing(timing),))[0] == timing
    if not timing.spans and not timing.assumed and any(columns):
        assert remarks
