"""Which food, state and motion of FOON may stand for what a recipe wants (paper, algorithm 4, lines on equivalents).

A known *diced potato* becomes a *sliced potato* with *slice* instead of *dice*: first the object, then a state
of the same class, then the motion that makes the wanted state. What is sold in a state never stands for what
somebody has to make (a whole potato for a sliced one): that would claim work that nobody does (contract, C8).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from functools import cached_property

from foon_kg import motions
from foon_kg.food import Food, Level, tables
from foon_kg.kitchen import Kitchen, words
from foon_kg.knowledge import MadeBy, SeenAs, Vocabulary
from foon_kg.model import RequiredIngredient
from foon_kg.recent import Recent
from foon_kg.script import Recast
from foon_kg.states import motion_for

FAIR = 0.5
"""An equivalent below this confidence is none (contract, C6 and S5)."""

SAME_CLASS = 0.5
"""States at least this similar may stand for one another."""

MOST_FOODS = 1024
"""Of so many foods it is kept what may stand for them."""

Rows = Recent[str, tuple[tuple[str, float], ...]]
Named = Recent[str, MadeBy | None]


@dataclass(frozen=True)
class Candidate:
    """A food of FOON in a state that FOON makes, as an equivalent of a required one."""

    label: str
    state: str
    name_confidence: float
    state_confidence: float

    @property
    def confidence(self) -> float:
        """How likely a cook would accept it, taking name and state as independent."""
        return self.name_confidence * self.state_confidence


def eaten_raw(food: str, state: str = "") -> bool:
    """Return whether ``food`` may be eaten without being cooked: no raw meat, fish, egg or potato."""
    return _known(food, state).owes.get("cook") is not Level.FATAL


def _is_raw_flesh(food: str, state: str) -> bool:
    return _known(food, state).is_a("meat", "fish", "shellfish") and not eaten_raw(food, state)


def _known(food: str, state: str) -> Food:
    return tables().foods.food(food, [state] if state else [])


@dataclass(frozen=True)
class Equivalents:
    """What the words of one FOON may stand for, seen from one recipe.

    ``name_confidence`` maps (required object, FOON label) to a probability; ``state_similarity`` two states to 0..1.
    ``own_confidence`` is what an answer says of the names, where a person's choice made ``name_confidence`` differ.
    Without ``choose_motions`` every motion stays as the FOON has it.
    """

    vocabulary: Vocabulary
    kitchen: Kitchen
    name_confidence: Callable[[str, str], float]
    state_similarity: Callable[[str, str], float]
    own_confidence: Callable[[str, str], float] | None = None
    choose_motions: bool = True
    _fair: Rows = field(default_factory=lambda: Recent(MOST_FOODS), repr=False, compare=False)
    _motion_named: Named = field(default_factory=lambda: Recent(MOST_FOODS), repr=False, compare=False)
    _labels_like: Rows = field(default_factory=lambda: Recent(MOST_FOODS), repr=False, compare=False)

    def state_confidence(self, food: str, required: str, known: str) -> float:
        """Say how well the FOON's state ``known`` stands for ``required`` of ``food``; 0 where it must not."""
        if required == known:
            return 1.0
        sold = self.kitchen.is_start_state(food, required)
        if sold != self.kitchen.is_start_state(food, known) and known:
            return 0.0
        if not known:
            return SAME_CLASS if sold else 0.0
        return self.state_similarity(required, known)

    def candidates(self, want: RequiredIngredient, *, limit: int = 8) -> tuple[Candidate, ...]:
        """Answer the fair equivalents that FOON makes, surest first, at most ``limit``; ties by label and state."""
        found = []
        for label, name in self._made_like(want.object):
            for row in self._made[label]:
                state = self.state_confidence(want.object, want.state, row.state)
                if state >= SAME_CLASS:
                    found.append(Candidate(label, row.state, name, state))
        found.sort(key=lambda c: (-c.confidence, c.label, c.state))
        return tuple(found[:limit])

    def _made_like(self, food: str) -> tuple[tuple[str, float], ...]:
        """Answer the foods that FOON makes and that are fair equivalents of ``food``, with their confidence."""
        if food not in self._fair:
            sure = ((label, self.name_confidence(food, label)) for label in self._made)
            self._fair[food] = tuple(row for row in sure if row[1] >= FAIR)
        return self._fair[food]

    @cached_property
    def _made(self) -> dict[str, tuple[SeenAs, ...]]:
        """The states in which FOON makes each food."""
        made = {
            label: tuple(row for row in rows if row.made and row.state)
            for label, rows in self.vocabulary.rows_of.items()
        }
        return {label: rows for label, rows in made.items() if rows}

    @cached_property
    def _made_with_word(self) -> dict[str, list[str]]:
        """The foods that FOON makes, by each word of their names."""
        found: dict[str, list[str]] = {}
        for label in self._made:
            for word in set(words(label)):
                found.setdefault(word, []).append(label)
        return found

    def recast(
        self, want: RequiredIngredient, states: Iterable[str], made_by: Iterable[tuple[str, str]]
    ) -> tuple[Recast, float] | None:
        """Answer how a food that passes ``states`` plays ``want``, and how well its states fit (0..1).

        ``made_by`` are the (state, motion) of the line. ``None`` where none of its states can stand for the
        wanted one.
        """
        passed = sorted(set(states)) or [""]
        if not want.state or want.state in passed:
            return Recast(want.object), 1.0
        best = max(passed, key=lambda s: (self.state_confidence(want.object, want.state, s), s))
        fit = self.state_confidence(want.object, want.state, best)
        if fit < SAME_CLASS:
            return None
        motion = dict(made_by).get(best)
        renamed = {} if motion is None else self._motion_for(want.state, motion)
        return Recast(want.object, {best: want.state}, renamed), fit

    def _motion_for(self, state: str, motion: str) -> dict[str, str]:
        """Answer the motion that stands for ``motion`` when ``state`` is made; nothing where FOON makes it so too.

        It is the one named after the state (minced, mince) before the commonest, and none that only moves food or
        needs other things than are there for ``motion``.
        """
        known = self._motions.get(state, ())
        if not self.choose_motions or not known or motion in {name for name, _ in known}:
            return {}
        if state not in self._motion_named:
            self._motion_named[state] = motion_for(state, self.vocabulary)
        named = self._motion_named[state]
        if named is not None and named.motion == motion:
            return {}  # to boil makes boiled, whether or not FOON has ever called it so
        first = [named.motion] if named is not None and named.count else []
        others = (other for other, _ in known if not motions.transfers(other))
        chosen = next((other for other in (*first, *others) if motions.may_stand_for(other, motion)), None)
        return {} if chosen is None else {motion: chosen}

    @cached_property
    def _motions(self) -> dict[str, tuple[tuple[str, int], ...]]:
        rows: dict[str, list[tuple[str, int]]] = {}
        for row in self.vocabulary.motions:
            rows.setdefault(row.state, []).append((row.motion, row.count))
        return {state: tuple(sorted(found, key=lambda r: (-r[1], r[0]))) for state, found in rows.items()}

    def labels_like(self, food: str) -> tuple[tuple[str, float], ...]:
        """Answer the foods of FOON with their confidence as equivalents of ``food``, surest first."""
        if food not in self._labels_like:
            labels = self.vocabulary.rows_of.keys() - {food}
            confidence = self.own_confidence or self.name_confidence
            rows = sorted(((name, confidence(food, name)) for name in labels), key=lambda row: (-row[1], row[0]))
            self._labels_like[food] = tuple(rows)
        return self._labels_like[food]

    def states_like(self, food: str, required: str, label: str) -> tuple[tuple[str, float], ...]:
        """Answer the states of the known food ``label`` that may stand for ``required`` of ``food``, surest first."""
        states = sorted({row.state for row in self.vocabulary.rows_of.get(label, ()) if row.state})
        rows = ((state, self.state_confidence(food, required, state)) for state in states)
        return tuple(sorted((row for row in rows if row[1] > 0), key=lambda r: (-r[1], r[0])))

    def motions_like(self, state: str) -> tuple[tuple[str, float], ...]:
        """Answer the motions that make ``state`` with their shares, most frequent first."""
        rows = self._motions.get(state, ())
        total = sum(count for _, count in rows)
        return tuple((motion, count / total) for motion, count in rows)

    def states_known(self, label: str) -> tuple[str, ...]:
        """Answer the states in which FOON makes the food ``label``, most frequent first."""
        return tuple(row.state for row in sorted(self._made.get(label, ()), key=lambda row: (-row.made, row.state)))

    def parts(self, food: str) -> tuple[tuple[str, str], ...]:
        """Answer each raw (label, state) that FOON makes and calls after ``food`` with more words, sorted."""
        own = words(food)
        labels = self._made_with_word.get(own[0], ()) if own else self._made
        rows = (row for label in labels if set(own) < set(words(label)) for row in self._made[label])
        return tuple(sorted((r.label, r.state) for r in rows if self.kitchen.is_start_state(r.label, r.state)))

    def cooked(self, want: RequiredIngredient) -> tuple[Candidate, ...]:
        """Answer how FOON cooks meat or fish that is asked raw, or its fair equivalent, surest first; none for others.

        Nobody eats it raw: where nothing is heated after it joins, it is cooked before.
        """
        sold = want.state and self.kitchen.is_start_state(want.object, want.state)
        if not sold or not _is_raw_flesh(want.object, want.state):
            return ()
        return self.candidates(replace(want, state="cooked"))

    def makings(self, want: RequiredIngredient) -> tuple[tuple[str, str], ...]:
        """Answer each (label, state) of FOON that may have to be made for ``want``, sorted.

        For a processed food these are its equivalents, for one that is sold so the states in which it is opened.
        """
        if self.kitchen.is_start_state(want.object, want.state):
            states = (s for s in self.states_known(want.object) if not self.kitchen.is_start_state(want.object, s))
            cooked = ((candidate.label, candidate.state) for candidate in self.cooked(want))
            return tuple(sorted({*((want.object, state) for state in states), *self.parts(want.object), *cooked}))
        return tuple(sorted({(candidate.label, candidate.state) for candidate in self.candidates(want)}))
