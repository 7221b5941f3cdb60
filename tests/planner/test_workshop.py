from kitchen_stories import node, script, subgraph
from planner.dishes import KITCHEN

from foon_kg.snapshot import Snapshot
from foon_kg.workshop import gap_cost, mixtures

SALAD = (
    "bowl(empty); onion(whole) > add > bowl{onion}; onion(whole)@bowl",
    "cup(empty); bottle{oil}; oil(liquid)@bottle > pour > cup{oil}; oil(liquid)@cup",
    "cup{oil}; oil(liquid)@cup; whisk > whisk > cup{dressing}; dressing(mixed){oil}@cup",
    "cup{dressing}; dressing(mixed){oil}@cup; bowl{onion} > pour > bowl{dressing,onion}; dressing(mixed){oil}@bowl",
    "bowl{dressing,onion}; onion(whole)@bowl; spoon > mix > bowl{salad}; salad(mixed){oil,onion}@bowl",
)
FRIED = ("onion(whole); pan{butter} > fry > onion(fried){butter}@pan",)
VOCABULARY = Snapshot.of(
    [subgraph("salad", "salad", *SALAD), subgraph("fried", "vegetables", *FRIED)], KITCHEN
).vocabulary()


def test_what_is_made_and_never_bought_is_a_mixture():
    assert mixtures(KITCHEN, VOCABULARY) == {"dressing", "salad"}


def test_a_bowl_of_something_bought_costs_the_same_whether_or_not_some_other_video_fries_it_in_butter():
    names = mixtures(KITCHEN, VOCABULARY)
    part, whole = (gap_cost(KITCHEN, units, names) for units in (script(*SALAD), script(*SALAD, *FRIED)))
    assert part(node("bowl{onion}")) == whole(node("bowl{onion}"))
    assert part(node("bowl{onion}")) < part(node("bowl{dressing}"))


GAPS = (
    "stove(off) > turn on > stove(on)",
    "bowl(empty); salt(granulated) > pour > bowl{salt}",
    "pan(hot); onion(whole); leek(whole) > fry > relish(fried){leek,onion}@pan",
)
DEARER = (
    "onion(whole)@on shelf",  # an odd place
    "plate{salt}",  # a vessel that nobody fills
    "pan(hot)",  # hot, and nobody makes it so
    "bowl{salt}",  # a vessel that a unit fills
    "onion(chopped)",
    "stove(on)",  # a unit turns it on
    "sauce{onion}",  # a mixture
    "plate{leek,onion}",  # each of its foods counts
    "relish(fried){leek,onion}@pan",  # a unit makes it
)


def test_what_is_not_at_hand_costs_the_more_the_more_it_is_somebodys_work():
    cost = gap_cost(KITCHEN, script(*GAPS))
    paid = [cost(node(text)) for text in DEARER]
    assert None not in paid
    assert paid == sorted(set(paid))


def test_a_food_that_was_processed_twice_costs_twice_as_much():
    cost = gap_cost(KITCHEN, script(*GAPS))
    assert cost(node("onion(chopped,fried)")) == 2 * cost(node("onion(chopped)"))


def test_a_mixture_that_names_no_food_costs_more_than_one_of_two_where_a_unit_makes_it():
    names, units = {"dressing"}, script("oil(liquid) > whisk > dressing(mixed)@cup")
    cost = gap_cost(KITCHEN, units, names)
    assert cost(node("dressing(mixed)@cup")) > cost(node("dressing{oil,salt}"))
    assert cost(node("dressing(mixed)@jar")) < cost(node("dressing{oil}"))
