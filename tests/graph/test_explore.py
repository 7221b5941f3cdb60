"""The queries for people: each gives what a plain walk over the demo FOON's files gives."""

from __future__ import annotations

import json
from collections import Counter, deque
from itertools import combinations, pairwise

import pytest
from demo_foon import demo_foon, demo_subgraphs

from foon_kg.cli.named_queries import explore_query, values
from foon_kg.cypher import explore_queries
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely

every_query = pytest.mark.parametrize("query", explore_queries(), ids=lambda query: query.name)

SUBGRAPHS = demo_subgraphs()
SNAPSHOT = demo_foon()
UNITS = {a.unit for subgraph in SUBGRAPHS for a in subgraph.annotations}
VIDEOS = {s.name: [annotation.unit for annotation in s.annotations] for s in SUBGRAPHS}
FOODS = {row.label for row in SNAPSHOT.vocabulary().foods}


@pytest.fixture(scope="module")
def connection(emptied_server):
    with Connection(emptied_server) as connection:
        load(connection, SUBGRAPHS)
        yield connection


def ask(connection, name, **given):
    query = explore_query(name)
    answer = ask_freely(connection, query.text, values(query, given))
    assert answer.columns == query.columns
    return [tuple(row) for row in answer.rows]


def units_of(subgraph):
    return [annotation.unit for annotation in subgraph.annotations]


def labels(nodes):
    return sorted({node.label for node in nodes})


def seen():
    return ((subgraph.name, step, unit) for subgraph in SUBGRAPHS for step, unit in enumerate(units_of(subgraph)))


@pytest.mark.neo4j
@every_query
def test_its_example_has_an_answer_or_nothing_is_missing(connection, query):
    rows = ask_freely(connection, query.text, values(query, query.examples)).rows
    assert bool(rows) == (query.name != "made_by_nobody")


@pytest.mark.neo4j
def test_the_videos_that_chop_onion(connection):
    expected = {
        (name, step) for name, step, unit in seen() if unit.motion == "chop" and "onion" in labels(unit.input_nodes)
    }
    found = ask(connection, "motion_on_food", food="onion", motion="chop")
    assert {(video, step) for video, step, _, _ in found} == expected
    assert len(found) == len(expected)


@pytest.mark.neo4j
def test_the_names_of_a_graph_are_those_of_its_files(connection):
    found = {}
    for kind, name in ask(connection, "names"):
        found.setdefault(kind, set()).add(name)
    assert found["thing"] == {label for unit in UNITS for label in labels((*unit.input_nodes, *unit.output_nodes))}
    assert found["motion"] == {unit.motion for unit in UNITS}
    assert found["video"] == VIDEOS.keys()
    assert found["state"] == {row.state for row in SNAPSHOT.vocabulary().foods if row.state}
    assert found["dish type"] == {goal.dish_type for goal in SNAPSHOT.goals()}
    assert "oil" in found["kind of food"]


@pytest.mark.neo4j
@pytest.mark.parametrize(
    "asked", ["MATCH (m:Motion {verb: 'chop'}) RETURN count(m)", explore_query("next_motions").text]
)
def test_units_are_found_by_their_verb_without_a_look_at_all(connection, asked):
    with connection.session() as session:  # plans, and how much is where, are of when nothing was there yet
        session.run("CALL db.prepareForReplanning(60)").consume()
    plan = " ".join(map(str, ask_freely(connection, f"EXPLAIN {asked}", {"motion": "chop", "most": 1}).rows))
    assert "IndexSeek" in plan
    assert "LabelScan" not in plan


@pytest.mark.neo4j
def test_the_motions_that_make_a_state_are_those_of_units_that_bring_it(connection):
    def makes(unit):
        before, after = ([n for n in nodes if n.label == "onion"] for nodes in (unit.input_nodes, unit.output_nodes))
        return any("chopped" in n.states for n in after) and not any("chopped" in n.states for n in before)

    found = ask(connection, "makers_of_state", food="onion", state="chopped")
    assert {(motion, units) for motion, units, _ in found} == set(Counter(u.motion for u in UNITS if makes(u)).items())
    assert {video for *_, videos in found for video in videos} == {name for name, _, unit in seen() if makes(unit)}


@pytest.mark.neo4j
def test_the_states_of_a_food_are_those_of_the_vocabulary(connection):
    expected = {(row.state, row.made, row.used) for row in SNAPSHOT.vocabulary().foods if row.label == "onion"}
    assert set(ask(connection, "states_of_food", food="onion")) == expected


