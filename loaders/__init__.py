"""Read and write FOONs: text in both dialects, and JSON."""

from __future__ import annotations

from foon_kg.loaders.notices import Notice, NoticeKind, ReadResult, Severity
from foon_kg.loaders.paths import read_path, read_paths

__all__ = ["Notice", "NoticeKind", "ReadResult", "Severity", "read_path", "read_paths"]
