"""What a narration says of a video before any FOON is asked: who did what with what, where and when."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.model import Timing


@dataclass(frozen=True)
class Mention:
    """A thing as the narration names it, with the states that it says of it."""

    name: str
    states: tuple[str, ...] = ()


@dataclass(frozen=True)
class Place:
    """Where something is done or brought: ``relation`` is the word as said (into, onto, to, in)."""

    relation: str
    name: str


@dataclass(frozen=True)
class NarratedAction:
    """One narrated action.

    ``objects`` are what it is done to, in the order in which they are named, and empty where the narration leaves them
    out ("stir"). ``places`` are where it is done or where the objects go, ``origin`` is what they are taken from;
    ``instruments`` what it is done with; ``results`` the states that it goes on to, ``product`` what it makes of the
    objects. ``said`` is the narration itself.
    """

    verb: str
    objects: tuple[Mention, ...] = ()
    places: tuple[Place, ...] = ()
    origin: str | None = None
    instruments: tuple[str, ...] = ()
    results: tuple[str, ...] = ()
    product: str | None = None
    said: str = ""
    timing: Timing = field(default_factory=Timing)


@dataclass(frozen=True)
class Sentence:
    """One sentence that somebody said or wrote of a video or a recipe, with its time where it has one."""

    text: str
    timing: Timing = field(default_factory=Timing)


@dataclass(frozen=True)
class Narration:
    """A whole video or recipe: its actions where the source names them, else the sentences that tell of them.

    ``ingredients`` are those that a recipe lists, with the states in which it asks for them.
    """

    name: str
    actions: tuple[NarratedAction, ...] = ()
    sentences: tuple[Sentence, ...] = ()
    source: str = ""
    ingredients: tuple[Mention, ...] = ()
