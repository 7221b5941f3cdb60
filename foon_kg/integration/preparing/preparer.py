"""What is done to one food before it joins: it is opened, peeled, cut, squeezed, rinsed.

A cook's duties to a food (peel it, stone it, shell it) are data (:mod:`foon_kg.food`); how they are done is taken from
the operators of the FOON. What no operator does is assumed to have been done, and that is said.
"""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Level, words
from foon_kg.food.lists import word_list
from foon_kg.food.parted import parts_in
from foon_kg.integration.bench import Bench, RefusedError, Stuff
from foon_kg.integration.preparing.cutting import BOWL, STANDS_FOR, Cutter
from foon_kg.integration.preparing.preparation import (
    BRINGS,
    BY_HAND,
    CUTS,
    FROM_A_CAN,
    IN_ORDER,
    JUICE,
    NOT_BY_HAND,
    POWDER,
    RINSED,
    Ready,
    Want,
    owed,
)
from foon_kg.integration.teaching.operators import Attested, Way, form_of
from foon_kg.world.treatment import ADVISED

_DONE_WITH = {"stone": "core", "peel": "husk"}
"""What is done by another treatment, where that is due."""

_HALVED = 1
"""How fine a food in halves is (:class:`~foon_kg.food.rows.State`)."""


class Preparer(Cutter):
    """Prepares foods on a bench."""

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._parts: dict[str, Stuff] = {}

    def prepare(self, want: Want, form: Sequence[str] = (), *, divided: bool = True, alone: bool = True) -> Ready:
        """Return the food as it can join: opened, peeled and cut as it is asked, as ``form`` says and as it needs.

        ``form`` are states in which such a food joins elsewhere. ``divided``: it has to be in pieces (not where it is
        blended); ``alone``: it is cooked by itself before it joins. A food in a shell that is to be opened over a
        vessel comes as it is (``whole_shell``).
        """
        due = self._due(want)
        later = want.then and want.then not in word_list("only what is soft is so")  # it stays whole until it is done
        cut = "" if later else self._cut_state(want, form, due, divided=divided, alone=alone)
        pieces = self._comes_in_pieces(want, cut)
        worked = pieces and self._way_so(want, cut) is not None
        pieces = pieces and not worked
        ready = Ready(want, self._taken(want))
        if want.bought_so:
            ready.assumptions.append(f"no step of this FOON makes {want.label} {', '.join(want.leaf)}: it is bought so")
        if want.foamed or want.of is not None:
            return ready
        if "shell" in due and self.opening(want) is not None:
            ready.whole_shell = True
            return ready
        if pieces:
            self._assume(ready, cut)
            self._advise(ready)
            return ready
        if worked and self._worked_so(ready, cut):
            return ready
        self._clean(ready, due)
        if "wash" in due:
            self.rinse(ready, "washed")
        juicy = JUICE in form and not want.make and form_of(self.known, want.label, want.leaf) == "whole"
        if (want.squeezed or juicy) and self.operators.giving.get(JUICE):
            self._squeeze(ready)
            return ready
        if want.storage in word_list("is poured out of its can") and "drain" in {
            *want.facts.owes,
            *self.known.state(want.asked).earns,
        }:
            self._drain(ready)
        self._advise(ready)
        self._divide(ready, cut, alone=alone)
        ready.cut_later = want.then or ready.cut_later
        return ready

    def _taken(self, want: Want) -> Stuff:
        """Return a food as the kitchen has it; of one that comes apart the part that is meant, in a bowl of its own."""
        whole = want.of
        if whole is None:
            return self.bench.fetch(want.label, want.leaf, [want.number], want.storage)
        if want.label not in self._parts:
            attested = self.opening(whole)
            if attested is None:
                raise RefusedError(f"nothing opens {whole.label}")
            stuff = self.bench.fetch(whole.label, whole.leaf, [whole.number], whole.storage)
            self._parts |= self.bench.part(stuff, parts_in(whole.label), (whole.asked,), attested, BOWL)
        stuff = self._parts.pop(want.label)
        stuff.wants = frozenset({want.number})
        return stuff

    def _divide(self, ready: Ready, cut: str, *, alone: bool) -> None:
        """Cut a food as it is asked or as it needs, now or once it is cooked."""
        want = ready.want
        if want.make in word_list("is cut off at the ends"):
            self._trim(ready, want.make)
            return
        if want.facts.is_a(*word_list("has tough ends")) and form_of(self.known, want.label, want.leaf) == "whole":
            self._trim(ready, min(word_list("is trimmed")))
        if self.is_mashed_raw(want) and want.facts.is_a(*word_list("is flesh")) and not alone:
            self._cut(ready, self.usual_cut(want))  # it falls into shreds only once it is cooked
        elif self.is_mashed_raw(want):
            ready.cut_later = cut
        elif cut:
            self._cut(ready, cut)

    def _trim(self, ready: Ready, state: str) -> None:
        """Cut off the ends of a food, which makes it ``state``, or assume that it was done where it is asked so."""
        ways = [way for motion in sorted(word_list("cuts off the ends")) for way in self.operators.ways_of(motion)]
        attested = self.bench.attest(ways, ready.want.names, act=True) or self.bench.far(
            ways, ready.want.names, act=True
        )
        if attested is None:
            if ready.want.make == state:
                self._assume(ready, state)
            return
        attested = self.with_tool(attested)
        self.bench.act(ready.stuff, attested, (state,), self.board(attested.way))

    def _due(self, want: Want) -> set[str]:
        """Return what hands have to do to a food: what it owes, and what the asked state needs."""
        if want.squeezed or want.at_hand or want.facts.is_a(*word_list("is grated off the whole")):
            return set()
        trimmed = want.make in word_list("is cut off at the ends")
        earns = self.known.state(want.make).earns if want.make and not trimmed else frozenset()
        return owed(want, self.known) | (earns & BY_HAND)

    def is_mashed_raw(self, want: Want) -> bool:
        """Whether a food is asked in a form for which it is still too hard (mashed, shredded): it is cooked before."""
        if want.make in word_list("only what is cooked is so") and want.facts.is_a(*word_list("is flesh")):
            return {"cook"} <= want.facts.owes.keys()
        if want.make in word_list("only what is soft is so") and want.facts.is_a(*word_list("is hard")):
            return True
        ways = self.operators.giving.get(want.make, ()) if want.make else ()
        mashed = (self.known.state(want.make).fine or 0) >= POWDER and any(
            "mash" in self.known.motion(way[0]).does for way in ways
        )
        return mashed and bool({"cook", "boil"} & want.facts.owes.keys())

    def cut_once_done(self, ready: Ready) -> None:
        """Have a food cut when it is cooked, unless it is in pieces or is cut anyway."""
        states = (*ready.stuff.states, ready.want.make) if ready.want.make else ready.stuff.states
        whole = not any((self.known.state(state).fine or 0) > 0 for state in states)
        if whole and not ready.cut_later and not self._is_no_work_for_a_knife(ready.want):
            ready.cut_later = self.usual_cut(ready.want)

    def cut_to_bites(self, ready: Ready) -> None:
        """Cut a food again of which half of one is too large to be eaten with a spoon or fork."""
        rows = [self.known.state(state) for state in ready.stuff.states]
        halves = any((row.fine or 0) == _HALVED for row in rows) and not any((row.fine or 0) > _HALVED for row in rows)
        if halves and ready.want.facts.is_a(*word_list("is more than a bite in halves")):
            self._cut(ready, self.usual_cut(ready.want))

    def cut_now(self, ready: Ready) -> None:
        """Cut or mash what had to be cooked before."""
        state, ready.cut_later = ready.cut_later, ""
        if state:
            self._cut(ready, state)

    def _advise(self, ready: Ready) -> None:
        """Do what is only advised and yet asked (rinsed), or assume that it was done (soaked)."""
        asked = ready.want.make
        earns = self.known.state(asked).earns if asked else frozenset()
        if not earns or not earns <= ADVISED or asked in ready.stuff.states:
            return
        if (earns == RINSED and self.rinse(ready, asked)) or self._worked_so(ready, asked):
            return
        self._assume(ready, asked)

    def _worked_so(self, ready: Ready, state: str) -> bool:
        """Bring a food into a state as the FOON shows it of such a food, without heat; return whether it does."""
        attested = self._way_so(ready.want, state)
        if attested is not None:
            self.bench.act(ready.stuff, attested, tuple(sorted({*ready.stuff.states, state})), BOWL)
        return attested is not None

    def _way_so(self, want: Want, state: str) -> Attested | None:
        """Return how hands bring a food into a state otherwise than by cutting it (sifted); ``None`` where none do."""
        does = {way: self.known.motion(way[0]).does for way in self.operators.making(state)}
        ways = [way for way, done in does.items() if not (done & (NOT_BY_HAND | CUTS) or done <= BRINGS)]
        return self.bench.attest(ways, want.names, act=True)

    def rinse(self, ready: Ready, state: str) -> bool:
        """Rinse a food where it lies, or in a strainer, which makes it ``state``; return whether the FOON shows how."""
        bench, stuff, foods = self.bench, ready.stuff, ready.want.names
        ways: list[Way] = [("rinse", ()), ("wash", ())]
        attested = bench.attest(ways, foods) or bench.far(ways, foods)
        if attested is None:
            return False
        if stuff.at is None or stuff.at.storage:
            bench.bring([stuff], bench.vessel("strainer"), bench.require([("pick-and-place", ()), ("pour", ())], foods))
        places = [stuff.at] if stuff.at is not None else []
        states = tuple(sorted({*stuff.states, state}))

        def change() -> None:
            stuff.states = states

        bench.emit(attested, [*places, stuff, bench.fetch("water", ("liquid",), (), "faucet")], change, [stuff])
        return True

    def _drain(self, ready: Ready) -> None:
        """Pour what is sold in liquid into a strainer, which makes it drained where it is asked so."""
        asked = ready.want.asked
        drained = asked and self.known.state(asked).earns == FROM_A_CAN
        states = (*ready.stuff.states, asked) if drained else None
        ways: list[Way] = [("drain", ()), ("pour", ())] if drained else [("pour", ()), ("drain", ())]
        foods = ready.want.names
        attested = self.bench.attest(ways[:1], foods) or self.bench.attest(ways, foods) or self.bench.far(ways, foods)
        if attested is not None:
            self.bench.bring([ready.stuff], self.bench.vessel("strainer"), attested, states)

    def _squeeze(self, ready: Ready) -> None:
        """Halve the food and press its juice into a bowl."""
        stuff, bench = ready.stuff, self.bench
        halves = [way for way in self.operators.making("halved") if self.is_cut(way)]
        bench.act(
            stuff, self.with_tool(bench.require(halves, ready.want.names, act=True)), ("halved",), "cutting board"
        )
        ways = [
            way
            for way in self.operators.giving.get(JUICE, ())
            if "separate" in self.known.motion(way[0]).does and way[1]
        ]
        attested = bench.require(ways, ready.want.names)
        board, bowl = stuff.at, bench.vessel("bowl")

        def change() -> None:
            if board is not None:
                board.contents.remove(stuff)
            bowl.contents.append(stuff)
            stuff.at, stuff.states = bowl, (JUICE,)

        bench.emit(attested, [stuff, *([board] if board is not None else []), bowl], change, [stuff, bowl])
        ready.read_as = JUICE

    def opening(self, want: Want) -> Attested | None:
        """Return the way to open the food's shell over a vessel, if there is one."""
        ways = [way for way in self.operators.ways.get("shell", ()) if "open" in self.known.motion(way[0]).does]
        ways = [way for way in ways if self.operators.onto.get(way) and not way[1]]
        opens = "shell" in want.facts.owes and not want.facts.is_a(*word_list("is peeled and not cracked"))
        return self.bench.attest(ways, want.names, act=True) if opens else None

    def shelled(self, ready: Ready, form: Sequence[str] = ()) -> None:
        """Take the shell off a food that was cooked in it, and cut it as it is asked."""
        ways = [way for way in self.operators.ways.get("shell", ()) if "peel" in self.known.motion(way[0]).does]
        ways = list(self.with_a_fit_tool("shell", ways, ready.want))
        attested = self.bench.require(ways, ready.want.names, act=True)
        kept = {s for s in ready.stuff.states if not self.known.state(s).undivided} - {"washed"}
        self.bench.act(ready.stuff, attested, tuple(sorted({*kept, self._gives(attested.way, ("peel",))})))
        cut = self._cut_state(ready.want, form, owed(ready.want, self.known), divided=True)
        if cut:
            self._cut(ready, cut)

    def _cut_state(self, want: Want, form: Sequence[str], due: set[str], *, divided: bool, alone: bool = True) -> str:
        asked = self.known.state(want.make) if want.make else None
        if asked is not None and (asked.fine or 0) > 0:
            return want.make
        hard = self._is_no_work_for_a_knife(want) or want.facts.is_a(*word_list("is a mouthful"))
        rows = [self.known.state(state) for state in want.leaf if not self._is_still_whole(want, state)]
        if hard or not divided or any((row.fine or 0) > 0 or "cut" in row.earns for row in rows):
            return ""
        if form_of(self.known, want.label, want.leaf) not in {"whole", "pieces"} or want.facts.is_a("stock"):
            return ""
        if (
            "cut" in want.facts.owes
            and want.facts.is_a("raw")
            and not want.facts.is_a(*word_list("is served in leaves"))
        ):
            due = due | {"cut"}  # nobody serves it in one piece, though it could be eaten so
        first = not (want.cooked and alone) or want.facts.is_a(*word_list("is split"))  # what is toasted is cut before
        for state in form if first else ():
            if state in word_list("is a shape of some foods") and not self.comes_so(want, state):
                continue
            if (self.known.state(state).fine or 0) > 0 and ("cut" in want.facts.owes or "cut" in due):
                return state
        if "cut" in due:
            return self.usual_cut(want)
        return ""

    def _is_no_work_for_a_knife(self, want: Want) -> bool:
        """Whether a food is flesh that no knife cuts small, as its name says."""
        hard = not word_list("is no work for a knife").isdisjoint(words(want.label))
        return hard and want.facts.is_a(*word_list("is flesh"))

    def _is_still_whole(self, want: Want, state: str) -> bool:
        """Whether a food that is sold so is still to be cut, though the word is one of a part: a clove, a steak."""
        is_a = want.facts.is_a
        plucked = is_a(*word_list("is cut off its stem")) and not is_a(*word_list("is served in leaves"))
        flesh = state in word_list("is still in one piece") and is_a(*word_list("is flesh"))
        plucked = plucked and state in word_list("is plucked off its stem")
        small = state in word_list("is called small") and is_a(*word_list("is firm"))
        return flesh or plucked or small or state in word_list("is a piece to be cut")

    def _treat(self, ready: Ready, name: str) -> None:
        """Peel, core or stone the food, or assume that it was bought so."""
        want = ready.want
        does = (name, *STANDS_FOR.get(name, ()))
        attested = self.way_to_treat(want, name)
        if attested is None:
            if want.facts.owes.get(name) is Level.FATAL or (want.make and name in self.known.state(want.make).earns):
                self._assume(ready, self._state_for(name, want))
            return
        able = self.known.motion(attested.way[0]).gives
        cut = bool(want.make) and (self.known.state(want.make).fine or 0) > 0
        state = want.make if want.make in able and not cut else self._gives(attested.way, does)
        if want.make and not self.known.state(want.make).fine and want.make != state:
            ready.read_as = state
        kept = tuple(s for s in ready.stuff.states if not self.known.state(s).undivided and s != "unpeeled")
        if any(self.known.state(s).undivided for s in ready.stuff.states):
            kept = (*kept, "whole") if name in {"peel", "shell"} else kept
        board = self.board(attested.way)
        if ready.stuff.at is not None and ready.stuff.at.storage:
            board = board or BOWL  # what is peeled does not stay in its packet
        self.bench.act(ready.stuff, attested, tuple(sorted({*kept, state})), board)

    def _gives(self, way: Way, does: Sequence[str]) -> str:
        """Return the state that a treatment gives: the one that the FOON tells most often, else the table's."""
        fit = [s for s, ways in self.operators.giving.items() if way in ways and self.known.state(s).earns & {*does}]
        fit.sort(key=lambda s: (-self.operators.giving[s][way], s))
        able = sorted(s for s in self.known.motion(way[0]).gives if self.known.state(s).earns & {*does})
        return (fit or able or [does[0]])[0]

    def _state_for(self, name: str, want: Want) -> str:
        if want.make and name in self.known.state(want.make).earns:
            return want.make
        found = [s for s, row in self.known.states.items() if row.earns == {name}]
        return min(found, key=lambda state: (state.count(" "), state), default=name)

    def _assume(self, ready: Ready, state: str) -> None:
        stuff = ready.stuff
        was = self.known.state(state).before
        kept = (s for s in stuff.states if not self.known.state(s).undivided and s not in was)
        stuff.states = tuple(sorted({*kept, state}))
        why = f"no step of this FOON makes {ready.want.label} {state}, nor a like food or one of its kind"
        ready.assumptions.append(why)

    def _clean(self, ready: Ready, due: set[str]) -> None:
        order = list(IN_ORDER)
        if ready.want.facts.is_a(*word_list("is stoned before it is peeled")):
            order.sort(key=lambda name: name == "peel")
        for name in order:
            if name in due and _DONE_WITH.get(name) not in due:
                self._treat(ready, name)

    def _comes_in_pieces(self, want: Want, cut: str) -> bool:
        """Whether a food is taken in pieces since nobody brings such a one into them: then it is not peeled before."""
        return bool(cut) and not self.is_mashed_raw(want) and self.way_to_cut(want, cut) is None

    def _is_finer(self, ready: Ready, state: str) -> bool:
        """Whether a food is a powder already, of which nobody makes pieces; it is read as that where it is asked."""
        powder = next((one for one in ready.stuff.states if (self.known.state(one).fine or 0) >= POWDER), "")
        finer = bool(powder) and (self.known.state(state).fine or 0) < POWDER
        if finer and state == ready.want.make:
            ready.read_as = powder
        return finer

    def _cut(self, ready: Ready, state: str) -> None:
        want = ready.want
        if self._is_finer(ready, state):
            return
        attested = self.way_to_cut(want, state)
        if attested is None:
            self._assume(ready, state)
            return
        attested = self.with_tool(attested)
        board = self.board(attested.way)
        if board and ready.stuff.at is not None and not ready.stuff.at.storage and ready.stuff.at.label != board:
            carried = self.bench.require([("pick-and-place", ()), ("pour", ())], want.names)
            self.bench.bring([ready.stuff], self.bench.vessel(board), carried)  # nothing is cut in a strainer
        try:
            self.bench.act(ready.stuff, attested, (state,), board)
        except RefusedError:
            self._assume(ready, state)
