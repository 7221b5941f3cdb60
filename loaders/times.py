"""Times as annotators wrote them, and back.

Known forms: ``<1:10-1:11>``, ``<1:10,1:11>``, ``<0:46-0:48,0:52-0:54>``, ``<Assumed>``, and two columns
``1:10<TAB>1:11``. A third part is ambiguous in the wild: ``0:01:20`` counts hours where the file mostly does so,
and ``2:41:50`` means two minutes, 41 seconds and 50 hundredths beside times of two parts.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from decimal import Decimal

from foon_kg.model import Timing

_CLOCK = re.compile(r"(?:(\d{1,9}):)?(?:(\d{1,9}):)?(\d{1,9}(?:\.\d{1,30})?)", re.ASCII)
_THREE_PARTS = re.compile(r"\d+:\d+:\d+", re.ASCII)
_TWO_PARTS = re.compile(r"(?<![:\d])\d+:\d+(?![:\d])", re.ASCII)


def counts_hours(columns: Iterable[str]) -> bool:
    """Answer whether a file, given all its time columns, writes h:mm:ss: it has more times of three parts than of two."""
    text = "\n".join(columns)
    return len(_THREE_PARTS.findall(text)) > len(_TWO_PARTS.findall(text))


class _Reading:
    """The reading of one motion's time columns: the spans so far and what was odd."""

    def __init__(self, *, hours: bool) -> None:
        self.hours = hours
        self.assumed = False
        self.spans: list[tuple[float, float]] = []
        self.odd: list[str] = []

    def token(self, text: str) -> None:
        """Take one comma-separated part: ``Assumed`` or a span with a dash."""
        if text.casefold() == "assumed":
            self.assumed = True
        elif text and "assumed".startswith(text.casefold()):
            self.assumed = True
            self.odd.append(f"{text!r} read as Assumed")
        else:
            start, dash, end = text.partition("-")
            self.span(start, end if dash else "")

    def span(self, start_text: str, end_text: str) -> None:
        """Take a span; a lone time is a moment, a time that cannot be read is left out."""
        start, end = self.seconds(start_text), self.seconds(end_text)
        if start is None and end is None:
            return
        if start is None or end is None:
            moment = end if start is None else start
            self.odd.append("only one end of the span is readable, taken as a moment")
            start = end = moment
        if start is None or end is None:
            return
        if end < start:
            self.odd.append("the end is before the start, kept as written")
        self.spans.append((start, end))

    def seconds(self, text: str) -> float | None:
        """Answer a clock time in seconds, ``None`` where it cannot be read."""
        match = _CLOCK.fullmatch(text.strip())
        if match is None:
            self.odd.append(f"{text.strip()!r} is no time" if text.strip() else "a time is missing")
            return None
        first, second, last = match.groups()
        if second is not None and not self.hours:
            self.odd.append(f"the last part of {match[0]} read as hundredths of a second")
            return float(60 * int(first) + int(second) + Decimal(last) / 100)
        minutes = (60 * int(first) + int(second)) if second is not None else int(first or 0)
        if first is not None and (Decimal(last) >= 60 or (second is not None and int(second) >= 60)):
            self.odd.append(f"{match[0]} has 60 seconds or minutes, or more")
        return float(60 * minutes + Decimal(last))


def read_timing(columns: Sequence[str], *, hours: bool = False) -> tuple[Timing, tuple[str, ...]]:
    """Answer the time that a motion line's last columns say, and what is odd about how they say it.

    ``hours``: the file counts hours (see ``counts_hours``).
    """
    text = ",".join(column.strip() for column in columns if column.strip())
    if not text:
        return Timing(), ()
    reading = _Reading(hours=hours)
    bare = text.strip("<>[]")
    if text != bare and text != f"<{bare}>":
        reading.odd.append(f"brackets of {text!r} do not match")
    parts = [part.strip() for part in bare.split(",")]
    if any("-" in part or part[:1].casefold() == "a" for part in parts) or not bare:
        _read_listed(reading, parts)
    else:
        _read_paired(reading, parts)
    return Timing(tuple(reading.spans), reading.assumed), tuple(reading.odd)


def _read_listed(reading: _Reading, parts: list[str]) -> None:
    for part in parts:
        reading.token(part)


def _read_paired(reading: _Reading, parts: list[str]) -> None:
    if len(parts) > 2:  # noqa: PLR2004  # a start and an end
        reading.odd.append("more than two times without a dash, read in pairs")
    for start in range(0, len(parts), 2):
        reading.span(parts[start], parts[start + 1] if start + 1 < len(parts) else "")


def write_timing(timing: Timing) -> str:
    """Answer the canonical column: ``<Assumed>``, ``<1:10-1:11.5,2:00-2:04>``, or nothing."""
    parts = ["Assumed"] if timing.assumed else []
    parts += [f"{_clock(start)}-{_clock(end)}" for start, end in timing.spans]
    return f"<{','.join(parts)}>" if parts else ""


def _clock(seconds: float) -> str:
    exact = Decimal(repr(float(seconds)))
    minutes = int(exact // 60)
    rest = f"{exact - 60 * minutes:f}".removesuffix(".0")
    return f"{minutes}:{'0' if Decimal(rest) < 10 else ''}{rest}"  # noqa: PLR2004  # seconds have two digits
