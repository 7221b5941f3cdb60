"""From what speaks for a drafted unit to the probability that it is right.

The shares that speak for a unit are multiplied as if they were independent, which they are not. A logistic curve over
the logarithm of the product makes a probability of it (Platt, 1999); one for narrated verbs and nouns and one for
sentences, whose parsing goes wrong besides. ``benchmarks/drafts.py`` fits and judges them on held-out videos.
"""

from __future__ import annotations

from math import exp, log

ACTIONS = (1.02, 0.09)
SENTENCES = (0.70, -0.50)
"""Slope and height of the curves, fitted on the units of 111 videos, each drafted from the 110 others."""

_LEAST = 0.005
"""Less than this is told apart by no figure in hundredths."""


def probability(evidence: float, *, parsed: bool) -> float:
    """Return how likely a unit is right in its motion, its main object and all the states of that object.

    ``evidence`` is the product of the shares that speak for it, 0 to 1; ``parsed`` says that it was told in sentences.

    >>> round(probability(1.0, parsed=False), 2)
    0.52
    """
    slope, height = SENTENCES if parsed else ACTIONS
    return 1 / (1 + exp(-slope * log(max(evidence, _LEAST)) - height))
