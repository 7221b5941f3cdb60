"""The ingredients that a recipe lists: their full names and states, and which of them nobody has used yet."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention


@dataclass
class Larder:
    """The listed ingredients by their canonical names; empty where a recipe lists none."""

    listed: dict[str, Mention] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)

    @classmethod
    def of(cls, ingredients: Iterable[Mention]) -> Larder:
        """Return the larder of a recipe by its ``ingredients``; what it lists twice is there once."""
        found: dict[str, Mention] = {}
        for one in ingredients:
            found.setdefault(canonical(one.name), one)
        return cls(found)

    def take(self, name: str) -> Mention | None:
        """Return the ingredient that ``name`` speaks of, and remember that it was used; the beans of black beans."""
        wanted = canonical(name)
        names = [wanted] if wanted in self.listed else self._alike(wanted.split())
        if len(names) != 1:
            return None
        self.used.add(names[0])
        return self.listed[names[0]]

    def names(self, words: Iterable[str]) -> bool:
        """Return whether an ingredient is listed whose name has these words: the chicken of chicken thighs."""
        wanted = set(words)
        return any(wanted <= set(name.split()) for name in self.listed)

    def _alike(self, wanted: list[str]) -> list[str]:
        """Return the ingredients that these words may mean: with the same last word, else those that begin so."""
        words = set(wanted)
        ending = [name for name in self.listed if name.split()[-1:] == wanted[-1:]]
        fuller = [name for name in ending if words < set(name.split())]
        shorter = [name for name in ending if set(name.split()) < words]
        return self._unused(fuller)[:1] or fuller or shorter or self._beginning(wanted)

    def _unused(self, names: Iterable[str]) -> list[str]:
        return [name for name in names if name not in self.used]

    def _beginning(self, wanted: list[str]) -> list[str]:
        """Return the ingredients whose longer names begin with these words: the chicken of chicken thighs."""
        begin = (name for name in self.listed if name.split()[: len(wanted)] == wanted)
        return [name for name in begin if set(wanted) < set(name.split())]

    def left(self) -> tuple[Mention, ...]:
        """Return what nobody has used yet."""
        return tuple(self.listed[name] for name in self._unused(self.listed))
