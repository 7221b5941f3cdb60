"""Why a final tree makes every required food as it does: read off the tree and what it was chosen from."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from foon_kg.integration.reenacting import FinalTree, Integration
from foon_kg.lines import FoodLine
from foon_kg.model import KnownUnit, RequiredIngredient
from foon_kg.party import Addition
from foon_kg.script import Casting, Recast
from foon_kg.substitution import FAIR, Candidate
from foon_kg.ways import Preparation

MOST_UNLIKE = 2
"""How many of the nearest known foods are named where none of them has an equivalent."""

How = Literal["played", "made", "sold", "assumed", "missing"]
"""A line of the reference plays the food; or it is made apart; or it joins as sold; or so assumed; or not at all."""


@dataclass(frozen=True)
class PassedOver:
    """A known food in a state that might have stood for the required one, how sure that is (0..1), and why not."""

    label: str
    state: str
    confidence: float
    why: str


@dataclass(frozen=True)
class Joining:
    """Where a food joins the others: the step of the tree (from 1; ``None`` where it is not in it) and its motion.

    The reasons for that place, where the food was brought there: ``like`` is the food most like it that joins there
    in the reference and ``likeness`` how like (0..1); ``left_open`` are foods that joined there and are not asked for.
    """

    step: int | None
    motion: str
    like: str = ""
    likeness: float = 0.0
    left_open: tuple[str, ...] = ()


@dataclass(frozen=True)
class Explanation:
    """Why one required food is made as it is.

    ``label`` is the known food that it is handled like, ``confidence`` how sure that is (0..1) or that a person
    has ``chosen`` it; ``renamed`` are states and motions as FOON has them and what stands for each; ``videos`` say
    where the units were seen.
    """

    want: RequiredIngredient
    how: How
    label: str = ""
    confidence: float = 1.0
    chosen: bool = False
    renamed: tuple[tuple[str, str], ...] = ()
    videos: tuple[str, ...] = ()
    joins: Joining | None = None
    passed_over: tuple[PassedOver, ...] = ()


def explanations(tree: FinalTree, integration: Integration) -> tuple[Explanation, ...]:
    """Answer why ``tree``, which ``integration`` made, has each required food as it has it, in their order."""
    reader = _Reader(tree, integration)
    return tuple(reader.explain(want) for want in integration.wants)


class _Reader:
    """One tree being explained."""

    def __init__(self, tree: FinalTree, integration: Integration) -> None:
        self.tree = tree
        self.script = integration.script
        self.kitchen = integration.kitchen
        self.equivalents = integration.equivalents
        self.preparations = integration.preparations
        self.lines = self.preparations.readings.of(self.script).lines
        self.additions = {addition.want: addition for addition in tree.additions}

    def explain(self, want: RequiredIngredient) -> Explanation:
        if want in self.tree.lines:
            return self._played(want, self.lines[self.tree.lines[want]])
        addition = self.additions.get(want)
        if addition is None:
            return Explanation(want, "missing", passed_over=tuple(self._not_chosen(want, None)))
        if addition.preparation is not None:
            return self._made(addition, addition.preparation)
        sold = self.kitchen.is_start_state(want.object, want.state)
        passed = tuple(self._not_chosen(want, None))
        return Explanation(want, "sold" if sold else "assumed", joins=self._joining(addition), passed_over=passed)

    def _played(self, want: RequiredIngredient, line: FoodLine) -> Explanation:
        recast = self._recast(line.label, (casting for step, casting in self.tree.steps if step.known in self.script))
        fit = [self.equivalents.state_confidence(want.object, now, known) for known, now in recast.states.items()]
        confidence = self._own(want, line.label) * min(fit, default=1.0)
        units = [known for known in self.script if any(n.label == line.label for n in known.unit.input_nodes)]
        made = self.tree.made_apart.get(want)
        apart = () if made is None else self._ready(made.preparation)
        before = [] if made is None else [step.known for step in made.preparation.steps]
        return Explanation(
            want,
            "played",
            line.label,
            round(confidence, 4),
            self._is_chosen(want, line.label),
            tuple(dict.fromkeys((*apart, *_renamed(recast)))),
            _videos((*before, *units)),
            Joining(self._step_of(self.script[line.joins]), self.script[line.joins].unit.motion),
            tuple(self._made_apart(want, confidence, None if made is None else made.preparation)),
        )

    def _made(self, addition: Addition, preparation: Preparation) -> Explanation:
        want, candidate = addition.want, preparation.candidate
        return Explanation(
            want,
            "made",
            candidate.label,
            round(self._confidence(want, candidate), 4),
            self._is_chosen(want, candidate.label),
            self._ready(preparation),
            _videos(step.known for step in preparation.steps),
            self._joining(addition),
            tuple(self._not_chosen(want, preparation)),
        )

    def _ready(self, preparation: Preparation) -> tuple[tuple[str, str], ...]:
        """Answer what is renamed where a food is made apart."""
        return tuple(_renamed(self._recast(preparation.candidate.label, [preparation.casting])))

    # ---- where it joins

    def _joining(self, addition: Addition) -> Joining:
        here = [line.label for line in self.lines.values() if line.joins == addition.place]
        likeness = {label: self.equivalents.name_confidence(addition.want.object, label) for label in here}
        like = max(sorted(here), key=likeness.__getitem__, default="")
        number = next((n for n, (s, _) in enumerate(self.tree.steps, 1) if addition.node in s.added), None)
        played = set(self.tree.lines.values())
        free = [label for label in here if label not in played and not self.kitchen.is_free(label)]
        motion = self.script[addition.place].unit.motion
        return Joining(number, motion, like, round(likeness.get(like, 0.0), 4), tuple(free))

    def _step_of(self, known: KnownUnit) -> int | None:
        return next((number for number, (step, _) in enumerate(self.tree.steps, 1) if step.known == known), None)

    # ---- what was not taken

    def _made_apart(
        self, want: RequiredIngredient, confidence: float, taken: Preparation | None
    ) -> Iterator[PassedOver]:
        """Answer the ways to make a food apart, but ``taken``, that a line of the reference was preferred to."""
        for other in self.preparations.of(want):
            if other is taken:
                continue
            less = self._confidence(want, other.candidate) < confidence
            why = _STALE if other.stale else "less sure" if less else "the reference has as good a one"
            yield self._passed(want, other.candidate, why)

    def _not_chosen(self, want: RequiredIngredient, taken: Preparation | None) -> Iterator[PassedOver]:
        """Answer the other ways to make a food apart; ``taken`` is ``None`` where it joins as it is."""
        made = self.preparations.of(want)
        before = len(made) if taken is None else made.index(taken)
        for other in made[:before]:
            yield self._passed(want, other.candidate, "nothing made so gets into the dish")
        for other in made[before + 1 :]:
            chosen = taken is not None and self._is_chosen(want, taken.candidate.label)
            beside = chosen and not self._is_chosen(want, other.candidate.label)
            yield self._passed(want, other.candidate, "you chose another" if beside else _why_later(other, taken))
        if self.kitchen.is_start_state(want.object, want.state):
            return
        known = {(other.candidate.label, other.candidate.state) for other in made}
        candidates = self.equivalents.candidates(want)
        for candidate in candidates:
            if (candidate.label, candidate.state) not in known:
                yield self._passed(want, candidate, "its own steps do not make it so from this kitchen")
        if not candidates:
            for label, sure in self.equivalents.labels_like(want.object)[:MOST_UNLIKE]:
                why = "too unlike" if sure < FAIR else "FOON makes it in no such state"
                yield PassedOver(label, "", round(sure, 4), why)

    def _passed(self, want: RequiredIngredient, candidate: Candidate, why: str) -> PassedOver:
        return PassedOver(candidate.label, candidate.state, round(self._confidence(want, candidate), 4), why)

    # ---- how sure

    def _own(self, want: RequiredIngredient, label: str) -> float:
        confidence = self.equivalents.own_confidence or self.equivalents.name_confidence
        return confidence(want.object, label)

    def _confidence(self, want: RequiredIngredient, candidate: Candidate) -> float:
        return self._own(want, candidate.label) * candidate.state_confidence

    def _is_chosen(self, want: RequiredIngredient, label: str) -> bool:
        return self.equivalents.name_confidence(want.object, label) > self._own(want, label)

    def _recast(self, label: str, castings: Iterable[Casting]) -> Recast:
        return next((recast for casting in castings if (recast := casting.foods.get(label)) is not None), Recast(label))


_STALE = "it takes something that an earlier step took away"


def _why_later(other: Preparation, taken: Preparation | None) -> str:
    if other.stale:
        return _STALE
    sure = taken is None or round(other.confidence, 4) >= round(taken.confidence, 4)
    return "takes more steps" if sure else "less sure"


def _renamed(recast: Recast) -> Iterator[tuple[str, str]]:
    """Answer the states and motions that FOON has and what stands for each now."""
    changes: Mapping[str, str] = {**recast.states, **recast.motions}
    yield from sorted((known, now) for known, now in changes.items() if known and known != now)


def _videos(units: Iterable[KnownUnit]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(known.seen_in[0].video for known in units if known.seen_in))