@pytest.mark.neo4j
def test_the_motion_of_each_state_is_the_one_that_most_units_make_it_with(connection):
    counts = {}
    for row in SNAPSHOT.vocabulary().motions:
        counts.setdefault(row.state, {})[row.motion] = row.count
    found = {state: row for state, *row in ask(connection, "motions_of_states")}
    assert found.keys() == counts.keys()
    for state, (motion, units, of) in found.items():
        assert (units, of) == (max(counts[state].values()), sum(counts[state].values()))
        assert motion == min(name for name, count in counts[state].items() if count == units)
    assert (found["sliced"][0], found["chopped"][0]) == ("slice", "chop")


@pytest.mark.neo4j
def test_dishes_with_two_foods_are_the_goals_that_have_both(connection):
    foods = {"onion", "tomato"}
    expected = {
        (g.node.label, tuple(sorted(set(g.node.ingredients) - foods)))
        for g in SNAPSHOT.goals()
        if foods <= set(g.node.ingredients)
    }
    found = ask(connection, "dishes_with_foods", foods="onion, tomato")
    assert {(dish, tuple(others)) for dish, _, others in found} == expected


@pytest.mark.neo4j
def test_what_can_be_made_needs_no_other_utensil(connection):
    used = {s.name: {n.label for u in units_of(s) for n in u.input_nodes} - FOODS for s in SUBGRAPHS}
    utensils = used["lemonade"] | used["iced_tea"]
    found = ask(connection, "makeable_with_utensils", utensils=json.dumps(sorted(utensils)))
    assert {video for _, _, video, _ in found} == {name for name, needs in used.items() if needs <= utensils}
    assert all(set(shown) == used[video] for _, _, video, shown in found)


@pytest.mark.neo4j
def test_two_videos_meet_in_the_units_that_both_show(connection):
    units = {s.name: units_of(s) for s in SUBGRAPHS}
    first, second = units["garden_salad"], units["greek_salad"]
    expected = {(i, j) for i, one in enumerate(first) for j, other in enumerate(second) if one == other}
    found = ask(connection, "where_dishes_meet", first="garden_salad", second="greek_salad")
    assert {(step, other) for step, *_, other in found} == expected


@pytest.mark.neo4j
def test_relatives_share_units(connection):
    units = {s.name: set(units_of(s)) for s in SUBGRAPHS}
    shared = {name: len(units["greek_salad"] & theirs) for name, theirs in units.items() if name != "greek_salad"}
    expected = sorted((-count, name, len(units[name])) for name, count in shared.items() if count)
    found = ask(connection, "relatives_of_dish", video="greek_salad", most="1000")
    assert [(-count, name, size) for name, count, size in found] == expected


@pytest.mark.neo4j
def test_the_central_objects_take_part_in_the_most_units(connection):
    units = Counter(label for unit in UNITS for label in labels(unit.input_nodes + unit.output_nodes))
    expected = sorted((-count, label, "food" if label in FOODS else "utensil") for label, count in units.items())[:9]
    assert [(-n, label, kind) for label, kind, n, _ in ask(connection, "central_objects", most="9")] == expected


@pytest.mark.neo4j
def test_the_steps_of_a_video_are_its_units_in_order(connection):
    (video,) = (s for s in SUBGRAPHS if s.name == "greek_salad")
    expected = [(i, labels(u.input_nodes), u.motion, labels(u.output_nodes)) for i, u in enumerate(units_of(video))]
    found = ask(connection, "steps_of_video", video="greek_salad")
    assert [(step, inputs, motion, outputs) for step, _, _, inputs, motion, outputs in found] == expected


@pytest.mark.neo4j
def test_the_way_to_a_dish_is_a_shortest_one(connection):
    food, dish = "cucumber", "greek salad"
    kitchen = Kitchen.default()

    def carries(node):
        return node.label == food or (food in node.ingredients and len(node.ingredients) > 1)

    goals = {goal.node for goal in SNAPSHOT.goals() if goal.node.label == dish}
    start = {n for unit in UNITS for n in unit.input_nodes if n.label == food and kitchen.has(n)}
    waiting, steps = deque((node, 0) for node in start), dict.fromkeys(start, 0)
    while waiting:
        node, far = waiting.popleft()
        for after in {n for u in UNITS if node in u.input_nodes for n in u.output_nodes if carries(n)} - steps.keys():
            steps[after] = far + 1
            waiting.append((after, far + 1))
    [(motions, becomes)] = ask(connection, "way_to_dish", food=food, dish=dish)
    assert len(motions) == len(becomes) == min(steps[goal] for goal in goals if goal in steps)
    assert becomes[-1].startswith(dish)


