"""What a reference tree is, shown on FOONs small enough to see through."""

import pytest

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Participant
from foon_kg.search import NoWayError, SearchProblem, UnitIndex, retrieve


def node(name: str) -> ObjectNode:
    label, _, state = name.partition(" ")
    return ObjectNode(label, (state,) if state else ())


def unit(inputs: str, motion: str, outputs: str) -> KnownUnit:
    sides = (tuple(Participant(node(name)) for name in side.split(", ")) for side in (inputs, outputs))
    return KnownUnit(FunctionalUnit(next(sides), motion, next(sides)), ())


def problem(units, goal, kitchen, *, costs=None, wanted=None, available=()):
    there, prices = set(map(node, kitchen)), {node(name): cost for name, cost in (costs or {}).items()}
    index = UnitIndex.of(units, at_hand=there.__contains__, gap_cost=prices.get)
    targets = (goal,) if isinstance(goal, str) else goal
    return SearchProblem(index, tuple(map(node, targets)), wanted or {}, frozenset(map(node, available)))


def motions(tree) -> list[str]:
    return [known.unit.motion for known in tree.units]


CHOP = unit("onion whole, knife", "chop", "onion chopped, knife")
GRATE = unit("onion whole, grater", "grate", "onion chopped, grater, onion juice")
FRY = unit("onion chopped, pan hot", "fry", "onion fried, pan hot")
HEAT = unit("pan cold", "heat", "pan hot")


def test_units_come_in_an_order_that_can_be_executed():
    tree = retrieve(problem([FRY, CHOP, HEAT], "onion fried", ["onion whole", "knife", "pan cold"]))
    assert motions(tree)[-1] == "fry"
    assert set(motions(tree)) == {"chop", "heat", "fry"}
    assert (tree.exact, tree.gaps, tree.bound) == (True, (), None)


def test_the_fewest_units_win():
    longer = [unit("onion whole", "peel", "onion peeled"), unit("onion peeled", "chop", "onion chopped")]
    tree = retrieve(problem([*longer, CHOP], "onion chopped", ["onion whole", "knife"]))
    assert tree.units == (CHOP,)


def test_overlap_goes_before_length():
    plain = unit("pan hot", "serve", "dish")
    rich = unit("pan hot, onion chopped", "serve", "dish")
    question = problem([plain, rich, CHOP], "dish", ["pan hot", "onion whole", "knife"], wanted={"onion": 3})
    tree = retrieve(question)
    assert set(tree.units) == {CHOP, rich}
    assert tree.covered == (3,)


def test_two_labels_of_one_wanted_food_count_once():
    both = unit("onion whole, shallot whole", "serve", "dish")
    wanted = {"onion": 0, "shallot": 0}
    assert retrieve(problem([both], "dish", ["onion whole", "shallot whole"], wanted=wanted)).overlap == 1


def test_a_side_product_is_not_made_again():
    mix = unit("onion chopped, onion juice", "mix", "dish")
    press = unit("onion whole", "press", "onion juice")
    tree = retrieve(problem([CHOP, GRATE, press, mix], "dish", ["onion whole", "knife", "grater"]))
    assert tree.units == (GRATE, mix)


def test_what_is_at_hand_is_never_made():
    tree = retrieve(problem([FRY, CHOP, HEAT], "onion fried", ["onion whole", "knife", "pan hot", "pan cold"]))
    assert "heat" not in motions(tree)


def test_a_goal_at_hand_is_made_all_the_same():
    assert retrieve(problem([HEAT], "pan hot", ["pan hot", "pan cold"])).units == (HEAT,)


def test_a_goal_at_hand_is_not_made_of_itself():
    with pytest.raises(NoWayError):
        retrieve(problem([unit("soup", "stir", "soup, foam")], "soup", ["soup"]))


def test_there_is_no_gap_where_there_is_a_way_round_however_long():
    peel, core = unit("onion whole", "peel", "onion peeled"), unit("onion peeled", "core", "onion cored")
    chop = unit("onion cored", "chop", "onion chopped")
    tree = retrieve(
        problem([peel, core, chop, FRY], "onion fried", ["onion whole", "pan hot"], costs={"onion chopped": 1})
    )
    assert tree.gaps == ()
    assert len(tree.units) == 4


