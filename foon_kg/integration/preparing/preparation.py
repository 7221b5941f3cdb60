"""One food on its own: how it is sold, how its asked state is read, and what a cook owes it.

A cook's duties to a food (peel it, stone it, shell it, cook it) are data (:mod:`foon_kg.food`). How they are done is in
:mod:`~foon_kg.integration.preparing.preparer`.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from foon_kg.food import Food, Level, Tables, singular, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import State
from foon_kg.food.told_states import asked_state, in_turn
from foon_kg.integration.bench import Stuff
from foon_kg.integration.teaching.operators import Operators, Way, form_of
from foon_kg.model import RequiredIngredient
from foon_kg.world.treatment import ADVISED

IN_ORDER = ("husk", "shell", "peel", "core", "stone", "choke")
"""What hands do to a food before it is cut, in this order."""

BY_HAND = frozenset(IN_ORDER)
"""The same, in no order."""


_MILLS = frozenset({"grind", "blend", "mash"})
CUTS = frozenset({"cut", "grate", "mash", "grind"})
NOT_BY_HAND = frozenset({"heat", "warm", "blend", "mix", "wait", "coat", "shape", "scatter", "fetch"})

_CANNED = "canned"
FROM_A_CAN = frozenset({"drain"})
"""What is done to what comes out of a can."""

RINSED = frozenset({"wash"})
"""What a state says that was only rinsed: washed, cleaned, scrubbed."""

JUICE = "juice"
"""The state of what is squeezed out of a fruit."""

BRINGS = frozenset({"fetch", "move", "scatter"})
"""What a motion does that only brings a food somewhere, whatever state its video notes afterwards."""


SECOND = 1000
"""Above this are the numbers of second portions: below it are those of what is asked."""

POWDER = 5
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
    states where there are several (:func:`~foon_kg.food.told_states.in_turn`). ``of`` is the food that comes apart
    when it is opened, and of which this is a part.
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
    of: Want | None = None
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
    ingredients: Iterable[RequiredIngredient], known: Tables, operators: Operators, title: str = "", dish_type: str = ""
) -> tuple[Want, ...]:
    """Return the distinct required foods in their order, each with its state as it is understood.

    ``title`` and ``dish_type`` say what nobody says of a food: of a whole lemon a cake wants the juice.
    """
    pressed = dish_type in word_list("is made with juice") and word_list("is made with slices").isdisjoint(words(title))
    distinct: dict[RequiredIngredient, tuple[int, ...]] = {}
    for place, one in enumerate(one for one in ingredients if one.object):
        distinct[one] = (*distinct.get(one, ()), place)
    found = []
    for number, (one, places) in enumerate(distinct.items(), start=1):
        want = replace(_in_turn(number, one, known, operators), part=one.part, places=places)
        want = _as_entitled(_cut_by_name(want, known), title, known, operators)
        found.append(_as_pressed(want, known, operators) if pressed else want)
    return tuple(found)


def _as_pressed(want: Want, known: Tables, operators: Operators) -> Want:
    """Return a whole food of which only the juice is used as one that is squeezed, unless it is for garnish."""
    is_whole = not want.make and all(known.state(state).undivided for state in want.leaf)
    pressed = (
        want.facts.is_a(*word_list("is pressed for its juice")) and not want.part and bool(operators.giving.get(JUICE))
    )
    return replace(want, make=JUICE, squeezed=True) if pressed and is_whole else want


def _in_turn(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    """Return a required food of whose state several things are told: what heat made of it, and how it is cut then."""
    *before, last = in_turn(asked_state(in_turn(one.state), known)) or ("",)
    want = understood(number, replace(one, state=last), known, operators)
    if not before:
        return replace(want, told=one.state) if want.asked != one.state else want
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
        if (row.fine or 0) >= POWDER and {"cook", "boil"} & want.facts.owes.keys():
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
        return _in_a_package(_as_asked(number, one, known, operators))
    (state,) = word_list("is grated off the whole")
    return replace(_as_asked(number, replace(one, state=state), known, operators), asked=one.state, read_as=state)


def _in_a_package(want: Want) -> Want:
    """Return a food that is sold free, but not in the state in which the kitchen has it: nobody keeps crumbs so."""
    if want.storage:
        return want
    for storage in ("bag", "container", "packet"):
        if not word_list(f"comes in a {storage}").isdisjoint(want.leaf):
            return replace(want, storage=storage)
    return want


def _as_asked(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    facts = known.foods.food(one.object, [one.state] if one.state else [])
    if JUICE in one.state and facts.is_a("remains"):
        facts = known.foods.food(one.object)  # its juice is asked, and not what is left of it
    plain = _plain_leaf(one.object, facts, one.state, known)
    want = Want(number, one.object, one.state, facts, (plain,) if plain else (), facts.sold_in)
    foamed = _misread(want) or _foamed(want, known.foods.food(one.object))
    if foamed is not None or not one.state or facts.sold_as == one.state:
        return foamed or replace(want, leaf=(one.state,) if one.state else want.leaf)
    row = known.state(one.state)
    sold_so = row.sold or bool(row.sold_for and facts.is_a(*row.sold_for))
    if sold_so or not (row.earns or row.fine or row.half):
        if one.state in word_list("only what was cooked is so") and {"cook", "boil"} & owed(want, known):
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
    if JUICE in one.state and form == "whole" and operators.giving.get(JUICE):
        return replace(want, make=one.state, squeezed=True)
    return _otherwise(want, plain, form, row, operators)


def _otherwise(want: Want, plain: str, form: str, row: State, operators: Operators) -> Want:
    """Return a food that is asked in a state which no heat and no squeezing gives: as hands make it, or as it is sold.

    ``plain`` is the state in which it is sold, ``form`` how it is handled then.
    """
    known, facts, state = operators.known, want.facts, want.asked
    if wants_a_mill(state, facts, known) and not any(is_mill(way, known) for way in operators.making(state)):
        ground = facts.is_a(*word_list("is sold ground")) or not facts.traits
        return replace(want, leaf=(state,), bought_so=True) if ground else replace(want, read_as=plain)
    if state in word_list("has no shell any more") and facts.is_a(*word_list("runs out of its shell")):
        boiled = min(word_list("is boiled so"))
        return replace(want, make=boiled, cooked=True, read_as=boiled)
    ends = state in word_list("is cut off at the ends") and facts.is_a("vegetable") and form == "whole"
    can = ends or _can_be_made(want, form, row, operators)
    alone = replace(want, make=state) if can else replace(want, read_as=plain)
    return _done_by_others(want, row, operators) or alone


def is_mill(way: Way, known: Tables) -> bool:
    """Whether what is hard is ground in this way."""
    return not _MILLS.isdisjoint(known.motion(way[0]).does)


def _misread(want: Want) -> Want | None:
    """Return a food whose asked state says nothing of it alone, or needs a machine: as something like it."""
    sold = want.facts.sold_as
    piece = sold in word_list("is one piece of it") and want.asked in word_list("is no state of a piece")
    if piece or want.asked in word_list("says nothing of one food"):
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
    if row.earns & FROM_A_CAN and canned.sold_as == _CANNED:
        return replace(want, facts=canned, leaf=(_CANNED,), storage=canned.sold_in, read_as=_CANNED)
    if row.earns and row.earns <= ADVISED and row.earns != RINSED and "boil" in want.facts.owes:
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
    if small and row.earns == {"cut"} and (row.fine or 0) < POWDER:
        return False  # flakes are as good as shreds, and nothing holds them to be cut
    if row.earns == RINSED:
        return form in {"whole", "pieces"} or _CANNED in want.leaf
    melts = asked in word_list("is so when it has melted") and facts.is_a("fat") and not facts.is_a("liquid")
    if melts or (asked in word_list("is mashed so") and facts.is_a(*word_list("is mashed as it is sold"))):
        return True
    return None


def _is_made_here(want: Want, form: str, row: State, operators: Operators) -> bool:
    """Whether the FOON shows how a state, that of ``row``, is given to such a food."""
    facts = want.facts
    ways = [way for way in operators.giving.get(want.asked, ()) if not operators.known.motion(way[0]).does <= BRINGS]
    if form in {"liquid", "powder", "soft"} and not any(operators.attested(w, want.names, act=True) for w in ways):
        return False
    if facts.is_a("fat", "creamy") and (row.fine or 0) >= POWDER:
        return False
    if any(operators.attested(way, want.names, act=True) for way in operators.making(want.asked)):
        return True
    if facts.is_a("stock", "ready") and (row.fine or 0) in {0, POWDER}:
        return False
    return bool(row.fine) or bool(row.earns & facts.owes.keys())


def wants_a_mill(state: str, facts: Food, known: Tables) -> bool:
    """Whether a food is asked so fine that only a mill makes it, or a mortar: a knife does it where it is soft."""
    row = known.state(state)
    fine = (row.fine or 0) >= POWDER and row.earns == {"cut"}
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
