"""Which frame a recipe is made after: vetoes first, then how natural its foods are there (algorithms 1 and 2)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from foon_kg.food import Tables, is_unbaked, singular, words
from foon_kg.food.lists import word_list
from foon_kg.integration.batters import is_of_batter, is_of_dough, is_thin
from foon_kg.integration.frames import Frame, Line
from foon_kg.integration.layouts import Layout, Spot
from foon_kg.integration.operators import Likes
from foon_kg.integration.outlines import Outlines, Sought
from foon_kg.integration.places import Join, Matcher
from foon_kg.integration.poured_over import is_poured_over
from foon_kg.integration.preparation import Want, owed
from foon_kg.model.drafted import is_draft
from foon_kg.world.becoming import meets

_CARRIES = word_list("a dish is built on")
_BAKED_ON = frozenset({"dough", *word_list("carries what is stacked")})
_SEASONS = word_list("only seasons")
_WORKED_IN = word_list("is worked in")
_BLENDED = word_list("is called blended")

_CHANGES = frozenset({"blend", "knead", "shape"})
"""Work after which a food is no longer what it was."""

_BY_TITLE, _BY_TYPE = 1.0, 0.6
"""How much a goal is called like the dish that is asked: by its title, and by its type alone."""

_MOST = 0.6
_CALLED_SO = 0.6
"""From this on a goal is called like the dish that is asked (:func:`named_alike`)."""


@dataclass(frozen=True)
class Fit:
    """How well a frame suits a recipe: where its foods join, what speaks against it, and a score (greater is better).

    ``similarity`` is how alike the lists of ingredients are, whatever their places: the share of the recipe's foods
    for which one of the goal's can stand (algorithm 2).
    """

    frame: Frame
    joins: tuple[Join, ...]
    vetoes: tuple[str, ...]
    score: float
    similarity: float = 0.0

    @property
    def order(self) -> tuple[object, ...]:
        """The best first, the same in every run."""
        return (
            len(self.vetoes),
            -round(self.score, 6),
            self.frame.video,
            self.frame.goal.sort_key,
            self.frame.dish_type,
        )


def weight(want: Want, known: Tables) -> float:
    """Return how much a food matters to a dish: most what it is built on, least what only seasons it."""
    if want.facts.is_a(*_CARRIES) or {"cook", "boil"} & owed(want, known):
        return 2.0
    return 0.4 if want.facts.is_a(*_SEASONS) else 1.0


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

_MIXED = 0.4
"""What a frame is less worth that mixes what should lie on dough."""

_GROUND = 0.6
"""What a frame is less worth that blends a food which is asked cut, where the dish need not be smooth."""

_HEATED = 0.6
"""What a frame is less worth that heats the whole of what is only stacked."""

_DRAFTED = 0.25
"""What a frame is less worth that nobody has watched: it was drafted from the words of a recipe."""

_MEANS = frozenset({"blend", "dry", "fat", "knead", "liquid", "mash", "whip"})
"""What tells ways of making a dish from each other."""

MOST_FITTED = 16
"""How many frames are looked at closely."""


def shortlisted(
    outlines: Outlines,
    wants: Sequence[Want],
    dish_type: str,
    title: str,
    *,
    known: Tables,
    likes: Likes,
    allowed: Callable[[str], bool] | None = None,
) -> list[str]:
    """Return the keys of the frames that are worth a closer look, the best first, at most ``MOST_FITTED``.

    They are those of the asked dish type, and of others those whose dish is heated last as some dish of that type is;
    those first that have a place for most of what the recipe is built on. ``allowed`` says which goals, by their names,
    may be taken.
    """
    baked = any(dish.baked for dish in known.dishes_named(dish_type, title)) and not is_unbaked(title)
    sought = []
    for want in wants:
        names = {singular(want.label), want.facts.taken_for, *(name for name, _ in likes(want.label))}
        sought.append(Sought(weight(want, known), names, want.facts.kind))
    return outlines.best(
        sought,
        dish_type,
        lambda there, own, named, headed: there + 0.5 * own + 0.5 * np.where(headed, _BY_TITLE, _BY_TYPE * named),
        title=title,
        ends={("bake", "")} if baked else {("", "")} if is_unbaked(title) else None,
        allowed=allowed,
        most=MOST_FITTED,
    )


def fits(layouts: Iterable[Layout], wants: Sequence[Want], dish_type: str, title: str, matcher: Matcher) -> list[Fit]:
    """Return how well each frame suits, the best first."""
    found = (_fit(layout, wants, dish_type, title, matcher) for layout in layouts)
    return sorted(found, key=lambda fit: fit.order)


def _fit(layout: Layout, wants: Sequence[Want], dish_type: str, title: str, matcher: Matcher) -> Fit:
    known, frame = matcher.known, layout.frame
    named_so = known.dishes_named(dish_type, title)
    stacked = any(dish.stacked for dish in named_so)
    joins = matcher.joins(layout, wants, stacked=stacked)
    vetoes = tuple(_vetoes(layout, joins, dish_type, title, known))
    weights = [weight(want, known) for want in wants]
    natural = sum(w * join.fit for w, join in zip(weights, joins, strict=True)) / sum(weights)
    carried = [join.slot is not None for join in joins if join.want.facts.is_a(*_CARRIES)]
    built, other = _recalled(frame, joins, known)
    score = 0.3 * (sum(carried) / len(carried) if carried else 0.7) + 0.5 * built + 0.1 * other + 0.25 * natural
    spoilt = sum(
        w for w, join in zip(weights, joins, strict=True)
        if join.slot is None and join.spot.post[0] in _CHANGES and matcher.posts.never(join.want, join.spot.post[0])
    )  # fmt: skip
    smooth = not (word_list("may be blended") | _BLENDED).isdisjoint(words(f"{dish_type} {title}"))
    ground = [join for join in joins if join.spot.post[0] == "blend" and _is_in_pieces(join.want, known)]
    score -= 0.0 if smooth else _GROUND * min(len(ground), 2)
    score -= 0.6 * spoilt / sum(weights)
    score -= 0.4 * sum(1 for _ in unlike_the_title(layout, title, known))
    named = named_alike(frame.goal.label, dish_type, title)
    own = frame.dish_type == dish_type or named >= _CALLED_SO
    batter = False
    if is_unbaked(title):
        own = layout.spots[-1].stage.motion in word_list("sets in the cold")
    elif any(dish.tin for dish in known.dishes_named(dish_type)):
        if is_of_batter(wants):
            own = batter = layout.batter is not None
            score += _batter_score(layout, wants, title, known)
        elif is_of_dough(wants):
            own = _makes_dough(layout, known)
    score += 0.2 * named + (1.0 if own and (batter or _defined(joins, dish_type, known)) else 0.0)
    score += min(_MOST_SAID, _SAID * sum(1 for _ in _said_alike(frame, wants, title, known)))
    if title:
        score -= min(_MOST_STRANGE, _STRANGE * len(unexplained(frame, wants, dish_type, title)))
        score -= _UNASKED_PART if _blends_beside(layout) and _has_strange_part(frame, wants, title, known) else 0.0
    score -= _DAMAGED if layout.raw or _is_damaged(frame) else 0.0
    if title and named < _BY_TITLE and _bakes(layout) and not is_baked(dish_type, title, known):
        score -= _UNTOLD_OVEN
    if stacked and named < _BY_TITLE and _is_cold(dish_type, title, known) and _heats_in_vain(joins):
        score -= _HEATED
    if not stacked and any(dish.stacked for dish in known.dishes_named(frame.dish_type, frame.goal.label)):
        score -= _HEATED
    laid = any(dish.laid for dish in named_so)
    score -= _MIXED if laid and layout.laid is None else 0.0
    score -= 0.15 if missing_core(frame, wants, known) else 0.0
    score -= _DRAFTED if is_draft(frame.video) else 0.0
    score += _AS_RECORDED * _same_foods(frame, joins, weights)
    alike = sum(join.slot is not None for join in joins) / len(joins)
    return Fit(frame, joins, vetoes, score - 0.05 * len(frame.weak), alike)


def _is_in_pieces(want: Want, known: Tables) -> bool:
    """Whether a food is asked cut, and is no powder."""
    fine = known.state(want.asked).fine or 0 if want.asked else 0
    return fine > 0 and not want.facts.is_a("spice", "stock")


def _blends_beside(layout: Layout) -> bool:
    """Whether a machine makes a part of a hot dish, by which that is called: a pesto."""
    return layout.heats and any(spot.side and "blend" in spot.stage.does for spot in layout.spots)


def _has_strange_part(frame: Frame, wants: Sequence[Want], title: str, known: Tables) -> bool:
    """Whether a goal is called by a food of which the recipe has none, and that its title does not name."""
    kinds = {want.facts.kind for want in wants}
    others = set(words(frame.goal.label)) - set(words(title))
    return any(known.foods.is_listed(word) and known.foods.food(word).kind not in kinds for word in others)


def _is_cold(dish_type: str, title: str, known: Tables) -> bool:
    """Whether nothing says that a dish is heated as a whole."""
    by_type = any(dish.heated for dish in known.dishes_named(dish_type))
    return not by_type and not any(dish.grilled for dish in known.dishes_named(dish_type, title))


def _heats_in_vain(joins: Sequence[Join]) -> bool:
    """Whether what it is laid on is heated, or flesh that is done."""
    flesh = word_list("is flesh")
    done = (join for join in joins if join.want.facts.is_a(*flesh) and join.want.facts.is_a("ready"))
    base = (join for join in joins if join.want.facts.is_a(*_BAKED_ON))
    return any(join.spot.heats_later for join in (*base, *done))


def _makes_dough(layout: Layout, known: Tables) -> bool:
    """Whether a frame bakes a dough that is mixed at once."""
    tin = any(dish.tin for dish in known.dishes_named(layout.frame.dish_type))
    flour = any(known.foods.food(place.slot.food, place.slot.states).is_a("flour") for place in layout.places)
    return tin and flour and layout.batter is None


def _batter_score(layout: Layout, wants: Sequence[Want], title: str, known: Tables) -> float:
    """Return what speaks for a frame and against it where a batter is asked, or a dough that nobody kneads."""
    rows = [known.utensil(spot.stage.vessel) for spot in layout.spots if "cut" in spot.stage.does and not spot.side]
    cut = any(row is not None and "bake" in row.can for row in rows)
    in_bowl = layout.batter is not None and layout.batter.fat.stage.vessel == "bowl"
    watered = layout.batter is not None and is_thin(layout.batter) and not any(w.facts.is_a("water") for w in wants)
    is_to_be_cut = not word_list("is cut when it is baked").isdisjoint(words(title))
    return (
        (0.0 if in_bowl else -_AWKWARD)
        - (3 * _AWKWARD if watered else 0.0)
        + (0.0 if not cut else 2 * _AWKWARD if is_to_be_cut else -2 * _AWKWARD)
    )


def _said_alike(frame: Frame, wants: Sequence[Want], title: str, known: Tables) -> Iterator[str]:
    """Yield the words by which both title and goal say how a dish is made (fried) or of which asked food (tomato)."""
    foods = {word for want in wants for word in words(want.label)}
    for word in set(words(frame.goal.label)) & set(words(title)) - set(words(frame.dish_type)):
        if word in foods or word in known.states:
            yield word


def _same_foods(frame: Frame, joins: Sequence[Join], weights: Sequence[float]) -> float:
    """Return how far (0 to 1) a recipe has the very foods of the recorded dish, and no others."""
    same = [join.slot is not None and join.fit >= _VERY for join in joins]
    asked = sum(weight for weight, one in zip(weights, same, strict=True) if one) / sum(weights)
    slots = {slot.food for slot in frame.line.all_slots()}
    there = {join.slot.food for join, one in zip(joins, same, strict=True) if one and join.slot is not None}
    return asked * len(there) / len(slots) if slots else 0.0


def refusals(wants: Sequence[Want], dish_type: str, title: str, known: Tables) -> list[str]:
    """Return what no dish of that type and title can do without, and the recipe has not."""
    found = []
    there = {singular(want.label) for want in wants}
    words_there = {word for want in wants for word in words(want.label)}
    for dish in known.dishes_named(dish_type, title):
        ready = dish.name in there or (not dish.is_type and dish.name in words_there)  # it is asked ready made
        for needs in dish.needs if not ready else ():
            if not any(meets(need, want.facts, known) for need in needs for want in wants):
                names = " or ".join(dict.fromkeys(need.rpartition(":")[2] for need in needs))
                found.append(f"no {dish.name} without {names}")
    return found


def unlike_the_title(layout: Layout, title: str, known: Tables) -> Iterator[str]:
    """Yield the words of a title that say how the dish is made (baked, fried, pureed) where the frame does not so."""
    done = set().union(*(spot.stage.does for spot in layout.spots))
    if layout.heats:
        slots = [known.foods.food(slot.food, slot.states) for slot in layout.frame.line.all_slots()]
        done |= {"fat" for food in slots if food.is_a("fat")}
        done |= {"liquid" for food in slots if food.is_a("liquid", "water")}
    for word in words(title):
        if word in _BLENDED and "blend" not in done:
            yield word
        if word not in known.states:
            continue
        rows = [row for motion, row in known.motion_words.items() if _is_of_verb(word, motion) and word in row.gives]
        means = frozenset().union(*(row.does for row in rows)) & _MEANS
        if means and means.isdisjoint(done):
            yield word


def is_baked(dish_type: str, title: str, known: Tables) -> bool:
    """Whether a dish is called so that it comes out of an oven: roast chicken, a gratin."""
    if any(dish.baked for dish in known.dishes_named(dish_type, title)):
        return True
    if not word_list("comes out of an oven").isdisjoint(words(title)):
        return True
    rows = [row for word in words(title) for verb, row in known.motion_words.items() if _is_of_verb(word, verb)]
    return any("dry" in row.does for row in rows)


def _bakes(layout: Layout) -> bool:
    return any(spot.stage.appliance == "oven" and "heat" in spot.stage.does for spot in layout.spots)


def _is_damaged(frame: Frame) -> bool:
    """Whether half of what is in the goal was lost when its video was followed, or the video ends before the dish."""
    ends_early = not word_list("is not done").isdisjoint(frame.goal.states)
    return ends_early or 2 * len(frame.weak) >= len(frame.goal.ingredients) > 0


def _is_of_verb(word: str, verb: str) -> bool:
    """Whether a word is made of a verb: baked of bake, fried of fry."""
    return word.startswith((verb, verb.removesuffix("e"), verb.removesuffix("y") + "i"))


def _defined(joins: Sequence[Join], dish_type: str, known: Tables) -> bool:
    """Whether what defines the dish type (the egg of an omelette) has a natural place."""
    for dish in known.dishes_named(dish_type):
        for needs in dish.needs:
            meeting = [join for join in joins if any(meets(need, join.want.facts, known) for need in needs)]
            if not any(join.slot is not None for join in meeting):
                return False
    return True


def _recalled(frame: Frame, joins: Sequence[Join], known: Tables) -> tuple[float, float]:
    """Return which share (0 to 1) of what the recorded dish is built on, and of its other foods, this recipe has."""
    taken = {id(join.slot) for join in joins if join.slot is not None}
    built: list[bool] = []
    other: list[bool] = []
    for slot in frame.line.all_slots():
        facts = known.foods.food(slot.food, slot.states)
        if facts.is_a(*_CARRIES):
            built.append(id(slot) in taken)
        elif not facts.is_a(*_SEASONS):
            other.append(id(slot) in taken)
    return (sum(built) + 0.35) / (len(built) + 0.5), (sum(other) + 0.25) / (len(other) + 0.5)


def named_alike(label: str, dish_type: str, title: str) -> float:
    """Return how much (0 to 1) a goal is called like the dish that is asked: by its type, better by its title."""
    own = set(words(label))
    asked = set(words(title))
    head = words(label)[-1:]
    if head and head[0] in asked:
        return _BY_TITLE
    return _BY_TYPE if own & set(words(dish_type)) else 0.0


def is_truly(fit: Fit, known: Tables) -> bool:
    """Whether a dish may be called as the recorded one is: it has most of its foods but seasonings."""
    taken = {id(join.slot) for join in fit.joins if join.slot is not None}
    slots = [s for s in fit.frame.line.all_slots() if not known.foods.food(s.food, s.states).is_a(*_SEASONS)]
    plain = set(words(fit.frame.goal.label)) <= set(words(fit.frame.dish_type)) or not slots
    return plain or sum(id(slot) in taken for slot in slots) >= _MOST * len(slots)


def unexplained(frame: Frame, wants: Sequence[Want], dish_type: str, title: str) -> tuple[str, ...]:
    """Return the words of the goal's name that neither the title nor the type nor any food of the recipe explains."""
    known = {*words(title), *words(dish_type), *words(frame.dish_type)}
    for want in wants:
        known |= {*want.facts.name.split(), *want.facts.taken_for.split(), want.facts.kind, *want.facts.kinds}
    return tuple(word for word in words(frame.goal.label) if word not in known)


