from __future__ import annotations

import io
import json

from foon_kg.loaders import NoticeKind, Severity, count_by_kind, read_text, summary, write_report

TEXT = (
    "O\tegg\t00\nS\tcontains\t{a,a}\nM\tmix\nO\tb\t0\n//\n"
    "O\tsmörgås\t1\nS\tcontains\t{a,a}\n//\n"
    "O\tegg\t1\nS\tin\t[b\n//\n"
)


def test_every_notice_is_one_line_of_json():
    notices = read_text(TEXT, "a", "dir/a.txt").notices
    stream = io.StringIO()
    assert write_report(notices, stream) == 5
    rows = [json.loads(line) for line in stream.getvalue().splitlines()]
    assert rows[0] == {
        "file": "dir/a.txt",
        "line": 1,
        "severity": "assumed",
        "kind": "odd-flag",
        "message": "the flag is '00', neither 0 nor 1",
        "action": "read as 0, it does not move",
    }
    assert [(row["line"], row["severity"], row["kind"]) for row in rows] == [
        (1, "assumed", "odd-flag"),
        (2, "assumed", "name-twice"),
        (7, "assumed", "name-twice"),
        (8, "rejected", "unit-without-motion"),
        (10, "rejected", "bad-brackets"),
    ]
    assert stream.getvalue().isascii()


def test_what_was_rejected_is_counted_first():
    notices = read_text(TEXT, "a").notices
    assert list(count_by_kind(notices).items()) == [
        ((Severity.REJECTED, NoticeKind.BAD_BRACKETS), 1),
        ((Severity.REJECTED, NoticeKind.UNIT_WITHOUT_MOTION), 1),
        ((Severity.ASSUMED, NoticeKind.NAME_TWICE), 2),
        ((Severity.ASSUMED, NoticeKind.ODD_FLAG), 1),
    ]
    assert summary(notices) == (
        "rejected: 1 bad-brackets",
        "rejected: 1 unit-without-motion",
        "assumed: 2 name-twice",
        "assumed: 1 odd-flag",
    )


def test_nothing_to_report_is_reported_as_nothing():
    assert write_report([], io.StringIO()) == 0
    assert summary([]) == ()
