"""A coating is a part of its own: flesh is turned in what is wet, then in what is dry, and fried."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables, tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.course import COATS
from foon_kg.integration.frames import Line, Slot, Stage
from foon_kg.integration.places import NATURAL, Join
from foon_kg.integration.preparation import Want, owed

_COATED = word_list("is coated")
_DRY = word_list("coats dry")
_WET = word_list("coats wet")
_WHOLE = word_list("is strewn whole")
_SEASONS = ("leaven", "salty", "spice", "sweet")
_IN_BATTER = word_list("is battered")
_POURED = word_list("is poured on what is battered")

_MIX = Stage((), "mix", frozenset({"mix"}), (), "bowl", "in", "", "", "", (), 0)
_BATH = replace(_MIX, motion=min(word_list("is turned in by")), does=COATS)
_HEAT = replace(_MIX, motion="cook", does=frozenset({"heat"}), vessel="cooking pan", appliance="stove", source="heat")
_TURN = replace(_HEAT, motion="flip", does=frozenset({"turn"}), tools=("turner",))


_FINE = min(word_list("is called so when it is fine"))
_THICK = min(word_list("is called so when it is beaten"))

_POST = ("mix", "later", True)
_BAKE = replace(_HEAT, motion="bake", does=frozenset({"dry", "heat"}), vessel="baking dish", appliance="oven")
_TOP = replace(_MIX, motion="", does=frozenset(), vessel="plate", relation="on")
_SAUCE = replace(_HEAT, motion="cook and stir", does=frozenset({"heat", "mix"}), tools=("spoon",))
_BESIDE = word_list("is served with what is fried")


def coated_alone(
    line: Line, joins: Sequence[Join], told: Collection[str], known: Tables
) -> tuple[Line, tuple[Join, ...]]:
    """Return how coated flesh is made that is the dish: coated, fried, and baked under what melts on it.

    ``told`` are the words of type and title. Nothing changes where there is no such flesh, or where something else has
    to be cooked too, unless it is battered: then that is fried beside it.
    """
    facts = [join.want.facts for join in joins]
    if not word_list("is called battered").isdisjoint(told):
        made, found = _battered(line, joins, known)
        if made is not line:
            return made, found
    shaped = any("shape" in stage.does for one in _all(line) for stage in one.stages)
    rough = any(one.is_a(*word_list("coats roughly")) for one in facts)
    kinds = (
        (*word_list("is coated"), *word_list("is coated where it is rough")) if rough else tuple(word_list("is coated"))
    )
    flesh = [join for join in joins if join.want.facts.is_a(*kinds) and not _is_done(join.want)]
    wet = any(one.is_a("cooking liquid") and not one.is_a(*_WET) for one in facts)
    whole = len(flesh) == 1 and is_portion(flesh[0].want, known)
    dusted = any(one.is_a("flour") for one in facts) and (whole or not wet)
    rough = rough or (dusted and any(one.is_a("fat") for one in facts))
    others = [join for join in joins if join not in flesh and {"cook", "boil"} & owed(join.want, known)]
    if (
        (shaped and not whole)
        or len(flesh) != 1
        or not rough
        or any(not join.want.facts.is_a(*_WET, *_DRY) for join in others)
    ):
        return line, tuple(joins)
    melts = any(one.is_a(*word_list("melts on top")) for one in facts)
    if melts:
        baked = replace(_BAKE)
        below = sorted(joins, key=lambda join: join.want.facts.is_a(*word_list("melts on top")))
        return coated_apart(Line((baked,)), [_at(join, baked) for join in below], kinds)
    top = replace(_TOP)
    if wet:
        sauce = replace(_SAUCE, motion="simmer", does=frozenset({"heat", "liquid"}), tools=())
    else:  # a fried piece that is stirred falls to pieces
        sauce = replace(_HEAT) if whole else replace(_SAUCE)
    over = [join for join in joins if join.want.facts.is_a(*word_list("lies on flesh"), *_BESIDE)]
    rest = [join for join in joins if join not in over]
    made, found = coated_apart(Line((sauce,)), [_at(join, sauce) for join in rest], kinds)
    if not any(join.spot.stage is made.stages[-1] for join in found):
        return coated_apart(Line((top,)), [replace(_at(join, top), on_top=True) for join in joins], kinds)
    return Line((*made.stages, top)), (*found, *(_at(join, top) for join in over))


def _battered(line: Line, joins: Sequence[Join], known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how one food is turned in a batter of flour and what thins it, and fried; what goes with it is fried too.

    Bread is dipped into eggs and milk. What is poured on it comes at the end.

    Nothing changes where there is no such batter, or where more than one food may be turned in it.
    """
    batter = [join for join in joins if join.want.facts.is_a(*_DRY, *_WET, *word_list("thins what is fried in"))]
    thin = any(join.want.facts.is_a(*_WET, *word_list("thins what is fried in")) for join in batter)
    rest = [join for join in joins if join not in batter and not join.want.facts.is_a("fat", *_SEASONS)]
    beside = [join for join in rest if join.want.facts.is_a(*word_list("is fried beside what is battered"))]
    dipped = [join for join in rest if join not in beside and join.want.facts.is_a(*_COATED, *_IN_BATTER)]
    beside += [join for join in dipped if dipped[0].want.facts.is_a(*_COATED) and join is not dipped[0]]
    dipped = [join for join in dipped if join not in beside]
    if not thin or len(batter) == 1 or len(dipped) != 1:
        return line, tuple(joins)
    mixed, fried, turned, done, top = (replace(one) for one in (_MIX, _HEAT, _TURN, _HEAT, _TOP))
    bathed_in = replace(_BATH, adds=(Line((mixed,)),))
    top = replace(top, adds=(Line((bathed_in, fried, turned, done)),))
    fats = [join for join in joins if join.want.facts.is_a("fat")]
    found = []
    for join in joins:
        if join in dipped:
            found.append(_side(join, bathed_in, (fried, turned, done, top)))
        elif join in fats:
            found.append(_side(join, fried, (turned, done, top)))
        elif join in batter or (join.want.facts.is_a(*_SEASONS) and not join.want.facts.is_a(*_POURED)):
            found.append(_side(join, mixed, (bathed_in, fried, turned, done, top)))
        else:
            cooks = "cook" in owed(join.want, known)
            slot = Slot(join.want.label, join.want.facts.kind, cooked=("cook",)) if cooks else None
            found.append(
                Join(join.want, replace(join.spot, stage=top, after=(), side=False), NATURAL, slot, on_top=True)
            )
    return Line((top,)), tuple(found)


