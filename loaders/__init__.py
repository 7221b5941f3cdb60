"""FOONs as files: text in both dialects, and JSON.

>>> from pathlib import Path
>>> from foon_kg.loaders import read_path
>>> for result in read_path(Path("subgraphs")):  # doctest: +SKIP
...     print(result.path, len(result.subgraph.annotations), result.notices)

Reading never stops at a defect: a unit that cannot be understood is left out, the rest of its file is kept, and a
:class:`Notice` says file, line, what is wrong and what was done about it. Writing is the strict side: what would not
be read back as the same raises :class:`~foon_kg.model.errors.FormatError`. A name is imported when it is
first asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from foon_kg.loaders.json_reader import read_json
    from foon_kg.loaders.json_writer import write_json
    from foon_kg.loaders.notices import Notice, NoticeKind, ReadResult, Severity
    from foon_kg.loaders.paths import read_path, read_paths
    from foon_kg.loaders.report import count_by_kind, summary, write_report
    from foon_kg.loaders.text_reader import read_text
    from foon_kg.loaders.text_writer import write_text
    from foon_kg.loaders.weights import read_weights

__all__ = [
    "Notice",
    "NoticeKind",
    "ReadResult",
    "Severity",
    "count_by_kind",
    "read_json",
    "read_path",
    "read_paths",
    "read_text",
    "read_weights",
    "summary",
    "write_json",
    "write_report",
    "write_text",
]

_HOMES = {
    "Notice": "notices",
    "NoticeKind": "notices",
    "ReadResult": "notices",
    "Severity": "notices",
    "count_by_kind": "report",
    "read_json": "json_reader",
    "read_path": "paths",
    "read_paths": "paths",
    "read_text": "text_reader",
    "read_weights": "weights",
    "summary": "report",
    "write_json": "json_writer",
    "write_report": "report",
    "write_text": "text_writer",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
