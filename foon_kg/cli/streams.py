"""The two streams of a command: data on stdout, messages and progress on stderr."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console


def data() -> Console:
    """Return the console for data: stdout, coloured only on a terminal."""
    from rich.console import Console

    return Console(highlight=False)


def messages(*, quiet: bool = False) -> Console:
    """Return the console for messages and progress: stderr, or where it shall be ``quiet``, nothing at all."""
    from rich.console import Console

    return Console(stderr=True, quiet=quiet, highlight=False, soft_wrap=True)
