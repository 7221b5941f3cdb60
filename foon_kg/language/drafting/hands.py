"""What is in somebody's hands: taken from somewhere, and held until a narration says where it is put."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.model.names import canonical

_TAKES = word_list("is held then")
_BACK = word_list("comes to where it was")


def takes(verb: str) -> bool:
    """Whether a verb of a narration takes something into the hand."""
    return _spoken(verb) in _TAKES


def brings_back(verb: str, said: str) -> bool:
    """Return whether an action brings a thing to where it was before: "put milk back", "put away bowl".

    ``verb`` is that of the action, ``said`` its words.
    """
    words = set(said.lower().split())
    return _spoken(verb) in _BACK or any(set(phrase.split()) <= words for phrase in _BACK)


@dataclass
class Hands:
    """Where held things come from, by their canonical names; ``None`` where nobody said so.

    ``opened`` is the fixture that was opened last and not closed since, a drawer: what nobody says the place of is
    taken from there.
    """

    held: dict[str, str | None] = field(default_factory=dict)
    guessed: set[str] = field(default_factory=set)
    home: dict[str, str] = field(default_factory=dict)
    opened: str | None = None

    def take(self, name: str, origin: str | None) -> None:
        """Hold the thing called ``name``; ``origin`` is the place as it was told."""
        known = canonical(name)
        (self.guessed.discard if origin is not None else self.guessed.add)(known)
        self.held.pop(known, None)  # what was taken last stands last
        self.held[known] = origin or self.opened
        if (place := self.held[known]) is not None:
            self.home[known] = place

    def place_of(self, name: str) -> str | None:
        """Return where a thing called ``name`` is put that is put back: where it was, else into what is open."""
        return self.home.get(canonical(name)) or self.opened

    def latest(self) -> str | None:
        """Return what was taken last and is still held."""
        return next(reversed(self.held), None)

    def put(self, name: str) -> tuple[str | None, bool]:
        """Return where the thing called ``name`` was taken from that is put now, and whether that is only a guess."""
        known = canonical(name)
        return self.held.pop(known, None), known in self.guessed

    def see(self, name: str, *, opened: bool) -> None:
        """Remember a fixture by its ``name`` that is ``opened`` or closed.

        What opens and keeps nothing does not count.
        """
        row = tables().utensil(name)
        if row is not None and (row.role == "place" or row.source == "cold") and "hold" in row.can:
            self.opened = name if opened else None


def _spoken(verb: str) -> str:
    return verb.replace("-", " ").strip().lower()
