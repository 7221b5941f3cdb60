"""Success rates as whole numbers that add up: the greater the product of the rates, the lesser the sum, exactly.

Minus the logarithm turns a product into a sum, but a rounded logarithm may turn two trees round, or part two that are
as good (0.9 · 0.1 and 0.3 · 0.3). Neither happens here. Every rate is written by powers of a few whole numbers that
share no factor; only their logarithms are rounded, so equal products have equal sums. And these have so many digits
that no sum of roundings reaches from one product to the next; at most 600, so that hundreds of rates with 17 decimals
each are still worked out in a second: should two products of these differ, but by less than one part in 10**580, they
may count as equal or in either order.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable
from decimal import Decimal, localcontext
from fractions import Fraction

_GUARD = 10
"""Decimal places beyond those that the proof needs, for the roundings of ``ln`` itself."""

_MOST_DIGITS = 600
"""The public weights, multiples of 0.05, need as many for trees of 450 units."""


def efforts(rates: Collection[Fraction], units: int) -> dict[Fraction, int]:
    """Return an effort for each of ``rates`` (above 0, at most 1) so that sums of efforts order products of rates.

    For any two collections of at most ``units`` of them, with repetition, the one with the greater product has the
    lesser sum, and products are equal where sums are. Rates over a common denominator D have products A/D**units with
    whole A, so the logarithms of two of them differ by 1/(D**units + 1) or more: logarithms are scaled by more than
    that.

    Raises ValueError for a rate out of its range.
    """
    if not all(0 < rate <= 1 for rate in rates):
        raise ValueError("a success rate is above 0 and at most 1")
    whole = math.lcm(*(rate.denominator for rate in rates))
    shares = {rate: int(rate * whole) for rate in rates}
    base = coprime_base([whole, *shares.values()])
    powers = sum(_powers(whole, base)) + max((sum(_powers(share, base)) for share in shares.values()), default=0)
    digits = math.ceil(math.log10(whole) * units) + len(str((powers + 1) * (units + 1))) + _GUARD
    digits = min(digits, _MOST_DIGITS)
    logs = _scaled_logs(base, digits)
    return {rate: _log_of(whole, base, logs) - _log_of(share, base, logs) for rate, share in shares.items()}


def coprime_base(numbers: Iterable[int]) -> list[int]:
    """Return whole numbers above 1 without common factors such that each of ``numbers`` is a product of their powers.

    By common divisors, without factoring into primes (Bach, Driscoll, Shallit: Factor refinement, 1993).
    """
    base: list[int] = []
    waiting = [number for number in numbers if number > 1]
    while waiting:
        number = waiting.pop()
        for place, other in enumerate(base):
            shared = math.gcd(number, other)
            if shared > 1:
                del base[place]
                waiting += [part for part in (shared, number // shared, other // shared) if part > 1]
                break
        else:
            base.append(number)
    return sorted(base)


def _powers(number: int, base: Iterable[int]) -> list[int]:
    powers = []
    for part in base:
        power = 0
        while number % part == 0:
            number, power = number // part, power + 1
        powers.append(power)
    return powers


def _scaled_logs(numbers: Iterable[int], digits: int) -> list[int]:
    with localcontext() as context:
        context.prec = digits + _GUARD
        return [int(Decimal(number).ln().scaleb(digits).to_integral_value()) for number in numbers]


def _log_of(number: int, base: Iterable[int], logs: Iterable[int]) -> int:
    return sum(power * log for power, log in zip(_powers(number, base), logs, strict=True))
