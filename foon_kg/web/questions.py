"""What is asked of the service, and how it answers: plain values that travel to the processes that plan, and back."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Self

from foon_kg.errors import FoonError, GraphError, NoTreeError, ServerError, UsageError, WriteRefused
from foon_kg.json_fields import JsonObject
from foon_kg.likeness import Substitute

_STATUS = ((UsageError, 422), (NoTreeError, 404), (WriteRefused, 403), (GraphError, 503), (ServerError, 503))


@dataclass(frozen=True)
class PlanQuestion:
    """Plan a dish; no ``dish_type`` asks for the one that is most like these ``ingredients``."""

    dish_type: str
    ingredients: tuple[str, ...]
    substitutes: tuple[Substitute, ...] = ()
    avoided: tuple[str, ...] = ()
    pictures: bool = False


@dataclass(frozen=True)
class SuggestQuestion:
    """Name the at most ``most`` dishes that ``foods`` make best."""

    foods: tuple[str, ...]
    most: int


Question = PlanQuestion | SuggestQuestion


class UnknownError(FoonError):
    """What was asked about is not in this FOON."""

    code = "unknown"


@dataclass(frozen=True)
class Reply:
    """An answer as HTTP has it: a status, and JSON as UTF-8."""

    status: int
    body: bytes

    @classmethod
    def of(cls, value: JsonObject, status: int = 200) -> Self:
        """Answer with ``value``."""
        return cls(status, json.dumps(value, ensure_ascii=False, separators=(",", ":")).encode())

    @classmethod
    def of_error(cls, error: FoonError, beside: JsonObject | None = None) -> Self:
        """Answer with what is wrong and what to do about it."""
        said = {"code": error.code, "message": error.message, "hint": error.hint}
        return cls.of({"error": said} | (beside or {}), status_of(error))

    def value(self) -> JsonObject:
        """Answer the JSON as a value."""
        read: JsonObject = json.loads(self.body)
        return read


def status_of(error: FoonError) -> int:
    """Answer the HTTP status that says what kind of error this is."""
    if isinstance(error, UnknownError):
        return 404
    return next((status for kind, status in _STATUS if isinstance(error, kind)), 500)