def _is_done(want: Want) -> bool:
    """Whether flesh is asked cooked; where only the title says so (fried chicken), the dish cooks it."""
    return want.cooked and bool(want.make) and tables().state(want.make).needs_heat


def _side(join: Join, stage: Stage, after: tuple[Stage, ...]) -> Join:
    return Join(join.want, replace(join.spot, stage=stage, post=_POST, after=after, side=True), NATURAL)


def is_portion(want: Want, known: Tables) -> bool:
    """Whether flesh comes in portions and is not asked cut."""
    fine = known.state(want.make).fine or 0 if want.make else 0
    minced = want.facts.is_a(*word_list("patties are made of"))
    return not minced and fine == 0 and not word_list("is a portion").isdisjoint(words(want.label))


def _at(join: Join, stage: Stage) -> Join:
    return replace(join, spot=replace(join.spot, stage=stage, after=(), side=False), slot=None)


def coated_apart(line: Line, joins: Sequence[Join], kinds: Collection[str] = _COATED) -> tuple[Line, tuple[Join, ...]]:
    """Return a line and its joins such that raw flesh is coated and fried by itself, where something coats it."""
    flesh = [join for join in joins if join.want.facts.is_a(*kinds) and not _is_done(join.want)]
    minced = any(join.want.facts.is_a(*word_list("patties are made of")) for join in flesh)
    shaped = minced and any("shape" in stage.does for one in _all(line) for stage in one.stages)
    dry = [join for join in joins if join.want.facts.is_a(*_DRY)]
    if shaped or len(flesh) != 1 or not dry:
        return line, tuple(joins)
    wet = [join for join in joins if join.want.facts.is_a(*_WET) and join not in dry]
    seasons = [join for join in joins if join.want.facts.is_a("spice") and join.want.facts.is_a("stock")]
    seasons = [join for join in seasons if not join.want.facts.is_a("ready", "liquid", *_WHOLE)]
    seasons += [join for join in joins if join.want.facts.is_a("leaven")]
    wet += [join for join in joins if wet and join.want.facts.is_a(*word_list("seasons what coats"))]
    fats = [join for join in joins if join.want.facts.is_a("fat")]
    fat = [join for join in fats if join.want.facts.is_a("liquid")] or fats
    egg = any(join.want.facts.is_a("egg") for join in wet)
    flour = any(join.want.facts.is_a("flour") for join in dry)
    wash = Line((replace(_MIX, label=_THICK if egg else ""),))
    powder = Line((replace(_MIX, label=_FINE if flour else ""),))
    outer = [join for join in dry if join.want.facts.is_a(*word_list("coats roughly"))]
    dust = [join for join in dry if join not in outer] if outer and wet else []  # it lets the wash cling to it
    dusted = replace(_BATH)
    bathed = replace(_BATH, adds=(wash,))
    rolled = replace(_BATH, adds=(powder,))
    fried, turned, done = replace(_HEAT), replace(_TURN), replace(_HEAT)
    last = line.stages[-1]
    first = (dusted, bathed) if dust else (bathed,)
    served = replace(last, adds=(*last.adds, Line((*first, rolled, fried, turned, done))))
    rest = [join for join in (*dry, *seasons) if join not in dust]
    places = [(wet, wash.stages[0]), (rest, powder.stages[0]), ([*flesh, *dust], first[0]), (fat, fried)]
    after = (fried, turned, done, served)
    found = []
    for join in joins:
        stage = next((stage for some, stage in places if any(one is join for one in some)), None)
        if stage is not None:
            want = replace(join.want, cooked=False) if join in flesh else join.want
            found.append(Join(want, replace(join.spot, stage=stage, post=_POST, after=after, side=True), NATURAL))
        elif join.spot.stage is last:
            found.append(replace(join, spot=replace(join.spot, stage=served)))
        else:
            found.append(join)
    return Line((*line.stages[:-1], served)), tuple(found)


def _all(line: Line) -> list[Line]:
    found = [line]
    for stage in line.stages:
        for add in stage.adds:
            found += _all(add) if isinstance(add, Line) else []
    return found
