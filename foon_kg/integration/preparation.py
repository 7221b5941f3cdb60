"""One food on its own: how it is sold, how its asked state is read, and what is done to it before it joins.

A cook's duties to a food (peel it, stone it, shell it, cook it) are data (:mod:`foon_kg.food`); how they are done is
taken from the operators of the FOON. What no operator does is assumed to have been done, and that is said.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

from foon_kg.food import Food, Level, Tables, singular, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import State
from foon_kg.food.told_states import in_turn
from foon_kg.integration.bench import Bench, RefusedError, Stuff
from foon_kg.integration.operators import Attested, Nearness, Operators, Way, form_of
from foon_kg.model import RequiredIngredient
from foon_kg.world.treatment import ADVISED

_IN_ORDER = ("husk", "shell", "peel", "core", "stone", "choke")
"""What hands do to a food before it is cut, in this order."""

BY_HAND = frozenset(_IN_ORDER)
"""The same, in no order."""

_STANDS_FOR = {"stone": ("core",), "core": ("stone",), "shell": ("peel",)}
"""What also does for a treatment."""

_MILLS = frozenset({"grind", "blend", "mash"})
_CUTS = frozenset({"cut", "grate", "mash", "grind"})
_NOT_BY_HAND = frozenset({"heat", "warm", "blend", "mix", "wait", "coat", "shape", "scatter", "fetch"})
_SOFT = word_list("can be mashed")
LEAST_ALIKE = 0.2
"""A food is grated or mashed like another one only where that is not quite absurd."""

_CANNED = "canned"
_FROM_A_CAN = frozenset({"drain"})
"""What is done to what comes out of a can."""

_RINSED = frozenset({"wash"})
"""What a state says that was only rinsed: washed, cleaned, scrubbed."""

_JUICE = "juice"
"""The state of what is squeezed out of a fruit."""

_BRINGS = frozenset({"fetch", "move", "scatter"})
"""What a motion does that only brings a food somewhere, whatever state its video notes afterwards."""

_BOWL = "bowl"
_OPEN = "open"
_GRATE = "grate"

_RARE = 0.2
"""So seldom, beside the most usual way, is a state given in a way that somebody noted wrongly."""

_SHREDS = word_list("only what is cooked is so")

SECOND = 1000
"""Above this are the numbers of second portions: below it are those of what is asked."""

_POWDER = 5
"""How fine a powder is (:class:`~foon_kg.food.rows.State`)."""


@dataclass(frozen=True)
class Want:
    """A required food as it is understood.

    ``leaf`` are the states in which the kitchen has it, in ``storage`` (``""``: free). ``make`` is the asked state that
    somebody has to make, ``cooked`` says that it is asked cooked. ``read_as`` is what a crude state was read as
    (``None``: it was taken at its word). ``bought_so``: no kitchen of this FOON makes what is asked (smoked, pickled).
    ``at_hand``: somebody has it in the asked state. ``then`` is what is made of it once it is cooked (mashed).
    ``foamed``: it is a liquid that is whipped. ``roasted``: the title says that it comes out of an oven. ``part`` is
    for what of the dish the recipe says that it is, ``places`` are those at which it lists it. ``told`` are the asked
    states where there are several (:func:`~foon_kg.food.told_states.in_turn`).
    """

    number: int
    label: str
    asked: str
    facts: Food
    leaf: tuple[str, ...]
    storage: str
    make: str = ""
    cooked: bool = False
    read_as: str | None = None
    squeezed: bool = False
    bought_so: bool = False
    then: str = ""
    at_hand: bool = False
    foamed: bool = False
    roasted: bool = False
    part: str = ""
    told: str = ""
    places: tuple[int, ...] = field(default=(), compare=False)

    @property
    def names(self) -> tuple[str, ...]:
        """The names under which evidence is sought."""
        return (singular(self.label),)


@dataclass
class Ready:
    """A food that is ready to join, and what had to be assumed for it."""

    want: Want
    stuff: Stuff
    whole_shell: bool = False
    cut_later: str = ""
    read_as: str | None = None
    assumptions: list[str] = field(default_factory=list)


def wants_of(
    ingredients: Iterable[RequiredIngredient], known: Tables, operators: Operators, title: str = ""
) -> tuple[Want, ...]:
    """Return the distinct required foods in their order, each with its state as it is understood."""
    distinct: dict[RequiredIngredient, tuple[int, ...]] = {}
    for place, one in enumerate(one for one in ingredients if one.object):
        distinct[one] = (*distinct.get(one, ()), place)
    found = []
    for number, (one, places) in enumerate(distinct.items(), start=1):
        want = replace(_in_turn(number, one, known, operators), part=one.part, places=places)
        found.append(_as_entitled(_cut_by_name(want, known), title, known, operators))
    return tuple(found)


def _in_turn(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    """Return a required food of whose state several things are told: what heat made of it, and how it is cut then."""
    *before, last = in_turn(one.state) or ("",)
    want = understood(number, replace(one, state=last), known, operators)
    if not before:
        return want
    first = understood(number, replace(one, state=before[-1]), known, operators)
    if want.cooked and first.make and known.state(first.make).fine:
        return replace(first, cooked=True, told=one.state)
    divided = want.make if want.make and known.state(want.make).fine else ""
    if first.cooked:
        return replace(first, then=divided, told=one.state)
    if before[-1] in word_list("is in a can"):
        return replace(first, make=divided, told=one.state)
    return replace(want, told=one.state)


def _as_entitled(want: Want, title: str, known: Tables, operators: Operators) -> Want:
    """Return a food as the title has it, which says what the recipe left out: smoked salmon, mashed potato."""
    told = words(title)
    heads = words(want.label)[-1:]
    mash = word_list("is mash")
    covers = not word_list("is covered with mash").isdisjoint(told)
    if covers and want.facts.is_a(*word_list("covers a dish when it is mashed")) and not want.cooked:
        return replace(want, then=min(word_list("is mashed so")))
    if any(head in heads and word in mash for head, word in itertools.pairwise(told)):
        return replace(want, then=min(word_list("is mashed so")))
    given = word_list("is so by the dish")
    for before in _before_it(want, told):
        if before not in known.states or before in {want.asked, *want.leaf, *given}:
            continue
        word = heads[0]
        dish = known.dishes.get(f"{before} {word}")
        if dish is not None and not dish.mashed:
            continue  # grilled cheese is a sandwich
        row = known.state(before)
        if _is_bought_so(row, before, operators):
            return replace(want, leaf=(before,), bought_so=True)
        if row.needs_heat and "cook" in row.earns and not want.cooked and "boil" not in want.facts.owes:
            make = before if before in word_list("is so by boiling") else ""
            return replace(want, cooked=True, make=want.make or make, roasted=before in word_list("is roasted"))
        if (row.fine or 0) >= _POWDER and {"cook", "boil"} & want.facts.owes.keys():
            return replace(want, then=before)
    return want


def _before_it(want: Want, told: Sequence[str]) -> Iterator[str]:
    """Yield the words of a title before the name of a food, of which the last word is enough there (breast)."""
    own = words(want.label)
    for place, word in enumerate(told):
        if word not in own[-1:]:
            continue
        first = place
        while first and told[first - 1] in own[:-1]:
            first -= 1
        if first:
            yield told[first - 1]


def _cut_by_name(want: Want, known: Tables) -> Want:
    """Return a food that is cut as its name says (lime wedge), or grated off the whole (zest), if no state is asked."""
    shape = words(want.label)[-1:]
    grated_off = want.facts.is_a(*word_list("is grated off the whole"))
    as_sold = grated_off and want.asked == want.facts.sold_as
    if want.asked and not as_sold and not known.state(want.asked).undivided:
        return want
    if grated_off:
        return replace(want, make=min(word_list("only grates")), leaf=("whole",))
    cut = want.facts.sold_as == "whole" and not word_list("is cut so by name").isdisjoint(shape)
    return replace(want, make=shape[0]) if cut else want


def _is_bought_so(row: State, state: str, operators: Operators) -> bool:
    """Whether no kitchen of this FOON makes a food so, which is fit to be eaten then."""
    return "cook" in row.earns and not row.needs_heat and not any(True for _ in operators.making(state))


def as_there(want: Want, ready_in: Callable[[str, str], str | None]) -> Want:
    """Return a food as a named kitchen has it: in the asked state and in what a person said."""
    storage = ready_in(want.label, want.make) if want.make else None
    if storage is None:
        return want
    return replace(want, leaf=(want.make,), storage=storage, make="", cooked=False, squeezed=False, at_hand=True)


def understood(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    """Return a required food with its state as it is understood: sold so, made so, or a crude word for something."""
    if one.state not in word_list("asks for what is grated off"):
        return _as_asked(number, one, known, operators)
    (state,) = word_list("is grated off the whole")
    return replace(_as_asked(number, replace(one, state=state), known, operators), asked=one.state, read_as=state)


def _as_asked(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    facts = known.foods.food(one.object, [one.state] if one.state else [])
    if _JUICE in one.state and facts.is_a("remains"):
        facts = known.foods.food(one.object)  # its juice is asked, and not what is left of it
    plain = _plain_leaf(one.object, facts, one.state, known)
    want = Want(number, one.object, one.state, facts, (plain,) if plain else (), facts.sold_in)
    foamed = _misread(want) or _foamed(want, known.foods.food(one.object))
    if foamed is not None or not one.state or facts.sold_as == one.state:
        return foamed or replace(want, leaf=(one.state,) if one.state else want.leaf)
    row = known.state(one.state)
    sold_so = row.sold or bool(row.sold_for and facts.is_a(*row.sold_for))
    if sold_so or not (row.earns or row.fine or row.half):
        if one.state in word_list("only what was cooked is so") and {"cook", "boil"} & facts.owes.keys():
            return replace(want, cooked=True)
        warm = one.state in word_list("is only made warm") and facts.is_a(*word_list("is warmed alone"))
        had_so = replace(want, make=one.state) if warm else replace(want, leaf=(one.state,))
        return had_so if warm or _taken_at_its_word(want, plain, known, operators) else replace(want, read_as=plain)
    form = form_of(known, one.object, want.leaf)
    by_boiling = one.state in word_list("is so by boiling") and facts.is_a("vegetable")
    if (row.needs_heat and "cook" in row.earns) or by_boiling:
        whole = form in {"whole", "pieces"} and not facts.is_a("spice", "fat")
        dry = one.state in word_list("is so by dry heat") and facts.is_a(*word_list("is toasted by itself"))
        whole = whole or dry
        return replace(want, cooked=True, make=one.state) if whole else replace(want, read_as=plain)
    if _JUICE in one.state and form == "whole" and operators.giving.get(_JUICE):
        return replace(want, make=one.state, squeezed=True)
    return _otherwise(want, plain, form, row, operators)


def _otherwise(want: Want, plain: str, form: str, row: State, operators: Operators) -> Want:
    """Return a food that is asked in a state which no heat and no squeezing gives: as hands make it, or as it is sold.

    ``plain`` is the state in which it is sold, ``form`` how it is handled then.
    """
    known, facts, state = operators.known, want.facts, want.asked
    if _wants_a_mill(state, facts, known) and not any(_is_mill(way, known) for way in operators.making(state)):
        ground = facts.is_a(*word_list("is sold ground")) or not facts.traits
        return replace(want, leaf=(state,), bought_so=True) if ground else replace(want, read_as=plain)
    if state in word_list("has no shell any more") and facts.is_a(*word_list("runs out of its shell")):
        boiled = min(word_list("is boiled so"))
        return replace(want, make=boiled, cooked=True, read_as=boiled)
    ends = state in word_list("is cut off at the ends") and facts.is_a("vegetable") and form == "whole"
    can = ends or _can_be_made(want, form, row, operators)
    alone = replace(want, make=state) if can else replace(want, read_as=plain)
    return _done_by_others(want, row, operators) or alone


def _is_mill(way: Way, known: Tables) -> bool:
    """Whether what is hard is ground in this way."""
    return not _MILLS.isdisjoint(known.motion(way[0]).does)


def _misread(want: Want) -> Want | None:
    """Return a food whose asked state says nothing of it alone, or needs a machine: as something like it."""
    sold = want.facts.sold_as
    if want.asked in word_list("says nothing of one food"):
        return replace(want, leaf=(sold,) if sold else (), read_as=sold)
    if want.asked in word_list("needs a machine") and want.facts.is_a("vegetable") and want.facts.is_a("raw"):
        state = min(word_list("is made fine by hand"))
        return replace(want, make=state, read_as=state)
    return None


def _foamed(want: Want, before: Food) -> Want | None:
    """Return a liquid that is asked whipped, ``before`` being what is known of it as it is sold."""
    if want.asked not in word_list("is beaten to a foam") or before.sold_as == want.asked or not before.is_a("liquid"):
        return None
    return replace(want, leaf=(before.sold_as,), storage=before.sold_in, make=want.asked, foamed=True)


def _done_by_others(want: Want, row: State, operators: Operators) -> Want | None:
    """Return a food whose asked state is not given to it alone: drained of what it was canned or boiled in, smoked."""
    canned = operators.known.foods.food(want.label, [_CANNED])
    if row.earns & _FROM_A_CAN and canned.sold_as == _CANNED:
        return replace(want, facts=canned, leaf=(_CANNED,), storage=canned.sold_in, read_as=_CANNED)
    if row.earns and row.earns <= ADVISED and row.earns != _RINSED and "boil" in want.facts.owes:
        return replace(want, cooked=True)
    return replace(want, leaf=(want.asked,), bought_so=True) if _is_bought_so(row, want.asked, operators) else None


def _taken_at_its_word(want: Want, plain: str, known: Tables, operators: Operators) -> bool:
    """Whether a food is had as it is asked: the FOON has it so, or it is undivided."""
    if any(want.asked in operators.states[name] for name in (singular(want.label), f"kind:{want.facts.kind}")):
        return True
    return known.state(want.asked).undivided or form_of(known, want.label, (plain,)) == "whole"


def _can_be_made(want: Want, form: str, row: State, operators: Operators) -> bool:
    """Whether the asked state, that of ``row``, can be given to a food of such a form."""
    told = _is_known_to_be_made(want, form, row)
    return told if told is not None else _is_made_here(want, form, row, operators)


def _is_known_to_be_made(want: Want, form: str, row: State) -> bool | None:
    """Whether a state can be given to a food by what is known of both; ``None`` where the FOON has to show it."""
    facts, asked = want.facts, want.asked
    small = not word_list("is too small for a grater").isdisjoint(want.leaf)
    if small and row.earns == {"cut"} and (row.fine or 0) < _POWDER:
        return False  # flakes are as good as shreds, and nothing holds them to be cut
    if row.earns == _RINSED:
        return form in {"whole", "pieces"} or _CANNED in want.leaf
    melts = asked in word_list("is so when it has melted") and facts.is_a("fat") and not facts.is_a("liquid")
    if melts or (asked in word_list("is mashed so") and facts.is_a(*word_list("is mashed as it is sold"))):
        return True
    return None


def _is_made_here(want: Want, form: str, row: State, operators: Operators) -> bool:
    """Whether the FOON shows how a state, that of ``row``, is given to such a food."""
    facts = want.facts
    ways = [way for way in operators.giving.get(want.asked, ()) if not operators.known.motion(way[0]).does <= _BRINGS]
    if form in {"liquid", "powder", "soft"} and not any(operators.attested(w, want.names, act=True) for w in ways):
        return False
    if facts.is_a("fat", "creamy") and (row.fine or 0) >= _POWDER:
        return False
    if any(operators.attested(way, want.names, act=True) for way in operators.making(want.asked)):
        return True
    if facts.is_a("stock", "ready") and (row.fine or 0) in {0, _POWDER}:
        return False
    return bool(row.fine) or bool(row.earns & facts.owes.keys())


def _wants_a_mill(state: str, facts: Food, known: Tables) -> bool:
    """Whether a food is asked so fine that only a mill makes it, or a mortar: a knife does it where it is soft."""
    row = known.state(state)
    fine = (row.fine or 0) >= _POWDER and row.earns == {"cut"}
    return fine and not facts.is_a(*word_list("is soft enough for a knife"))


def _is_grated_off(label: str, facts: Food, known: Tables) -> bool:
    """Whether what is asked is only grated off the whole of that name."""
    return facts.is_a(*word_list("is grated off the whole")) and known.foods.food(label).kind != facts.kind


def _plain_leaf(label: str, facts: Food, asked: str, known: Tables) -> str:
    """Return the state in which a shop sells the food, such that its name still means the same food."""
    row = known.state(asked)
    if asked in word_list("is so by a grater") and _is_grated_off(label, facts, known):
        return "whole"
    candidates = [facts.sold_as, "whole", "whole veg", "raw", "fresh", "ground"]
    if row.sold or not (row.earns or row.fine or row.half):
        candidates.append(asked)
    for state in candidates:
        if state and known.foods.food(label, [state]).kind == facts.kind:
            return state
    return facts.sold_as


def as_mash(want: Want, known: Tables) -> Want:
    """Return a food that is too hard to be shaped as it is: it is cooked and mashed before, unless it is asked cut."""
    whole = not want.make or not known.state(want.make).fine
    hard = want.facts.is_a(*word_list("is cooked and mashed to be shaped"))
    return replace(want, then=min(word_list("is mashed so"))) if hard and whole and not want.then else want


def as_mixed(want: Want, known: Tables) -> Want:
    """Return a food as it is mixed to be shaped: mashed where it is hard, torn where it is to soak."""
    whole = not want.make or (known.state(want.make).fine or 0) <= 1
    torn = whole and want.facts.kind in word_list("is torn to be soaked")
    return replace(want, make="torn") if torn else as_mash(want, known)


def owed(want: Want, known: Tables, level: Level = Level.MINOR) -> set[str]:
    """Return what a cook still has to do to the food as it is sold: all that is fatal, and minor where asked."""
    levels = {Level.FATAL} if level is Level.FATAL else {Level.FATAL, Level.MINOR}
    earned = frozenset().union(*(known.state(state).earns for state in want.leaf))
    return {name for name, how in want.facts.owes.items() if how in levels} - earned


@lru_cache(maxsize=1 << 12)
def _divides(known: Tables, motion: str) -> bool:
    """Whether a motion divides a food, and does it by hand."""
    does = known.motion(motion).does
    others = _NOT_BY_HAND - {"mix"} if "mash" in does else _NOT_BY_HAND
    return not does.isdisjoint(_CUTS) and does.isdisjoint(others)


class Preparer:
    """Prepares foods on a bench."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known = bench.known
        self.operators = bench.operators
        self._cuts: dict[tuple[str, Food, str], Attested | None] = {}

    def prepare(self, want: Want, form: Sequence[str] = (), *, divided: bool = True, alone: bool = True) -> Ready:
        """Return the food as it can join: opened, peeled and cut as it is asked, as ``form`` says and as it needs.

        ``form`` are states in which such a food joins elsewhere. ``divided``: it has to be in pieces (not where it is
        blended); ``alone``: it is cooked by itself before it joins. A food in a shell that is to be opened over a
        vessel comes as it is (``whole_shell``).
        """
        due = self._due(want)
        later = want.then and want.then not in word_list("only what is soft is so")  # it stays whole until it is done
        cut = "" if later else self._cut_state(want, form, due, divided=divided)
        pieces = self._comes_in_pieces(want, cut)
        worked = pieces and self._way_so(want, cut) is not None
        pieces = pieces and not worked
        ready = Ready(want, self.bench.fetch(want.label, want.leaf, [want.number], want.storage))
        if want.bought_so:
            ready.assumptions.append(f"no step of this FOON makes {want.label} {', '.join(want.leaf)}: it is bought so")
        if want.foamed:
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
        juicy = _JUICE in form and not want.make and form_of(self.known, want.label, want.leaf) == "whole"
        if want.squeezed or (juicy and self.operators.giving.get(_JUICE)):
            self._squeeze(ready)
            return ready
        if "canned" in want.leaf and "drain" in {*want.facts.owes, *self.known.state(want.asked).earns}:
            self._drain(ready)
        self._advise(ready)
        self._divide(ready, cut, alone=alone)
        ready.cut_later = want.then or ready.cut_later
        return ready

    def _divide(self, ready: Ready, cut: str, *, alone: bool) -> None:
        """Cut a food as it is asked or as it needs, now or once it is cooked."""
        want = ready.want
        if want.make in word_list("is cut off at the ends"):
            self._trim(ready, want.make)
            return
        if want.facts.is_a(*word_list("has tough ends")) and form_of(self.known, want.label, want.leaf) == "whole":
            self._trim(ready, min(word_list("is trimmed")))
        if self.is_mashed_raw(want) and want.facts.is_a(*word_list("is flesh")) and not alone:
            self._cut(ready, self._usual_cut(want))  # it falls into shreds only once it is cooked
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
        attested = self._with_tool(attested)
        self.bench.act(ready.stuff, attested, (state,), self._board(attested.way))

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
        mashed = (self.known.state(want.make).fine or 0) >= _POWDER and any(
            "mash" in self.known.motion(way[0]).does for way in ways
        )
        return mashed and bool({"cook", "boil"} & want.facts.owes.keys())

    def cut_once_done(self, ready: Ready) -> None:
        """Have a food cut when it is cooked, unless it is in pieces or is cut anyway."""
        states = (*ready.stuff.states, ready.want.make) if ready.want.make else ready.stuff.states
        whole = not any((self.known.state(state).fine or 0) > 0 for state in states)
        if whole and not ready.cut_later:
            ready.cut_later = self._usual_cut(ready.want)

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
        if (earns == _RINSED and self.rinse(ready, asked)) or self._worked_so(ready, asked):
            return
        self._assume(ready, asked)

    def _worked_so(self, ready: Ready, state: str) -> bool:
        """Bring a food into a state as the FOON shows it of such a food, without heat; return whether it does."""
        attested = self._way_so(ready.want, state)
        if attested is not None:
            self.bench.act(ready.stuff, attested, tuple(sorted({*ready.stuff.states, state})), _BOWL)
        return attested is not None

    def _way_so(self, want: Want, state: str) -> Attested | None:
        """Return how hands bring a food into a state otherwise than by cutting it (sifted); ``None`` where none do."""
        does = {way: self.known.motion(way[0]).does for way in self.operators.making(state)}
        ways = [way for way, done in does.items() if not (done & (_NOT_BY_HAND | _CUTS) or done <= _BRINGS)]
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
        drained = asked and self.known.state(asked).earns == _FROM_A_CAN
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
            stuff, self._with_tool(bench.require(halves, ready.want.names, act=True)), ("halved",), "cutting board"
        )
        ways = [
            way
            for way in self.operators.giving.get(_JUICE, ())
            if "separate" in self.known.motion(way[0]).does and way[1]
        ]
        attested = bench.require(ways, ready.want.names)
        board, bowl = stuff.at, bench.vessel("bowl")

        def change() -> None:
            if board is not None:
                board.contents.remove(stuff)
            bowl.contents.append(stuff)
            stuff.at, stuff.states = bowl, (_JUICE,)

        bench.emit(attested, [stuff, *([board] if board is not None else []), bowl], change, [stuff, bowl])
        ready.read_as = _JUICE

    def opening(self, want: Want) -> Attested | None:
        """Return the way to open the food's shell over a vessel, if there is one."""
        ways = [way for way in self.operators.ways.get("shell", ()) if "open" in self.known.motion(way[0]).does]
        ways = [way for way in ways if self.operators.onto.get(way) and not way[1]]
        opens = "shell" in want.facts.owes and not want.facts.is_a(*word_list("is peeled and not cracked"))
        return self.bench.attest(ways, want.names, act=True) if opens else None

    def shelled(self, ready: Ready, form: Sequence[str] = ()) -> None:
        """Take the shell off a food that was cooked in it, and cut it as it is asked."""
        ways = [way for way in self.operators.ways.get("shell", ()) if "peel" in self.known.motion(way[0]).does]
        attested = self.bench.require(ways, ready.want.names, act=True)
        kept = {s for s in ready.stuff.states if not self.known.state(s).undivided} - {"washed"}
        self.bench.act(ready.stuff, attested, tuple(sorted({*kept, self._gives(attested.way, ("peel",))})))
        cut = self._cut_state(ready.want, form, owed(ready.want, self.known), divided=True)
        if cut:
            self._cut(ready, cut)

    def _cut_state(self, want: Want, form: Sequence[str], due: set[str], *, divided: bool) -> str:
        asked = self.known.state(want.make) if want.make else None
        if asked is not None and (asked.fine or 0) > 0:
            return want.make
        hard = want.facts.is_a(*word_list("is flesh")) and not word_list("is no work for a knife").isdisjoint(
            words(want.label)
        )
        hard = hard or want.facts.is_a(*word_list("is a mouthful"))
        rows = [self.known.state(state) for state in want.leaf]
        if hard or not divided or any((row.fine or 0) > 0 or "cut" in row.earns for row in rows):
            return ""
        if form_of(self.known, want.label, want.leaf) not in {"whole", "pieces"} or want.facts.is_a("stock"):
            return ""
        if "cut" in want.facts.owes and want.facts.is_a("raw") and not want.facts.is_a("herb", "berry"):
            due = due | {"cut"}  # nobody serves it in one piece, though it could be eaten so
        first = not want.cooked or want.facts.is_a(*word_list("is split"))  # what is toasted is cut before
        for state in form if first else ():
            if state in word_list("is a shape of some foods") and not self._comes_so(want, state):
                continue
            if (self.known.state(state).fine or 0) > 0 and ("cut" in want.facts.owes or "cut" in due):
                return state
        if "cut" in due:
            return self._usual_cut(want)
        return ""

    def _comes_so(self, want: Want, state: str) -> bool:
        """Whether any video has this food, or one of its very kind, in such a state."""
        names = (singular(want.label), want.facts.taken_for, f"kind:{want.facts.kind}")
        return any(state in self.operators.states.get(name, ()) for name in names)

    def _usual_cut(self, want: Want) -> str:
        """Return the state into which the FOON most often cuts such a food."""
        counts: dict[str, int] = {}
        for name in (singular(want.label), want.facts.taken_for, f"kind:{want.facts.kind}", "kind:vegetable"):
            for state in self.operators.states.get(name, ()):
                fine = self.known.state(state).fine or 0
                if 1 < fine < _POWDER:
                    counts[state] = counts.get(state, 0) + sum(
                        n for way, n in self.operators.giving.get(state, {}).items() if self.is_cut(way)
                    )
            if any(counts.values()):
                break
        counts = counts or {"chopped": 1}
        return min(counts, key=lambda state: (-counts[state], state))

    def is_cut(self, way: Way) -> bool:
        """Whether a way divides a food by hand."""
        return len(way[1]) <= 1 and _divides(self.known, way[0])

    def _with_tool(self, attested: Attested) -> Attested:
        """Return a way of cutting with the tool that the motion most often has, where a video forgot to name it."""
        if attested.way[1]:
            return attested
        tool = next((way[1] for way in self.operators.ways_of(attested.way[0]) if way[1]), ())
        return replace(attested, way=(attested.way[0], tool))

    def _with_a_fit_tool(self, name: str, ways: Sequence[Way], want: Want) -> Sequence[Way]:
        """Return the ways to take off a skin with what does it: fingers, a peeler, or a knife where it is a rind."""
        if name != "peel" or want.facts.is_a(*word_list("is peeled by hand")):
            return ways
        if want.facts.is_a(*word_list("is peeled with a knife")):
            return [way for way in ways if self._has_tool_to(_OPEN, way)] or ways
        return [way for way in ways if way[1]] or ways

    def _treat(self, ready: Ready, name: str) -> None:
        """Peel, core or stone the food, or assume that it was bought so."""
        want = ready.want
        does = (name, *_STANDS_FOR.get(name, ()))
        ways = [way for one in does for way in self.operators.ways.get(one, ())]
        ways = [way for way in ways if not self.known.motion(way[0]).does & _NOT_BY_HAND]
        if name == "shell":
            ways = [way for way in ways if "open" not in self.known.motion(way[0]).does]  # opened is not shelled
        ways = list(self._with_a_fit_tool(name, ways, want))
        attested = self.bench.attest(ways, want.names, act=True)
        if attested is None and not want.facts.is_a("stock", "ready"):
            attested = self.bench.far(ways, want.names, act=True)
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
        board = self._board(attested.way)
        if ready.stuff.at is not None and ready.stuff.at.storage:
            board = board or _BOWL  # what is peeled does not stay in its packet
        self.bench.act(ready.stuff, attested, tuple(sorted({*kept, state})), board)

    def _far(self, ways: Sequence[Way], want: Want) -> Attested | None:
        """Return how the likest food is divided: a knife cuts all, but no trout is grated or mashed like a carrot."""
        found = self.bench.far(ways, want.names, act=True)
        if found is not None and want.facts.is_a(*_SOFT) and "mash" in self.known.motion(found.way[0]).does:
            return found
        if found is not None and found.like is not None and found.like[2] >= LEAST_ALIKE:
            return found
        return self.bench.far([way for way in ways if "cut" in self.known.motion(way[0]).does], want.names, act=True)

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
        stuff.states = tuple(sorted({*(s for s in stuff.states if not self.known.state(s).undivided), state}))
        why = f"no step of this FOON makes {ready.want.label} {state}, nor a like food or one of its kind"
        ready.assumptions.append(why)

    def _board(self, way: Way) -> str:
        """Return what a food lies on or in while it is worked on in this way; ``""`` for the hand.

        What fingers tear or crumble falls into a bowl.
        """
        if not self.is_cut(way):
            return ""
        if not way[1]:
            return _BOWL
        places = self.operators.onto.get(way)
        if not places:
            places = self.operators.onto[("chop", ("knife",))]
        return min(places, key=lambda place: (-places[place], place)) if places else "cutting board"

    def _usual_ways(self, ways: Sequence[Way], state: str) -> list[Way]:
        """Return the ways by which the FOON usually gives a state: a grater grates, though a knife might do."""
        given: Mapping[Way, int] = self.operators.giving.get(state, {})
        most = max((given[way] for way in ways if way in given), default=0)
        return [way for way in ways if given.get(way, 0) > _RARE * most]

    def _clean(self, ready: Ready, due: set[str]) -> None:
        order = list(_IN_ORDER)
        if ready.want.facts.is_a(*word_list("is stoned before it is peeled")):
            order.sort(key=lambda name: name == "peel")
        for name in order:
            if name in due and not (name == "stone" and "core" in due):
                self._treat(ready, name)

    def _comes_in_pieces(self, want: Want, cut: str) -> bool:
        """Whether a food is taken in pieces since nobody brings such a one into them: then it is not peeled before."""
        return bool(cut) and not self.is_mashed_raw(want) and self._way_to_cut(want, cut) is None

    def _way_to_cut(self, want: Want, state: str) -> Attested | None:
        """Return how a food is brought into pieces of that state; ``None`` where nobody does so with a like food."""
        key = (want.label, want.facts, state)  # it is asked first whether there is a way, and then which
        if key not in self._cuts:
            self._cuts[key] = self._way_to_cut_so(want, state)
        return self._cuts[key]

    def _way_to_cut_so(self, want: Want, state: str) -> Attested | None:
        ways = [way for way in self.operators.making(state) if self.is_cut(way)]
        ways = [way for way in ways if "peel" not in self.known.motion(way[0]).does] or ways  # that was done before
        if _wants_a_mill(state, want.facts, self.known):
            ways = [way for way in ways if _is_mill(way, self.known)]
        if state in word_list("is pulled apart by hand"):
            pulls = [way for motion in sorted(word_list("pulls flesh apart")) for way in self.operators.ways_of(motion)]
            pulls = [way for way in pulls if not way[1]]
            return self.bench.attest(pulls, want.names, act=True) or self.bench.far(pulls, want.names, act=True)
        if state in _SHREDS and want.facts.is_a(*word_list("is flesh")):
            by_hand = [way for way in ways if way[0] in word_list("pulls flesh apart") and not way[1]]
            ways = by_hand or ways
        hard = state in word_list("grates what is hard") and want.facts.is_a(*word_list("is hard to shred"))
        grating = [way for way in ways if self._has_tool_to(_GRATE, way)]
        if grating and (hard or state in word_list("only grates") | word_list("is so by a grater")):
            like = self._nearest_cut(grating, want, state)
            if like is None and want.facts.is_a(*word_list("can be grated")):
                like = self.bench.far(grating, want.names, act=True)
            return like or self._nearest_cut(ways, want, state)
        return self._nearest_cut(ways, want, state)

    def _nearest_cut(self, ways: Sequence[Way], want: Want, state: str) -> Attested | None:
        usual = self._usual_ways(ways, state)
        tools = {way[1] for way in usual}
        attested = self.bench.attest([way for way in ways if way[1] in tools], want.names, act=True)
        if attested is None or attested.nearness > Nearness.FOOD:
            attested = self.bench.attest(usual, want.names, act=True) or (self._far(usual, want) if usual else None)
        return attested or self.bench.attest(ways, want.names, act=True) or self._far(ways, want)

    def _has_tool_to(self, work: str, way: Way) -> bool:
        rows = (self.known.utensil(tool) for tool in way[1])
        return any(row is not None and work in row.can for row in rows)

    def _cut(self, ready: Ready, state: str) -> None:
        want = ready.want
        attested = self._way_to_cut(want, state)
        if attested is None:
            self._assume(ready, state)
            return
        attested = self._with_tool(attested)
        board = self._board(attested.way)
        if board and ready.stuff.at is not None and not ready.stuff.at.storage and ready.stuff.at.label != board:
            carried = self.bench.require([("pick-and-place", ()), ("pour", ())], want.names)
            self.bench.bring([ready.stuff], self.bench.vessel(board), carried)  # nothing is cut in a strainer
        try:
            self.bench.act(ready.stuff, attested, (state,), board)
        except RefusedError:
            self._assume(ready, state)