def test_the_cheapest_gaps_are_taken_and_each_is_paid_once():
    left = unit("pan hot, onion whole", "left", "left")
    right = unit("pan hot, onion whole", "right", "right")
    join = unit("left, right", "join", "dish")
    costs = {"pan hot": 10, "left": 6, "right": 6}
    tree = retrieve(problem([left, right, join], "dish", ["onion whole"], costs=costs))
    assert tree.gaps == (node("pan hot"),)
    assert tree.penalty == 10


def test_a_circle_is_no_way():
    there, back = unit("bowl full", "empty", "bowl empty"), unit("bowl empty", "fill", "bowl full")
    with pytest.raises(NoWayError) as stopped:
        retrieve(problem([there, back], "bowl full", []))
    assert stopped.value.missing == (node("bowl full"), node("bowl empty"))


def test_what_is_missing_is_named_the_nearest_first():
    far = unit("saffron", "grind", "spice")
    near = unit("spice, truffle", "mix", "dish")
    with pytest.raises(NoWayError) as stopped:
        retrieve(problem([far, near], "dish", ["onion whole"]))
    assert stopped.value.missing == (node("truffle"), node("saffron"))
    assert (stopped.value.code, stopped.value.exit_code) == ("no-way", 3)
    assert "truffle; saffron" in stopped.value.message


def test_a_goal_that_no_unit_knows_is_itself_what_is_missing():
    with pytest.raises(NoWayError) as stopped:
        retrieve(problem([CHOP], "unicorn", ["onion whole"]))
    assert stopped.value.missing == (node("unicorn"),)


def test_the_best_of_several_targets_is_made():
    targets = ["onion fried", "onion chopped"]
    tree = retrieve(problem([FRY, CHOP, HEAT], targets, ["onion whole", "knife", "pan cold"]))
    assert tree.goal == node("onion chopped")


def test_what_is_available_costs_nothing():
    question = problem([FRY, CHOP, HEAT], "onion fried", ["pan cold"], available=["onion chopped"])
    assert motions(retrieve(question)) == ["heat", "fry"]


def test_an_available_target_needs_no_unit():
    tree = retrieve(problem([FRY, CHOP, HEAT], ["onion fried", "pan hot"], ["pan cold"], available=["onion fried"]))
    assert (tree.goal, tree.units, tree.exact) == (node("onion fried"), (), True)


def test_a_unit_that_makes_nothing_new_is_never_used():
    idle = unit("onion whole, truffle", "look", "truffle")
    index = UnitIndex.of([idle, CHOP], at_hand=lambda _: True)
    assert index.units == (CHOP,)


@pytest.mark.parametrize("cost", [0, -3])
def test_a_gap_must_cost_something(cost):
    with pytest.raises(ValueError, match="must be 1 or more"):
        UnitIndex.of([CHOP], at_hand=lambda _: False, gap_cost=lambda _: cost)


def test_a_search_that_is_out_of_time_says_so_and_its_bound_holds():
    routes = [unit(f"a{k}", f"way{m}", f"a{k + 1}, side{m}") for k in range(6) for m in range(3)]
    join = unit("a6, side1, side2", "join", "dish")
    question = problem([*routes, join], "dish", ["a0"], wanted={"side1": 0, "side2": 1})
    hurried, best = retrieve(question, time_limit=0.0), retrieve(question, time_limit=None)
    assert not hurried.exact
    assert best.exact
    assert hurried.bound is not None
    assert hurried.bound.penalty <= best.penalty
    assert hurried.bound.overlap >= best.overlap
    assert hurried.bound.units <= len(best.units)


def test_one_index_answers_many_questions_alike():
    units = [FRY, CHOP, HEAT, GRATE]
    whole = problem(units, "onion fried", ["onion whole", "knife", "pan cold"])
    again = SearchProblem(whole.index, (node("onion chopped"),))
    alone = problem([CHOP, GRATE], "onion chopped", ["onion whole", "knife"])
    assert retrieve(again) == retrieve(again)
    assert retrieve(again).units == retrieve(alone).units
