"""Foods are made ready to join: fetched, opened, cut and peeled, as they are asked and as the dish needs them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from dataclasses import replace

from foon_kg.food import Food, Tables
from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import fineness
from foon_kg.integration.joining.course import MIXES
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.alone import Alone
from foon_kg.integration.preparing.preparation import Ready, Want
from foon_kg.integration.teaching.forms import form_of, is_scooped
from foon_kg.integration.teaching.frames import HEATS, Phase, Stage

_LEFT = "it is too small to be taken out again: it stays in the dish, and is not eaten"


class Readying:
    """Makes the foods of one dish ready on a bench; what is cooked by itself then is cooked ``alone``."""

    def __init__(self, alone: Alone) -> None:
        self.bench = alone.bench
        self.known: Tables = alone.known
        self.plan = alone.plan
        self.course = alone.precooking.course
        self.alone = alone
        self.ready = alone.ready

    def prepare(self, join: Join) -> None:
        """Make the food of ``join`` ready as far as that is done before anything is hot."""
        blended = _is_blended(join)
        form = self._form(join)
        want = self._as_eaten(join, blended=blended)
        self.bench.phase = "prepare"
        method = self.alone.precooking.method(join)
        if method and self._is_cooked_in_its_shell(want):
            taken = self.bench.fetch(want.label, want.leaf, [want.number], want.storage, stands=want.stands)
            shelled = Ready(want, taken, whole_shell=True, cut_later=want.then)
            self.ready[want.number] = self._cut_once_done(join, shelled)
            return
        ready = self.alone.preparer.prepare(want, form, divided=not blended, alone=bool(method))
        if method:
            self._cut_once_done(join, ready)
        elif self.plan.by_bites and not blended and not _is_done_later(join, {"cut"}):
            self.alone.preparer.cut_to_bites(ready, hot=_is_done_later(join, HEATS))
        self.ready[want.number] = ready
        self._tell_what_is_left(ready, blended=blended)
        self.alone.beaten_first(join, ready)
        self._set_water_aside(join, ready)

    def _set_water_aside(self, join: Join, ready: Ready) -> None:
        """Keep the water of a pot for later, and measure what comes into a hot vessel, where ``ready`` is water."""
        if ready.want.facts.is_any(word_list("is the water of a pot")):
            self.alone.carry.water.kept.append(ready)
        elif ready.want.facts.is_a("water") and self.course.is_hot(join.spot.stage):
            self.alone.measure(ready)

    def _tell_what_is_left(self, ready: Ready, *, blended: bool) -> None:
        """Tell of what nobody finds again in a dish, where nothing is ``blended`` and no strainer keeps it back."""
        if not (self.plan.in_glass or blended) and self._is_left_on_the_plate(ready.want):
            ready.assumptions.append(_LEFT)

    def _is_left_on_the_plate(self, want: Want) -> bool:
        """Whether a food comes whole that nobody eats, and is too small to be found again in a dish."""
        whole = fineness(filter(None, (want.make, *want.leaf)), self.known) == 0
        return whole and want.facts.is_any(word_list("is left on the plate"))

    def _is_cooked_in_its_shell(self, want: Want) -> bool:
        """Whether a food that is cooked by itself goes into the water in its shell."""
        if "shell" not in want.facts.owes or self.alone.precooking.is_fried_open(want):
            return False
        return form_of(self.known, want.label, want.leaf) != "liquid"

    def _form(self, join: Join) -> tuple[str, ...]:
        """Return in which states a food joins as far as nobody asked: as the slot has it, or as such a dish needs."""
        facts, stage = join.want.facts, join.spot.stage
        pulled = any(one.motion in word_list("pulls flesh apart") for one in join.spot.after)
        bites = self.plan.by_bites and not self.plan.in_pieces  # that is cut when it is cooked
        small = (bites or (isinstance(stage, Phase) and stage.small)) and not pulled
        needs = [
            ("halved", self.plan.stacked, "is split"),
            ("sliced", self.plan.stacked, "is sliced to be stacked"),
            ("chopped", small, "is cut for a dish"),
            ("shaved", self._is_mixed(join), "is cut off its cob"),
            ("chopped", _is_done_later(join, MIXES), "is cut to be mixed"),
            ("crushed", _is_done_later(join, {"dry"}), "is crushed to be baked"),
        ]
        hot = _is_done_later(join, HEATS) and not self.plan.stacked
        melts = [
            ("grated", True, "is grated over it"),
            ("grated", hot, "is grated to melt"),
            ("crumbled", not self.plan.stacked, "is crumbled"),
        ]
        form = join.slot.states if join.slot is not None else ()
        return (*_those(melts, facts), *form, *_those(needs, facts))

    def _is_mixed(self, join: Join) -> bool:
        """Whether more than seasoning joins at the same stage, or before it, so that nobody eats a food by itself."""
        others = (one.want.facts for one in self.plan.joins if one is not join)
        return any(not facts.is_any(word_list("is eaten on a cob")) for facts in others)

    def _is_soft_or_cut(self, want: Want) -> bool:
        """Whether a food comes soft or in pieces, so that no knife need do more."""
        soft = is_scooped(want.leaf) or says(want.leaf, "is soft so")
        return soft or fineness(filter(None, (want.make, *want.leaf)), self.known) > 0

    def _as_eaten(self, join: Join, *, blended: bool) -> Want:
        """Return a want that nobody asked cut, cut or mashed where it is never eaten, shaped or ``blended`` whole."""
        want = self._as_soft_as_needed(join)
        if self._is_soft_or_cut(want):
            return want
        if blended and want.facts.is_any(word_list("is cut to be blended")):
            return replace(want, make=min(word_list("is cut so to be blended")))
        if self._is_stirred_in(join) and want.facts.is_any(word_list("is cut to be stirred in")):
            return replace(want, make=min(word_list("is cut so to be blended")))
        if _is_shaped_later(join) and want.facts.is_any(word_list("is mashed to be shaped")):
            return replace(want, make="mashed")
        if _is_eaten_raw(join) and want.facts.is_any(word_list("is never eaten whole")):
            return replace(want, make=min(word_list("is cut so to be eaten raw")))
        return want

    def _is_stirred_in(self, join: Join) -> bool:
        """Whether a food is mixed with the rest of what is eaten, and neither lies on it nor swims in a glass."""
        mixed = self.plan.in_pieces or _is_done_later(join, MIXES)
        return mixed and not self.plan.in_glass and not join.on_top

    def _as_soft_as_needed(self, join: Join) -> Want:
        """Return a want that lay out of the refrigerator where it is beaten or stirred with others while it is cold."""
        want = join.want
        if want.make or not want.facts.is_any(word_list("is soft when it is beaten")):
            return want
        if set(want.leaf) <= word_list("is hard in the refrigerator") and self._is_beaten(join.spot.stage):
            return replace(want, leaf=(min(word_list("is soft so")),))
        return want

    def _is_beaten(self, stage: Stage) -> bool:
        """Whether a stage beats or stirs cold what joins it; into flour fat is rubbed as hard as it is."""
        if stage.heats:
            return False
        if not stage.does.isdisjoint({"blend", "whip"}):
            return True
        return "mix" in stage.does and not any(one.want.facts.is_a("flour") for one in self.course.ordered(stage))

    def _cut_once_done(self, join: Join, ready: Ready) -> Ready:
        """Have what is eaten in pieces, or is mixed with others where it joins, cut when it is cooked."""
        first_fried = ready.want.facts.is_any(word_list("is cut once it is fried alone"))
        if (first_fried and join.spot.stage.does & MIXES) or self._is_cut_once_done(ready.want):
            self.alone.preparer.cut_once_done(ready)
        return ready

    def _is_cut_once_done(self, want: Want) -> bool:
        """Whether a food that is cooked by itself comes in pieces to the others."""
        facts = want.facts
        cut = [
            (self.plan.in_pieces, "is cut once it is cooked"),
            (self.plan.stacked, "is cut to be stacked"),
            (self.plan.laid, "is flesh"),
            (self.plan.by_bites, "is cut for a dish"),
        ]
        if any(so and facts.is_any(word_list(kinds)) for so, kinds in cut):
            return True
        flat = self.plan.stacked and facts.is_any(word_list("is fried rather than boiled"))
        return self.alone.precooking.is_asked_done(want) and not flat


def _those(needs: Sequence[tuple[str, bool, str]], facts: Food) -> Iterator[str]:
    """Yield of ``needs`` the states in which a food joins: each with whether such a dish has it, and the kinds."""
    return (state for state, needed, kinds in needs if needed and facts.is_any(word_list(kinds)))


def _is_blended(join: Join) -> bool:
    """Whether a food is mashed or blended where it joins, or right after a stage at which foods only come together."""
    stage, after = join.spot.stage, join.spot.after
    if "blend" in stage.does or ("mash" in stage.does and "mix" not in stage.does):
        return True
    return not stage.does and bool(after) and "blend" in after[0].does


def _is_done_later(join: Join, does: Set[str]) -> bool:
    """Whether any of these things is done to a food where it joins, or later."""
    return any(not stage.does.isdisjoint(does) for stage in (join.spot.stage, *join.spot.after))


def _is_eaten_raw(join: Join) -> bool:
    """Whether a food joins what nobody heats any more, or what is shaped with it inside."""
    works = (join.spot.stage, *join.spot.after)
    if any(not stage.does.isdisjoint({"blend", "liquid"}) for stage in works):
        return False
    return _is_shaped_later(join) or all(not stage.heats for stage in works)


def _is_shaped_later(join: Join) -> bool:
    """Whether the mass that a food joins is shaped, and then cooked: patties."""
    places = [place for place, stage in enumerate(join.spot.after) if "shape" in stage.does]
    return bool(places) and any("heat" in stage.does for stage in join.spot.after[places[0] :])