def missing_core(frame: Frame, wants: Sequence[Want], known: Tables) -> tuple[str, ...]:
    """Return what the goal's name promises and the recipe does not have."""
    found = []
    foods = [want.facts for want in wants]
    dishes = known.dishes_named(frame.goal.label)
    for dish in dishes:
        unmet = (needs for needs in dish.needs if not any(meets(need, f, known) for need in needs for f in foods))
        found += [dish.name for _ in unmet]
    met = {word for dish in dishes for word in words(dish.name)} | set(words(frame.dish_type))
    met |= {word for want in wants for word in (*want.facts.name.split(), *want.facts.taken_for.split())}
    for word in words(frame.goal.label):
        if word in met or any(facts.is_a(word) for facts in foods) or not known.foods.is_listed(word):
            continue
        if not known.foods.food(word).is_a("made", "dough"):
            found.append(word)
    return tuple(found)


def _vetoes(layout: Layout, joins: Sequence[Join], dish_type: str, title: str, known: Tables) -> Iterator[str]:
    yield from _against_heat(layout, joins, dish_type, title, known)
    spots = layout.spots
    dressed = any(dish.dressed for dish in known.dishes_named(dish_type, title))
    solid = [join for join in joins if not is_poured_over(join.want, join.slot)]
    if dressed and len(solid) > 1 and _is_only_poured(layout, known):
        yield f"{layout.frame.goal.label} is only what comes over such a dish"
    for spot in spots:
        if spot.post[0] not in {"knead", "shape"} or spot.stage.does & {"heat"}:
            continue
        inside = [join for join in joins if _comes_through(join.spot, spot)]
        carried = [join for join in inside if join.want.facts.is_a(*_CARRIES)]
        if not any(join.slot is not None for join in carried) and (carried or inside):
            yield f"nothing of it is to be {spot.stage.motion}ed"
            break
    for join in joins:
        runs = join.want.facts.is_a("liquid", "creamy", "egg") and not join.want.facts.is_a("water", "fat")
        if id(join.spot) in layout.drained and runs and join.slot is None:
            yield f"{join.want.label} would run off"
        if join.slot is None and join.spot.post[0] in {"knead", "shape"} and not join.want.facts.is_a(*_WORKED_IN):
            yield f"{join.want.label} would be worked into it"
        if join.slot is None and join.spot.post[0] == "blend" and join.want.facts.is_a(*word_list("is flesh")):
            yield f"{join.want.label} would be blended"