@pytest.mark.neo4j
def test_foods_eaten_together_stand_in_one_list(connection):
    goals = {goal.node for goal in SNAPSHOT.goals() if "tomato" in goal.node.ingredients}
    together = Counter(food for goal in goals for food in goal.ingredients if food != "tomato")
    assert dict(ask(connection, "eaten_together", food="tomato", most="1000")) == dict(together)


@pytest.mark.neo4j
def test_the_commonest_steps_are_seen_in_the_most_videos(connection):
    videos = Counter(unit for subgraph in SUBGRAPHS for unit in set(units_of(subgraph)))
    expected = sorted(videos.values(), reverse=True)[:7]
    assert [count for *_, count in ask(connection, "commonest_steps", most="7")] == expected


@pytest.mark.neo4j
def test_the_ways_with_a_food_are_its_operators_and_those_that_peel_it_are_among_them(connection):
    operators = SNAPSHOT.methods().operators
    expected = {
        (motion, tools, found.often["onion"], operators.acts[motion, tools].often["onion"])
        for (motion, tools), found in operators.evidence.items()
        if "onion" in found.often
    }
    found = ask(connection, "ways_with_food", food="onion")
    assert {(motion, tuple(tools), units, changing) for motion, tools, units, changing, _ in found} == expected
    assert {motion for motion, *_ in ask(connection, "ways_with_food", food="onion", motion="peel")} == {"peel"}
    for motion, tools, *_, seen_at in found:
        first = sorted(set(operators.evidence[motion, tuple(tools)].foods["onion"]))[:3]
        assert seen_at == [f"{sighting.video} {sighting.position}" for sighting in first]


@pytest.mark.neo4j
def test_the_frames_with_a_food_are_those_that_have_a_slot_for_it(connection):
    slots = [(frame, slot) for frame in SNAPSHOT.methods().frames for slot in frame.line.all_slots()]
    expected = [(frame.goal.label, frame.video, slot.motion) for frame, slot in slots if slot.food == "milk"]
    found = ask(connection, "frames_with_food", food="milk")
    assert sorted((dish, video, motion) for dish, _, video, _, motion, *_ in found) == sorted(expected)


@pytest.mark.neo4j
def test_the_stages_of_a_dish_are_those_of_its_frame(connection):
    (frame,) = (frame for frame in SNAPSHOT.methods().frames if frame.video == "garden_omelette")
    found = ask(connection, "stages_of_dish", video="garden_omelette")
    assert [row[3] for row in found if row[1] in {stage.step for stage in frame.line.stages}] == [
        stage.motion for stage in frame.line.stages
    ]
    slots = [name for *_, names, _, _, _, _, _, _ in found for name in names if name != "egg mixture"]
    assert sorted(slots) == sorted(slot.food for slot in frame.line.all_slots())


@pytest.mark.neo4j
def test_where_a_kind_joins_is_what_is_counted_over_frames(connection):
    expected = SNAPSHOT.methods().joining_counts.counts["oil", ""][0]
    counted = Counter()
    for work, _, _, times, _ in ask(connection, "where_kind_joins", kind="oil"):
        counted[work] += times
    assert counted == expected


def utensils(unit):
    return {node.label for node in unit.input_nodes} - FOODS


def videos_of(unit):
    return sorted({name for name, _, other in seen() if other == unit})


@pytest.mark.neo4j
def test_the_tools_of_a_food_are_the_utensils_beside_it(connection):
    expected = {}
    for unit in UNITS:
        for tool in utensils(unit) if "potato" in labels(unit.input_nodes) else ():
            expected.setdefault(tool, []).append(unit.motion)
    found = ask(connection, "tools_of_food", food="potato")
    assert {tool: (units, motions) for tool, units, motions in found} == {
        tool: (len(motions), sorted(set(motions))) for tool, motions in expected.items()
    }
    assert found[0][0] == "knife"


@pytest.mark.neo4j
def test_a_potato_comes_from_raw_to_boiled_by_being_peeled_washed_and_diced(connection):
    expected = ["peel", "wash", "pick-and-place", "dice", "pick-and-place", "boil"]
    for before in ("whole", ""):
        [(motions, becomes)] = ask(connection, "from_state_to_state", food="potato", before=before, after="boiled")
        assert motions == expected
        assert len(becomes) == len(motions)
        assert becomes[0] == "potato (peeled, whole)"
        assert becomes[-1] == "potato (boiled, diced)"
    assert ask(connection, "from_state_to_state", food="potato", before="boiled", after="whole") == []


