"""How well a recorded dish suits a recipe, beside what must not be: the greater the score, the better."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.goals.asked import Asked
from foon_kg.goals.names import BY_TITLE, named_alike
from foon_kg.goals.recorded import Recorded
from foon_kg.integration.joining.posts import Posts
from foon_kg.integration.joining.spots import Join
from foon_kg.model.drafted import is_draft

_CHANGES = frozenset({"blend", "knead", "shape"})
"""Work after which a food is no longer what it was."""

_CALLED_SO = 0.6
"""From this on a goal is called like the dish that is asked (:func:`named_alike`)."""

_AS_RECORDED, _VERY = 0.3, 0.99
"""What it counts that a recipe has the foods of the recorded dish, and how well a food fits its own slot."""

_STRANGE, _MOST_STRANGE = 0.12, 0.3
"""What a word counts by which only the recorded dish is called (pesto, grilled), and all of them at most."""

_AWKWARD = 0.2
"""What a frame is less worth that makes a batter in an odd way."""

_SAID, _MOST_SAID = 0.35, 0.6
"""What a word counts that the title and the recorded dish share beside their type (fried, tomato), and all of them."""

_DAMAGED = 0.5
"""What a frame is less worth in which something is never cooked that has to be, or most of its foods are lost."""

_UNTOLD_OVEN = 0.8
"""What a frame is less worth that bakes a dish which nobody calls baked."""

_UNASKED_PART = 0.8
"""What a frame is less worth that makes a part with a machine by which nobody calls the dish (pesto)."""

_DRAFTED = 0.25
"""What a frame is less worth that nobody has watched: it was drafted from the words of a recipe."""

_MIXED = 0.4
"""What a frame is less worth that mixes what should lie on dough."""

_GROUND = 0.6
"""What a frame is less worth that blends a food which is asked cut, where the dish need not be smooth."""

_HEATED = 0.6
"""What a frame is less worth that heats the whole of what is only stacked."""


def score(dish: Recorded, joins: Sequence[Join], asked: Asked, posts: Posts) -> float:
    """Return how well ``dish``, a recorded one, suits what is ``asked``, a recipe whose foods join it by ``joins``.

    More is better; the number compares dishes for one recipe and has no scale. ``posts`` are counts of where foods join
    in all recorded dishes, and beside which others.
    """
    named = named_alike(dish.label, asked.dish_type, asked.title)
    found = _places(dish, joins, asked) - _spoilt(joins, asked, posts)
    found -= 0.4 * sum(way.isdisjoint(dish.done) for way in asked.ways)
    found += _kind_of_dish(dish, joins, asked, named)
    found += min(_MOST_SAID, _SAID * len(asked.said.intersection(dish.words) - dish.type_words))
    if asked.title:
        found -= _not_so_called(dish, asked, named)
    found -= _DAMAGED if dish.damaged else 0.0
    found -= _stacked_otherwise(dish, joins, asked, named)
    found -= _MIXED if asked.laid and dish.layout.laid is None else 0.0
    found -= 0.15 if missing_core(dish, asked) else 0.0
    found -= _DRAFTED if is_draft(dish.frame.video) else 0.0
    found += _AS_RECORDED * _same_foods(dish, joins, asked)
    return found - 0.05 * len(dish.frame.weak)


def _places(dish: Recorded, joins: Sequence[Join], asked: Asked) -> float:
    """Return what the natural places count of what is asked, and what is asked of what was recorded."""
    natural = sum(food.weight * join.fit for food, join in zip(asked.foods, joins, strict=True)) / asked.weight
    carried = [join.slot is not None for food, join in zip(asked.foods, joins, strict=True) if food.carries]
    taken = {id(join.slot) for join in joins if join.slot is not None}
    built = (sum(slot in taken for slot in dish.built_on) + 0.35) / (len(dish.built_on) + 0.5)
    other = (sum(slot in taken for slot in dish.beside) + 0.25) / (len(dish.beside) + 0.5)
    return 0.3 * (sum(carried) / len(carried) if carried else 0.7) + 0.5 * built + 0.1 * other + 0.25 * natural


def _spoilt(joins: Sequence[Join], asked: Asked, posts: Posts) -> float:
    """Return what counts against a dish in which foods would lose their form."""
    spoilt, ground = 0.0, 0
    for food, join in zip(asked.foods, joins, strict=True):
        work = join.spot.post[0]
        if join.slot is None and work in _CHANGES and posts.never(join.want, work):
            spoilt += food.weight
        ground += work == "blend" and food.in_pieces
    return (0.0 if asked.smooth else _GROUND * min(ground, 2)) + 0.6 * spoilt / asked.weight


def _kind_of_dish(dish: Recorded, joins: Sequence[Join], asked: Asked, named: float) -> float:
    """Return what it counts that a dish is of the asked kind and called so."""
    own = dish.frame.dish_type == asked.dish_type or named >= _CALLED_SO
    found, batter = 0.2 * named, False
    if asked.unbaked:
        own = dish.sets_cold
    elif asked.of_batter:
        own = batter = dish.layout.batter is not None
        found += _batter_score(dish, asked)
    elif asked.of_dough:
        own = dish.makes_dough
    return found + (1.0 if own and (batter or _is_defined(joins, asked)) else 0.0)


def _is_defined(joins: Sequence[Join], asked: Asked) -> bool:
    """Whether what defines the dish type (the egg of an omelette) has a natural place."""
    return all(any(joins[place].slot is not None for place in places) for places in asked.defining)


def _batter_score(dish: Recorded, asked: Asked) -> float:
    """Return what speaks for a frame and against it where a batter is asked, or a dough that nobody kneads."""
    score = 0.0 if dish.mixed_in_bowl else -_AWKWARD
    if dish.watered and not asked.has_a("water"):
        score -= 3 * _AWKWARD
    if dish.cut_when_baked:
        score += 2 * _AWKWARD if asked.is_cut_when_baked else -2 * _AWKWARD
    return score


def _not_so_called(dish: Recorded, asked: Asked, named: float) -> float:
    """Return what counts against a dish that is not called as the title says, or baked though nobody says so."""
    found = min(_MOST_STRANGE, _STRANGE * len(unexplained(dish, asked)))
    if dish.blends_beside and _has_strange_part(dish, asked):
        found += _UNASKED_PART
    if named < BY_TITLE and dish.in_oven and not asked.baked:
        found += _UNTOLD_OVEN
    return found


def _has_strange_part(dish: Recorded, asked: Asked) -> bool:
    """Whether a goal is called by a food of which the recipe has none, and that its title does not name."""
    return any(word not in asked.told and kind not in asked.kinds for word, kind in dish.named_foods)


def _stacked_otherwise(dish: Recorded, joins: Sequence[Join], asked: Asked, named: float) -> float:
    """Return what counts against a dish that heats what is only stacked, or is stacked where nobody asks for that."""
    in_vain = asked.stacked and named < BY_TITLE and asked.cold and _heats_in_vain(joins, asked)
    return _HEATED * (in_vain + (dish.is_stacked and not asked.stacked))


def _heats_in_vain(joins: Sequence[Join], asked: Asked) -> bool:
    """Whether what it is laid on is heated, or flesh that is done."""
    foods = zip(asked.foods, joins, strict=True)
    return any((food.base or food.done) and join.spot.heats_later for food, join in foods)


def _same_foods(dish: Recorded, joins: Sequence[Join], asked: Asked) -> float:
    """Return how far (0 to 1) a recipe has the very foods of the recorded dish, and no others."""
    same = 0.0
    there = set()
    for food, join in zip(asked.foods, joins, strict=True):
        if join.slot is not None and join.fit >= _VERY:
            same += food.weight
            there.add(join.slot.food)
    return same / asked.weight * len(there) / len(dish.food_names) if dish.food_names else 0.0


def unexplained(dish: Recorded, asked: Asked) -> tuple[str, ...]:
    """Return the words of the name of ``dish`` that nothing of what is ``asked`` explains: title, type or a food."""
    return tuple(word for word in dish.words if word not in asked.explained and word not in dish.type_words)


def missing_core(dish: Recorded, asked: Asked) -> tuple[str, ...]:
    """Return what the name of ``dish`` promises and the recipe that is ``asked`` does not have."""
    named = dish.known.dishes_named(dish.label)
    found = [one.name for one in named for needs in one.needs if not any(map(asked.has, needs))]
    found += (word for word in dish.promised if word not in asked.food_words and not asked.has_a(word))
    return tuple(found)
