"""The default similarity: evidence of fourteen kinds, weighed into one probability.

``confidence = 0.99 / (1 + exp(-(bias + sum of weight * evidence)))``, a logistic regression on pairs of foods that were
judged as a cook would, stretched so that what is *told* (the first five of a food) is accepted as often as is said.
``benchmarks/similarity.py`` fits the weights (``similarity.json``) and measures them on halves that they were not
fitted on: of what was told at 0.9 or more 97 % were accepted, at 0.5 to 0.7 54 %, at 0.1 to 0.3 18 %. So 0.5 means: as
likely as not, a cook would accept the known food. Below ``UNLIKE`` (:mod:`foon_kg.model.knowledge`) nothing is
like it, and the confidence is 0. Of a name with a word that no recipe and no table has ("floober sauce") nothing is
sure. Equal canonical names are one food, at 1; nothing else reaches 0.99.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from importlib.resources import files

import numpy as np
import numpy.typing as npt

from foon_kg.model.knowledge import UNLIKE, Neighbour
from foon_kg.model.names import canonical, canonical_all
from foon_kg.similarity.confidences import DECIMALS, Confidences, best
from foon_kg.similarity.evidence import KINDS, Evidence, Names
from foon_kg.similarity.groups import food_groups
from foon_kg.similarity.roles import roles, roles_of
from foon_kg.similarity.sparse import Table
from foon_kg.similarity.taxonomy import food_taxonomy
from foon_kg.similarity.vectors import food_vectors

_MOST = 0.99
_FEW = 8  # known foods that are not worth to be remembered in the place of many
_REMEMBERED = 8_000_000  # confidences, 64 MB: 20,000 rows where 400 foods are known
_AT_ONCE = 1_000_000  # pairs whose evidence is in memory at a time, 96 MB
_NAMES_AT_ONCE = 1_000  # names of which all that is known is in memory at a time
_TOLD = 0.3  # evidence of less weight than this changes no answer that a person would notice
_TOLD_AS = {
    "vectors": "named in like company",
    "kind": "of one kind",
    "group": "both used alike",
    "guessed group": "likely used alike",
    "more specific": "a sort of it",
    "more general": "a wider name of it",
}


@dataclass(frozen=True, eq=False)
class _Known:
    """Known names made ready once, and the log odds of each wanted name so far, a row of them all."""

    names: npt.NDArray[np.str_]
    about: Names
    odds_of: dict[str, Table]

    @cached_property
    def roles(self) -> npt.NDArray[np.int64]:
        """The roles that each may play, a bit for each."""
        return _roles(self.names.tolist())


class FoodSimilarity:
    """Weighs the evidence for each pair of names; the odds of a name once asked are remembered."""

    def __init__(self, evidence: Evidence, weights: Table, bias: float, slot: tuple[float, float] = (1.0, 0.0)) -> None:
        self.evidence = evidence
        self._slot = slot
        self.bias = bias
        self._weights = weights
        self._known = lru_cache(maxsize=4)(self._about_known)

    @property
    def weights(self) -> dict[str, float]:
        """Return what each kind of evidence weighs."""
        return dict(zip(KINDS, self._weights.tolist(), strict=True))

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        """Return confidences, one row for each wanted name, one column for each known one.

        They are 0 where nothing speaks for it, else between ``UNLIKE`` and 1.
        """
        rows, side = [canonical(name) for name in wanted], self._side(known)
        return _sure(self._odds(rows, side), rows, side)

    def in_slots(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        """Return how sure a cook is to accept each known food for what the wanted one does in the slot of a dish.

        One row for each wanted name, one column for each known one: the most that :meth:`in_slot` returns for any role.
        """
        rows, side = [canonical(name) for name in wanted], self._side(known)
        slope, bias = self._slot
        shared = _roles(rows)[:, None] & side.roles[None, :] != 0
        return np.where(shared, _sure(slope * self._odds(rows, side) + bias, rows, side), 0.0)

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        """Return the ``limit`` known names that can best stand for ``name``, best first, ties by name.

        Fewer where fewer are like it, and none where nothing is.
        """
        return best(known, self.matrix([name], known)[0], limit)

    def in_slot(self, name: str, known: Sequence[str], role: str) -> Confidences:
        """Return for each known name how sure a cook is to accept it where ``name`` plays ``role`` in a dish.

        Broth is unlike water, and is taken for it as a liquid. 0 for names that do not play it, and where ``name``
        does not.
        """
        one, side = canonical(name), self._side(known)
        slope, bias = self._slot
        plays = [role in roles_of(one) and role in roles_of(other) for other in side.names.tolist()]
        return np.where(plays, _sure(slope * self._odds([one], side) + bias, [one], side)[0], 0.0)

    def why(self, name: str, known: str) -> tuple[str, ...]:
        """Return the kinds of evidence that speak for ``known`` standing for ``name``, the weightiest first."""
        one, other = canonical(name), canonical(known)
        if one == other:
            return ("the same food",)
        evidence = self.evidence.between(self.evidence.about([one]), self.evidence.about([other]))[:, 0, 0]
        weight = dict(zip(KINDS, (self._weights * evidence).tolist(), strict=True))
        told = sorted((kind for kind in _TOLD_AS if weight[kind] >= _TOLD), key=lambda kind: (-weight[kind], kind))
        return tuple(self._in_words(kind, one, other, float(evidence[KINDS.index(kind)])) for kind in told)

    def _in_words(self, kind: str, one: str, other: str, value: float) -> str:
        if kind == "group":
            groups = self.evidence.food_groups
            both = [group for group in groups.of(one) if group in groups.of(other)]
            return f"both used as {', '.join(both)}" if both else "a part or form of it is used alike"
        if kind == "kind" and (shared := self.evidence.taxonomy.shared(one, other)):
            return f"both are {shared} ({value:.2f})"
        return _TOLD_AS[kind] + (f" ({value:.2f})" if value < 1 else "")

    def _side(self, known: Sequence[str]) -> _Known:
        columns = canonical_all(tuple(known))
        return self._known(columns) if len(columns) > _FEW else self._about_known(columns)

    def _about_known(self, known: tuple[str, ...]) -> _Known:
        return _Known(np.array(known, dtype=np.str_), self.evidence.about(known), {})

    def _odds(self, rows: Sequence[str], side: _Known) -> Table:
        """Return the log odds that each known name stands for each of ``rows``, which are remembered."""
        new = [name for name in dict.fromkeys(rows) if name not in side.odds_of]
        if new and len(side.names):
            if (len(side.odds_of) + len(new)) * len(side.names) > _REMEMBERED:
                side.odds_of.clear()
                new = list(dict.fromkeys(rows))
            step = min(max(_AT_ONCE // len(side.names), 1), _NAMES_AT_ONCE)
            for start in range(0, len(new), step):
                some = new[start : start + step]
                evidence = self.evidence.between(self.evidence.about(some), side.about)
                odds = np.tensordot(self._weights, evidence, axes=1) + self.bias
                side.odds_of.update(zip(some, odds, strict=True))
        there = len(side.names) > 0
        return np.array([side.odds_of[name] for name in rows if there]).reshape(len(rows), len(side.names))


def _roles(names: Sequence[str]) -> npt.NDArray[np.int64]:
    """Return the roles that each of ``names`` may play, a bit for each."""
    bits = {role: 1 << place for place, role in enumerate(roles())}
    return np.array([sum(bits[role] for role in roles_of(name)) for name in names], dtype=np.int64)


def _sure(odds: Table, rows: Sequence[str], side: _Known) -> Confidences:
    """Return the confidences that odds amount to: 0 for the least, 1 for the same name."""
    confidences = np.round(confidence_of(odds), DECIMALS)
    like = np.where(confidences < UNLIKE, 0.0, confidences)
    return np.where(np.array(rows, dtype=np.str_)[:, None] == side.names[None, :], 1.0, like)


def confidence_of(odds: Table) -> Confidences:
    """Return the confidences that log odds amount to; none reaches that of an equal name."""
    confidences: Confidences = _MOST / (1 + np.exp(-odds))
    return confidences


@lru_cache(maxsize=1)
def food_similarity() -> FoodSimilarity:
    """Return the default similarity, made once (some 0.1 s)."""
    fitted = json.loads(files("foon_kg.similarity").joinpath("similarity.json").read_text(encoding="utf-8"))
    weights = np.array([fitted["weights"][kind] for kind in KINDS])
    slot = fitted["in a slot"]["slope"], fitted["in a slot"]["bias"]
    return FoodSimilarity(Evidence(food_vectors(), food_taxonomy(), food_groups()), weights, fitted["bias"], slot)
