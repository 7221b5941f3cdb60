"""Foods are made ready as a cook would do it: peeled before they are cut, and cooked where nobody eats them raw."""

from __future__ import annotations

from kitchen_stories import CHOP_ONION, SALAD, subgraph, unit
from planner.dishes import KITCHEN, SETTINGS
from planner.judged import fatal

from foon_kg.model import Annotation, Recipe, RequiredIngredient, Subgraph
from foon_kg.planning.planner import plan
from foon_kg.store.snapshot import Snapshot

AVOCADO = (
    "cutting board(empty); avocado(whole) > pick-and-place > avocado(whole)@on cutting_board",
    "avocado(whole)@on cutting_board; knife > cut > avocado(slit)@on cutting_board",
    "avocado(slit)@on cutting_board > pull apart > avocado(halved)@on cutting_board",
    "avocado(halved)@on cutting_board > peel > avocado(halved,peeled)@on cutting_board",
)
STOVE = ("stove(off) > turn on > stove(on)", "stove(on) > turn off > stove(off)")
BOILED_EGG = (
    "pot(empty); stove(on); water(liquid) > heat > pot(hot){water}; water(hot)@pot",
    "pot(hot){water}; water(hot)@pot; egg(whole) > place > pot(hot){egg,water}; egg(whole)@pot",
    "pot(hot){egg,water}; egg(whole)@pot; stove(on) > boil > egg(hardboiled,whole)@pot",
    "egg(hardboiled,whole)@pot > peel > egg(hardboiled,peeled,whole)@pot",
)
FRIED_BEEF = (
    "frying pan(empty); stove(on) > heat > frying pan(empty,hot)",
    "beef(raw); frying pan(empty,hot) > place > frying pan(hot){beef}; beef(raw)@frying_pan",
    "frying pan(hot){beef}; beef(raw)@frying_pan; stove(on) > cook > beef(cooked)@frying_pan",
)
SOUP = (
    "pot(empty); water(liquid) > pour > pot{water}",
    "stove(off); pot{water} > place > pot{water}@on stove",
    "stove(off) > turn on > stove(on)",
    (
        "cutting board{onion}; onion(chopped)@on cutting_board; pot{water}@on stove"
        " > pour > pot{onion,water}@on stove; onion(chopped)@pot; cutting board(empty)"
    ),
    (
        "pot{onion,water}@on stove; onion(chopped)@pot; water(liquid)@pot; stove(on)"
        " > boil > pot{soup}@on stove; soup(cooked){onion,water}@pot"
    ),
)


def planned(dish_type, dish, known, *foods):
    """The tree of a dish of onion and more, after the judge found nothing fatal in it."""
    others = Subgraph("known", tuple(Annotation(unit(line)) for line in known))
    snapshot = Snapshot.of([subgraph("dish", dish_type, *dish), others], KITCHEN)
    result = plan(snapshot, Recipe(dish_type, tuple(RequiredIngredient(*food) for food in foods)), SETTINGS)
    assert fatal(result, snapshot) == []
    return result


def motions(result):
    return [unit.motion for unit in result.units]


def states(result, food):
    """The states in which a food joins the others."""
    units = [u for u in result.units if any(n.label == food for n in u.input_nodes)]
    into = next(u for u in units if any({"onion", food} <= {*n.ingredients} for n in u.output_nodes))
    return next(n.states for n in into.input_nodes if n.label == food)


def test_a_whole_food_is_peeled_before_it_is_cut():
    result = planned("salad", SALAD, AVOCADO, ("tomato", "diced"), ("onion", "chopped"), ("avocado", "whole"))
    own = [u for u in result.units if any(node.label == "avocado" for node in u.input_nodes)]
    assert own[0].motion == "peel"
    assert "whole" not in states(result, "avocado")


def test_meat_is_cooked_for_a_dish_that_is_not_and_the_stove_is_off_again():
    result = planned("salad", SALAD, (*STOVE, *FRIED_BEEF), ("tomato", "diced"), ("onion", "chopped"), ("beef", "raw"))
    assert states(result, "beef") == ("chopped",)
    done = motions(result)
    assert done.index("turn on") < done.index("cook") < done.index("turn off")
    later = [node for unit in result.units[done.index("turn off") :] for node in unit.input_nodes]
    assert ("beef", ("cooked",)) in {(node.label, node.states) for node in later}


def test_meat_joins_raw_what_is_cooked_later():
    result = planned(
        "soup", (*CHOP_ONION, *SOUP), (*STOVE, *FRIED_BEEF), ("onion", "chopped"), ("water", "liquid"), ("beef", "raw")
    )
    assert states(result, "beef") == ("chopped",)
    assert motions(result).index("boil") < motions(result).index("turn off")


def test_what_people_eat_raw_is_not_cooked_for_a_salad():
    fried = "tomato(diced)@on cutting_board; pan(empty); stove(on) > fry > tomato(diced,fried)@pan"
    result = planned("salad", SALAD, (*STOVE, fried), ("tomato", "whole"), ("onion", "chopped"))
    assert {"fry", "turn on"}.isdisjoint(motions(result))


def test_an_egg_is_boiled_and_peeled_for_a_salad():
    known = (*STOVE, *BOILED_EGG)
    result = planned("salad", SALAD, known, ("tomato", "diced"), ("onion", "chopped"), ("egg", "whole"))
    assert motions(result).index("boil") < len(motions(result)) - motions(result)[::-1].index("peel")
