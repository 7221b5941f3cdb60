"""What a recipe asks of its foods, as it is understood: sold so, made so, or a crude word for something.

A state in which shops sell a food, or which says nothing of it, is that in which the kitchen has it. Another one is
made: by heat, by squeezing, by hand, or by nobody, and then it is bought so.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from foon_kg.food import Food, Tables, singular, words
from foon_kg.food.lists import says, word_list, word_lists
from foon_kg.food.rows import POWDER, State
from foon_kg.food.told_states import asked_state, in_turn
from foon_kg.food.workings import working
from foon_kg.integration.preparing.entitled import as_entitled, is_bought_so
from foon_kg.integration.preparing.preparation import (
    BRINGS,
    CANNED,
    FROM_A_CAN,
    JUICE,
    RINSED,
    Want,
    is_mill,
    owed,
    package_of,
    wants_a_mill,
)
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.operators import Operators, Way
from foon_kg.model import RequiredIngredient
from foon_kg.world.treatment import ADVISED

_MEANT = (
    ("is flat when it is flesh", "is flesh", True, "is beaten flat"),
    ("is peeled where it is no flesh", "is flesh", False, "has no peel any more"),
    ("is so out of a press", "is crushed with a knife", True, "is crushed out of a press"),
)
"""Lists of states; of foods; whether these mean it, or all others; of what is meant."""


def wants_of(
    ingredients: Iterable[RequiredIngredient], known: Tables, operators: Operators, title: str = ""
) -> tuple[Want, ...]:
    """Return the distinct ``ingredients`` in their order, each with its state as it is understood.

    ``title`` says what the recipe left out; ``known`` are the tables, ``operators`` what the FOON shows.
    """
    distinct: dict[RequiredIngredient, tuple[int, ...]] = {}
    for place, one in enumerate(one for one in ingredients if one.object):
        distinct[one] = (*distinct.get(one, ()), place)
    found = []
    for number, (one, places) in enumerate(distinct.items(), start=1):
        want = replace(_in_turn(number, one, known, operators), part=one.part, places=places)
        found.append(_in_a_package(as_entitled(_cut_by_name(want, known), title, known, operators)))
    return tuple(found)


def _in_turn(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    """Return a required food of whose state several things are told: what heat made of it, and how it is cut then."""
    *before, last = in_turn(asked_state(in_turn(one.state), known)) or ("",)
    want = understood(number, replace(one, state=last), known, operators)
    if not before:
        return replace(want, as_written=one.state) if want.asked != one.state else want
    first = understood(number, replace(one, state=before[-1]), known, operators)
    if want.cooked and _divides(first.make, known):
        return replace(first, cooked=True, as_written=one.state)
    divided = _divided_then(want, first, last, known)
    if first.cooked:
        return replace(first, then=divided, as_written=one.state)
    if before[-1] in word_list("is in a can") | word_list("is bought so before it is cut"):
        return replace(first, make=divided, as_written=one.state)
    return replace(want, as_written=one.state)


def _divided_then(want: Want, first: Want, last: str, known: Tables) -> str:
    """Return how the food ``want`` is divided at ``last``, once it is as ``first`` has it; ``""`` where it is not.

    What is sold ground is bought whole where it is to be toasted before. ``known`` are the tables.
    """
    toasted = first.cooked and first.facts.is_any(word_list("is toasted by itself"))
    state = last if toasted else want.make
    return state if _divides(state, known) else ""


def _divides(state: str, known: Tables) -> bool:
    """Whether a state that has to be made is one of pieces."""
    return bool(state) and known.state(state).fineness > 0


def _cut_by_name(want: Want, known: Tables) -> Want:
    """Return a food that is cut as its name says (lime wedge), or grated off the whole (zest), if no state is asked."""
    shape = words(want.label)[-1:]
    grated_off = want.facts.is_any(word_list("is grated off the whole"))
    as_sold = grated_off and want.asked == want.facts.sold_as
    if want.asked and not as_sold and not known.state(want.asked).undivided:
        return want
    if grated_off:
        return replace(want, make=min(word_list("only grates")), leaf=("whole",))
    cut = want.facts.sold_as == "whole" and says(shape, "is cut so by name")
    return replace(want, make=shape[0]) if cut else want


def understood(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    """Return ``one`` required food, called by ``number``, with its state as it is understood.

    It is sold so, made so, or the state is a crude word for something. ``known`` are the tables, ``operators`` what the
    FOON shows.
    """
    state = _meant(one, known, operators)
    if state == one.state:
        return _as_asked(number, one, known, operators)
    return replace(_as_asked(number, replace(one, state=state), known, operators), asked=one.state)


def _meant(one: RequiredIngredient, known: Tables, operators: Operators) -> str:
    """Return the state that the asked one means for ``one`` food; see :func:`understood` for the other arguments."""
    state = one.state if operators.giving.get(one.state) else known.state_called(one.state)
    fine = state in word_list("is so when it is grated off")
    fine = fine and _is_grated_off(one.object, known.foods.food(one.object, [state]), known)
    if fine or state in word_list("asks for what is grated off"):
        return min(word_list("is grated off the whole"))
    facts = known.foods.food(one.object)
    rows = ((foods, fit, meant) for states, foods, fit, meant in _MEANT if state in word_list(states))
    fitting = (meant for foods, fit, meant in rows if facts.is_any(word_list(foods)) is fit)
    return next((min(word_list(meant)) for meant in fitting), state)


def _in_a_package(want: Want) -> Want:
    """Return a food that is sold free, but not in the state in which the kitchen has it: nobody keeps crumbs so."""
    return want if want.storage else replace(want, storage=package_of(want.leaf))


def _as_asked(number: int, one: RequiredIngredient, known: Tables, operators: Operators) -> Want:
    """Return a required food in its own state, as that is understood; see :func:`understood` for the arguments."""
    state, facts = one.state, _facts(one, known)
    plain = _plain_leaf(one.object, facts, state, known)
    want = Want(number, one.object, state, facts, (plain,) if plain else (), facts.sold_in)
    # first what no table of states can know (a crude word, a foam), then sold so, then by heat, then by hand or nobody
    other = _misread(want) or _worked_or_foamed(want, known)
    if other is not None or not state:
        return other or want
    bought = _as_bought(want)
    if bought is not None:
        return bought
    row = known.state(state)
    if _is_had_so(facts, row):
        return _as_had(want, plain, known, operators)
    if _is_given_by_heat(want, row):
        return _as_heated(want, known)
    return _otherwise(want, row, operators)


def _as_bought(want: Want) -> Want | None:
    """Return a food that is asked as a shop has it; ``None`` where it is not asked so."""
    facts, state = want.facts, want.asked
    if facts.sold_as == state:
        return replace(want, leaf=(state,))
    if facts.is_any(word_lists().get(f"is bought {state}", ())):
        return replace(want, leaf=(state,), bought_so=True)
    ready = facts.is_any(word_list("is ready when it is bought"))
    return want if ready and state in word_list("is so when it is bought ready") else None


def _facts(one: RequiredIngredient, known: Tables) -> Food:
    """Return what is known of a food in the asked state; if its juice is asked, not of what is left of it."""
    facts = known.foods.food(one.object, [one.state] if one.state else [])
    return known.foods.food(one.object) if JUICE in one.state and facts.is_a("remains") else facts


def _is_had_so(facts: Food, row: State) -> bool:
    """Whether a shop sells a food so, or its state says of nothing that was done to it."""
    return row.sold or facts.is_a(*row.sold_for) or not (row.earns or row.fine or row.half)


def _as_had(want: Want, plain: str, known: Tables, operators: Operators) -> Want:
    """Return a food that is asked as it is had: so, as it is sold (``plain``), or with what is still to be done."""
    raw = want.facts.is_any(word_list("is chilled raw"))
    if not raw and want.asked in word_list("only what was cooked is so") and {"cook", "boil"} & owed(want, known):
        return replace(want, cooked=True)
    if want.asked in word_list("is only made warm") and want.facts.is_any(word_list("is warmed alone")):
        return replace(want, make=want.asked)
    if _taken_at_its_word(want, plain, known, operators):
        return replace(want, leaf=(want.asked,))
    return want


def _is_given_by_heat(want: Want, row: State) -> bool:
    by_boiling = want.asked in word_list("is so by boiling") and want.facts.is_a("vegetable")
    return by_boiling or (row.needs_heat and "cook" in row.earns)


def _as_heated(want: Want, known: Tables) -> Want:
    """Return a food that is asked cooked: by itself, where it is a thing that can be; else as it is sold."""
    form = form_of(known, want.label, want.leaf)
    whole = form in {"whole", "pieces"} and not want.facts.is_a("spice", "fat")
    toasted = want.asked in word_list("is so by dry heat") and want.facts.is_any(word_list("is toasted by itself"))
    return replace(want, cooked=True, make=want.asked) if whole or toasted else want


def _otherwise(want: Want, row: State, operators: Operators) -> Want:
    """Return a food that is asked in a state, that of ``row``, which no heat gives: as hands make it, or as sold."""
    facts, state = want.facts, want.asked
    form = form_of(operators.known, want.label, want.leaf)
    if JUICE in state and form == "whole" and operators.giving.get(JUICE):
        return replace(want, make=state, squeezed=True)
    if _lacks_a_mill(want, operators):
        return _as_ground(want)
    if state in word_list("has no shell any more") and _runs_out_of_its_shell(facts):
        return replace(want, make=min(word_list("is boiled so")), cooked=True)
    others = _done_by_others(want, row, operators)
    if others is not None:
        return others
    if not _can_be_made(want, form, row, operators):
        return want
    return replace(_without_its_shell(want, row), make=state)


def _runs_out_of_its_shell(facts: Food) -> bool:
    """Whether a food runs where its shell is opened: not what was bought boiled."""
    boiled = facts.is_any(word_list("is peeled and not cracked"))
    return facts.is_any(word_list("runs out of its shell")) and not boiled


def _without_its_shell(want: Want, row: State) -> Want:
    """Return a food that is asked in pieces, and comes in a shell that no knife cuts: its flesh is bought."""
    shelled = row.fineness > 0 and want.facts.is_any(word_list("is cut out of its shell"))
    return replace(want, leaf=(min(word_list("is sold out of its shell")),)) if shelled else want


def _lacks_a_mill(want: Want, operators: Operators) -> bool:
    """Whether a food is asked so fine that it wants a mill, and nobody has one."""
    mills = (way for way in operators.making(want.asked) if is_mill(way, operators.known))
    return wants_a_mill(want.asked, want.facts, operators.known) and next(mills, None) is None


def _as_ground(want: Want) -> Want:
    """Return a food that is asked ground where nobody has a mill: bought so, if it is sold so, else as it is sold."""
    ground = want.facts.is_any(word_list("is sold ground")) or not want.facts.traits
    return replace(want, leaf=(want.asked,), bought_so=True) if ground else want


def _misread(want: Want) -> Want | None:
    """Return a food whose asked state says nothing of it alone, or needs a machine: as something like it."""
    sold = want.facts.sold_as
    piece = sold in word_list("is one piece of it") and want.asked in word_list("is no state of a piece")
    if piece or want.asked in word_list("says nothing of one food"):
        return replace(want, leaf=(sold,) if sold else ())
    state = _cut_as(want) if want.facts.is_a("vegetable") else ""
    return replace(want, make=state) if state else None


def _cut_as(want: Want) -> str:
    """Return how a vegetable is cut that is asked as a machine or a shop cuts it; ``""`` where it is not asked so."""
    if want.asked in word_list("needs a machine") and want.facts.is_a("raw"):
        return min(word_list("is made fine by hand"))
    by_hand = want.asked in word_list("is cut by hand into it") and want.facts.sold_as != want.asked
    return min(word_list("is so when it is cut into it")) if by_hand else ""


def _worked_or_foamed(want: Want, known: Tables) -> Want | None:
    """Return a food that hands bring into the asked state in a way of its own, or a liquid that is whipped."""
    worked = working(want.asked, want.facts) is not None and not known.state(want.asked).sold
    if worked and want.asked in word_list("is so when it has thawed"):
        want = replace(want, leaf=(min(word_list("is so before it thaws")),))
    return replace(want, make=want.asked) if worked else _foamed(want, known.foods.food(want.label))


def _foamed(want: Want, before: Food) -> Want | None:
    """Return a liquid that is asked whipped, ``before`` being what is known of it as it is sold."""
    if want.asked not in word_list("is beaten to a foam") or before.sold_as == want.asked or not before.is_a("liquid"):
        return None
    return replace(want, leaf=(before.sold_as,), storage=before.sold_in, make=want.asked, foamed=True)


def _done_by_others(want: Want, row: State, operators: Operators) -> Want | None:
    """Return a food whose asked state is not given to it alone: drained of what it was canned or boiled in, smoked."""
    canned = operators.known.foods.food(want.label, [CANNED])
    if row.earns & FROM_A_CAN and canned.sold_as == CANNED:
        return replace(want, facts=canned, leaf=(CANNED,), storage=canned.sold_in)
    if row.earns and row.earns <= ADVISED and row.earns != RINSED and "boil" in want.facts.owes:
        return replace(want, cooked=True)
    return replace(want, leaf=(want.asked,), bought_so=True) if is_bought_so(row, want.asked, operators) else None


def _taken_at_its_word(want: Want, plain: str, known: Tables, operators: Operators) -> bool:
    """Whether a food is had as it is asked: the FOON has it so, or it is undivided."""
    if any(want.asked in operators.states[name] for name in (singular(want.label), f"kind:{want.facts.kind}")):
        return True
    return known.state(want.asked).undivided or form_of(known, want.label, (plain,)) == "whole"


def _can_be_made(want: Want, form: str, row: State, operators: Operators) -> bool:
    """Whether the asked state, that of ``row``, can be given to a food of such a form."""
    told = _is_known_to_be_made(want, form, row)
    return told if told is not None else _is_made_here(want, form, row, operators)


def _is_trimmed_here(want: Want, form: str) -> bool | None:
    """Whether a cook trims a food that is asked so and is sold in a ``form``; ``None`` where that is not told.

    A butcher trims flesh: it has no ends that a cook cuts off.
    """
    if want.asked not in word_list("is cut off at the ends"):
        return None
    if want.facts.is_any(word_list("is flesh") | word_list("is trimmed when it is bought")):
        return False
    return True if want.facts.is_a("vegetable") and form == "whole" else None


def _is_known_to_be_made(want: Want, form: str, row: State) -> bool | None:
    """Whether a state can be given to a food by what is known of both; ``None`` where the FOON has to show it."""
    if (trimmed := _is_trimmed_here(want, form)) is not None:
        return trimmed
    if _is_too_small_to_be_cut(want, row):
        return False
    if row.earns == RINSED:
        return form in {"whole", "pieces"} or CANNED in want.leaf or row.earns <= want.facts.owes.keys()
    return True if _is_peeled_here(want, form) or _melts(want) or _is_mashed_as_sold(want) else None


def _is_peeled_here(want: Want, form: str) -> bool:
    """Whether a food is asked peeled that has a peel, though not all who eat it mind that."""
    peeled = form == "whole" and want.asked in word_list("has no peel any more")
    return peeled and want.facts.is_any(word_list("is peeled where it is asked"))


def _is_too_small_to_be_cut(want: Want, row: State) -> bool:
    """Whether pieces are asked of flakes: they are as good as shreds, and nothing holds them to be cut."""
    small = says(want.leaf, "is too small for a grater")
    return small and row.earns == {"cut"} and row.fineness < POWDER


def _melts(want: Want) -> bool:
    facts = want.facts
    return want.asked in word_list("is so when it has melted") and facts.is_a("fat") and not facts.is_a("liquid")


def _is_mashed_as_sold(want: Want) -> bool:
    return want.asked in word_list("is mashed so") and want.facts.is_any(word_list("is mashed as it is sold"))


def _is_made_here(want: Want, form: str, row: State, operators: Operators) -> bool:
    """Whether the FOON shows how a state, that of ``row``, is given to such a food."""
    facts, powder = want.facts, row.fineness >= POWDER
    if _keeps_its_form(want, form, row) and not _is_worked_so(want, operators):
        return False
    if powder and facts.is_a("fat", "creamy"):
        return False
    if _is_shown(operators.making(want.asked), want, operators):
        return True
    if facts.is_a("stock", "ready") and (powder or not row.fine):
        return False
    return bool(row.fine) or bool(row.earns & facts.owes.keys())


def _keeps_its_form(want: Want, form: str, row: State) -> bool:
    """Whether a food runs, is a powder or is soft in its ``form``, so that no knife makes it smaller."""
    bits = row.earns == {"cut"} and row.fineness < POWDER
    cut = bits and want.facts.is_any(word_list("is cut smaller where it is asked"))
    return form in {"liquid", "powder", "soft"} and not cut


def _is_worked_so(want: Want, operators: Operators) -> bool:
    """Whether the FOON shows work on such a food that gives the asked state, and does not only bring it somewhere."""
    given = operators.giving.get(want.asked, ())
    return _is_shown((way for way in given if not operators.known.motion(way[0]).does <= BRINGS), want, operators)


def _is_shown(ways: Iterable[Way], want: Want, operators: Operators) -> bool:
    return any(operators.attested(way, want.names, act=True) for way in ways)


def _is_grated_off(label: str, facts: Food, known: Tables) -> bool:
    """Whether what is asked is only grated off the whole of that name."""
    return facts.is_any(word_list("is grated off the whole")) and known.foods.food(label).kind != facts.kind


def _plain_leaf(label: str, facts: Food, asked: str, known: Tables) -> str:
    """Return the state in which a shop sells the food, such that its name still means the same food."""
    row = known.state(asked)
    if asked in word_list("is so by a grater") and _is_grated_off(label, facts, known):
        return "whole"
    # as whom the word of its state makes it: "pepper" is a vegetable when it is whole, and a spice when it is ground
    candidates = [facts.sold_as, "whole", "whole veg", "raw", "fresh", "ground"]
    if row.sold or not (row.earns or row.fine or row.half):
        candidates.append(asked)
    for state in candidates:
        if state and known.foods.food(label, [state]).kind == facts.kind:
            return state
    return facts.sold_as
