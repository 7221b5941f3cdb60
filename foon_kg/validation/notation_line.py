"""One line of the notation while it is read from left to right, and the names in it.

The notation itself is told in :mod:`foon_kg.validation.notation`.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from typing import NoReturn

from foon_kg.model.errors import ReadError

NOTHING = "nothing"
"""Stands for an empty list, an empty side of a step, and what is not told."""

LIKE = "like"
"""Stands between what was required and its equivalent."""

HINT = "The notation is described in foon_kg/validation/notation.py; docs/contract.md has examples."

_END_OF_NAME = re.compile(rf'[(){{}};,+→#":]|->|(?<!\S){LIKE}(?!\S)')
_BEGINS_A_LINE = re.compile(r"[-✗]")
_WHOLE_NUMBER = re.compile(r"-?\d+")
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def written_name(name: str) -> str:
    """Return a name as the notation writes it: as it stands, or in quotes where it would be read as something else."""
    return name if _is_bare(name) else in_quotes(name)


def written_motion(motion: str) -> str:
    """Return a motion in capitals, or in quotes where capitals would not lead back to it."""
    capitals = motion.upper()
    return capitals if capitals.lower() == motion and _is_bare(capitals) else in_quotes(motion)


def written_rest(text: str) -> str:
    """Return a text that stands alone at the end of its line."""
    bare = text and text.isprintable() and text == text.strip() and not text.startswith('"')
    return text if bare else in_quotes(text)


def in_quotes(name: str) -> str:
    """Return a name as a JSON string."""
    return json.dumps(name, ensure_ascii=False)


def _is_bare(name: str) -> bool:
    plain = name.isprintable() and " ".join(name.split()) == name and name not in {"", NOTHING}
    return plain and not _END_OF_NAME.search(name) and not _BEGINS_A_LINE.match(name)


@dataclass
class Line:
    """A line of the notation: ``where`` it stands (``file:line``) and ``at`` which character the reader is.

    Every method passes over spaces first, and raises ReadError with the place where it finds something else.
    """

    text: str
    where: str
    at: int = 0

    def fail(self, what: str) -> NoReturn:
        """Raise ReadError for this line; ``what`` is wrong with it, in a few words."""
        raise ReadError(f"{self.where}: {what}", hint=HINT)

    def next_is(self, *marks: str) -> bool:
        """Return whether one of ``marks`` comes next."""
        while self.text[self.at : self.at + 1].isspace():
            self.at += 1
        return self.text.startswith(marks, self.at)

    def take(self, *marks: str) -> bool:
        """Pass over one of ``marks`` where one comes next, and return whether one did."""
        if not self.next_is(*marks):
            return False
        self.at += next(len(mark) for mark in marks if self.text.startswith(mark, self.at))
        return True

    def expect(self, *marks: str) -> None:
        """Pass over one of ``marks``."""
        if not self.take(*marks):
            self.fail(f"expected “{marks[0]}”{self._found()}")

    def end(self) -> None:
        """Make sure that nothing is left."""
        if self.text[self.at :].strip():
            self.fail(f"nothing was expected any more{self._found()}")

    def take_nothing(self) -> bool:
        """Pass over a last ``nothing``, and return whether there was one."""
        if self.text[self.at :].strip() != NOTHING:
            return False
        self.at = len(self.text)
        return True

    def quoted(self) -> str:
        """Return the text in quotes that comes next."""
        try:
            value, self.at = json.JSONDecoder().raw_decode(self.text, self.at)
        except ValueError:
            self.fail(f"this quote does not end as one of JSON does{self._found()}")
        return str(value)

    def name(self) -> str:
        """Return the name that comes next, in quotes or up to the next mark."""
        if self.next_is('"'):
            return self.quoted()
        end = _END_OF_NAME.search(self.text, self.at)
        found = self.text[self.at : end.start() if end else None]
        if not found:
            self.fail(f"a name is missing{self._found()}")
        self.at += len(found)
        return found.strip()

    def optional_name(self) -> str | None:
        """Return the name that comes next; ``None`` for ``nothing``."""
        quoted = self.next_is('"')
        found = self.name()
        return None if found == NOTHING and not quoted else found

    def rest(self) -> str:
        """Return what is left of the line, in quotes or not."""
        if self.next_is('"'):
            return self.quoted()
        found, self.at = self.text[self.at :].strip(), len(self.text)
        return found

    def whole_number(self) -> int:
        """Return the whole number that comes next."""
        return int(self._number(_WHOLE_NUMBER))

    def number(self) -> float:
        """Return the number that comes next."""
        return float(self._number(_NUMBER))

    def _number(self, form: re.Pattern[str]) -> str:
        self.next_is()
        match = form.match(self.text, self.at)
        if match is None:
            self.fail(f"expected a number{self._found()}")
        self.at = match.end()
        return match[0]

    def _found(self) -> str:
        left = self.text[self.at :].strip()
        return f", found “{left[:20]}”" if left else " before the end of the line"
