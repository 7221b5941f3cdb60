"""A coating is a part of its own: flesh is turned in what is wet, then in what is dry, and fried."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables, tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.course import COATS
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.patterns import BAKE, COOK, MIX, SIMMER, STIR, TOP, TURN
from foon_kg.integration.places import NATURAL
from foon_kg.integration.preparation import Want, owed
from foon_kg.integration.spots import Join

_COATED = word_list("is coated")
_DRY = word_list("coats dry")
_WET = word_list("coats wet")
_WHOLE = word_list("is strewn whole")

_MIX = replace(MIX, tools=(), vessel="bowl", label="")
_BATH = replace(_MIX, motion=min(word_list("is turned in by")), does=COATS)
_FINE = min(word_list("is called so when it is fine"))
_THICK = min(word_list("is called so when it is beaten"))

_POST = ("mix", "later", True)
_BESIDE = word_list("is served with what is fried")


def coated_alone(line: Line, joins: Sequence[Join], known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how coated flesh is made that is the dish: coated, fried, and baked under what melts on it.

    Nothing changes where there is no such flesh, or where something else has to be cooked too.
    """
    facts = [join.want.facts for join in joins]
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
        baked = replace(BAKE)
        below = sorted(joins, key=lambda join: join.want.facts.is_a(*word_list("melts on top")))
        return coated_apart(Line((baked,)), [_at(join, baked) for join in below], kinds)
    top = replace(TOP)
    sauce = replace(SIMMER if wet else COOK if whole else STIR)  # a fried piece that is stirred falls to pieces
    over = [join for join in joins if join.want.facts.is_a(*word_list("lies on flesh"), *_BESIDE)]
    rest = [join for join in joins if join not in over]
    made, found = coated_apart(Line((sauce,)), [_at(join, sauce) for join in rest], kinds)
    if not any(join.spot.stage is made.stages[-1] for join in found):
        return coated_apart(Line((top,)), [replace(_at(join, top), on_top=True) for join in joins], kinds)
    return Line((*made.stages, top)), (*found, *(_at(join, top) for join in over))


def _is_done(want: Want) -> bool:
    """Whether flesh is asked cooked; where only the title says so (fried chicken), the dish cooks it."""
    return want.cooked and bool(want.make) and tables().state(want.make).needs_heat


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
    fried, turned, done = replace(COOK), replace(TURN), replace(COOK)
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
