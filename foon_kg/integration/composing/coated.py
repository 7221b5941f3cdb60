"""A coating is a part of its own: flesh is turned in what is wet, then in what is dry, and fried."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables, tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.integration.joining.course import COATS
from foon_kg.integration.joining.patterns import BAKE, COOK, MIX, SIMMER, STIR, TOP, TURN
from foon_kg.integration.joining.spots import NATURAL, Join, StageType, any_is
from foon_kg.integration.preparing.preparation import Want, owed
from foon_kg.integration.teaching.frames import Line, Stage

_COATED = word_list("is coated")
_DRY = word_list("coats dry")
_WET = word_list("coats wet")
_WHOLE = word_list("is strewn whole")
_ROUGH = word_list("coats roughly")

_MIX = replace(MIX, tools=(), vessel="bowl", label="")
_BATH = replace(_MIX, motion=min(word_list("is turned in by")), does=COATS)
_FINE = min(word_list("is called so when it is fine"))
_THICK = min(word_list("is called so when it is beaten"))

_FRIED_AFTER = StageType("mix", "later", joins=True)
"""The stage type of what is mixed apart and fried then (:class:`~foon_kg.integration.joining.spots.StageType`)."""

_BESIDE = word_list("is served with what is fried")


def coated_alone(
    line: Line, joins: Sequence[Join], known: Tables, *, baked: bool = False
) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` for coated flesh that is the dish: coated, fried, and baked under what melts on it.

    ``baked``: it is fried in the oven, as people say. Nothing changes where there is no such flesh, or where something
    else has to be cooked too. ``known`` are the tables.
    """
    kinds = _COATED | word_list("is coated where it is rough") if any_is(joins, *_ROUGH) else _COATED
    flesh = _flesh_of_the_dish(line, joins, kinds, known)
    if flesh is None:
        return line, tuple(joins)
    whole, wet = is_portion(flesh.want, known), _has_liquid(joins)
    if not _has_a_coating(joins, takes_flour=whole or not wet):
        return line, tuple(joins)
    if any_is(joins, *word_list("melts on top")):
        return _baked_under(joins, kinds)
    if baked and not wet:
        return _on_a_tray(joins, kinds)
    if wet:
        return _in_a_sauce(replace(SIMMER), joins, kinds)
    return _in_a_sauce(replace(COOK if whole else STIR), joins, kinds)  # a fried piece that is stirred falls to pieces


def _flesh_of_the_dish(line: Line, joins: Sequence[Join], kinds: Collection[str], known: Tables) -> Join | None:
    """Return the one piece of raw flesh that a dish is made of, if it is not shaped and nothing else is cooked."""
    flesh = _raw_flesh(joins, kinds)
    if len(flesh) != 1 or _cooks_others(joins, flesh, known):
        return None
    return None if _is_shaped(line) and not is_portion(flesh[0].want, known) else flesh[0]


def _has_a_coating(joins: Sequence[Join], *, takes_flour: bool) -> bool:
    """Whether something coats flesh: crumbs and the like, or flour and fat where no sauce would take it off."""
    return any_is(joins, *_ROUGH) or (takes_flour and any_is(joins, "flour") and any_is(joins, "fat"))


def _has_liquid(joins: Sequence[Join]) -> bool:
    """Whether a liquid is there to cook in, beside what flesh is turned in."""
    return any(join.want.facts.is_a("cooking liquid") and not join.want.facts.is_any(_WET) for join in joins)


