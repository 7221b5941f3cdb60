"""What is cooked in a liquid is blended when it is done, if it is to be smooth: not raw, nor what stays in pieces."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import Dish
from foon_kg.integration.bench import fineness
from foon_kg.integration.joining.additions import is_strewn
from foon_kg.integration.joining.spots import Join, any_is
from foon_kg.integration.teaching.frames import Line, Slot, Stage

_JOINED = frozenset({"and", "con", "in", "on", "over", "with"})
"""After these words a title says no more what a dish is."""

_LEAST = 2
"""Of so many foods that run a sauce is made: one alone (a spoon of soy sauce) seasons."""

_BLENDED = Stage((), "blend", frozenset({"blend", "mix"}), (), "blender jar", "in", "blender", "power", "", (), 0)
_SERVED = Stage((), "", frozenset(), (), "bowl", "in", "", "", "", (), 0)
_SIMMERED = Stage((), "simmer", frozenset({"heat", "liquid"}), (), "pot", "on", "stove", "heat", "", (), 0)


def blended_when_done(line: Line, joins: Sequence[Join], name_words: Collection[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` for a dish with a liquid that is cooked and blended, by its foods and name.

    ``name_words`` are those of its type and title. One that is served cold, and of which nothing has to be cooked, is
    only blended.
    """
    stages = list(line.all_stages())
    blends = any("blend" in stage.does for stage in stages)
    raw_first = _is_blended_raw(stages)
    pieces = any_is(joins, *word_list("stays in pieces"))
    if not pieces and _is_served_cold(joins, name_words):
        return _with_stages(joins, (replace(_BLENDED),))
    smooth = not pieces and _is_to_be_smooth(joins, name_words)
    if smooth and (raw_first or not blends):
        return _with_stages(joins, (_boiling(stages), replace(_BLENDED)))
    if raw_first:
        return _with_stages(joins, (_boiling(stages),))
    return line, tuple(joins)


def _is_blended_raw(stages: Sequence[Stage]) -> bool:
    """Whether a video heats what it has blended for the last time."""
    blends = [place for place, stage in enumerate(stages) if "blend" in stage.does]
    return bool(blends) and any(stage.heats for stage in stages[blends[-1] + 1 :])


def _is_served_cold(joins: Sequence[Join], name_words: Collection[str]) -> bool:
    cold = says(name_words, "is served cold")
    return cold and all({"cook", "boil"}.isdisjoint(join.want.facts.owes) for join in joins)


def _is_to_be_smooth(joins: Sequence[Join], name_words: Collection[str]) -> bool:
    """Whether a dish is called so that it is smooth, or one of its foods makes it so."""
    named = says(name_words, "is blended smooth")
    return named or any(_makes_it_smooth(join, name_words) for join in joins)


def is_stewed(title: str, dishes: Collection[Dish], joins: Sequence[Join], known: Tables) -> bool:
    """Return whether all of ``joins`` is cooked in a pot: a title ends so, or flesh in pieces is asked with a sauce.

    ``dishes`` are those that it is called, ``known`` the tables.
    """
    head = list(itertools.takewhile(lambda word: word not in _JOINED, words(title)))
    other = any(dish.stacked or dish.dressed or dish.laid or dish.baked for dish in dishes)
    named = _is_called_by_a_pot(head, joins)
    return not other and (named or _is_in_sauce(joins, words(title), known))


def _is_called_by_a_pot(head: Sequence[str], joins: Sequence[Join]) -> bool:
    """Whether a title ends in a dish that is cooked in one pot, or has such a word before the flesh that it is of."""
    in_a_pot = word_list("is cooked in one pot")
    if not head or in_a_pot.isdisjoint(head):
        return False
    flesh = {word for join in joins if join.want.facts.is_any(word_list("is flesh")) for word in words(join.want.label)}
    wet = any(join.want.facts.is_of(*word_list("is cooked in for long")) for join in joins)
    return head[-1] in in_a_pot or (wet and head[-1] in flesh)


def _is_in_sauce(joins: Sequence[Join], title_words: Sequence[str], known: Tables) -> bool:
    """Whether flesh that is asked in pieces has a sauce to be cooked in, and nothing says that it is made otherwise."""
    if not title_words or any(known.state(word).needs_heat for word in title_words if word in known.states):
        return False
    pieces = any(_is_raw_flesh_in_pieces(join, known) for join in joins)
    sauce = sum(join.want.facts.is_of(*word_list("is cooked in for long")) for join in joins) >= _LEAST
    return pieces and sauce and not any_is(joins, *word_list("is never in a pot so"))


def _is_raw_flesh_in_pieces(join: Join, known: Tables) -> bool:
    facts = join.want.facts
    raw = "cook" in facts.owes and facts.is_any(word_list("is flesh"))
    return raw and fineness((join.want.make,), known) > 0


def stewed(joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that cooks all of ``joins`` in a pot, each food in its phase, and serves it."""
    return _with_stages(joins, (replace(_SIMMERED),))


def _makes_it_smooth(join: Join, name_words: Collection[str]) -> bool:
    """Whether a dish is blended for what it is called by, or because there is such a food in it."""
    names = word_list("is blended where a title names it") & set(name_words)
    return join.want.facts.is_any(word_list("is blended when it is soft")) or not names.isdisjoint(
        words(join.want.label)
    )


def _boiling(stages: Sequence[Stage]) -> Stage:
    """Return the stage at which everything is cooked: as the video does it at last, with its water."""
    hot = [stage for stage in stages if stage.heats]
    found = [stage for stage in hot if stage.source == "heat" and "dry" not in stage.does]
    stage = found[-1] if found else _SIMMERED
    # slots stay, its water among them; a line that joins there is made of the video's own foods
    return replace(stage, adds=tuple(add for add in stage.adds if isinstance(add, Slot)))


def _with_stages(joins: Sequence[Join], works: tuple[Stage, ...]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line of the stages ``works`` and serving; all joins at the first but what is strewn on the dish."""
    stages = (*works, replace(_SERVED))  # a copy: joins find their stage by identity, and each dish has its own
    found = []
    for join in joins:
        late = is_strewn(join) or join.want.facts.is_any(word_list("floats on top"))
        at = len(works) if late else 0
        spot = replace(join.spot, stage=stages[at], side=False, after=stages[at + 1 :])
        found.append(replace(join, spot=spot, slot=None))
    return Line(stages), tuple(found)