@pytest.mark.neo4j
def test_shared_tasks_are_the_longest_runs_of_steps_that_two_videos_show(connection):
    shown = {s.name: units_of(s) for s in SUBGRAPHS}
    runs = {}
    for first, second in combinations(sorted(shown), 2):
        one, two = shown[first], shown[second]
        alike = {(i, j) for i in range(len(one)) for j in range(len(two)) if one[i] == two[j]}
        for i, j in alike:
            if (i - 1, j - 1) not in alike:
                length = next(n for n in range(1, len(one) + 1) if (i + n, j + n) not in alike)
                runs.setdefault(tuple(one[i : i + length]), set()).update((first, second))
    expected = sorted(
        (len(run), tuple(unit.motion for unit in run), tuple(sorted(videos))) for run, videos in runs.items()
    )
    found = ask(connection, "shared_tasks", least="3", most="1000")
    told = [(steps, tuple(motions), videos, tuple(first)) for steps, motions, _, videos, first in found]
    assert sorted(told) == sorted(
        (steps, motions, len(videos), videos[:10]) for steps, motions, videos in expected if steps >= 3
    )
    assert found[0][0] == max(steps for steps, *_ in expected)


@pytest.mark.neo4j
def test_the_central_motions_are_those_of_the_most_units(connection):
    types = {video: {goal.dish_type for goal in SNAPSHOT.goals() if video in goal.videos} for video in VIDEOS}
    for motion, units, videos, dish_types, foods in ask(connection, "central_motions", most="1000"):
        doing = [unit for unit in UNITS if unit.motion == motion]
        shown_in = {name for name, _, unit in seen() if unit.motion == motion}
        assert units == len(doing)
        assert videos == len(shown_in)
        assert dish_types == len(set().union(*(types[video] for video in shown_in)))
        assert foods == len({label for unit in doing for label in labels(unit.input_nodes)} & FOODS)
    counts = Counter(unit.motion for unit in UNITS)
    expected = sorted((-count, motion) for motion, count in counts.items())[:5]
    assert [(-units, motion) for motion, units, *_ in ask(connection, "central_motions", most="5")] == expected


@pytest.mark.neo4j
def test_without_a_knife_one_peels_with_the_peeler_and_chops_nothing(connection):
    found = {motion: row for motion, *row in ask(connection, "one_utensil_less", utensil="knife")}
    lost = [unit for unit in UNITS if "knife" in labels(unit.input_nodes)]
    assert found.keys() == {unit.motion for unit in lost}
    for motion, (units, videos, first, otherwise) in found.items():
        doing = [unit for unit in lost if unit.motion == motion]
        others = [unit for unit in UNITS - set(lost) if unit.motion == motion]
        assert units == len(doing)
        names = sorted({name for unit in doing for name in videos_of(unit)})
        assert (videos, first) == (len(names), names[:10])
        assert otherwise == sorted(set().union(*map(utensils, others)))
    assert "peeler" in found["peel"][-1]
    assert found["chop"][-1] == []


@pytest.mark.neo4j
def test_what_comes_after_a_motion_is_the_next_step_of_its_videos(connection):
    after = Counter(
        then.motion for s in SUBGRAPHS for unit, then in pairwise(units_of(s)) if unit.motion == "chop"
    )  # fmt: skip
    found = ask(connection, "next_motions", motion="chop", most="1000")
    assert {motion: times for motion, times, _ in found} == dict(after)
    assert [times for _, times, _ in found] == sorted(after.values(), reverse=True)


@pytest.mark.neo4j
def test_the_quickest_dishes_are_those_of_the_shortest_videos(connection):
    expected = []
    for goal in SNAPSHOT.goals("drinks"):
        for video in goal.videos:
            units = VIDEOS[video]
            tools = set().union(*map(utensils, units))
            expected.append((len(units), goal.node.label, video, len(goal.node.ingredients), len(tools)))
    found = ask(connection, "quickest_dishes", dish_type="drinks", most="1000")
    assert [(steps, dish, video, foods, tools) for dish, video, steps, foods, tools in found] == sorted(expected)
    assert len(ask(connection, "quickest_dishes", dish_type="", most="1000")) == len(SNAPSHOT.goals())


@pytest.mark.neo4j
def test_what_a_video_alone_teaches_is_in_no_other(connection):
    expected = [
        (step, unit.motion) for step, unit in enumerate(VIDEOS["spanish_omelette"]) if len(videos_of(unit)) == 1
    ]  # fmt: skip
    found = ask(connection, "only_in_video", video="spanish_omelette")
    assert [(step, motion) for step, motion, *_ in found] == expected
