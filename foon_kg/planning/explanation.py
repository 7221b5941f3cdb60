"""Why a final tree makes every required food as it does: read off the tree and what it was chosen from."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from foon_kg.food import singular
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.preparing.preparation import Want
from foon_kg.model import RequiredIngredient
from foon_kg.model.tree import Step
from foon_kg.planning.attempt import Attempt
from foon_kg.planning.likes import RecipeLikes

MOST_OTHERS = 3
"""How many known foods that were passed over are named."""

How = Literal["played", "made", "sold", "assumed", "missing"]
"""The recorded dish has a place for such a food; or it is prepared and joins where its kind does; or it joins as it
is sold, or is assumed to be; or not at all."""


@dataclass(frozen=True)
class PassedOver:
    """A known food that might have stood for the required one, how sure that is (0..1), and why not."""

    label: str
    state: str
    confidence: float
    why: str

    def __str__(self) -> str:
        return f"{self.state} {self.label} ({self.confidence:.2f})".strip()


@dataclass(frozen=True)
class Joining:
    """Where a food joins the others: the step of the tree (from 1; ``None`` where it is not in it) and its motion.

    ``like`` is the food of the recorded dish in whose place it comes and ``likeness`` how like (0..1); without one it
    joins where foods of its kind do.
    """

    step: int | None
    motion: str
    like: str = ""
    likeness: float = 0.0
    left_open: tuple[str, ...] = ()

    def __str__(self) -> str:
        """Return where the food joins, and in whose place, as the end of a sentence about it."""
        where = f"joins the others in step {self.step} ({self.motion})" if self.step else f"joins in “{self.motion}”"
        if self.like and round(self.likeness, 1) > 0:
            return f"{where}, where {self.like} joins in the recorded dish ({self.likeness:.2f} like it)"
        if self.left_open:
            return f"{where}, in the place of {', '.join(self.left_open)}, which nobody asked for"
        return where


@dataclass(frozen=True)
class Explanation:
    """Why one required food is made as it is.

    ``label`` is the known food that it is handled like, ``confidence`` how sure that is (0..1) or that a person
    has ``chosen`` it; ``renamed`` are asked states and what each was read as; ``videos`` say where the evidence is.

    >>> print(Explanation(RequiredIngredient("salt", "granulated"), "sold", joins=Joining(3, "sprinkle")))
    salt (granulated)
      joins as it is sold
      joins the others in step 3 (sprinkle)
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

    @property
    def reasons(self) -> tuple[str, ...]:
        """Where the food comes from and where it joins the others, a sentence each; one of them where it joins nothing.

        >>> Explanation(RequiredIngredient("leek", "sliced"), "made", "onion", 0.87, videos=("soup",)).reasons
        ('is made ready as FOON makes onion in soup, 0.87 sure',)
        """
        joins = () if self.joins is None else (str(self.joins),)
        return (_origin(self) + _renamed_so(self), *joins)

    @property
    def others(self) -> tuple[str, ...]:
        """The known foods that were passed over, a sentence for each reason.

        >>> leek = PassedOver("leek", "", 0.8, "less sure")
        >>> Explanation(RequiredIngredient("chive", "chopped"), "made", "onion", 0.87, passed_over=(leek,)).others
        ('not like leek (0.80): less sure',)
        """
        reasons = dict.fromkeys(other.why for other in self.passed_over)
        named = {why: ", ".join(str(other) for other in self.passed_over if other.why == why) for why in reasons}
        return tuple(f"not like {names}: {why}" for why, names in named.items())

    def __str__(self) -> str:
        """Return the food with its state, and below it each sentence."""
        want = f"{self.want.object} ({self.want.state})" if self.want.state else self.want.object
        return "\n  ".join((want, *self.reasons, *self.others))


class Explanations(tuple[Explanation, ...]):
    """The explanations of a plan in the order of its recipe: a tuple that prints as sentences."""

    __slots__ = ()

    def __str__(self) -> str:
        return "\n".join(map(str, self))


def _origin(one: Explanation) -> str:
    """Return how the food of an explanation comes to what it is, where that was seen and how sure it is."""
    seen = f" in {', '.join(one.videos)}" if one.videos else ""
    like = one.label if one.label != one.want.object else "it"
    sure = f", {one.confidence:.2f} sure" if one.confidence < 1 else ""
    chosen = ", as you chose" if one.chosen else ""
    match one.how:
        case "played":
            return f"has a place in the recorded dish, and is handled as FOON handles {like}{seen}{sure}{chosen}"
        case "made":
            return f"is made ready as FOON makes {like}{seen}{sure}{chosen}"
        case "sold":
            return "joins as it is sold"
        case "assumed":
            return "is assumed to be there: nothing in this FOON, nor any fair equivalent, makes it so"
        case "missing":
            return "does not get into this dish"


