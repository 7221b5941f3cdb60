"""How a food is brought into pieces or rid of a skin or core: which way of the FOON, with which tool, on what.

Ways are taken from the FOON's operators, of the food itself or of one that is like it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from foon_kg.food import Food, Tables, singular
from foon_kg.food.lists import says, word_list, word_lists
from foon_kg.food.rows import POWDER
from foon_kg.integration.bench import Bench
from foon_kg.integration.preparing.preparation import CUTS, NOT_BY_HAND, Want, is_mill, wants_a_mill
from foon_kg.integration.teaching.operators import Attested, Way

_SOFT = word_list("can be mashed")

LEAST_ALIKE = 0.2
"""From which confidence on a food is grated or mashed like another one: a trout is not, like a carrot.

A knife cuts anything, so that no likeness is asked for it."""

BOWL = "bowl"

_GRATE = "grate"
"""What a tool can do (:class:`~foon_kg.food.rows.Utensil`) that is a grater."""

_OPEN = "open"
"""What a tool can do that is a knife and no peeler: to open."""

STANDS_FOR = {"stone": ("core",), "choke": ("core",), "core": ("stone",), "shell": ("peel",), "husk": ("peel",)}
"""Which others also do for a treatment: annotators call one hollow of a fruit its core or its stone."""

_RARE = 0.3
"""A way that gives a state less than this often, beside the most usual one, was noted wrongly by somebody."""

_COOKED_FIRST = word_list("only what is cooked is so")
"""States that only cooked flesh can be in: pulled, shredded."""


@lru_cache(maxsize=1 << 12)
def _divides(known: Tables, motion: str) -> bool:
    """Whether a motion divides a food, and does it by hand."""
    does = known.motion(motion).does
    others = NOT_BY_HAND - {"mix"} if "mash" in does else NOT_BY_HAND
    return not does.isdisjoint(CUTS) and does.isdisjoint(others)


def _bare(ways: Iterable[Way]) -> list[Way]:
    """Return those of some ways that hands do without a tool."""
    return [way for way in ways if not way[1]]


def _without_tools(ways: Iterable[Way], which: str) -> list[Way]:
    """Return the ways that have none of the tools of the list ``which``."""
    return [way for way in ways if not says(way[1], which)]


def _with_tools(ways: Iterable[Way]) -> list[Way]:
    """Return those of some ways that are done with a tool."""
    return [way for way in ways if way[1]]


def _wants_a_knife(want: Want) -> bool:
    return want.facts.is_any(word_list("wants a knife")) and not want.facts.is_any(word_list("is broken by hand"))


def _by_bare_hands(ways: Iterable[Way]) -> list[Way]:
    """Return those of some ways in which fingers pull flesh apart."""
    return [way for way in _bare(ways) if way[0] in word_list("pulls flesh apart")]


def _is_taken_off_by_hand(name: str, want: Want) -> bool:
    return name == "husk" or (name == "shell" and want.facts.is_any(word_list("is shelled by hand")))


class Cutter:
    """Finds how foods are brought into pieces on a bench."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known = bench.known
        self.operators = bench.operators
        self._cuts: dict[tuple[str, Food, str], Attested | None] = {}

    def is_cut(self, way: Way) -> bool:
        """Return whether a way divides a food by hand."""
        return len(way[1]) <= 1 and _divides(self.known, way[0])

    def is_asked_cut(self, want: Want) -> bool:
        """Return whether ``want`` is asked in pieces that are still to be made."""
        return bool(want.make) and self.known.state(want.make).fineness > 0

    def way_to_cut(self, want: Want, state: str) -> Attested | None:
        """Return how ``want`` is brought into pieces of that state; ``None`` where nobody does so with a like food."""
        key = (want.label, want.facts, state)  # kept, as it is asked first whether there is a way, and then which
        if key not in self._cuts:
            self._cuts[key] = self._way_to_cut_so(want, state)
        return self._cuts[key]

    def _way_to_cut_so(self, want: Want, state: str) -> Attested | None:
        if state in word_list("is pulled apart by hand"):
            pulls = [way for motion in sorted(word_list("pulls flesh apart")) for way in self.operators.ways_of(motion)]
            return self.bench.near_or_far(_by_bare_hands(pulls), want.names, act=True)
        ways = self._ways_to_cut(want, state)
        grating = self._ways_to_grate(ways, want, state)
        like = self._nearest_cut(grating, want, state)
        if like is None and (state in word_list("is so by a grater") or want.facts.is_any(word_list("can be grated"))):
            like = self.bench.far(grating, want.names, act=True)
        return like or self._nearest_cut(ways, want, state)

    def _ways_to_cut(self, want: Want, state: str) -> list[Way]:
        """Return the ways of this FOON by which such a food can be brought into pieces of that state."""
        ways = self._ways_to_divide(state)
        torn = state in _COOKED_FIRST and want.facts.is_any(word_list("is flesh"))  # it is cooked by then
        ways = (_by_bare_hands(ways) if torn else []) or self.with_a_knife(ways, want, state)
        if wants_a_mill(state, want.facts, self.known):
            mills = [way for way in ways if is_mill(way, self.known)]
            return [way for way in mills if self.board(way) not in word_list("is no mill")] or mills
        return ways

    def _ways_to_divide(self, state: str) -> list[Way]:
        """Return the ways of dividing by hand that give a state, those that peel only where there are no others."""
        ways = [way for way in self.operators.making(state) if self.is_cut(way)]
        ways = _without_tools(ways, "only muddles") or ways
        return [way for way in ways if "peel" not in self.known.motion(way[0]).does] or ways

    def _ways_to_grate(self, ways: Sequence[Way], want: Want, state: str) -> list[Way]:
        """Return those of some ways that have a grater, where a food is brought into such a state by that alone.

        Where they have only what slices, the others that grate stand for them.
        """
        hard = state in word_list("grates what is hard") and want.facts.is_any(word_list("is hard to shred"))
        if not hard and state not in word_list("only grates") | word_list("is so by a grater"):
            return []
        graters = self._with_graters(ways)
        usual = _without_tools(graters, "slices and grates little")
        if graters and not usual:
            usual = _without_tools(self._with_graters(self.operators.ways_of(_GRATE)), "slices and grates little")
        return usual or graters

    def _with_graters(self, ways: Iterable[Way]) -> list[Way]:
        return [way for way in ways if self.has_tool_to(_GRATE, way)]

    def with_a_knife(self, ways: list[Way], want: Want, state: str = "") -> list[Way]:
        """Return those of ``ways`` that divide ``want`` to ``state``.

        A firm food is not divided by bare hands, nor with what is no knife.
        """
        if not _wants_a_knife(want):
            sharp = _without_tools(ways, "only scrapes") or ways
            return sharp if state in word_list("is so by bare hands") else _with_tools(sharp) or sharp
        bare = word_list("is done by bare hands")
        return [way for way in _without_tools(ways, "is no knife") if way[1] or way[0] not in bare] or ways

    def _nearest_cut(self, ways: Sequence[Way], want: Want, state: str) -> Attested | None:
        for some in filter(None, (self._usual_ways(ways, state) or self._fit_ways(ways, want, state), ways)):
            attested = self.bench.attest(some, want.names, act=True) or self._far(some, want)
            if attested is not None:
                return attested
        return None

    def _usual_ways(self, ways: Sequence[Way], state: str) -> list[Way]:
        """Return the ways by which the FOON usually gives a state: a grater grates, though a knife might do."""
        given: Mapping[Way, int] = self.operators.giving.get(state, {})
        most = max((given[way] for way in ways if way in given), default=0)
        return [way for way in ways if given.get(way, 0) > _RARE * most]

    def _fit_ways(self, ways: Sequence[Way], want: Want, state: str) -> list[Way]:
        """Return the ways that are said to be fit for a state that the FOON never gives."""
        if want.facts.is_any(word_list("is crushed with a knife")):
            return []
        fit = word_lists().get(f"makes what is {state}", frozenset())
        return [way for way in ways if way[0] in fit]

    def usual_cut(self, want: Want) -> str:
        """Return the state into which the FOON most often cuts such a food as ``want``."""
        if want.facts.is_any(word_list("is grated where nothing is said")):
            return min(word_list("only grates"))
        # the narrowest name that is ever cut decides, the whole kitchen (vegetables) at last
        counts: dict[str, int] = {}
        for name in (singular(want.label), want.facts.taken_for, f"kind:{want.facts.kind}", "kind:vegetable"):
            for state in self.operators.states.get(name, ()):
                fine = self.known.state(state).fineness
                if 1 < fine < POWDER:
                    counts[state] = counts.get(state, 0) + sum(
                        n for way, n in self.operators.giving.get(state, {}).items() if self.is_cut(way)
                    )
            if any(counts.values()):
                break
        counts = counts or {"chopped": 1}  # a FOON that cuts nothing like it
        return min(counts, key=lambda state: (-counts[state], state))

    def comes_so(self, want: Want, state: str) -> bool:
        """Return whether any video has the food ``want``, or one of its very kind, in such a state."""
        names = (singular(want.label), want.facts.taken_for, f"kind:{want.facts.kind}")
        return any(state in self.operators.states.get(name, ()) for name in names)

    def with_a_fit_tool(self, name: str, ways: list[Way], want: Want) -> list[Way]:
        """Return those of ``ways`` to treat ``want`` as ``name`` says that take its skin off with what does it.

        That is fingers, a peeler, or a knife where the skin is a rind.
        """
        if _is_taken_off_by_hand(name, want):
            fit = _bare(ways)
        elif name != "peel" or want.facts.is_any(word_list("is peeled by hand")):
            return ways
        elif want.facts.is_any(word_list("is peeled with a knife")):
            fit = [way for way in ways if self.has_tool_to(_OPEN, way)]
        else:
            fit = _with_tools(ways)
        return fit or ways

    def way_to_treat(self, want: Want, name: str) -> Attested | None:
        """Return how hands peel, core or stone such a food as ``want``; ``None`` where nobody does with a like one.

        ``name`` is what is to be done.
        """
        ways = [way for one in (name, *STANDS_FOR.get(name, ())) for way in self.operators.ways.get(one, ())]
        unfit = NOT_BY_HAND | {"open" if name == "shell" else "separate"}  # nobody skims a skin; opened is not shelled
        ways = [way for way in ways if unfit.isdisjoint(self.known.motion(way[0]).does)]
        ways = self.with_a_fit_tool(name, ways, want)
        attested = self.bench.attest(ways, want.names, act=True)
        if attested is None and (name in want.facts.owes or not want.facts.is_a("stock", "ready")):
            attested = self.bench.far(ways, want.names, act=True)
        return attested

    def with_tool(self, attested: Attested) -> Attested:
        """Return the way of cutting that is ``attested``, with the motion's usual tool if a video forgot to name it."""
        if attested.way[1]:
            return attested
        tools = [way[1] for way in self.operators.ways_of(attested.way[0]) if way[1]]
        tool = min(tools, key=lambda some: says(some, "is no knife"), default=())
        return replace(attested, way=(attested.way[0], tool))

    def has_tool_to(self, work: str, way: Way) -> bool:
        """Return whether a tool of ``way`` is made for a ``work``, as to grate."""
        rows = (self.known.utensil(tool) for tool in way[1])
        return any(row is not None and work in row.can for row in rows)

    def _far(self, ways: Sequence[Way], want: Want) -> Attested | None:
        """Return how the likest food is divided: a knife cuts all, but no trout is grated or mashed like a carrot."""
        found = self.bench.far(ways, want.names, act=True)
        if found is not None and self._gives_way(want, found.way):
            return found
        if found is not None and found.like is not None and found.like[2] >= LEAST_ALIKE:
            return found
        return self.bench.far([way for way in ways if "cut" in self.known.motion(way[0]).does], want.names, act=True)

    def _gives_way(self, want: Want, way: Way) -> bool:
        """Whether any masher mashes a food, or any mill grinds it, whatever others were mashed or ground so."""
        does, is_any = self.known.motion(way[0]).does, want.facts.is_any
        mashed = "mash" in does and is_any(_SOFT | word_list("crumbles"))
        return mashed or ("grind" in does and is_any(word_list("is ground in a mill")))

    def board(self, way: Way) -> str:
        """Return what a food lies on or in while it is worked on in this way; ``""`` for the hand.

        What fingers tear or crumble falls into a bowl.
        """
        if not self.is_cut(way):
            return ""
        if not way[1]:
            return BOWL
        places = self.operators.onto.get(way)
        if not places:  # no video says on what: as what is chopped with a knife
            places = self.operators.onto.get(("chop", ("knife",)))
        return min(places, key=lambda place: (-places[place], place)) if places else "cutting board"
