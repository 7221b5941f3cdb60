"""Times as annotators wrote them, and back.

Known forms: ``<1:10-1:11>``, ``<1:10,1:11>``, ``<0:46-0:48,0:52-0:54>``, ``<Assumed>``, and two columns
``1:10<TAB>1:11``. A third part is ambiguous in the wild: ``0:01:20`` is h:mm:ss in a file that mostly writes so,
while ``2:41:50`` among times of two parts is two minutes, 41 seconds and 50 hundredths.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from decimal import Decimal
from itertools import zip_longest
from typing import TypeGuard

from foon_kg.loaders.notices import NoticeKind, Remark
from foon_kg.model import Timing

_CLOCK = re.compile(r"(?:([0-9]{1,9}):)?(?:([0-9]{1,9}):)?([0-9]{1,9}(?:\.[0-9]{1,30})?)")
_TIMES = re.compile(r"(?<![0-9:])[0-9]++(?::[0-9]++)++")
_ASSUMED = "assumed"
_MINUTE = 60
_LATEST = 1e9  # seconds; what is later is no time of a video


def counts_hours(columns: Iterable[str]) -> bool:
    """Return whether a file with these time columns writes h:mm:ss: more of its times have three parts than two."""
    times: list[str] = _TIMES.findall("\n".join(columns))
    colons = [time.count(":") for time in times]
    return sum(count > 1 for count in colons) > sum(count == 1 for count in colons)


def read_timing(columns: Sequence[str], *, hours: bool = False) -> tuple[Timing, tuple[Remark, ...]]:
    """Return the time that the last columns of a motion line say, and what is odd about how they say it.

    ``hours``: the file counts hours (see :func:`counts_hours`). What cannot be read is left out and remarked on;
    an end before its start is kept as it was written.
    """
    text = ",".join(column for column in columns if column)
    reading = _Reading(hours=hours)
    if text:
        reading.read(text)
    return Timing(tuple(reading.spans), reading.assumed), tuple(reading.remarks)


class _Reading:
    """The reading of one motion's time: what is known so far, and what was odd."""

    def __init__(self, *, hours: bool) -> None:
        self._hours = hours
        self.assumed = False
        self.spans: list[tuple[float, float]] = []
        self.remarks: list[Remark] = []

    def read(self, text: str) -> None:
        bare = text.strip("<>[]")
        if text not in {bare, f"<{bare}>"}:
            self._odd(f"the brackets of {text!r} do not match", "left out")
        lone: list[str] = []
        for part in (part.strip() for part in bare.split(",")):
            if part[:1].isalpha():
                self._word(part)
            elif "-" in part:
                start, _, end = part.rstrip("-").partition("-")
                if part.endswith("-"):
                    self._odd(f"{part!r} ends in a dash", "left out")
                self._span(start, end)
            else:
                lone.append(part)
        self._pairs(lone)

    def _word(self, word: str) -> None:
        self.assumed = self.assumed or _ASSUMED.startswith(word.casefold())
        if not _ASSUMED.startswith(word.casefold()):
            self._odd(f"{word!r} is no time", "left out")
        elif word.casefold() != _ASSUMED:
            self._odd(f"{word!r} for a time", "read as Assumed")

    def _pairs(self, times: list[str]) -> None:
        """Take times without a dash: ``1:10,1:11`` is one span."""
        if len(times) > 2:  # noqa: PLR2004  # a start and an end
            self._odd(f"{len(times)} times without a dash", "read in pairs")
        for start, end in zip_longest(times[::2], times[1::2], fillvalue=""):
            self._span(start, end)

    def _span(self, start_text: str, end_text: str) -> None:
        known = [time for time in (self._seconds(start_text), self._seconds(end_text)) if time is not None]
        if not (start_text.strip() or end_text.strip()):
            self._odd("an empty time", "left out")
        if len(known) == 1:
            self._odd(f"only one time in '{start_text}-{end_text}'", "read as a moment")
        if known:
            self.spans.append((known[0], known[-1]))
            if known[-1] < known[0]:
                self._odd(f"'{start_text}-{end_text}' ends before it starts", "kept as written")

    def _seconds(self, text: str) -> float | None:
        """Return a clock time in seconds, ``None`` where it is none."""
        text = text.strip()
        match = _CLOCK.fullmatch(text)
        seconds = self._added_up(match) if match else None
        if seconds is None or seconds >= _LATEST:
            if text:
                self._odd(f"{text!r} is no time", "left out")
            return None
        return seconds

    def _added_up(self, match: re.Match[str]) -> float:
        first, second, last = match[1] or "0", match[2], Decimal(match[3])
        if second is not None and not self._hours:
            self._odd(f"{match[0]!r} has three parts", "the last read as hundredths of a second")
            return float(_MINUTE * int(first) + int(second) + last / 100)
        minutes = int(first) if second is None else _MINUTE * int(first) + int(second)
        if (match[1] and last >= _MINUTE) or (second is not None and int(second) >= _MINUTE):
            self._odd(f"{match[0]!r} has {_MINUTE} or more of a unit", "added up")
        return float(_MINUTE * minutes + last)

    def _odd(self, message: str, action: str) -> None:
        self.remarks.append(Remark(NoticeKind.ODD_TIME, message, action))


def is_time(value: object) -> TypeGuard[float]:
    """Return whether ``value`` is a number of seconds that may stand in a video."""
    return isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < _LATEST


def write_timing(timing: Timing) -> str:
    """Return ``timing`` as the canonical column: ``<Assumed>``, ``<1:10-1:11.5,2:00-2:04>``; nothing for none."""
    parts = ["Assumed"] if timing.assumed else []
    parts += [f"{_clock(start)}-{_clock(end)}" for start, end in timing.spans]
    return f"<{','.join(parts)}>" if parts else ""


def _clock(seconds: float) -> str:
    """Return m:ss, with as many decimals as it takes to be read back the same."""
    if not is_time(seconds):
        return repr(seconds)  # no clock time; who writes it finds out by reading it back
    exact = Decimal(repr(float(seconds)))
    minutes = exact // _MINUTE
    whole, _, decimals = f"{exact - _MINUTE * minutes:f}".partition(".")
    return f"{minutes}:{whole:0>2}" + (f".{decimals}" if decimals.strip("0") else "")
