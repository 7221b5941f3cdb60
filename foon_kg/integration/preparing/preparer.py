"""What is done to one food before it joins: whether it is opened, cleaned, squeezed or cut, and in which order.

A cook's duties to a food (peel it, stone it, shell it) are data (:mod:`foon_kg.food`); how they are done is in
:mod:`~foon_kg.integration.preparing.treating` and :mod:`~foon_kg.integration.preparing.cutting`.
"""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import words
from foon_kg.food.lists import says, word_list
from foon_kg.food.parted import parts_in
from foon_kg.food.rows import HALVED, POWDER
from foon_kg.food.workings import first_states, working
from foon_kg.integration.bench import Bench, RefusedError, Stuff
from foon_kg.integration.preparing.cutting import BOWL
from foon_kg.integration.preparing.preparation import (
    BY_HAND,
    JUICE,
    Ready,
    Want,
    earned,
    is_left_whole,
    owed,
)
from foon_kg.integration.preparing.treating import Treater
from foon_kg.integration.teaching.forms import form_of, is_scooped


class Preparer(Treater):
    """Prepares foods on a bench."""

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._parts: dict[str, Stuff] = {}

    def prepare(self, want: Want, form: Sequence[str] = (), *, divided: bool = True, alone: bool = True) -> Ready:
        """Return the food ``want`` as it can join: opened, peeled and cut as it is asked, as ``form`` says or it needs.

        ``form`` are states in which such a food joins elsewhere. ``divided``: it has to be in pieces (not where it is
        blended); ``alone``: it is cooked by itself before it joins. A food in a shell that is to be opened over a
        vessel comes as it is (``whole_shell``).
        """
        due = self._due(want)
        later = want.then and want.then not in word_list("only what is soft is so")  # it stays whole until it is done
        later = later or _is_worked_whole(want)
        cut = "" if later else self._cut_state(want, form, due, divided=divided, alone=alone)
        ready = Ready(want, self._taken(want))
        if want.bought_so:
            ready.assumptions.append(f"no step of this FOON makes {want.label} {', '.join(want.leaf)}: it is bought so")
        if want.foamed or want.of is not None:
            return ready
        if "shell" in due and self.opening(want) is not None:
            ready.whole_shell = True  # an egg on a board would run off
        elif self._comes_in_pieces(want, cut):
            self._take_in_pieces(ready, cut)
        else:
            self._work_on(ready, due, cut, form, alone=alone)
        return ready

    def _take_in_pieces(self, ready: Ready, cut: str) -> None:
        """Bring a food that nobody ``cut``s so into pieces in another way (sifted), or assume that it comes in them."""
        if not self.worked_so(ready, cut):
            self.assume(ready, cut)
            self.advise(ready)

    def _work_on(self, ready: Ready, due: set[str], cut: str, form: Sequence[str], *, alone: bool) -> None:
        """Clean a food of what is ``due``, then squeeze it, or drain and ``cut`` it; see :meth:`prepare`."""
        # in the order of hands: peeled and washed whole, drained before it is cut, and washed inside when it is
        self.clean(ready, due, cut)
        want = ready.want
        if self._is_pressed(want, form):
            self.squeeze(ready)
            return
        if self._comes_in_a_liquid(want):
            self.drain(ready)
        self._rid(ready)
        if _is_soaked_first(want):
            self.soak(ready)
        self.bring_about(ready, want.make)
        if _is_torn_to_soak(want):
            self._cut(ready, min(word_list("is so when it is torn")))
            cut = ""  # no knife cuts what is soft with water
        self.advise(ready)
        self._divide(ready, cut, alone=alone)
        self.clean_inside(ready, due)
        ready.cut_later = want.then or ready.cut_later

    def _rid(self, ready: Ready) -> None:
        """Rid a food that gets ``ready`` of what it was packed in, of its ice, and of what is inside it."""
        want = ready.want
        if _is_packed_dry(want):
            self.rinse(ready, min(word_list("is so when it is rinsed")))
        if want.asked in word_list("is so when it has thawed"):
            self.bring_about(ready, want.asked)
        self._clean_first(ready)

    def _clean_first(self, ready: Ready) -> None:
        """Do to a food that gets ``ready`` what its kind needs before all else."""
        want = ready.want
        told = (want.asked, *words(want.label), *words(want.asked), *want.leaf)
        for state in first_states(want.facts, want.asked, told, cut=self.is_asked_cut(want)):
            if state not in word_list("is so when it is rinsed"):
                self.bring_about(ready, state)
            elif not _is_soaked_first(want):  # that is poured off
                self.rinse(ready, state)

    def _is_pressed(self, want: Want, form: Sequence[str]) -> bool:
        """Whether only the juice of a food joins: as it is asked, or as such a food joins elsewhere."""
        as_elsewhere = JUICE in form and not want.make and form_of(self.known, want.label, want.leaf) == "whole"
        return (want.squeezed or as_elsewhere) and bool(self.operators.giving.get(JUICE))

    def _comes_in_a_liquid(self, want: Want) -> bool:
        """Whether a food is to be drained of what it is sold in."""
        drained = "drain" in want.facts.owes or "drain" in self.known.state(want.asked).earns
        return drained and want.storage in word_list("is poured out of its can") and not is_scooped(want.leaf)

    def _taken(self, want: Want) -> Stuff:
        """Return a food as the kitchen has it; of one that comes apart the part that is meant, in a bowl of its own."""
        whole = want.of
        if whole is None:
            return self.bench.fetch(want.label, want.leaf, [want.number], want.storage, stands=want.stands)
        if want.label not in self._parts:
            attested = self.opening(whole)
            if attested is None:
                raise RefusedError(f"nothing opens {whole.label}")
            stuff = self.bench.fetch(whole.label, whole.leaf, [whole.number], whole.storage, stands=whole.stands)
            self._parts |= self.bench.part(stuff, parts_in(whole.label), (whole.asked,), attested, BOWL)
        stuff = self._parts.pop(want.label)
        stuff.wants = frozenset({want.number})
        return stuff

    def _divide(self, ready: Ready, cut: str, *, alone: bool) -> None:
        """Cut a food as it is asked or as it needs, now or once it is cooked."""
        want = ready.want
        if want.make in word_list("is cut off at the ends"):
            self.trim(ready, want.make)
            return
        if want.facts.is_any(word_list("has tough ends")) and form_of(self.known, want.label, want.leaf) == "whole":
            self.trim(ready, min(word_list("is trimmed")))
        if self.is_mashed_raw(want) and want.facts.is_any(word_list("is flesh")) and not alone:
            self._cut(ready, self.usual_cut(want))  # it falls into shreds only once it is cooked
        elif self.is_mashed_raw(want):
            ready.cut_later = cut
        elif cut:
            self._cut(ready, cut)

    def _due(self, want: Want) -> set[str]:
        """Return what hands have to do to a food: what it owes, and what the asked state needs."""
        if _is_taken_as_it_is(want):
            return set()
        # the table has "trimmed" take out a choke, which only artichokes have: anything else loses but its ends
        trimmed = want.make in word_list("is cut off at the ends")
        earns = self.known.state(want.make).earns & BY_HAND if want.make and not trimmed else frozenset()
        asked = earns & want.facts.owes.keys()
        if not asked and working(want.make, want.facts) is None:
            asked = earns  # hulled: cored, or out of a husk
        return owed(want, self.known) | (asked - earned(want, self.known))

    def is_mashed_raw(self, want: Want) -> bool:
        """Return whether ``want`` is asked in a form for which it is still too hard (mashed): it is cooked before."""
        if want.make in word_list("only what is cooked is so") and want.facts.is_any(word_list("is flesh")):
            return {"cook"} <= want.facts.owes.keys()
        if want.make in word_list("only what is soft is so") and want.facts.is_any(word_list("is hard")):
            return True
        ways = self.operators.giving.get(want.make, ()) if want.make else ()
        mashed = self.known.state(want.make).fineness >= POWDER and any(
            "mash" in self.known.motion(way[0]).does for way in ways
        )
        return mashed and bool({"cook", "boil"} & want.facts.owes.keys())

    def cut_once_done(self, ready: Ready) -> None:
        """Have a food that is ``ready`` cut when it is cooked, unless it is in pieces or is cut anyway."""
        states = (*ready.stuff.states, ready.want.make) if ready.want.make else ready.stuff.states
        whole = not any(self.known.state(state).fineness > 0 for state in states)
        whole = whole and not ready.want.facts.is_any(word_list("is in bits"))
        if whole and not ready.cut_later and not self._is_no_work_for_a_knife(ready.want):
            ready.cut_later = self.usual_cut(ready.want)

    def cut_to_bites(self, ready: Ready, *, hot: bool = False) -> None:
        """Cut a food that is ``ready`` again if half of one is too large to be eaten with a spoon or fork.

        ``hot``: it is cooked then; halves that are asked and get soft stay as they are.
        """
        if self._is_soft_in_halves(ready.want, hot=hot):
            return
        rows = [self.known.state(state) for state in ready.stuff.states]
        halves = max((row.fineness for row in rows), default=0) == HALVED
        halves = halves and not says(words(ready.want.label), "is a small one")
        if halves and ready.want.facts.is_any(word_list("is more than a bite in halves")):
            self._cut(ready, self.usual_cut(ready.want))

    def _is_soft_in_halves(self, want: Want, *, hot: bool) -> bool:
        """Whether halves are asked that whoever eats them divides with a spoon, since they are cooked."""
        asked = bool(want.make) and self.known.state(want.make).fineness == HALVED
        return hot and asked and want.facts.is_any(word_list("is soft in halves when it is cooked"))

    def cut_now(self, ready: Ready) -> None:
        """Cut or mash what is ``ready`` and had to be cooked before."""
        state, ready.cut_later = ready.cut_later, ""
        if state in word_list("is pulled apart by hand"):
            self.clear(ready)
        if state:
            self._cut(ready, state, done=True)

    def shelled(self, ready: Ready, form: Sequence[str] = ()) -> None:
        """Take the shell off a food that is ``ready`` and was cooked in it.

        Cut it as it is asked, or as ``form`` says.
        """
        ways = [way for way in self.operators.ways.get("shell", ()) if "peel" in self.known.motion(way[0]).does]
        ways = self.with_a_fit_tool("shell", ways, ready.want)
        attested = self.bench.require(ways, ready.want.names, act=True)
        kept = {s for s in ready.stuff.states if not self.known.state(s).undivided} - {"washed"}
        self.bench.act(ready.stuff, attested, tuple(sorted({*kept, self.gives(attested.way, ("peel",))})))
        self.bring_about(ready, ready.want.make, done=True)
        cut = self._cut_state(ready.want, form, owed(ready.want, self.known), divided=True)
        if cut:
            self._cut(ready, cut)

    def _cut_state(self, want: Want, form: Sequence[str], due: set[str], *, divided: bool, alone: bool = True) -> str:
        """Return the state into which a food is to be cut, ``""`` for none; see :meth:`prepare` for the arguments."""
        if self.is_asked_cut(want):
            return want.make
        if not divided or not self._can_be_cut(want):
            return ""
        needs = "cut" in due or _is_served_cut(want)
        if (needs or "cut" in want.facts.owes) and _is_cut_first(want, alone=alone):
            shape = self._shape_elsewhere(want, form)
            if shape:
                return shape
        return self.usual_cut(want) if needs else ""

    def _can_be_cut(self, want: Want) -> bool:
        """Whether a food comes whole, is more than a mouthful, and is something that a knife cuts."""
        if self._is_no_work_for_a_knife(want) or is_left_whole(want):
            return False
        if want.facts.is_a("stock", *word_list("is a mouthful")):
            return False
        if form_of(self.known, want.label, want.leaf) not in {"whole", "pieces"}:
            return False
        rows = [self.known.state(state) for state in want.leaf if not self._is_still_whole(want, state)]
        return not any(row.fineness > 0 or "cut" in row.earns for row in rows)

    def _shape_elsewhere(self, want: Want, form: Sequence[str]) -> str:
        """Return the first cut of ``form``, the states in which such a food joins elsewhere, that is one for it."""
        never = want.facts.is_any(word_list("is never so unasked"))
        if never and says(form, "is a shape that is asked"):
            return ""
        some = word_list("is a shape of some foods")
        fits = (state for state in form if state not in some or self.comes_so(want, state))
        return next((state for state in fits if self.known.state(state).fineness > 0), "")

    def _is_no_work_for_a_knife(self, want: Want) -> bool:
        """Whether a food is flesh that no knife cuts small, as its name says."""
        told = {*words(want.label), *words(want.facts.taken_for)}
        hard = says(told, "is no work for a knife")
        return hard and want.facts.is_any(word_list("is flesh"))

    def _is_still_whole(self, want: Want, state: str) -> bool:
        """Whether a food that is sold so is still to be cut, though the word is one of a part: a clove, a steak."""
        is_a = want.facts.is_a
        plucked = is_a(*word_list("is cut off its stem")) and not is_a(*word_list("is served in leaves"))
        plucked = plucked or is_a(*word_list("is too large in leaves"))
        plucked = plucked and state in word_list("is plucked off its stem")
        flesh = state in word_list("is still in one piece") and is_a(*word_list("is flesh"))
        small = state in word_list("is called small") and is_a(*word_list("is firm"))
        small = small or _is_cut_though_dried(want)
        return flesh or plucked or small or state in word_list("is a piece to be cut")

    def _comes_in_pieces(self, want: Want, cut: str) -> bool:
        """Whether a food is taken in pieces since nobody brings such a one into them: then it is not peeled before."""
        known = working(cut, want.facts) is not None or self.is_mashed_raw(want)
        return bool(cut) and not known and self.way_to_cut(want, cut) is None

    def _is_finer(self, ready: Ready, state: str) -> bool:
        """Whether a food is a powder already, of which nobody makes pieces."""
        powder = any(self.known.state(one).fineness >= POWDER for one in ready.stuff.states)
        return powder and self.known.state(state).fineness < POWDER

    def _cut(self, ready: Ready, state: str, *, done: bool = False) -> None:
        """Bring a food into pieces of that state, unless it is a powder; where nobody does so, assume it.

        ``done``: it was cooked before.
        """
        want = ready.want
        if self._is_finer(ready, state) or self.bring_about(ready, state, done=done):
            return
        attested = self.way_to_cut(want, state)
        if attested is None:
            self.assume(ready, state)
            return
        attested = self.with_tool(attested)
        board = self.board(attested.way)
        if board and ready.stuff.at is not None and not ready.stuff.at.storage and ready.stuff.at.label != board:
            loose = ready.want.facts.is_any(word_list("lies loose"))
            ways = ("pour", "pick-and-place") if loose else ("pick-and-place", "pour")
            carried = self.bench.require([(way, ()) for way in ways], want.names)
            self.bench.bring([ready.stuff], self.bench.vessel(board), carried)  # nothing is cut in a strainer
        self.bench.act(ready.stuff, attested, (state,), board)


