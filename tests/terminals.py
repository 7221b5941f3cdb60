"""Programs on a terminal: what a person sees there, and what only a terminal gets."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
from collections.abc import Mapping, Sequence

PROGRAM = "import sys; from foon_kg.cli import main; sys.argv[0] = 'foon'; main()"


def on_a_terminal(
    words: Sequence[str], *, program: str = PROGRAM, environment: Mapping[str, str] | None = None
) -> tuple[int, str]:
    """Run ``foon`` with stdout and stderr on a terminal of 100 columns; return its exit code and all that it wrote."""
    above, below = pty.openpty()
    told = {**os.environ, "TERM": "xterm-256color", "COLUMNS": "100", **(environment or {})}
    if "NO_COLOR" not in (environment or {}):
        told.pop("NO_COLOR", None)
    call = [sys.executable, "-c", program, *words]
    with subprocess.Popen(call, stdin=below, stdout=below, stderr=below, env=told) as running:
        os.close(below)
        seen = b"".join(iter(lambda: _read(above), b""))
    os.close(above)
    return running.returncode, seen.decode().replace("\r\n", "\n")


def _read(terminal: int) -> bytes:
    """Return what comes next; nothing at the end, which Linux tells as an error."""
    try:
        return os.read(terminal, 65536)
    except OSError:
        return b""
