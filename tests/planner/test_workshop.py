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
