"""Which other recorded dishes a recipe could have been made after, and what spoke against them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from foon_kg.goals.choice import Fit
from foon_kg.model import ObjectNode
from foon_kg.model.errors import NoTreeError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.node_json import node_to_json
from foon_kg.model.nodes import one_spelling
from foon_kg.planning.likes import RecipeLikes

MOST_NEARER = 3
"""How many goals that are nearer and were passed over are named."""

MOST_OTHERS = 4
"""How many other goals are named."""


@dataclass(frozen=True)
class Considered:
    """A goal that was considered: its ``video``, how near its foods are (0 to 1), and ``why`` it was not taken.

    ``nearer`` says that it is nearer by its foods than the one that was taken.
    """

    goal: ObjectNode
    video: str
    dish_type: str
    similarity: float
    nearer: bool
    why: str

    def to_json(self) -> JsonObject:
        """Return it field by field."""
        return {
            "goal": node_to_json(self.goal),
            "video": self.video,
            "dish_type": self.dish_type,
            "similarity": self.similarity,
            "nearer": self.nearer,
            "why": self.why,
        }


def core_of(fit: Fit, likes: RecipeLikes) -> tuple[str, ...]:
    """Return the foods of the recorded dish of ``fit`` that the recipe has too, or such as fairly stand for them.

    ``likes`` say which do.
    """
    places = ((join.want.label, join.slot.food) for join in fit.joins if join.slot is not None)
    return tuple(dict.fromkeys(food for label, food in places if likes.is_fair(label, food)))


def nearer_goals(fits: Sequence[Fit], taken: Fit, dish_type: str) -> Iterator[Considered]:
    """Yield of ``fits`` the goals of the ``dish_type`` that are nearer by their foods than that ``taken``.

    The nearest comes first.
    """
    types = {dish_type, taken.frame.dish_type}
    rows = [fit for fit in fits if fit.frame.dish_type in types and fit.similarity > taken.similarity]
    rows.sort(key=lambda fit: (-fit.similarity, fit.frame.goal.sort_key))
    told = {taken.frame.goal}
    for fit in rows:
        if fit.frame.goal not in told and len(told) <= MOST_NEARER:  # the one that is taken is among those told
            told.add(fit.frame.goal)
            yield _considered(fit, taken)


def other_goals(fits: Sequence[Fit], taken: Fit, dish_type: str) -> Iterator[Considered]:
    """Yield of ``fits`` the goals nearer than the one ``taken``, then those of any type that suit next best.

    Nothing speaks against the latter, and each takes some of the foods. ``dish_type`` is the one that was asked.
    """
    nearer = tuple(nearer_goals(fits, taken, dish_type))
    yield from nearer
    told = {taken.frame.goal, *(one.goal for one in nearer)}
    most = len(told) + MOST_OTHERS
    for fit in fits:  # the best first
        suits = 0 < fit.similarity <= taken.similarity and not fit.vetoes
        if suits and fit.frame.goal not in told and len(told) < most:
            told.add(fit.frame.goal)
            yield _considered(fit, taken)


def _considered(fit: Fit, taken: Fit) -> Considered:
    why = fit.vetoes[0] if fit.vetoes else _less_suited(fit, taken)
    frame, similarity = fit.frame, round(fit.similarity, 4)
    return Considered(frame.goal, frame.video, frame.dish_type, similarity, fit.similarity > taken.similarity, why)


def _less_suited(fit: Fit, taken: Fit) -> str:
    """Return why a dish against which nothing speaks was not ``taken``: what of its score is less, if that is plain."""
    if fit.score > taken.score:
        return "it suits better, and another was asked for, or it came to no tree that is accepted"
    if fit.dish.frame.dish_type != taken.frame.dish_type:
        return f"it is of another type ({fit.frame.dish_type}), and suits less in all: {_scores(fit, taken)}"
    places, others = (sum(join.slot is not None for join in one.joins) for one in (fit, taken))
    if places < others:
        return f"{places} of the foods asked with a place of their own in it, and {others} in the one that is taken"
    return f"what it is built on, how it is made and called suit less in all: {_scores(fit, taken)}"


def _scores(fit: Fit, taken: Fit) -> str:
    return f"score {fit.score:.2f}, of the one that is taken {taken.score:.2f}"


def made_after(found: Sequence[Fit], after: str) -> list[Fit]:
    """Return those ``found`` that are of a dish or a video called ``after`` (``""``: any).

    Raises :class:`NoTreeError` where none is.
    """
    chosen = [fit for fit in found if not after or after in {one_spelling(fit.frame.goal.label), fit.frame.video}]
    if after and not chosen:
        names = ", ".join(list(dict.fromkeys(fit.frame.goal.label for fit in found))[:5]) or "none"
        hint = f"What suits these foods best: {names}."
        raise NoTreeError(
            f"these foods are not made after a dish or a video called “{after}”", code="no-goal", hint=hint
        )
    return chosen