def _is_taken_as_it_is(want: Want) -> bool:
    """Whether hands do nothing to a food but what is asked: it is pressed, stays whole, or gives its zest."""
    off = want.make in word_list("is off the outside") or want.facts.is_any(word_list("is grated off the whole"))
    return want.squeezed or want.at_hand or want.left_whole or off


def _is_packed_dry(want: Want) -> bool:
    """Whether a food is asked as it was packed to be kept, by its state or its name."""
    told = says((want.asked, *words(want.label)), "is packed dry")
    return told and want.facts.kind in word_list("is rinsed of what it was packed in")


def _is_worked_whole(want: Want) -> bool:
    """Whether a food is asked as hands make it that leave it in one piece: bruised."""
    how = working(want.make, want.facts)
    return how is not None and how.whole


def _is_served_cut(want: Want) -> bool:
    """Whether nobody serves a food in one piece, though it could be eaten so."""
    if _is_cut_though_dried(want) or want.facts.is_any(word_list("is too large in leaves")):
        return "cut" in want.facts.owes
    raw = want.facts.is_a("raw") and not want.facts.is_any(word_list("is served in leaves"))
    return raw and "cut" in want.facts.owes


def _is_cut_first(want: Want, *, alone: bool) -> bool:
    """Whether a food is not only cut when it is cooked ``alone``; what is toasted is split before."""
    if alone and want.facts.is_any(word_list("is cut once it is fried alone")):
        return False
    return not (want.cooked and alone) or want.facts.is_any(word_list("is split"))


def _is_soaked_first(want: Want) -> bool:
    """Whether a food was dried so hard that a cook lets it soak before anything else is done with it."""
    is_any = want.facts.is_any
    if want.asked in word_list("is so when it has soaked"):
        return is_any(word_list("is soaked where it is asked"))
    return is_any(word_list("is soaked first")) and not is_any(word_list("is done without soaking"))


def _is_torn_to_soak(want: Want) -> bool:
    """Whether a food is asked soaked that comes in a piece too large to lie in water: a loaf."""
    soaked = want.asked in word_list("is so when it has soaked")
    return soaked and want.facts.kind in word_list("is torn to be soaked")


def _is_cut_though_dried(want: Want) -> bool:
    """Whether a food was dried in pieces that are too large for a mouth."""
    return want.facts.is_any(word_list("is cut though it is dried")) and "cut" in want.facts.owes
