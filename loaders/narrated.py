"""Files that narrate videos in words, without states: what they give, and which of their forms a file has."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeVar

from foon_kg.loaders.notices import Notice, Severity
from foon_kg.model.narration import NarratedAction, Narration, Sentence

_NAME = re.compile(r"[\w-][\w .+-]{0,119}")

T = TypeVar("T", NarratedAction, Sentence)


@dataclass(frozen=True)
class NarratedFile:
    """What one file narrates, and everything odd about it. Long files are read again for their ``narrations``."""

    path: str
    narrations: Iterable[Narration]
    notices: tuple[Notice, ...] = ()

    @property
    def rejected(self) -> int:
        """How many narrated actions or sentences were left out; an unusable file counts as one."""
        return sum(notice.severity is Severity.REJECTED for notice in self.notices)


def is_video_name(name: str) -> bool:
    """Return whether ``name`` may name a video and the file of its draft: no path, no marks, not too long."""
    return _NAME.fullmatch(name) is not None and name.strip() == name


def ordered(told: Iterable[T]) -> tuple[T, ...]:
    """Return ``told`` by when it begins; what has no time stays behind what it was told after."""
    keyed: list[tuple[float, T]] = []
    latest = 0.0
    for one in told:
        latest = latest if one.timing.start is None else one.timing.start
        keyed.append((latest, one))
    return tuple(one for _, one in sorted(keyed, key=_start))


def _start(keyed: tuple[float, object]) -> float:
    return keyed[0]
