"""What is asked of the service, and how it answers: plain values that travel to the processes that plan, and back."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import cached_property
from typing import Self

from foon_kg.foon import Substitute
from foon_kg.model.errors import FoonError, GraphError, NoTreeError, ServerError, UsageError, WriteRefused
from foon_kg.model.json_fields import JsonObject


@dataclass(frozen=True)
class PlanQuestion:
    """Plan a dish; no ``dish_type`` asks for the one that is most like these ``ingredients``.

    ``kitchen`` names what is at hand (:mod:`foon_kg.plans.stock`); nothing is everything. ``after`` names the recorded
    dish, or the video, after which it is made; nothing is the one that suits best. ``with_drafts`` plans after dishes,
    too, that were only drafted from the words of recipes. ``export`` names a format in which the plan is written beside
    it, ``title`` what the dish is called. The answer says why each ingredient is made as it is where it
    shall ``explain``, has a schedule for each number of pairs of ``hands``, and pictures where there is a
    ``picture_width`` (pixels of the progress lines and schedules).
    """

    dish_type: str
    ingredients: tuple[str, ...]
    substitutes: tuple[Substitute, ...] = ()
    avoided: tuple[str, ...] = ()
    kitchen: tuple[str, ...] = ()
    after: str = ""
    with_drafts: bool = False
    title: str = ""
    export: str = ""
    explain: bool = False
    hands: tuple[int, ...] = ()
    picture_width: int | None = None


@dataclass(frozen=True)
class SuggestQuestion:
    """Name the at most ``most`` dishes that ``foods`` make best with what ``kitchen`` names beside them."""

    foods: tuple[str, ...]
    most: int
    kitchen: tuple[str, ...] = ()


@dataclass(frozen=True)
class ExamplesQuestion:
    """Name at most ``most`` dishes of this FOON to begin with."""

    most: int = 6


Question = PlanQuestion | SuggestQuestion | ExamplesQuestion


class UnknownError(FoonError):
    """What was asked about is not in this FOON."""

    code = "unknown"


class BusyError(FoonError):
    """It cannot be answered now, and perhaps in a second."""

    code = "busy"


class TooLongError(FoonError):
    """The answer took longer than anybody waits."""

    code = "timeout"

    def __init__(self, seconds: float) -> None:
        hint = "Choose a dish type, name fewer things, or ask again later."
        super().__init__(f"no answer within {seconds:g} seconds", hint=hint)


class InternalError(FoonError):
    """The service itself went wrong; it tells nothing of what: that is in the log."""

    code = "internal"

    def __init__(self) -> None:
        super().__init__("the service has an error of its own", hint="See its log, and please report it.")


_STATUS = (
    (UsageError, 422), (NoTreeError, 404), (UnknownError, 404), (WriteRefused, 403), (GraphError, 503),
    (ServerError, 503), (BusyError, 503), (TooLongError, 504),
)  # fmt: skip


@dataclass(frozen=True)
class Reply:
    """An answer as HTTP has it: a status, and JSON as UTF-8."""

    status: int
    body: bytes

    @cached_property
    def mark(self) -> str:
        """What tells this answer from others: an entity tag of HTTP."""
        return f'"{hashlib.blake2b(self.body, digest_size=16).hexdigest()}"'

    @classmethod
    def of(cls, value: JsonObject, status: int = 200) -> Self:
        """Return the reply with ``value`` and ``status`` (of HTTP)."""
        text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), check_circular=False)
        return cls(status, text.encode())

    @classmethod
    def of_error(cls, error: FoonError, beside: JsonObject | None = None) -> Self:
        """Return the reply that says what is wrong (``error``), what to do, and what stands ``beside`` it."""
        said = {"code": error.code, "message": error.message, "hint": error.hint}
        return cls.of({"error": said} | (beside or {}), status_of(error))

    def value(self) -> JsonObject:
        """Return the JSON as a value."""
        read: JsonObject = json.loads(self.body)
        return read


def status_of(error: FoonError) -> int:
    """Return the HTTP status that says what kind of error this is."""
    return next((status for kind, status in _STATUS if isinstance(error, kind)), 500)