def _renamed_so(one: Explanation) -> str:
    pairs = [f"“{asked}” is read as {meant}" for asked, meant in one.renamed]
    return f" ({', '.join(pairs)})" if pairs else ""


def explanations(attempt: Attempt, likes: RecipeLikes) -> tuple[Explanation, ...]:
    """Return why the tree of ``attempt`` has each required food as it has it, in their order, by these ``likes``."""
    joins = sorted(attempt.fit.joins, key=lambda join: join.want.number)
    steps = _steps_of_things(attempt.result.units)
    return tuple(_explained(attempt, join, likes, steps) for join in joins)


def _explained(
    attempt: Attempt, join: Join, likes: RecipeLikes, steps: Mapping[int, Sequence[tuple[int, Step]]]
) -> Explanation:
    """Return why the food that comes in by ``join`` is made as the tree of ``attempt`` makes it.

    ``steps`` are those of each thing.
    """
    want = join.want
    asked = RequiredIngredient(want.label, want.asked)
    ready = attempt.cooking.ready.get(want.number)
    if ready is None:
        return Explanation(asked, "missing")
    number = ready.stuff.number
    own = steps.get(number, ())
    how = _how(ready.assumptions, join, [unit for _, unit in own])
    like, sure = _handled_like(attempt, want.label)
    chosen = bool(like) and singular(want.label) in likes.instead
    renamed = _renamed(attempt, want)
    others = likes.others(want.label, like) if like else ()
    return Explanation(
        asked, how, like or want.label, sure, chosen, renamed,
        tuple(_videos(unit for _, unit in own)), _joining(own, number, join),
        tuple(_passed_over(others, sure, chosen=chosen)),
    )  # fmt: skip


def _passed_over(others: Sequence[tuple[str, float]], sure: float, *, chosen: bool) -> Iterator[PassedOver]:
    """Yield the first of ``others``, known foods with how sure each is, as passed over, each with its reason.

    ``sure`` is how sure the one is that was taken: the surest of those that have evidence for a step of the food
    (:meth:`~foon_kg.integration.teaching.operators.Operators.attested`). So a surer one has none.
    """
    for name, confidence in others[:MOST_OTHERS]:
        if chosen:
            why = "you chose another"
        elif round(confidence, 4) > sure:
            why = "no video does with it what is done here"
        else:
            why = "less sure" if round(confidence, 4) < sure else "no surer"
        yield PassedOver(name, "", round(confidence, 4), why)


def _how(assumptions: Sequence[object], join: Join, own: Sequence[Step]) -> How:
    """Return how a food comes to what it is: assumed, as a video plays it, made in steps of its own, or as sold."""
    if assumptions:
        return "assumed"
    if join.slot:
        return "played"
    return "made" if any(unit.phase == "prepare" for unit in own) else "sold"


def _renamed(attempt: Attempt, want: Want) -> tuple[tuple[str, str], ...]:
    """Return the state that was asked of a food, with the one that it was read as, where that is another."""
    return tuple(
        (one.required, one.equivalent)
        for one in attempt.result.substitutions
        if one.kind == "state" and one.object == want.label and one.required == want.asked
    )


def _handled_like(attempt: Attempt, label: str) -> tuple[str, float]:
    for one in attempt.result.substitutions:
        if one.kind == "object" and singular(one.object) == singular(label):
            return one.equivalent, one.confidence
    return "", 1.0


def _steps_of_things(units: Iterable[Step]) -> dict[int, list[tuple[int, Step]]]:
    """Return by the number of each thing the steps that take or make it, each with its place from 1."""
    found: dict[int, list[tuple[int, Step]]] = {}
    for place, unit in enumerate(units, 1):
        for thing in {one.thing for one in (*unit.inputs, *unit.outputs) if one.thing is not None}:
            found.setdefault(thing, []).append((place, unit))
    return found


def _joining(own: Sequence[tuple[int, Step]], number: int, join: Join) -> Joining:
    """Return where the thing of this ``number``, which comes in by ``join``, joins others among its ``own`` steps."""
    step, motion = _first_shared(own, number)
    if join.slot is None:
        return Joining(step, motion)
    return Joining(step, motion, join.slot.food, round(join.fit, 4))


def _first_shared(own: Sequence[tuple[int, Step]], number: int) -> tuple[int | None, str]:
    """Return the first step after which a food shares its vessel with others."""
    for place, unit in own:
        inside = {one.container_thing for one in unit.outputs if one.thing == number} - {None}
        if any(one.thing in inside and len(one.node.ingredients) > 1 for one in unit.outputs):
            return place, unit.motion
    return (own[-1][0], own[-1][1].motion) if own else (None, "")


def _videos(units: Iterator[Step]) -> Iterator[str]:
    yield from dict.fromkeys(unit.seen_in[0].video for unit in units if unit.seen_in)
