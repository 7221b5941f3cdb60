"""What an export answers: texts with the names under which they are written."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ExportFile:
    """One file, as its name without a folder and its text."""

    name: str
    text: str
