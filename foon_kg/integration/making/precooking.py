"""Whether a food is cooked by itself before it joins, and by which motions.

Nothing is done here: :mod:`~foon_kg.integration.making.alone` does it.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence, Set

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.food.rows import CHOPPED, POWDER
from foon_kg.integration.bench import Bench
from foon_kg.integration.composing.coated import is_portion
from foon_kg.integration.joining.course import MIXES, Course
from foon_kg.integration.joining.spots import Join, Spot
from foon_kg.integration.making.outcome import STEM
from foon_kg.integration.preparing.preparation import Want, owed
from foon_kg.integration.preparing.preparer import Preparer
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import HEATS, Phase, Stage
from foon_kg.integration.teaching.operators import Nearness, Way

_MUCH_ALIKE = 0.8
"""From this fit on a food is cooked before as the video cooks that of its slot, though it is of another kind."""

_IN_WATER, _IN_A_PAN = ("boil",), ("cook",)
"""The motions of the two ways of cooking that any kitchen has."""


class Precooking:
    """Decides for the foods of one dish how each is cooked before it joins."""

    def __init__(self, bench: Bench, course: Course, preparer: Preparer) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.course = course
        self.plan = course.plan
        self.preparer = preparer

    def method(self, join: Join) -> tuple[str, ...]:
        """Return the motions by which the food of ``join`` is cooked by itself before; nothing where the dish cooks it.

        What is asked outright comes before what the dish would do, that before what its video shows, and that before
        what is usual for its kind.
        """
        if self._is_dense(join.want) and self._is_only_fried(join.spot):
            return _IN_WATER
        return self._by_what_is_due(join)

    def _by_what_is_due(self, join: Join) -> tuple[str, ...]:
        """Return how a food is cooked by itself before that gets soft where it joins, or is asked done."""
        want, due = join.want, self._due(join.want)
        if not (due or want.cooked):
            return self._warming(join)
        otherwise = self._browned(join) or self._otherwise(join)
        if otherwise:
            return otherwise
        if self._was_cooked_before(want):
            return self._usual(want)
        if self._is_cooked_in_turn(join, due) or self._is_eaten_raw_there(want):
            return ()
        return self._as_told(join, due) or self._unless_done_there(join, due)

    def _was_cooked_before(self, want: Want) -> bool:
        """Whether a food is asked cold, or as it was left over, that somebody has to cook for that."""
        return want.cooked and want.asked in word_list("only what was cooked is so") and not self.pours(want)

    def _is_eaten_raw_there(self, want: Want) -> bool:
        """Whether a dish has such a food raw, though others cook it (the egg of a mayonnaise), and so it is asked."""
        return not want.cooked and not self.plan.eased.isdisjoint({want.facts.kind, *want.facts.kinds})

    def _due(self, want: Want) -> set[str]:
        """Return of boiling and cooking what the food still needs to be eaten."""
        return {"cook", "boil"} & owed(want, self.known)

    # --- what is asked of a food ---

    def is_asked_done(self, want: Want) -> bool:
        """Return whether ``want`` is meat or fish that was cooked before: then it is boiled by itself, and cut."""
        return want.make in word_list("begins cooked") and want.facts.is_any(word_list("is flesh"))

    def is_fried_open(self, want: Want) -> bool:
        """Return whether ``want``, which runs out of its shell, is asked done as only a pan does it."""
        return want.make in word_list("is done in a pan") and self.pours(want)

    def pours(self, want: Want) -> bool:
        """Return whether ``want`` is opened over the dish and runs into it: such food is cooked as fast as anything."""
        return "shell" in want.facts.owes and self.preparer.opening(want) is not None

    def _is_cut_of_its_shell(self, want: Want) -> bool:
        """Whether a food that runs out of its shell is asked in pieces or peeled: it is boiled in its shell."""
        fine = self.known.state(want.make).fineness
        peeled = want.asked in word_list("has no shell any more")
        boiled = want.make in word_list("is so by boiling")
        return (peeled or boiled or 0 < fine < POWDER) and self.pours(want)

    def _is_dense(self, want: Want) -> bool:
        """Whether a raw food stays hard in a pan, however it was cut, unless it is grated."""
        fine = self.known.state(want.make).fineness if want.make else 0
        dense = want.facts.is_any(word_list("stays hard in the pan"))
        return dense and not want.cooked and fine <= CHOPPED

    def _is_thick(self, want: Want) -> bool:
        """Whether a food is asked in such large pieces that it takes very long in a pan."""
        halved = bool(want.make) and self.known.state(want.make).fine == 1
        return halved and want.facts.is_any(word_list("takes long in the pan"))

    # --- cooked otherwise than its video or its kind says ---

    def _otherwise(self, join: Join) -> tuple[str, ...]:
        """Return how a food is cooked for which neither its video nor its kind is asked.

        What a title calls roasted is baked, flesh for a salad fried whole, and what is divided then as it is asked.
        """
        want, stage = join.want, join.spot.stage
        if want.roasted and not _is_done_there(join.spot, {"dry"}):
            return tuple(sorted(word_list("is roasted by")))
        if want.cooked and want.then:
            return self._to_be_divided(want)
        if self._is_thick(want) and self._comes_into_a_pan(join.spot):
            return _IN_WATER  # it would be brown outside and raw within
        if isinstance(stage, Phase) and self._is_done_late(want):
            return _IN_WATER
        return _IN_A_PAN if self._is_fried_first(join) else ()

    def _to_be_divided(self, want: Want) -> tuple[str, ...]:
        """Return how a food is cooked that is cut or mashed then: as it is asked, else in water to be mashed."""
        if want.make in word_list("begins cooked") and self._is_made_soft(want):
            return _IN_WATER
        if not want.make or self._is_boiled(want.make):
            return _IN_WATER
        return self._asked_cooking(want) or self._usual(want)

    @staticmethod
    def _is_made_soft(want: Want) -> bool:
        """Whether a food is pulled apart or mashed once it is cooked, or such as nobody fries to have it done."""
        facts, soft = want.facts, want.then in word_list("only what is soft is so")
        pulled = want.then in word_list("is pulled apart so") and facts.is_any(word_list("is flesh"))
        return soft or pulled or facts.is_any(word_list("is boiled rather than fried"))

    def _comes_into_a_pan(self, spot: Spot) -> bool:
        """Whether what joins there is first heated in a pan with no liquid in it."""
        first = next((stage for stage in _stages(spot) if stage.heats), None)
        return first is not None and "dry" not in first.does and not self.course.has_liquid([first])

    def _is_only_fried(self, spot: Spot) -> bool:
        """Whether what joins there comes into a pan, and into no liquid after that."""
        hot = [stage for stage in _stages(spot) if stage.heats]
        wet = any("liquid" in stage.does or "dry" in stage.does or self.course.has_liquid([stage]) for stage in hot)
        return not (wet or self.plan.spooned or self.plan.one_pot) and self._comes_into_a_pan(spot)

    def _takes_longer(self, want: Want) -> bool:
        """Whether pulses are asked beside grain that is done long before them; in a soup they have all the time."""
        slow = word_list("takes longer than the rest")
        if self.plan.spooned or not want.facts.is_any(slow) or "boil" not in want.facts.owes:
            return False
        others = (join.want.facts for join in self.plan.joins if not join.want.facts.is_any(slow))
        return any(facts.is_any(word_list("is toasted")) for facts in others)

    def _is_done_late(self, want: Want) -> bool:
        """Whether a food would be hard when the rest is done, or the rest, as grain, mush when it is done."""
        return self._takes_longer(want) or self._is_kept_hard(want)

    def _is_kept_hard(self, want: Want) -> bool:
        """Whether dry pulses are asked for a pan beside something sour, in which they would not get soft."""
        if self.plan.spooned or self.plan.one_pot or "boil" not in want.facts.owes:
            return False
        others = (join.want.facts for join in self.plan.joins)
        pulse = want.facts.is_any(word_list("takes longer than the rest"))
        return pulse and any(facts.is_any(word_list("keeps pulses hard")) for facts in others)

    def _is_fried_first(self, join: Join) -> bool:
        return self._is_fried_whole(join) or self._is_fried_before_it_is_mixed(join)

    def _is_fried_whole(self, join: Join) -> bool:
        """Whether a portion comes to what is eaten with a fork, and nothing boils it there."""
        portion = self.plan.in_pieces and is_portion(join.want, self.known)
        return portion and not self.course.has_liquid([join.spot.stage])

    def _is_fried_before_it_is_mixed(self, join: Join) -> bool:
        """Whether a food is stirred into a batter or dough, where it would stay limp and run with fat."""
        stage = join.spot.stage
        cold = not stage.does.isdisjoint(MIXES) and not stage.heats
        if not cold or not join.want.facts.is_any(word_list("is cut once it is fried alone")):
            return False
        baked = _is_done_there(join.spot, {"dry"}) and not _is_done_there(join.spot, {"shape"})
        return baked and any(one.want.facts.is_any(word_list("makes a batter")) for one in self.plan.joins)

    def _browned(self, join: Join) -> tuple[str, ...]:
        """Return how a food is cooked before that is asked fried, roasted or toasted, if the dish would not do that."""
        want, stage = join.want, join.spot.stage
        dry = stage.heats and "liquid" not in stage.does and not self.course.has_liquid([stage])
        if not self._is_asked_of_dry_heat(want) or (dry and not want.then):
            return ()
        return _IN_A_PAN if self.is_toasted_in_a_pan(want) else self._by_fat_or_oven(join)

    def _is_asked_of_dry_heat(self, want: Want) -> bool:
        """Whether a food is asked as something hot makes it alone: not what is boiled, nor runs out of its shell."""
        return want.cooked and not self.pours(want) and "boil" not in self._due(want)

    def _by_fat_or_oven(self, join: Join) -> tuple[str, ...]:
        """Return how a food is cooked by itself that is asked as only a hot pan makes it, or an oven.

        Nothing is roasted for a dish that comes into the oven, and what is toasted elsewhere is toasted here.
        """
        want = join.want
        if want.make in word_list("is so in fat"):
            return self._asked_cooking(want) or _IN_A_PAN
        oven = want.make in word_list("is so in the oven") and not _is_done_there(join.spot, {"dry"})
        toasted = want.facts.is_any(word_list("is toasted by itself"))
        return tuple(sorted(word_list("is roasted by"))) if oven and not toasted else ()

    @staticmethod
    def is_toasted_in_a_pan(want: Want) -> bool:
        """Return whether ``want`` is asked toasted and is a small thing, for which nobody heats an oven."""
        return want.make in word_list("is so by dry heat") and want.facts.is_any(word_list("is toasted in a pan"))

    # --- where the dish cooks it ---

    def _is_cooked_in_turn(self, join: Join, due: Collection[str]) -> bool:
        """Whether a food is cooked among the others in a vessel over the heat, in its turn and as it is."""
        want = join.want
        if not isinstance(join.spot.stage, Phase) or "boil" in due or want.cooked or want.then:
            return False
        return not self._is_cut_of_its_shell(want) and not self.preparer.is_mashed_raw(want)

    def _as_told(self, join: Join, due: Collection[str]) -> tuple[str, ...]:
        """Return how a food is cooked before whatever the dish would do to it; nothing where that may do."""
        want = join.want
        if self.is_fried_open(want) and not _is_done_there(join.spot, HEATS):
            return _IN_A_PAN
        if self._is_cut_of_its_shell(want):
            return _IN_WATER
        shown = _shown(join)
        if shown or want.then:
            return shown or _IN_WATER
        if self.preparer.is_mashed_raw(want) or (due and self.is_asked_done(want)):
            return _by_kind(want)
        return ()

    def _unless_done_there(self, join: Join, due: Collection[str]) -> tuple[str, ...]:
        """Return how a food is cooked before, unless it gets done where it joins."""
        want = join.want
        heats = [stage for stage in _stages(join.spot) if "heat" in stage.does]
        if self._is_boiled_there(join, heats, due):
            return ()
        if "boil" in due or self._is_asked_boiled(want, heats):
            return _IN_WATER
        if heats and self._gets_done_there(join, due):
            return ()
        return self._asked_cooking(want) or self._usual(want)

    def _is_boiled_there(self, join: Join, heats: Sequence[Stage], due: Collection[str]) -> bool:
        """Whether a food gets done in the liquid of the dish, which the stages in ``heats`` heat."""
        bath = [stage for stage in heats if "dry" not in stage.does]
        if "boil" not in due or not bath or not self._may_boil(join) or not self.course.has_liquid(bath):
            return False
        by_itself = join.want.facts.is_any(word_list("is boiled by itself")) and not self.plan.one_pot
        return not by_itself or any(map(_is_drained, heats))

    def _is_asked_boiled(self, want: Want, heats: Sequence[Stage]) -> bool:
        """Whether a food is asked as only boiling makes it, and none of ``heats`` boils anything."""
        return want.cooked and self._is_boiled(want.make) and not any("liquid" in stage.does for stage in heats)

    def _may_boil(self, join: Join) -> bool:
        """Whether a food can be boiled where it joins: in a phase over the heat only in a bath, or where it swells."""
        stage = join.spot.stage
        if not isinstance(stage, Phase):
            return True
        wet = stage.bath or self.course.swells_there(join) or self._simmers_on(stage)
        return not join.want.cooked and wet

    def _simmers_on(self, stage: Stage) -> bool:
        """Whether all of a dish goes on simmering at a stage, in a liquid that came before."""
        before = self.course.until(stage)[:-1]
        return self.plan.one_pot and "liquid" in stage.does and any(self.course.has_liquid([one]) for one in before)

    def _gets_done_there(self, join: Join, due: Collection[str]) -> bool:
        """Whether heat where a food joins, or later, makes it as it is asked."""
        want = join.want
        if self.plan.laid and want.facts.is_any(word_list("is flesh")):
            return False  # it would be raw when the dough is done
        if want.make in word_list("is so by dry heat") and join.spot.stage.does & MIXES:
            return False  # nothing gets brown inside what is wet
        if want.make in word_list("is so by steam") and join.spot.stage.does & MIXES and not join.spot.stage.heats:
            return False  # it would be as hard as it was when it is mixed
        return self._cooks_there(join, due) and not _is_toasted(join)

    def _cooks_there(self, join: Join, due: Collection[str]) -> bool:
        """Whether a food gets done where it joins, and is not only warmed up there with foods that are done."""
        quick = (
            join.spot.stage_type.work == "heat" and join.slot is None and "cook" in due and not self.pours(join.want)
        )
        return not quick or self.course.has_liquid([join.spot.stage])

    # --- how it is cooked then ---

    def _asked_cooking(self, want: Want) -> tuple[str, ...]:
        """Return the motions that give a food the cooked state in which it is asked (fried), as the FOON shows."""
        if not want.cooked:
            return ()
        if want.make in word_list("begins cooked") and want.facts.is_any(word_list("is boiled rather than fried")):
            return _IN_WATER
        ways = [way for way in self.bench.operators.giving.get(want.make, ()) if self._is_simple_heat(way)]
        found = self.bench.attest(ways, want.names, act=True)
        return (found.way[0],) if found is not None and found.nearness <= Nearness.LIKE else ()

    def _is_simple_heat(self, way: Way) -> bool:
        does = self.known.motion(way[0]).does
        return "heat" in does and "dry" not in does and does <= {"heat", "fat", "liquid", "mix"}

    def _usual(self, want: Want) -> tuple[str, ...]:
        """Return how such foods are cooked by themselves in this FOON."""
        traits = sorted(f"trait:{trait}" for trait in want.facts.traits)
        for name in (want.facts.kind, *traits, *sorted(want.facts.kinds)):
            if self.plan.cooked_by.get(name):
                return self.plan.cooked_by[name]
        if form_of(self.known, want.label, want.leaf) == "liquid":
            return ()  # it would be poured away with the water
        fat = any(one.want.facts.is_a("fat") for one in self.plan.joins)
        soft = not want.facts.is_any(word_list("is boiled rather than fried")) and "shell" not in want.facts.owes
        return _IN_A_PAN if fat and soft else _IN_WATER

    def _is_boiled(self, state: str) -> bool:
        """Whether a state is one that only cooking in water gives."""
        motions = {
            way[0] for way in self.bench.operators.ways.get("heat", ()) if state in self.known.motion(way[0]).gives
        }
        own = [motion for motion in motions if any(word.startswith(motion[:STEM]) for word in state.split())]
        return bool(own) and all("liquid" in self.known.motion(motion).does for motion in own)

    def _warming(self, join: Join) -> tuple[str, ...]:
        """Return how a food is made warm by itself where it is asked so (melted): not where it comes into the heat."""
        state = join.want.make
        if not state or not self.known.state(state).needs_heat:
            return ()
        if join.spot.stage.heats and not _is_toasted(join):
            return ()
        ways = self._warming_ways(state)
        found = self.bench.attest(ways, join.want.names) or self.bench.far(ways[:1], join.want.names)
        return (found.way[0],) if found is not None else ()

    def _warming_ways(self, state: str) -> list[Way]:
        """Return the ways that heat and give a state in this FOON; what is only made warm is heated, and no more."""
        does = self.known.motion
        ways = [way for way in self.bench.operators.making(state) if does(way[0]).does & HEATS]
        if state in word_list("is only made warm"):
            return [way for way in ways if does(way[0]).does == {"heat"} and not way[1]]
        return [way for way in ways if way in self.bench.operators.giving.get(state, ())]


def _stages(spot: Spot) -> tuple[Stage, ...]:
    """Return the stage of a spot and all that come after it."""
    return (spot.stage, *spot.after)


def _is_done_there(spot: Spot, does: Set[str]) -> bool:
    """Whether something of this is done where a food joins, or later."""
    return any(not stage.does.isdisjoint(does) for stage in _stages(spot))


def _shown(join: Join) -> tuple[str, ...]:
    """Return how the video cooks the food of a slot before, where what joins there is much like that."""
    slot = join.slot
    if slot is None:
        return ()
    return slot.cooked if slot.kind == join.want.facts.kind or join.fit >= _MUCH_ALIKE else ()


def _by_kind(want: Want) -> tuple[str, ...]:
    """Return how a food of such a kind is cooked whole."""
    return _IN_A_PAN if want.facts.is_any(word_list("is fried rather than boiled")) else _IN_WATER


def _is_toasted(join: Join) -> bool:
    """Whether a food that is eaten as it is would not turn out as asked among what is cooked there."""
    facts = join.want.facts
    return isinstance(join.spot.stage, Phase) and facts.traits >= {"ready", "stock"} and not facts.is_a("fat")


def _is_drained(stage: Stage) -> bool:
    """Whether what a stage boils is boiled in water of its own."""
    return "liquid" in stage.does and "water" in {slot.food for slot in stage.slots}
