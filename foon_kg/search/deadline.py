"""How long a search may still take."""

from __future__ import annotations

import time
from dataclasses import dataclass


@dataclass(frozen=True)
class Deadline:
    """A moment on the monotonic clock, in seconds; ``None`` never comes."""

    moment: float | None = None

    @classmethod
    def after(cls, seconds: float | None) -> Deadline:
        """Return the deadline in so many seconds from now."""
        return cls(None if seconds is None else time.monotonic() + seconds)

    def has_passed(self) -> bool:
        """Whether it is too late."""
        return self.moment is not None and time.monotonic() > self.moment
