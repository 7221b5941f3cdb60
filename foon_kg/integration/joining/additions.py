"""What joins one vessel over the heat, and in which phase: what it is decides that, not where a video has it.

How the stages of that vessel are made of these phases is in :mod:`~foon_kg.integration.joining.phases`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Food, words
from foon_kg.food.lists import says, word_list
from foon_kg.integration.joining.patterns import COOK, SIMMER, STIR
from foon_kg.integration.joining.spots import Join, any_is
from foon_kg.integration.teaching.frames import Line, Slot, Stage

_BATHS = tuple(word_list("is a bath"))
ORDER = (
    "is fried", "is stirred into the fat", "takes hours in a liquid", "cooks in the liquid", "is done soon",
    "is stirred in last",
)  # fmt: skip
"""The phases of a vessel with a liquid in it: each is the name of the list of foods that join then."""

FRIED, BINDS, LONG, WET, SOON, LAST = ORDER

EGGS_FIRST, EGGS = "eggs before what is boiled", "eggs"
"""The phases of eggs in a pan: before rice and noodles, which hold them together, or after them."""

REDUCED = "boils away"
"""The phase of wine in a pan: nobody boils it away where noodles are tossed in it."""

DRY_ORDER = (FRIED, BINDS, REDUCED, SOON, EGGS_FIRST, WET, EGGS, LAST)
"""The phases of a pan without a liquid: what was boiled by itself (``WET``) only gets hot among the rest."""

_CURDLES = word_list("curdles what is creamy")

_MOST_TELLING = (LAST, SOON, BINDS, FRIED, WET)
"""In which order the lists are asked for a food that stands in several: what is spoilt by cooking comes before all."""


@dataclass(frozen=True)
class Addition:
    """What joins a vessel over the heat: an asked food, a line, or water that nobody asked for.

    ``facts`` are those of the food (``None`` for a line and for water), ``phase`` is one of :data:`ORDER`, or of
    :data:`DRY_ORDER` in a pan.
    """

    what: Join | Line | Slot
    facts: Food | None
    phase: str

    @property
    def rank(self) -> tuple[bool, bool, bool, bool]:
        """Its place within its phase: fat first, then what takes longest, seasoning at the end, and what is sour.

        A line, of which there are no facts, comes after the foods that take long and before what seasons.
        """
        facts = self.facts
        if facts is None:
            return (True, True, False, False)
        first = facts.is_a("fat"), facts.is_a(*word_list("is flesh"), *word_list(REDUCED))
        return (not first[0], not first[1], facts.is_a("flour") or _seasons(facts), facts.is_any(_CURDLES))

    @property
    def is_solid(self) -> bool:
        """Whether something comes that is cooked, and no mere fat or seasoning."""
        if self.is_water:
            return False
        return self.facts is None or not (self.facts.is_a("fat") or _seasons(self.facts))

    @property
    def is_water(self) -> bool:
        """Whether it is water: to boil it is nothing to be told, but what joins it then is."""
        return isinstance(self.what, Slot) or (self.facts is not None and self.facts.is_a("water"))


@dataclass(frozen=True)
class Medium:
    """What foods cook in: hot ``fat``, a liquid (``bath``), or both; ``water`` is that which nobody asked for."""

    fat: bool
    bath: bool
    water: Slot | None = None


@dataclass(frozen=True)
class VesselOverHeat:
    """What one vessel takes up while it stands over the heat, in the stages of a ``run``.

    ``joins`` are foods by themselves, ``lines`` what is made of foods beside it, ``within`` the foods of both.
    """

    run: Sequence[Stage]
    joins: Sequence[Join]
    lines: Sequence[Line]
    within: Sequence[Join]

    @property
    def hot(self) -> list[Stage]:
        """The stages at which it is heated."""
        return [stage for stage in self.run if "heat" in stage.does]

    @property
    def water(self) -> Slot | None:
        """The free water that its video has in it."""
        return next((slot for stage in self.run for slot in stage.slots if slot.food == "water"), None)

    def shown(self, *, wet: bool, last: bool) -> Stage | None:
        """Return the stage that shows how a phase is cooked: one in a liquid (``wet``), or the ``last`` one."""
        if wet:
            return next((stage for stage in self.hot if "liquid" in stage.does or "mix" not in stage.does), None)
        return self.hot[-1] if last else next((stage for stage in self.hot if stage.does >= {"heat", "mix"}), None)

    def pattern(self, parts: Sequence[Sequence[Addition]], *, bath: bool, last: bool) -> Stage:
        """Return how the last of ``parts`` is cooked; there may be no stage of that kind in the video.

        ``bath``: in a liquid, if it boils at all; ``last``: it is the last phase of all.
        """
        wet = bath and boils(parts[-1])
        shown = self.shown(wet=wet, last=last)
        if self._breaks(parts, shown, bath=bath):
            return _done_like(self.hot[-1], SIMMER if bath else COOK)
        if shown is None:
            return _done_like(self.hot[-1], SIMMER if wet and not thickens(parts) else STIR)
        stirred = thickens(parts) if wet else not bath and "liquid" in shown.does
        return _done_like(shown, STIR) if stirred else shown

    def _breaks(self, parts: Sequence[Sequence[Addition]], shown: Stage | None, *, bath: bool) -> bool:
        """Return whether what the video has ``shown`` stirs to pieces what came; what is tossed dry may fall apart."""
        if shown is not None and "mix" not in shown.does:
            return False
        if not bath and any_is(self.within, "egg", *word_list("is eaten with a sauce")):
            return False
        return any(_is_soft(addition.facts) for part in parts for addition in part)


def phase_of(facts: Food) -> str:
    """Return in which phase a food of these ``facts`` joins a vessel over the heat.

    It is told by its name or kind, else by the broader ones.
    """
    for own in (facts.taken_for, facts.kind):
        for name in _MOST_TELLING:
            if own in word_list(name):
                return name
    return next((name for name in _MOST_TELLING if facts.is_any(word_list(name))), WET)


def phase_in(join: Join, medium: Medium, *, apart: bool) -> str:
    """Return in which phase an asked food joins: what no knife cuts takes as long as anything in the liquid.

    ``medium`` is what there is to cook in. ``apart``: what is boiled and drained is boiled by itself, and done when it
    joins.
    """
    facts = join.want.facts
    if not medium.bath:
        return phase_suited(facts, medium)
    if (_is_done(join, apart=apart) or _gets_soft(join)) and facts.is_any(
        word_list("is stirred in last when it is done")
    ):
        return LAST
    uncut = says(words(join.want.label), "is no work for a knife")
    hard = uncut and facts.is_any(word_list("is flesh"))
    return WET if hard and phase_of(facts) in {SOON, LAST} else phase_suited(facts, medium)


def _is_done(join: Join, *, apart: bool) -> bool:
    """Whether a food is done when it joins; ``apart``: what is boiled and drained is boiled by itself."""
    done = join.want.cooked or join.want.asked in word_list("is so by dry heat")
    return done or (apart and join.want.facts.is_any(word_list("is boiled by itself")))


def _gets_soft(join: Join) -> bool:
    """Whether a food is in pieces that are eaten as they are, and gets soft in a liquid."""
    raw = join.want.facts.is_any(word_list("gets soft in a liquid")) and "cook" not in join.want.facts.owes
    return raw and join.want.asked not in word_list("is ground")


def phase_suited(facts: Food, medium: Medium) -> str:
    """Return in which phase a food of these ``facts`` joins where ``medium`` has fat to fry in and a liquid, or not."""
    phase = phase_of(facts)
    if phase in {FRIED, BINDS} and not medium.fat:
        return WET
    if medium.fat and facts.is_any(word_list("blooms in hot fat")):
        return FRIED
    if medium.bath:
        toasted = phase == WET and medium.fat and facts.is_any(word_list("is toasted"))
        return BINDS if toasted else phase
    return _phase_in_a_pan(facts, phase)


def _phase_in_a_pan(facts: Food, phase: str) -> str:
    """Return in which phase a food joins where there is no liquid, if one that is in such a ``phase`` elsewhere."""
    if facts.is_any(word_list(REDUCED)):
        return REDUCED
    if facts.is_any(word_list("is boiled by itself")):
        return WET  # it is done already
    long = phase == WET and facts.is_any(word_list("takes long in the pan"))
    return FRIED if long or facts.is_any(word_list("is fried where nothing is wet")) else phase


def phase_together(foods: Sequence[Food], *, bath: bool) -> str:
    """Return when foods join that were put together beside the vessel: with the first that does not only fry.

    ``bath``: there is a liquid that they cook in.
    """
    if any(one.is_any(word_list("is flesh")) for one in foods):
        return FRIED
    phases = {phase_suited(one, Medium(fat=True, bath=bath)) for one in foods}
    order = (WET, SOON, LAST) if bath else (SOON, WET, LAST)
    return next((name for name in order if name in phases), WET)


def in_parts(additions: Sequence[Addition], order: Sequence[str]) -> list[list[Addition]]:
    """Return the ``additions`` of a stage, parted by the phases of ``order``.

    What only seasons, and fat, makes no phase: it joins the one before, or waits for the next.
    """
    parts: list[list[Addition]] = []
    waiting: list[Addition] = []
    for name in order:
        here = sorted((one for one in additions if one.phase == name), key=lambda one: one.rank)
        if _makes_a_phase(here, name):
            first, *others = _one_after_another(here) if name == FRIED else (here,)
            parts += [[*waiting, *first], *others]
            waiting = []
        elif parts and not any(one.is_water for one in here):
            parts[-1] += here
        else:
            waiting += here
    if waiting:
        parts.append(waiting)
    return parts


def _one_after_another(fried: Sequence[Addition]) -> list[list[Addition]]:
    """Return what is fried, parted: what its own fat runs out of, flesh that browns, and then the rest.

    Fat and seasoning come with the first of these.
    """
    first = [one for one in fried if not one.is_solid]
    solid = [one for one in fried if one.is_solid]
    groups = [[one for one in solid if _turn(one) == turn] for turn in (0, 1, 2)]
    groups = [group for group in groups if group]
    return [[*first, *groups[0]], *groups[1:]]


def _turn(addition: Addition) -> int:
    """Return when of all that is fried something comes, counted from 0."""
    kind = addition.facts.kind if addition.facts is not None else ""
    if kind in word_list("is fried until its fat runs") | word_list("gives its fat to other flesh"):
        return 0
    return 1 if kind in word_list("is browned before the rest") else 2


def _makes_a_phase(additions: Sequence[Addition], name: str) -> bool:
    if name == LONG:
        return bool(additions)  # water is enough where what was browned takes hours
    # water alone is no phase, salted water is: that is brought to the boil before anything comes
    water = [one for one in additions if one.is_water]
    return any(one.is_solid for one in additions) or 0 < len(water) < len(additions)


def untoasted(additions: Sequence[Addition]) -> list[Addition]:
    """Return ``additions``, grain with the water where nothing else comes with that: one cooking is told of both."""
    if not all(one.is_water for one in additions if one.phase == WET):
        return list(additions)
    toasted = word_list("is toasted")
    return [replace(c, phase=WET) if c.facts is not None and c.facts.is_any(toasted) else c for c in additions]


def finishing_fat_last(additions: Sequence[Addition]) -> list[Addition]:
    """Return ``additions`` with fat that only gives its taste at the end, where there is other fat to fry in."""
    fats = [addition for addition in additions if addition.facts is not None and addition.facts.is_a("fat")]
    last = [
        addition
        for addition in fats
        if addition.facts is not None and addition.facts.is_any(word_list("is fat for its taste"))
    ]
    if len(last) == len(fats):
        return list(additions)
    return [replace(addition, phase=LAST) if addition in last else addition for addition in additions]


def thickened_at_last(additions: Sequence[Addition], sauces: Sequence[Addition]) -> list[Addition]:
    """Return ``additions`` with ``sauces``, which are thick at once, after what is fried for a moment only.

    That is so where all the liquid is in them, and nothing has to cook in it: poured before, they stew what is to stay
    crisp.
    """
    others = [one for one in additions if one not in sauces]
    if any(map(_cooks_in_liquid, others)) or not any(one.phase == SOON and one.is_solid for one in others):
        return list(additions)
    return [replace(one, phase=LAST) if one in sauces and one.phase == WET else one for one in additions]


def _cooks_in_liquid(addition: Addition) -> bool:
    """Whether what comes is a liquid to cook in, or is done in none but that."""
    facts = addition.facts
    if facts is None or facts.is_a("fat") or _seasons(facts):
        return addition.is_water
    return addition.phase in {LONG, WET} or is_bath(facts) or facts.is_any(word_list("swells"))


def boils(additions: Iterable[Addition]) -> bool:
    """Return whether something of ``additions`` is to be cooked in a liquid, or is that."""
    return any(one.phase in {LONG, WET} and (one.is_solid or one.is_water) for one in additions)


def thickens(parts: Sequence[Sequence[Addition]]) -> bool:
    """Return whether the last of ``parts`` is what is poured on fat and flour, with nothing to be cooked in it."""
    *before, last = parts
    facts = [addition.facts for part in before for addition in part if addition.facts is not None]
    bound = any(one.is_a("flour") for one in facts) and any(one.is_a("fat") for one in facts)
    return bound and all(_is_stirred_on_flour(addition.facts) for addition in last)


def _is_soft(facts: Food | None) -> bool:
    """Whether a spoon stirs a food to pieces."""
    soft = facts is not None and facts.is_any(word_list("breaks when it is stirred"))
    return soft and facts is not None and not facts.is_any(word_list("is stirred and stays whole"))


def _is_stirred_on_flour(facts: Food | None) -> bool:
    return facts is not None and (facts.is_any(word_list("is stirred on flour")) or _seasons(facts))


def is_strewn(join: Join) -> bool:
    """Return whether the food of ``join`` is strewn on what is done; leaves that give their taste by and by are not."""
    facts = join.want.facts
    return join.on_top or (facts.is_a("topping", "herb") and phase_of(facts) == LAST)


def is_dry_binder(joins: Sequence[Join]) -> bool:
    """Return whether ``joins`` are but flour or starch, with what seasons it: a cook stirs it into the fat as it is."""
    facts = [join.want.facts for join in joins]
    binds = [one for one in facts if one.kind in word_list("makes lumps")]
    return bool(binds) and all(one in binds or _seasons(one) for one in facts)


def needs_pan(facts: Food) -> bool:
    """Return whether a food of these ``facts`` is not done when eggs set around it."""
    return is_raw_flesh(facts) or phase_of(facts) == FRIED or facts.is_any(word_list("takes long in the pan"))


def is_raw_flesh(facts: Food) -> bool:
    """Return whether a food of these ``facts`` is meat or fish, and not sold ready to be eaten."""
    return facts.is_any(word_list("is flesh")) and not facts.is_a("ready")


def makes_a_sauce(joins: Sequence[Join]) -> bool:
    """Return whether in ``joins`` flour is stirred into fat, and something is poured on it."""
    facts = [join.want.facts for join in joins]
    other = any(one.is_a("leaven", *word_list("makes no sauce of flour")) for one in facts)
    told = any(one.is_a("flour") for one in facts) and any(one.is_a("fat") for one in facts)
    return told and not other and any(one.is_of(*_BATHS) for one in facts)


def is_bath(facts: Food) -> bool:
    """Return whether other foods cook in a food of these ``facts``."""
    return facts.is_of(*_BATHS) and not facts.is_any(word_list("is no bath"))


def unbeaten(foods: Sequence[Join], *, sets: bool) -> list[Join]:
    """Return what of ``foods``, mixed cold, is not beaten with the eggs among them, or eggs that come to a liquid.

    ``sets``: all of it sets and is folded then, so that the eggs come first.
    """
    eggs = any_is(foods, "egg") and not any_is(foods, *word_list("is held together with eggs"))
    bath = not sets and any(_is_bath_for_eggs(join.want.facts) for join in foods)

    def comes_by_itself(facts: Food) -> bool:
        fried_before = eggs and not facts.is_a("fat") and needs_pan(facts)
        return fried_before or (bath and facts.is_a("egg"))

    return [join for join in foods if comes_by_itself(join.want.facts)]


def _is_bath_for_eggs(facts: Food) -> bool:
    """Whether eggs are stirred into a food that boils; they are beaten with a little milk before they are fried."""
    return is_bath(facts) and not facts.is_any(word_list("is beaten with eggs"))


def _seasons(facts: Food) -> bool:
    """Whether a food only seasons what is cooked: cheese and bacon are salty, yet more than that."""
    more = facts.is_a("ready", *word_list("is cooked in phases")) or is_bath(facts)
    return facts.is_any(word_list("only flavours")) and not more


def _done_like(stage: Stage, pattern: Stage) -> Stage:
    """Return a stage in its own vessel, cooked by the motion of ``pattern``."""
    return replace(stage, motion=pattern.motion, does=pattern.does, tools=pattern.tools)
