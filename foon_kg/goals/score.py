"""How well a recorded dish suits a recipe, beside what must not be: the greater the score, the better.

The score is a sum of small terms. None was fitted: each was set by hand when readers found a recipe made after the
wrong dish, as large as it takes to turn that choice. What counts is their order. To be of the asked kind and called so
outweighs all but the places of the foods (together at most 1.15); what would make another dish of it (an oven, a
blender, a pan) comes next; a word of the name last.
"""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.goals.asked import Asked
from foon_kg.goals.names import BY_TITLE, BY_TYPE, named_alike
from foon_kg.goals.recorded import Recorded
from foon_kg.integration.joining.joining_counts import JoiningCounts
from foon_kg.integration.joining.spots import Join
from foon_kg.model.drafted import is_draft

_UNTOLD, _UNTOLD_BESIDE = 0.7, 0.5
"""What a share counts of which there is nothing to be told: of what a dish is built on, and of its other foods.

It is better than many misses, and worse than few."""

_CHANGES = frozenset({"blend", "knead", "shape"})
"""Work after which a food is no longer what it was."""

_SPOILT, _GROUND, _MOST_GROUND = 0.6, 0.6, 2
"""What a dish is less worth in which all foods would lose their form, or one that is asked cut would be blended.

More foods than two that are blended say no more: it is a smooth dish."""

_OWN, _NAMED = 1.0, 0.2
"""What it counts that a dish is of the asked kind, and what that it is called like the asked one."""

_SAME_FOODS, _THE_FOOD_ITSELF = 0.3, 0.99
"""What it counts that a recipe has the foods of the recorded dish and no others; from which fit on one is the same."""

_SHARED_WORD, _MOST_SHARED = 0.35, 0.6
"""What a word counts that the title and the recorded dish share beside their type (fried, tomato), and all of them."""

_STRANGE_WORD, _MOST_STRANGE = 0.12, 0.3
"""What a word counts by which only the recorded dish is called (pesto, grilled), and all of them at most."""

_NOT_DONE = 0.4
"""What a frame is less worth for each word of the title that says how a dish is made (fried), if it is not made so."""

_UNTOLD_OVEN = 0.8
"""What a frame is less worth that bakes a dish which nobody calls baked."""

_UNASKED_PART = 0.8
"""What a frame is less worth that makes a part with a machine by which nobody calls the dish (pesto)."""

_HEATED = 0.6
"""What a frame is less worth that heats the whole of what is only stacked."""

_DAMAGED = 0.5
"""What a frame is less worth in which something is never cooked that has to be, or most of its foods are lost."""

_LOST_FOOD = 0.05
"""What a frame is less worth for each food of its goal that was not followed through its video."""

_MIXED = 0.4
"""What a frame is less worth that mixes what should lie on dough."""

_DRAFTED = 0.25
"""What a frame is less worth that nobody has watched: it was drafted from the words of a recipe."""

_LACKS_CORE = 0.15
"""What a frame is less worth whose name promises a food that the recipe has not.

It is little, since the dish is then only not called so (``planning/dish_names.py``)."""

_AWKWARD = 0.2
"""What a frame is less worth that makes a batter in an odd way: not in a bowl; several times that for what is odder."""


def score(dish: Recorded, joins: Sequence[Join], asked: Asked, counts: JoiningCounts) -> float:
    """Return how well ``dish``, a recorded one, suits what is ``asked``, a recipe whose foods join it by ``joins``.

    More is better; the number compares dishes for one recipe and has no scale. ``counts`` are how often foods join
    where in all recorded dishes, and beside which others.
    """
    named = named_alike(dish.label, asked.dish_type, asked.title)
    found = _places(dish, joins, asked) - _spoilt(joins, asked, counts)
    found -= _NOT_DONE * sum(way.isdisjoint(dish.work_done) for way in asked.ways)
    found += _kind_of_dish(dish, joins, asked, named)
    found += min(_MOST_SHARED, _SHARED_WORD * len(asked.telling_words.intersection(dish.words) - dish.type_words))
    if asked.title:
        found -= _not_so_called(dish, asked, named)
    found -= _DAMAGED if dish.damaged else 0.0
    found -= _stacked_otherwise(dish, joins, asked, named)
    found -= _MIXED if asked.laid and dish.layout.laid is None else 0.0
    found -= _LACKS_CORE if missing_core(dish, asked) else 0.0
    found -= _DRAFTED if is_draft(dish.frame.video) else 0.0
    found += _SAME_FOODS * _same_foods(dish, joins, asked)
    return found - _LOST_FOOD * len(dish.frame.weak)


def _places(dish: Recorded, joins: Sequence[Join], asked: Asked) -> float:
    """Return what the natural places count of what is asked, and what is asked of what was recorded (0 to 1.15).

    That the recipe has what the dish is built on counts most: a salad of beans is none without the beans.
    """
    natural = sum(food.weight * join.fit for food, join in zip(asked.foods, joins, strict=True)) / asked.weight
    carried = [join.slot is not None for food, join in zip(asked.foods, joins, strict=True) if food.carries]
    placed = sum(carried) / len(carried) if carried else _UNTOLD
    taken = {id(join.slot) for join in joins if join.slot is not None}
    built = _share_taken(dish.built_on, taken, _UNTOLD)
    beside = _share_taken(dish.beside, taken, _UNTOLD_BESIDE)
    return 0.3 * placed + 0.5 * built + 0.1 * beside + 0.25 * natural


