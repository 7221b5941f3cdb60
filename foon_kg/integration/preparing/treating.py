"""What hands do to one food beside cutting it: they peel, stone and shell it, rinse, drain and squeeze it.

How each is done is taken from the operators of the FOON. What no operator does is assumed to have been done, and that
is said.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Level, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.workings import Working, working
from foon_kg.integration.bench import RefusedError, Stuff, Vessel, is_flat
from foon_kg.integration.preparing.cutting import BOWL, STANDS_FOR, Cutter
from foon_kg.integration.preparing.preparation import (
    BRINGS,
    CUTS,
    FROM_A_CAN,
    IN_ORDER,
    JUICE,
    NOT_BY_HAND,
    RINSED,
    Ready,
    Want,
    package_of,
)
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.operators import Attested, Way
from foon_kg.world.treatment import ADVISED

_HALVED = "halved"

_DONE_WITH = {"stone": "core", "peel": "husk"}
"""What is done by another treatment, where that is due: who cores an apple, takes its pips out."""


class Treater(Cutter):
    """Treats foods on a bench."""

    def clean(self, ready: Ready, due: set[str], cut: str) -> None:
        """Take off and out of a food that gets ``ready`` what is ``due``, in the order of hands, and wash it at last.

        What has earth between its leaves is washed when it is ``cut``.
        """
        order = list(IN_ORDER)
        if ready.want.facts.is_any(word_list("is stoned before it is peeled")):
            order.sort(key=lambda name: name == "peel")
        for name in order:
            if name in due and _DONE_WITH.get(name) not in due:
                self._treat(ready, name)
        if "wash" in due and not (cut and _is_earthy(ready.want)):
            self.rinse(ready, "washed")

    def clean_inside(self, ready: Ready, due: set[str]) -> None:
        """Wash in a strainer a food that gets ``ready`` and was cut with earth between its leaves, if it is ``due``."""
        stuff, bench = ready.stuff, self.bench
        if "wash" not in due or "washed" in stuff.states or not _is_earthy(ready.want):
            return
        if stuff.at is not None and not stuff.at.storage:
            ways: list[Way] = [("pour", ()), ("pick-and-place", ())]
            bench.bring([stuff], bench.vessel("strainer"), bench.require(ways, ready.want.names))
        self.rinse(ready, "washed")

    def _treat(self, ready: Ready, name: str) -> None:
        """Peel, core or stone the food, as ``name`` says; where nobody does so to such a food, assume it.

        What is only better done (minor), and was not asked, is left undone then without a word.
        """
        want, stuff = ready.want, ready.stuff
        does = (name, *STANDS_FOR.get(name, ()))
        attested = self.way_to_treat(want, name)
        if attested is None:
            if want.facts.owes.get(name) is Level.FATAL or self._is_asked(want, name):
                self.assume(ready, self._state_for(name, want))
            return
        state = self._state_when_treated(want, attested.way, does)
        board = self.board(attested.way)
        if not board and stuff.at is not None and stuff.at.storage:
            board = BOWL  # what is peeled does not stay in its packet
        self.bench.act(stuff, attested, tuple(sorted({*self._kept(stuff, name), state})), board)

    def _state_when_treated(self, want: Want, way: Way, does: Sequence[str]) -> str:
        """Return the asked state where ``way`` gives that and it is no cut, else what such a treatment gives."""
        asked = want.make in self.known.motion(way[0]).gives and not self.is_asked_cut(want)
        return want.make if asked else self.gives(way, does)

    def _kept(self, stuff: Stuff, name: str) -> list[str]:
        """Return the states that a food keeps when it is treated; what was taken for whole with its peel still is."""
        kept = [s for s in stuff.states if not self.known.state(s).undivided and s != "unpeeled"]
        whole = name in {"peel", "shell"} and any(self.known.state(s).undivided for s in stuff.states)
        return [*kept, "whole"] if whole else kept

    def _is_asked(self, want: Want, name: str) -> bool:
        """Whether the asked state says that a treatment was done."""
        return bool(want.make) and name in self.known.state(want.make).earns

    def gives(self, way: Way, does: Sequence[str]) -> str:
        """Return the state that ``way``, a treatment, gives: the one that the FOON tells most often, else the table's.

        ``does`` is what it does, as the table of motions has it.
        """
        fit = [s for s, ways in self.operators.giving.items() if way in ways and self.known.state(s).earns & {*does}]
        fit.sort(key=lambda s: (-self.operators.giving[s][way], s))
        able = sorted(s for s in self.known.motion(way[0]).gives if self.known.state(s).earns & {*does})
        return (fit or able or [does[0]])[0]

    def _state_for(self, name: str, want: Want) -> str:
        if self._is_asked(want, name):
            return want.make
        found = [s for s, row in self.known.states.items() if row.earns == {name}]
        return min(found, key=lambda state: (state.count(" "), state), default=name)

    def bring_about(self, ready: Ready, state: str, *, done: bool = False) -> bool:
        """Bring a food that gets ``ready`` into ``state``; return whether the table of workings says how.

        ``done``: it was cooked before.
        """
        want, stuff, bench = ready.want, ready.stuff, self.bench
        how = working(state, want.facts, done=done)
        if how is None or state in stuff.states:
            return how is not None
        attested = bench.near_or_far(self._ways_like(how), want.names, act=True)
        if attested is None:
            return False
        if self._is_poured_to(how, stuff):
            bench.bring([stuff], bench.vessel(how.on), bench.require([("pour", ()), ("scoop", ())], want.names))
        was = self.known.state(state).before
        kept = (one for one in stuff.states if one not in was and (how.whole or not self.known.state(one).undivided))
        bench.declare(how.motion, attested, stuff.label)
        act = replace(attested, way=(how.motion, (how.tool,) if how.tool else ()))
        bench.act(stuff, act, tuple(sorted({*kept, state})), how.on)
        return True

    def clear(self, ready: Ready) -> None:
        """Take what nobody eats out of flesh that is ``ready`` and was cooked, where its name or state tells of it."""
        told = (*words(ready.want.label), *words(ready.want.asked), ready.want.asked)
        if says(told, "says that it is still to be cleared") and not says(told, "says that it was cleared"):
            self.bring_about(ready, min(word_list("is so when it is cleared")), done=True)

    def _is_poured_to(self, how: Working, stuff: Stuff) -> bool:
        """Whether a food comes by itself into the vessel in which it is worked: hands take what is in pieces."""
        if stuff.at is None or how.on in {"", stuff.at.label}:
            return False
        loose = form_of(self.known, stuff.label, stuff.states) not in {"whole", "pieces"}
        return loose if stuff.at.storage else not is_flat(how.on)

    def _ways_like(self, how: Working) -> list[Way]:
        """Return the ways of the videos that stand for such a working, those with its tool before others."""
        ways = [way for motion in how.like for way in self.operators.ways_of(motion)]
        tools = (how.tool,) if how.tool else ()
        return [way for way in ways if way[1] == tools] or ways

    def trim(self, ready: Ready, state: str) -> None:
        """Cut off the ends of a food that gets ``ready``, which makes it ``state``.

        Where nothing shows how, and it is asked so, it is assumed to have been done.
        """
        ways = [way for motion in sorted(word_list("cuts off the ends")) for way in self.operators.ways_of(motion)]
        ways = [way for way in ways if not says(way[1], "is no knife")] or ways
        attested = self.bench.near_or_far(self.with_a_knife(ways, ready.want), ready.want.names, act=True)
        if attested is None:
            if ready.want.make == state:
                self.assume(ready, state)
            return
        attested = self.with_tool(attested)
        self.bench.act(ready.stuff, attested, (state,), self.board(attested.way))

    def advise(self, ready: Ready) -> None:
        """Do to a food that gets ``ready`` what is only advised and yet asked (rinsed).

        What nothing shows is assumed to have been done (soaked).
        """
        asked = ready.want.make
        earns = self.known.state(asked).earns if asked else frozenset()
        if not earns or not earns <= ADVISED or asked in ready.stuff.states:
            return
        if asked in word_list("is so when it has soaked"):
            self.soak(ready)
        done = asked in ready.stuff.states or (earns == RINSED and self.rinse(ready, asked))
        if not done and not self.worked_so(ready, asked):
            self.assume(ready, asked)

    def soak(self, ready: Ready) -> None:
        """Let a food that is ``ready`` but dried hard lie in water, and pour that off, where the FOON shows how."""
        stuff, bench, foods = ready.stuff, self.bench, ready.want.names
        soaks = bench.near_or_far(bench.ways_by(word_list("soaks")), foods)
        if soaks is None or not set(stuff.states) & word_list("is soaked while it is so"):
            return
        bowl, pours = bench.vessel(BOWL), bench.require([("pour", ())], foods)
        bench.bring([stuff], bowl, pours)
        bench.bring([bench.fetch("water", ("liquid",), (), "faucet")], bowl, pours)
        states = tuple(sorted({*stuff.states, *word_list("is so when it has soaked")}))

        def swell() -> None:
            stuff.states = states

        bench.emit(soaks, [bowl, *bowl.contents], swell, [bowl, stuff])
        self._pour_off(stuff, bowl)

    def _pour_off(self, stuff: Stuff, bowl: Vessel) -> None:
        """Pour a bowl into a strainer, in which a food stays."""
        strainer = self.bench.vessel("strainer")
        drains = self.bench.require([("drain", ()), ("pour", ())], stuff.foods)

        def change() -> None:
            bowl.contents.clear()
            strainer.contents.append(stuff)
            stuff.at = strainer

        self.bench.emit(drains, [bowl, stuff, strainer], change, [strainer, stuff, bowl])

    def worked_so(self, ready: Ready, state: str) -> bool:
        """Bring a food that gets ``ready`` into a state as the FOON shows it of such a food, without heat.

        Return whether it does.
        """
        attested = self._way_so(ready.want, state)
        if attested is None:
            return False
        states = tuple(sorted({*ready.stuff.states, state}))
        if any("strain" in able for able in self.known.motion(attested.way[0]).tools):
            self._pass_through(ready, attested, states)
        else:
            self.bench.act(ready.stuff, attested, states, BOWL)
        return True

    def _pass_through(self, ready: Ready, attested: Attested, states: tuple[str, ...]) -> None:
        """Pour a powder into a sieve and through that into a bowl, where it has ``states``."""
        pours = self.bench.require([("pour", ())], ready.want.names)
        self.bench.bring([ready.stuff], self.bench.vessel("strainer"), pours)
        self.bench.bring([ready.stuff], self.bench.vessel(BOWL), attested, states)

    def _way_so(self, want: Want, state: str) -> Attested | None:
        """Return how hands bring a food into a state otherwise than by cutting it (sifted); ``None`` where none do."""
        does = {way: self.known.motion(way[0]).does for way in self.operators.making(state)}
        ways = [way for way, done in does.items() if not (done & (NOT_BY_HAND | CUTS) or done <= BRINGS)]
        return self.bench.attest(ways, want.names, act=True)

    def rinse(self, ready: Ready, state: str) -> bool:
        """Rinse a food that gets ``ready`` where it lies, or in a strainer, which makes it ``state``.

        Return whether the FOON shows how.
        """
        bench, stuff, foods = self.bench, ready.stuff, ready.want.names
        ways: list[Way] = [("rinse", ()), ("wash", ())]
        attested = bench.near_or_far(ways, foods)
        if attested is None:
            return False
        if stuff.at is None or stuff.at.storage:
            loose = ready.want.facts.is_any(word_list("lies loose"))
            brought: list[Way] = [("pour", ())] if loose else [("pick-and-place", ()), ("pour", ())]
            bench.bring([stuff], bench.vessel("strainer"), bench.require(brought, foods))
        places = [stuff.at] if stuff.at is not None else []
        states = tuple(sorted({*stuff.states, state}))

        def change() -> None:
            stuff.states = states

        water = bench.fetch("water", ("liquid",), (), "faucet")
        bench.emit(attested, [*places, stuff, bench.tap("faucet"), water], change, [stuff])
        return True

    def drain(self, ready: Ready) -> None:
        """Pour what gets ``ready`` and is sold in liquid into a strainer, which makes it drained if it is asked so."""
        asked = ready.want.asked
        drained = asked and self.known.state(asked).earns == FROM_A_CAN
        states = (*ready.stuff.states, asked) if drained else None
        ways: list[Way] = [("drain", ()), ("pour", ())] if drained else [("pour", ()), ("drain", ())]
        foods = ready.want.names
        # the first way if such a food is ever brought so, be the other nearer: drained, it is in the asked state
        attested = self.bench.attest(ways[:1], foods) or self.bench.near_or_far(ways, foods)
        if attested is not None:
            self.bench.bring([ready.stuff], self.bench.vessel("strainer"), attested, states)

    def squeeze(self, ready: Ready) -> None:
        """Halve the food that gets ``ready`` and press its juice into a bowl."""
        stuff, bench = ready.stuff, self.bench
        halving = self.way_to_cut(ready.want, _HALVED)
        if halving is None:
            raise RefusedError(f"nothing halves {ready.want.label}")
        bench.act(stuff, self.with_tool(halving), (_HALVED,), "cutting board")
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

    def opening(self, want: Want) -> Attested | None:
        """Return the way to open the shell of ``want`` over a vessel, if there is one."""
        ways = [way for way in self.operators.ways.get("shell", ()) if "open" in self.known.motion(way[0]).does]
        ways = [way for way in ways if self.operators.onto.get(way) and not way[1]]
        # what was boiled in its shell is peeled, and runs no more
        opens = "shell" in want.facts.owes and not want.facts.is_any(word_list("is peeled and not cracked"))
        return self.bench.attest(ways, want.names, act=True) if opens else None

    def assume(self, ready: Ready, state: str) -> None:
        """Take a food that gets ``ready`` in a state into which nobody brings it here, and say so.

        What was worked on here already stays as it is.
        """
        stuff = ready.stuff
        why = f"no step of this FOON makes {ready.want.label} {state}, nor a like food or one of its kind"
        if stuff.at is not None and not stuff.at.storage:
            ready.assumptions.append(f"{why}: it stays as it is")
            return
        was = self.known.state(state).before
        kept = (s for s in stuff.states if not self.known.state(s).undivided and s not in was)
        stuff.states = tuple(sorted({*kept, state}))
        package = package_of((state,)) if stuff.at is None else ""
        if package:  # nobody buys a powder loose
            stuff.at = self.bench.vessel(package, storage=True)
            stuff.at.contents.append(stuff)
        ready.assumptions.append(why)


def _is_earthy(want: Want) -> bool:
    """Whether there is earth between the leaves of a food, so that it is washed when it is cut."""
    return want.facts.is_any(word_list("is washed when it is cut"))
