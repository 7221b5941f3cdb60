"""The demo's FOON keeps what the demo promises: every subgraph can be executed, and their paths part and meet.

The simulation here is the test's own and stricter than the contract: a food, or a vessel with food, is gone once
a unit has taken it and not put it out again.
"""

import json
import re
from collections import defaultdict
from pathlib import Path

import pytest

from foon_kg.food import singular
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.loaders import ReadResult, read_path
from foon_kg.model import DISH_TYPES, FunctionalUnit, ObjectNode, Subgraph
from foon_kg.plans.kitchen import Kitchen

KITCHEN = Kitchen.default()
DISHES = {"salad": 5, "omelette": 4, "drinks": 5, "soup": 4}
STAGES = frozenset({"partly cooked"})
SAME_IN_THE_PLURAL = frozenset({"berries", "leaves"})
RESULTS: list[ReadResult] = sorted(read_path(demo_folder()), key=lambda result: str(result.path))
SUBGRAPHS: list[Subgraph] = [result.subgraph for result in RESULTS if result.subgraph is not None]
every_recipe = pytest.mark.parametrize("path", demo_recipes(), ids=lambda path: path.stem)

SPELLING = """
and apple attach attached bacon bag banana bean beat beaten bell berries black blend blended blender block board
boil boiled boiling bottle bouillon bowl box brewed browned butter can canned carrot carton celery cheddar
cheese chop chopped cinnamon clean closed clove cocoa coconut cold cook cooked cool cooled core cored cover
covered crack cracked cream creamy crumble crumbled cube cucumber cumin cup cut cutting detach dice diced drain
drained dressing dried drinking drop dry egg empty farmhouse faucet feta fill flip flipped fold folded fork
fried from frozen fruit fry frying garden garlic ginger glass granulated grate grated grater greek grind ground
halved hand heat honey hot hull hulled ice iced jar jug juice kettle knife ladle leaves lemon lemonade lentil
lettuce lid liquid mayonnaise meat melt melted milk milkshake mill mince minced mint mix mixed mixer mixture mug
mushroom napkin off oil olive omelette on onion open opener orange oregano packet pan parsley partly peel peeled
peeler pepper peppercorn pick pickle pitcher place plate pot potato pour powder preheat processed pumpkin punch
quartered raisin raw ready remove rinse rinsed salad salt saucepan sauteed scissors scoop scrape seasoned seeded
seeds shake shaker simmer slice sliced slide smoothie snip solid soup spanish sparkling spatula spoon sprinkle
squeeze squeezer steep stem stir stock stove strain strained strainer strawberry sugar syrup tea tear thick to
tomato torn toss turn uncover under vegetable wash washed water whisk whole winter wipe with yogurt
"""
KNOWN_WORDS = frozenset(SPELLING.split())


def units_of(subgraph: Subgraph) -> list[FunctionalUnit]:
    return [annotation.unit for annotation in subgraph.annotations]


def nodes_of(subgraph: Subgraph) -> set[ObjectNode]:
    return {node for unit in units_of(subgraph) for node in (*unit.input_nodes, *unit.output_nodes)}


def leaves_of(subgraph: Subgraph) -> set[ObjectNode]:
    """The inputs that no earlier unit puts out."""
    made: set[ObjectNode] = set()
    leaves: set[ObjectNode] = set()
    for unit in units_of(subgraph):
        leaves |= set(unit.input_nodes) - made
        made |= set(unit.output_nodes)
    return leaves


def goal_of(subgraph: Subgraph) -> ObjectNode:
    goals = [p.node for p in units_of(subgraph)[-1].outputs if p.dish_type is not None]
    assert len(goals) == 1
    return goals[0]


def dish_type_of(subgraph: Subgraph) -> str:
    return next(p.dish_type for p in units_of(subgraph)[-1].outputs if p.dish_type is not None)


def holds_food(node: ObjectNode) -> bool:
    return KITCHEN.is_food(node) or bool(KITCHEN.foods_in(node))


def producers() -> dict[ObjectNode, set[str]]:
    found: dict[ObjectNode, set[str]] = defaultdict(set)
    for subgraph in SUBGRAPHS:
        for unit in units_of(subgraph):
            for node in unit.output_nodes:
                found[node].add(unit.key)
    return found


def test_every_file_loads_without_a_single_notice() -> None:
    assert len(RESULTS) == len(SUBGRAPHS) == len(list(demo_folder().glob("*.txt")))
    assert [notice for result in RESULTS for notice in result.notices] == []


def test_there_are_enough_recipes_of_each_dish_type() -> None:
    counts = {dish: sum(dish_type_of(s) == dish for s in SUBGRAPHS) for dish in DISHES}
    assert all(counts[dish] >= least for dish, least in DISHES.items())
    assert sum(counts.values()) == len(SUBGRAPHS)


def test_a_subgraph_runs_in_order_and_nothing_is_taken_twice() -> None:
    for subgraph in SUBGRAPHS:
        there: set[ObjectNode] = set(leaves_of(subgraph))
        for position, unit in enumerate(units_of(subgraph)):
            missing = [str(node) for node in unit.input_nodes if node not in there]
            assert missing == [], f"{subgraph.name}: unit {position} ({unit.motion}) lacks {missing}"
            there -= {node for node in unit.input_nodes if holds_food(node)}
            there |= set(unit.output_nodes)


def test_every_leaf_is_at_hand() -> None:
    for subgraph in SUBGRAPHS:
        assert [str(leaf) for leaf in leaves_of(subgraph) if not KITCHEN.has(leaf)] == [], subgraph.name


