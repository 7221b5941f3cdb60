"""The sense measures about what the tree was made from: S5 close, S6 true name, S8 kept."""

from __future__ import annotations

from collections.abc import Iterator

from foon_kg.form.case import Case
from foon_kg.form.report import Finding
from foon_kg.kitchen import words

CLOSE = 0.5
KEPT = 0.3


def close(case: Case) -> Iterator[Finding]:
    """S5: no equivalent object has a confidence below 0.5."""
    for entry in case.tree.substitutions or ():
        if entry.kind == "object" and entry.confidence is not None and entry.confidence < CLOSE:
            yield Finding("S5", f"{entry.equivalent} stands for {entry.required} with {entry.confidence:.2f} only")


def true_name(case: Case) -> Iterator[Finding]:
    """S6: the goal's label names no food that is not there, the word of the dish type apart.

    A food is named when its known name stands in the label; of names within each other (peanut butter, butter) the
    longest counts. It is there when an ingredient of the goal has all its words (red potato is a potato).
    """
    if case.goal is None or case.foon is None:
        return
    there = [set(words(name)) for name in (*case.goal.ingredients, *(w.object for w in case.required))]
    products = case.foon.end_products
    types = [case.recipe.dish_type] if case.recipe else [t for t in products if case.goal.label in products[t]]
    dish = {word for dish_type in types for word in words(dish_type)}
    for name in _foods_named(words(case.goal.label), case.foon.food_names, dish):
        if not any(set(words(name)) <= ingredient for ingredient in there):
            yield Finding("S6", f"“{case.goal.label}” names {name}, which is not in it", None, case.goal)


def _foods_named(label: tuple[str, ...], foods: frozenset[str], dish: set[str]) -> Iterator[str]:
    start = 0
    while start < len(label):
        for end in range(len(label), start, -1):
            name = " ".join(label[start:end])
            if name in foods and not set(label[start:end]) <= dish:
                yield name
                start = end - 1
                break
        start += 1


def kept(case: Case) -> Iterator[Finding]:
    """S8: at least 30 % of the units of the reference goal's video are in the tree; of several, the best counts."""
    if case.foon is None or case.tree.reference_goal is None or not case.tree.units:
        return
    seen = {(s.video, s.position) for unit in case.tree.units for s in unit.seen_in or ()}
    shares = {}
    for video in case.foon.videos_of(case.tree.reference_goal):
        places = case.foon.video_units[video]
        shares[video] = len([place for place in places if (video, place) in seen]) / len(places)
    if not shares:
        yield Finding("S8", "no video of the FOON ends in the reference goal", None, case.tree.reference_goal)
    elif max(shares.values()) < KEPT:
        best = max(sorted(shares), key=lambda video: shares[video])
        yield Finding("S8", f"only {shares[best]:.0%} of the units of “{best}” are in the tree")