def _baked_under(joins: Sequence[Join], kinds: Collection[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return how flesh is coated, and baked under what melts on top of it."""
    under = replace(BAKE)
    below = sorted(joins, key=lambda join: join.want.facts.is_any(word_list("melts on top")))
    return coated_apart(Line((under,)), [_at(join, under) for join in below], kinds)


def _on_a_tray(joins: Sequence[Join], kinds: Collection[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return how flesh is coated and baked; what lies on flesh comes on top."""
    hot, top = replace(BAKE, vessel="baking tray", relation="on"), replace(TOP)
    made, found = coated_apart(Line((hot,)), [_at(join, hot) for join in joins], kinds, heats=False)
    last = made.stages[-1]
    found = tuple(
        replace(_at(join, top), on_top=True) if join.spot.stage is last and _lies_over(join) else join for join in found
    )
    return Line((*made.stages, top)), found


def _lies_over(join: Join) -> bool:
    """Whether a food lies on coated flesh or beside it, and gives its taste without heat."""
    there = join.want.facts.is_any(word_list("lies on flesh") | _BESIDE)
    return there and not join.want.facts.is_any(word_list("is cooked with flesh"))


def _in_a_sauce(sauce: Stage, joins: Sequence[Join], kinds: Collection[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line in which coated flesh comes into a ``sauce`` of the rest; what lies on flesh comes on top.

    Without a sauce all that coats nothing lies on it.
    """
    top = replace(TOP)
    over = [join for join in joins if _lies_over(join)]
    rest = [join for join in joins if join not in over]
    made, found = coated_apart(Line((sauce,)), [_at(join, sauce) for join in rest], kinds)
    if not any(join.spot.stage is made.stages[-1] for join in found):
        return coated_apart(Line((top,)), [replace(_at(join, top), on_top=True) for join in joins], kinds)
    return Line((*made.stages, top)), (*found, *(_at(join, top) for join in over))


def _raw_flesh(joins: Sequence[Join], kinds: Collection[str]) -> list[Join]:
    """Return what is raw of those kinds; minced flesh is mixed with what would coat it, and never turned in that."""
    raw = [join for join in joins if join.want.facts.is_any(kinds) and not _is_done(join.want)]
    return [join for join in raw if not join.want.facts.is_any(word_list("patties are made of"))]


def _is_shaped(line: Line) -> bool:
    return any("shape" in stage.does for stage in line.all_stages())


def _cooks_others(joins: Sequence[Join], flesh: Sequence[Join], known: Tables) -> bool:
    """Whether something has to be cooked beside the ``flesh`` and what coats it."""
    others = [join for join in joins if join not in flesh and {"cook", "boil"} & owed(join.want, known)]
    return any(not join.want.facts.is_a(*_WET, *_DRY) for join in others)


def _is_done(want: Want) -> bool:
    """Whether flesh is asked cooked; where only the title says so (fried chicken), the dish cooks it."""
    return want.cooked and bool(want.make) and tables().state(want.make).needs_heat


def is_portion(want: Want, known: Tables) -> bool:
    """Return whether ``want`` is flesh that comes in portions, by the tables ``known``, and is not asked cut."""
    whole = not want.make or known.state(want.make).fineness == 0
    minced = want.facts.is_any(word_list("patties are made of"))
    return whole and not minced and says(words(want.label), "is a portion")


def _at(join: Join, stage: Stage) -> Join:
    return replace(join, spot=replace(join.spot, stage=stage, after=(), side=False), slot=None)


def coated_apart(
    line: Line, joins: Sequence[Join], kinds: Collection[str] = _COATED, *, heats: bool = True
) -> tuple[Line, tuple[Join, ...]]:
    """Return a line and its joins such that raw flesh is coated by itself, where something coats it.

    ``kinds`` are those of the flesh; ``heats``: it is fried then, before it joins.
    """
    flesh = _raw_flesh(joins, kinds)
    dry = [join for join in joins if join.want.facts.is_any(_DRY)]
    if len(flesh) != 1 or not dry:
        return line, tuple(joins)
    wet = _what_wets(joins, dry)
    dust = _what_dusts(dry) if wet else []
    wash, powder = _mixed(wet, "egg", _THICK), _mixed(dry, "flour", _FINE)
    dusted = (replace(_BATH),) if dust else ()
    turned = (*dusted, replace(_BATH, adds=(Line((wash,)),)), replace(_BATH, adds=(Line((powder,)),)))
    hot = (replace(COOK), replace(TURN), replace(COOK)) if heats else ()
    last = line.stages[-1]
    served = replace(last, adds=(*last.adds, Line((*turned, *hot))))
    places = [(wet, wash), (dust, turned[0]), ([*dry, *_what_seasons(joins)], powder), (flesh, turned[0])]
    places += [(_frying_fat(joins), hot[0])] if hot else []

    def moved(join: Join) -> Join:
        stage = _place_of(join, places)
        if stage is None:
            return replace(join, spot=replace(join.spot, stage=served)) if join.spot.stage is last else join
        want = replace(join.want, cooked=False) if join in flesh else join.want
        return Join(
            want, replace(join.spot, stage=stage, stage_type=_FRIED_AFTER, after=(*hot, served), side=True), NATURAL
        )

    return Line((*line.stages[:-1], served)), tuple(map(moved, joins))


def _mixed(foods: Sequence[Join], kind: str, label: str) -> Stage:
    """Return the stage at which ``foods`` are mixed that coat, called ``label`` where one of that ``kind`` is there."""
    return replace(_MIX, label=label if any_is(foods, kind) else "")


def _place_of(join: Join, places: Sequence[tuple[Sequence[Join], Stage]]) -> Stage | None:
    """Return the stage beside the first of the foods among which this very one is; ``None`` for none."""
    return next((stage for some, stage in places if any(one is join for one in some)), None)


def _what_dusts(dry: Sequence[Join]) -> list[Join]:
    """Return what flesh is turned in first, so that the wash clings to it, where something else makes the crust."""
    dust = [join for join in dry if not join.want.facts.is_any(_ROUGH)]
    return dust if len(dust) < len(dry) else []


def _what_wets(joins: Sequence[Join], dry: Sequence[Join]) -> list[Join]:
    """Return what the wash is mixed of, with what seasons it; what is ``dry`` is none of that."""
    wet = [join for join in joins if join.want.facts.is_any(_WET) and join not in dry]
    seasons = [join for join in joins if join.want.facts.is_any(word_list("seasons what coats"))]
    return [*wet, *seasons] if wet else []


def _what_seasons(joins: Sequence[Join]) -> list[Join]:
    """Return what is mixed into the powder: ground spices, and what makes it rise."""
    spices = [join for join in joins if join.want.facts.is_a("spice") and join.want.facts.is_a("stock")]
    ground = [join for join in spices if not join.want.facts.is_a("ready", "liquid", *_WHOLE)]
    return [*ground, *(join for join in joins if join.want.facts.is_a("leaven"))]


def _frying_fat(joins: Sequence[Join]) -> list[Join]:
    """Return the fat in which it is fried: what is liquid, where any is."""
    fats = [join for join in joins if join.want.facts.is_a("fat")]
    return [join for join in fats if join.want.facts.is_a("liquid")] or fats