def test_a_device_is_turned_on_by_the_subgraph_itself() -> None:
    for subgraph in SUBGRAPHS:
        assert [str(leaf) for leaf in leaves_of(subgraph) if KITCHEN.is_running(leaf)] == [], subgraph.name


def test_every_unit_changes_something_and_leads_to_the_goal() -> None:
    for subgraph in SUBGRAPHS:
        wanted = {goal_of(subgraph)}
        units = units_of(subgraph)
        assert len({unit.key for unit in units}) == len(units), subgraph.name
        for unit in reversed(units):
            assert not set(unit.output_nodes) <= set(unit.input_nodes), subgraph.name
            assert wanted & set(unit.output_nodes), f"{subgraph.name}: {unit.motion} leads nowhere"
            wanted |= set(unit.input_nodes)


def test_the_goal_names_exactly_the_foods_that_were_taken_from_the_kitchen() -> None:
    for subgraph in SUBGRAPHS:
        taken = {leaf.label for leaf in leaves_of(subgraph) if KITCHEN.is_food(leaf)}
        poured_away = taken - set(goal_of(subgraph).ingredients)
        assert poured_away <= {"water"}, subgraph.name  # in which potatoes boiled
        assert set(goal_of(subgraph).ingredients) <= taken, subgraph.name


def test_only_the_last_unit_has_a_goal_and_the_size_is_that_of_a_short_video() -> None:
    for subgraph in SUBGRAPHS:
        *before, _ = units_of(subgraph)
        assert [p for unit in before for p in (*unit.inputs, *unit.outputs) if p.dish_type] == [], subgraph.name
        assert 8 <= len(subgraph.annotations) <= 30, subgraph.name


def test_no_time_and_no_address_is_invented() -> None:
    for subgraph in SUBGRAPHS:
        assert subgraph.sources == (), subgraph.name
        assert all(a.timing.assumed and not a.timing.spans for a in subgraph.annotations), subgraph.name


def test_every_word_is_spelt_as_in_the_list_and_every_name_is_singular() -> None:
    for subgraph in SUBGRAPHS:
        nodes = nodes_of(subgraph)
        names = (
            {n.label for n in nodes} | {i for n in nodes for i in n.ingredients} | {n.container or "" for n in nodes}
        )
        states = {state for node in nodes for state in node.states}
        motions = {unit.motion for unit in units_of(subgraph)}
        spelt = {word for text in names | states | motions for word in re.findall(r"[^\W_]+", text)}
        assert spelt - KNOWN_WORDS == set(), subgraph.name
        assert {name for name in names if name and singular(name) != name.lower()} <= {"scissors", "smoothie"}, (
            subgraph.name
        )
        assert {s for s in states if not s.endswith("ss") and s.endswith("s")} <= SAME_IN_THE_PLURAL, subgraph.name


def test_the_same_step_in_several_videos_is_one_unit() -> None:
    keys = [unit.key for subgraph in SUBGRAPHS for unit in units_of(subgraph)]
    shared = {key for key in keys if keys.count(key) > 1}
    assert len(shared) >= 40
    assert len(set(keys)) < 0.75 * len(keys)


def test_paths_branch_at_many_object_nodes_that_have_to_be_made() -> None:
    branching = [n for n, units in producers().items() if len(units) > 1 and KITCHEN.is_food(n) and not KITCHEN.has(n)]
    assert len(branching) >= 8


@pytest.mark.parametrize(
    "node",
    [
        ObjectNode("onion", ("chopped",), (), "on", "cutting board"),
        ObjectNode("egg", ("beaten",), (), "in", "bowl"),
        ObjectNode("lemon", ("juice",), (), "in", "bowl"),
        ObjectNode("dressing", ("mixed",), ("lemon", "olive oil", "salt"), "in", "salad bowl"),
        ObjectNode("water", ("boiling",), (), "in", "jug"),
        ObjectNode("butter", ("melted",), (), "in", "frying pan"),
    ],
    ids=str,
)
def test_a_well_known_step_has_two_ways(node: ObjectNode) -> None:
    assert len(producers()[node]) == 2


def test_half_made_dishes_are_never_goals() -> None:
    assert all(not STAGES & set(goal_of(subgraph).states) for subgraph in SUBGRAPHS)


@every_recipe
def test_a_recipe_asks_for_a_dish_that_nobody_recorded(path: Path) -> None:
    recipe = json.loads(path.read_text(encoding="utf-8"))
    assert recipe["id"] == path.stem
    assert recipe["type"] in DISH_TYPES
    asked = {(wanted["object"], wanted["state"]) for wanted in recipe["ingredients"]}
    assert len(asked) == len(recipe["ingredients"]) >= 3
    for subgraph in SUBGRAPHS:
        assert {name for name, _ in asked} != set(goal_of(subgraph).ingredients), subgraph.name


def test_the_recipes_ask_for_foods_and_states_that_the_foon_has_never_seen() -> None:
    foods = {(n.label, s) for subgraph in SUBGRAPHS for n in nodes_of(subgraph) for s in n.states}
    asked = {(w["object"], w["state"]) for p in demo_recipes() for w in json.loads(p.read_text())["ingredients"]}
    unseen_foods = {name for name, _ in asked} - {name for name, _ in foods}
    unseen_states = {pair for pair in asked - foods if pair[0] not in unseen_foods}
    assert len(demo_recipes()) >= 6
    assert len(unseen_foods) >= 4
    assert unseen_states