def _is_only_poured(layout: Layout, known: Tables) -> bool:
    """Whether the recorded dish is a dressing and nothing else, by its name and what is in it."""
    if any(dish.dressed for dish in known.dishes_named(layout.frame.goal.label)):
        return False
    slots = list(layout.frame.line.all_slots())
    foods = [known.foods.food(slot.food, slot.states) for slot in slots]
    parts = [food.is_a("herb", *word_list("is poured over")) for food in foods]
    return sum(parts) >= _MOST * len(slots)


def _against_heat(layout: Layout, joins: Sequence[Join], dish_type: str, title: str, known: Tables) -> Iterator[str]:
    frame, spots = layout.frame, layout.spots
    heats = any(not spot.stage.does.isdisjoint({"heat", "warm"}) for spot in spots)
    bakes = any(
        "dry" in spot.stage.does or spot.stage.appliance in {"oven", "microwave"}
        for spot in spots
        if "heat" in spot.stage.does
    )
    unbaked = is_unbaked(title)
    dishes = known.dishes_named(dish_type, title)
    stacked = any(dish.stacked for dish in dishes)
    grilled = stacked and any(dish.grilled for dish in dishes)
    if stacked and _base_is_heated_alone(layout, known):
        yield f"what it is laid on is heated by itself in {frame.goal.label}"
    in_a_pan = not word_list("is cooked in a pan").isdisjoint(words(title)) and not is_baked(dish_type, "", known)
    if (unbaked or in_a_pan) and bakes:
        yield f"it is not to be baked, and {frame.goal.label} is"
    for dish in known.dishes_named(dish_type, title) if not unbaked else ():
        unheated = (join.want for join in joins if not join.spot.heats_later and join.want.facts.is_a(*_BAKED_ON))
        if dish.laid and (want := next(unheated, None)) is not None:
            yield f"{want.label} would not be baked"
        if dish.baked and not bakes:
            yield f"{dish.name} is baked, and {frame.goal.label} is not"
        if dish.heated and not heats and not grilled and not any(slot.cooked for slot in frame.line.all_slots()):
            if dish.is_type or not any({"cook", "boil"} & owed(join.want, known) for join in joins):
                yield f"{dish.name} is hot, and {frame.goal.label} is not"
        elif dish.heated and _ends_raw(spots):
            yield f"{dish.name} is hot, and {frame.goal.label} is not cooked once it is shaped"


def _base_is_heated_alone(layout: Layout, known: Tables) -> bool:
    """Whether what a stacked dish is stacked on is heated before anything is laid on it."""
    main = [spot for spot in layout.spots if not spot.side]
    there: list[str] = []
    for number, spot in enumerate(main):
        there += [slot.food for slot in spot.stage.slots]
        lines = any(isinstance(add, Line) for one in main[: number + 1] for add in one.stage.adds)
        only = [food for food in there if not known.foods.food(food).is_a("fat")]
        if only and not lines and not spot.stage.does.isdisjoint({"heat", "warm"}):
            return all(known.foods.food(food).is_a(*word_list("carries what is stacked")) for food in only)
    return False


def _ends_raw(spots: Sequence[Spot]) -> bool:
    """Whether a dish is kneaded or shaped, and never heated as a whole."""
    main = [spot for spot in spots if not spot.side]
    return any(spot.post[0] in {"knead", "shape"} for spot in main) and not any("heat" in s.stage.does for s in main)


def _comes_through(joined: Spot, spot: Spot) -> bool:
    """Whether what joins at one stage is in the whole at another one."""
    return joined.stage is spot.stage or any(stage is spot.stage for stage in joined.after)
