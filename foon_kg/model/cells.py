"""Cells of tables that people open in a spreadsheet: no text of a FOON becomes a formula there."""

from __future__ import annotations

import re

_FORMULA = re.compile(r"[=+\-@\t\r]")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")


def as_cell(text: str) -> str:
    """Return ``text`` with an apostrophe before it where a spreadsheet would take it for a formula.

    >>> as_cell("=HYPERLINK(1)"), as_cell("onion"), as_cell("-3.5")
    ("'=HYPERLINK(1)", 'onion', '-3.5')
    """
    harmless = not _FORMULA.match(text) or _NUMBER.fullmatch(text)
    return text if harmless else f"'{text}"


def from_cell(cell: str) -> str:
    """Return what :func:`as_cell` made a cell of.

    >>> from_cell("'=HYPERLINK(1)"), from_cell("'tis")
    ('=HYPERLINK(1)', "'tis")
    """
    return cell[1:] if cell.startswith("'") and _FORMULA.match(cell, 1) else cell
