"""Which motions of a FOON a verb may stand for: the same words, the same stems, a table of what people say, a likeness.

The table is ``verbs.txt`` beside this module.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from importlib.resources import files

import numpy as np

from foon_kg.food import tables
from foon_kg.similarity.vectors import food_vectors, stem

SAME, SAME_STEM, BY_TABLE = 1.0, 0.95, 0.85
"""How sure a motion is that the verb names outright, in another form, or by way of the table."""

_LIKE = 0.6
_LOOKS_ONLY = frozenset({"inspect"})
_NO_MOTION = "-"
_WORD = re.compile(r"[^\W\d_]+")


@dataclass(frozen=True)
class Reading:
    """The ``motions`` that a verb may stand for, the likelier first, and how sure that is; none, and ``why`` not.

    ``idle`` says that the verb is known to change nothing: to look, to wait.
    """

    motions: tuple[str, ...]
    confidence: float = 0.0
    why: str = ""
    idle: bool = False

    @property
    def likeliest(self) -> str:
        """The motion that the verb stands for before all others, ``""`` where it stands for none."""
        return next(iter(self.motions), "")


@dataclass(frozen=True, eq=False)
class Verbs:
    """Reads verbs as the ``motions`` of one FOON (sorted)."""

    motions: tuple[str, ...]

    def is_motion(self, words: str) -> bool:
        """Whether the FOON has a motion of just these words."""
        return words in self._by_words

    def is_said(self, words: str) -> bool:
        """Whether ``words`` are a motion of the FOON or stand in the table."""
        return words in self._by_words or words in _table()

    def reading(self, verb: str) -> Reading:
        """Return the motions that ``verb`` may stand for ("put-down", "Peeling", "scoop and pour")."""
        said = " ".join(_words(verb))
        if not said:
            return Reading((), why="there is no verb in it")
        return self._of_foon(said) or self._of_parts(said) or self._of_motion_table(said) or self._alike(said)

    def _of_foon(self, said: str) -> Reading | None:
        """Return the motions of the FOON that are called so, by the table or by their stems."""
        if said in self._by_words:
            return Reading(self._by_words[said], SAME)
        if (listed := _table().get(said)) is not None:
            return self._listed(said, listed)
        if (stems := _stems(said)) in self._by_stems:
            return Reading(self._by_stems[stems], SAME_STEM)
        by_stem = next((listed for other, listed in _table().items() if _stems(other) == stems), None)
        return self._listed(said, by_stem) if by_stem is not None else None

    def _of_parts(self, said: str) -> Reading | None:
        """Return the reading of the first of several words, unless they mean another thing together (turn out)."""
        first, _, rest = said.partition(" ")
        if not rest or said in tables().motions:
            return None
        found = self.reading(first)
        return found if found.motions else None

    def _of_motion_table(self, said: str) -> Reading | None:
        """Return the verb itself as motion, where the table of motions says what that does."""
        known = said in tables().motions or said in tables().motion_words
        if not known or not tables().motion(said).does - _LOOKS_ONLY:
            return None
        why = f"no unit of the FOON has the motion “{said}”: taken as the table of motions has it"
        return Reading((said,), BY_TABLE, why)

    def _listed(self, said: str, listed: tuple[str, ...]) -> Reading:
        if listed == (_NO_MOTION,):
            return Reading((), why=f"“{said}” changes no object", idle=True)
        motions = tuple(motion for name in listed for motion in self._by_words.get(" ".join(_words(name)), ()))
        if not motions:
            if (own := self._of_motion_table(said)) is not None:
                return own
            return Reading(
                (), why=f"“{said}” stands for {' or '.join(listed)}, and no unit of the FOON has such a motion"
            )
        return Reading(motions, BY_TABLE)

    def _alike(self, said: str) -> Reading:
        """Return the motion of one word whose vector is nearest, where it is near."""
        single = [motion for motion in self.motions if len(_words(motion)) == 1]
        if single:
            vectors = food_vectors()
            near = np.round((vectors.embed([said]) @ vectors.embed(single).T)[0], 6)
            best = int(np.argmax(near))  # the first of equals, and the motions are sorted
            if near[best] >= _LIKE:
                why = f"no motion of the FOON is called “{said}”; taken as {single[best]}, {near[best]:.2f}"
                return Reading((single[best],), float(near[best]) * BY_TABLE, why)
        return Reading((), why=f"“{said}” is no motion of the FOON")

    @cached_property
    def _by_words(self) -> dict[str, tuple[str, ...]]:
        return _grouped((" ".join(_words(motion)), motion) for motion in self.motions)

    @cached_property
    def _by_stems(self) -> dict[str, tuple[str, ...]]:
        return _grouped((_stems(motion), motion) for motion in self.motions)


def is_verb(word: str, motions: Iterable[str]) -> bool:
    """Say whether ``word`` is a verb that the table lists or the first word of one of ``motions``."""
    known = {name.split()[0] for name in _table()} | {_words(motion)[0] for motion in motions if _words(motion)}
    return word.lower() in known or word.lower() in tables().motion_words


def _grouped(pairs: Iterable[tuple[str, str]]) -> dict[str, tuple[str, ...]]:
    grouped: dict[str, tuple[str, ...]] = {}
    for name, motion in pairs:
        grouped[name] = (*grouped.get(name, ()), motion)
    return grouped


def _words(text: str) -> list[str]:
    return _WORD.findall(text.lower())


def _stems(text: str) -> str:
    return " ".join(map(stem, _words(text)))


@lru_cache(maxsize=1)
def _table() -> dict[str, tuple[str, ...]]:
    """Return the motions of every verb of the table; a verb at several lines has those of all, in their order."""
    text = files("foon_kg.language.drafting").joinpath("verbs.txt").read_text(encoding="utf-8")
    table: dict[str, tuple[str, ...]] = {}
    for line in text.splitlines():
        motions, _, verbs = line.partition(":")
        if not line.startswith("#"):
            for verb in verbs.split(","):
                said = " ".join(_words(verb))
                table[said] = (*table.get(said, ()), *(motion.strip() for motion in motions.split(",")))
    return table