def _share_taken(slots: Sequence[int], taken: set[int], untold: float) -> float:
    """Return which share of ``slots`` is among the ``taken`` ones; ``untold`` is what none at all counts.

    It counts as half a slot more of which ``untold`` is taken: one of one is less sure a sign than five of five.
    """
    return (sum(slot in taken for slot in slots) + untold / 2) / (len(slots) + 0.5)


def _spoilt(joins: Sequence[Join], asked: Asked, counts: JoiningCounts) -> float:
    """Return what counts against a dish in which foods would lose their form.

    A food that has a slot there is meant to; so is one of a kind that some video blends, kneads or shapes.
    """
    spoilt, ground = 0.0, 0
    for food, join in zip(asked.foods, joins, strict=True):
        work = join.spot.stage_type.work
        if join.slot is None and work in _CHANGES and counts.never(join.want, work):
            spoilt += food.weight
        ground += work == "blend" and food.in_pieces
    cut = 0.0 if asked.smooth else _GROUND * min(ground, _MOST_GROUND)
    return cut + _SPOILT * spoilt / asked.weight


def _kind_of_dish(dish: Recorded, joins: Sequence[Join], asked: Asked, named: float) -> float:
    """Return what it counts that a dish is of the asked kind and called so.

    How a cake comes about says more than that a video is of a cake: without an oven, of a batter, of a dough.
    """
    own = dish.frame.dish_type == asked.dish_type or named >= BY_TYPE
    found, batter = _NAMED * named, False
    if asked.unbaked:
        own = dish.sets_cold
    elif asked.of_batter:
        own = batter = dish.layout.batter is not None
        found += _batter_score(dish, asked)
    elif asked.of_dough:
        own = dish.makes_dough
    return found + (_OWN if own and (batter or _is_defined(joins, asked)) else 0.0)


def _is_defined(joins: Sequence[Join], asked: Asked) -> bool:
    """Whether what defines the dish type (the egg of an omelette) has a natural place."""
    return all(any(joins[place].slot is not None for place in places) for places in asked.defining)


def _batter_score(dish: Recorded, asked: Asked) -> float:
    """Return what speaks for a frame and against it where a batter is asked, or a dough that nobody kneads."""
    found = 0.0 if dish.mixed_in_bowl else -_AWKWARD
    if dish.watered and not asked.has_a("water"):  # the plan would have to add the water
        found -= 3 * _AWKWARD
    if dish.cut_when_baked:  # bars and brownies are, and a round cake is not
        found += 2 * _AWKWARD if asked.is_cut_when_baked else -2 * _AWKWARD
    return found


def _not_so_called(dish: Recorded, asked: Asked, named: float) -> float:
    """Return what counts against a dish that is not called as the title says, or baked though nobody says so."""
    found = min(_MOST_STRANGE, _STRANGE_WORD * len(unexplained(dish, asked)))
    if dish.blends_beside and _has_strange_part(dish, asked):
        found += _UNASKED_PART
    if named < BY_TITLE and dish.in_oven and not asked.baked:  # a dish of that very name comes as its video has it
        found += _UNTOLD_OVEN
    return found


def _has_strange_part(dish: Recorded, asked: Asked) -> bool:
    """Whether a goal is called by a food of which the recipe has none, and that its title does not name."""
    return any(word not in asked.title_words and kind not in asked.kinds for word, kind in dish.named_foods)


def _stacked_otherwise(dish: Recorded, joins: Sequence[Join], asked: Asked, named: float) -> float:
    """Return what counts against a dish that heats what is only stacked, or is stacked where nobody asks for that."""
    in_vain = asked.stacked and named < BY_TITLE and asked.not_called_hot and _heats_in_vain(joins, asked)
    return _HEATED * (in_vain + (dish.is_stacked and not asked.stacked))


def _heats_in_vain(joins: Sequence[Join], asked: Asked) -> bool:
    """Whether what it is laid on is heated, or flesh that is done."""
    foods = zip(asked.foods, joins, strict=True)
    return any((food.base or food.ready_flesh) and join.spot.heats_later for food, join in foods)


def _same_foods(dish: Recorded, joins: Sequence[Join], asked: Asked) -> float:
    """Return how far (0 to 1) a recipe has the very foods of the recorded dish, and no others."""
    same = 0.0
    there = set()
    for food, join in zip(asked.foods, joins, strict=True):
        if join.slot is not None and join.fit >= _THE_FOOD_ITSELF:
            same += food.weight
            there.add(join.slot.food)
    return same / asked.weight * len(there) / len(dish.food_names) if dish.food_names else 0.0


def unexplained(dish: Recorded, asked: Asked) -> tuple[str, ...]:
    """Return the words of the name of ``dish`` that nothing of what is ``asked`` explains: title, type or a food."""
    return tuple(word for word in dish.words if word not in asked.explained_words and word not in dish.type_words)


def missing_core(dish: Recorded, asked: Asked) -> tuple[str, ...]:
    """Return what the name of ``dish`` promises and the recipe that is ``asked`` does not have."""
    named = dish.known.dishes_named(dish.label)
    found = [one.name for one in named for needs in one.needs if not any(map(asked.has, needs))]
    found += (word for word in dish.promised if word not in asked.food_words and not asked.has_a(word))
    return tuple(found)
