"""What the API of the explorer answers: the same from files and from Neo4j, bounded, filtered, and along the food."""

from __future__ import annotations

from itertools import pairwise

import pytest
from demo_foon import demo_subgraphs
from fastapi.testclient import TestClient
from pictures.demo_plans import demo_foon
from web.serving import app

from foon_kg import Foon
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, load
from foon_kg.web.foon import LiveFoon

SUBGRAPHS = {subgraph.name: subgraph for subgraph in demo_subgraphs()}
UNITS = {known.unit.key: known for known in demo_foon().units}
KITCHEN = Kitchen.default()


@pytest.fixture(scope="module")
def of_files():
    with TestClient(app(), base_url="http://localhost") as made:
        yield made


@pytest.fixture(scope="module")
def of_neo4j(emptied_server):
    with Connection(emptied_server) as connection:
        load(connection, SUBGRAPHS.values())
    live = LiveFoon(lambda: Foon(server=emptied_server))
    with TestClient(app(foon=live), base_url="http://localhost") as made:
        yield made


@pytest.fixture(params=["files", pytest.param("neo4j", marks=pytest.mark.neo4j)])
def client(request):
    """A served FOON: the demo's, from files and from Neo4j."""
    return request.getfixturevalue(f"of_{request.param}")


def search(client, text, **more):
    return client.get("/api/explore/search", params={"text": text, **more}).json()


def around(client, name, **more):
    return client.post("/api/explore/around", json={"id": name, **more}).json()


def way(client, start, end, **more):
    return client.post("/api/explore/way", json={"start": start, "end": end, **more})


def ids(told):
    return [thing["id"] for thing in told["things"]]


def nodes_of(side):
    return {f"object:{node.key}" for node in side}


def nodes_in(known):
    return (*known.unit.input_nodes, *known.unit.output_nodes)


def test_search_finds_things_of_every_kind_as_one_types(client):
    assert search(client, "oni")[0]["id"] == "food:onion"
    assert search(client, "kni")[0]["id"] == "utensil:knife"
    assert "motion:chop" in [one["id"] for one in search(client, "chop")]
    assert "video:greek_salad" in [one["id"] for one in search(client, "gre")]
    assert "dish:salad" in [one["id"] for one in search(client, "salad")]
    assert search(client, "SALAD gre")[0]["name"] in {"greek salad", "greek_salad"}
    assert search(client, "zzz") == search(client, " ") == []


def test_search_finds_objects_by_state_and_name(client):
    found = search(client, "chopped on")
    assert found
    assert all(one["kind"] == "object" and one["name"] == "onion" and "chopped" in one["states"] for one in found)
    assert [one["kind"] for one in search(client, "onion", kind="food")] == ["food"]


def test_around_a_step_are_its_objects_its_motion_apart_and_its_videos(client):
    known = next(known for known in UNITS.values() if len(known.seen_in) > 1)
    told = around(client, f"step:{known.unit.key}", utensils=True, most=100)
    assert ids(told)[0] == f"step:{known.unit.key}"
    videos = {f"video:{seen.video}" for seen in known.seen_in}
    objects = nodes_of(nodes_in(known))
    assert set(ids(told)[1:]) == objects | videos
    taken = {edge["source"] for edge in told["edges"] if edge["kind"] == "takes"}
    made = {edge["target"] for edge in told["edges"] if edge["kind"] == "makes"}
    assert (taken, made) == (nodes_of(known.unit.input_nodes), nodes_of(known.unit.output_nodes))
    assert told["about"]["links"][0]["id"] == f"motion:{known.unit.motion}"


def test_empty_utensils_are_left_out_unless_they_are_all_there_is(client):
    chop = next(known for known in UNITS.values() if known.unit.motion == "chop")
    shown = around(client, f"step:{chop.unit.key}", most=100)["things"]
    assert shown
    assert not any(thing["empty"] for thing in shown)
    assert any(thing["empty"] for thing in around(client, f"step:{chop.unit.key}", utensils=True, most=100)["things"])
    only = next(known for known in UNITS.values() if not any(map(KITCHEN.is_food, known.unit.input_nodes)))
    assert len(ids(around(client, f"step:{only.unit.key}"))) > 1


def test_around_an_object_are_the_steps_that_make_and_take_it(client):
    for thing in search(client, "onion", kind="object", limit=50):
        key = thing["id"].partition(":")[2]
        expected = {f"step:{k}" for k, known in UNITS.items() if key in {node.key for node in nodes_in(known)}}
        steps = {name for name in ids(around(client, thing["id"], most=150)) if name.startswith("step:")}
        assert steps == expected


@pytest.mark.parametrize("name", ["food:onion", "utensil:knife", "motion:chop", "video:greek_salad", "dish:salad"])
@pytest.mark.parametrize("depth", [1, 2, 3])
def test_no_more_is_told_than_was_asked_and_what_is_left_out_is_counted(client, name, depth):
    told = around(client, name, depth=depth, most=4)
    assert 1 < len(told["things"]) <= 5
    whole = around(client, name, most=150)
    assert told["more"][name] == len(whole["things"]) - 1 - len({*ids(whole)} & {*ids(told)} - {name})
    assert all(edge["source"] in ids(told) and edge["target"] in ids(told) for edge in told["edges"])


def test_of_many_steps_those_of_different_motions_come_first(client):
    (knife,) = (thing["id"] for thing in around(client, "utensil:knife")["things"][1:])
    few = [thing["name"] for thing in around(client, knife, most=6)["things"][1:]]
    assert len(set(few)) == 6
    facts = {fact["name"]: fact["words"] for fact in around(client, "utensil:knife")["about"]["facts"]}
    assert facts["Done with it"][:2] == ["scrape 17", "chop 15"]


def test_what_joins_the_most_of_what_is_near_comes_before_what_joins_less(client):
    told = ids(around(client, "food:onion", depth=2, most=12))
    near = {name for name in told if name.startswith("object:")}
    joins = {key: len(near & nodes_of(nodes_in(known))) for key, known in UNITS.items()}
    shown = {name.partition(":")[2] for name in told} & UNITS.keys()
    assert shown
    assert min(joins[key] for key in shown) >= max(joins[key] for key in UNITS.keys() - shown)
    assert max(joins[key] for key in shown) > 1


def test_what_is_shown_already_is_joined_and_takes_no_place(client):
    first = around(client, "food:onion", most=10)
    step = next(one for one in ids(around(client, ids(first)[1], most=10)) if one.startswith("step:"))
    grown = around(client, step, most=2, shown=[*ids(first), "object:gone"])
    assert any({edge["source"], edge["target"]} == {step, ids(first)[1]} for edge in grown["edges"])
    assert len({*ids(grown)} - {*ids(first), step}) <= 2
    assert grown["more"].keys() >= {*ids(first)}


def test_filters_let_through_steps_of_their_videos_motions_and_dish_types(client):
    def steps(**filters):
        found = {name.partition(":")[2] for name in ids(around(client, "food:onion", depth=2, most=150, **filters))}
        return [UNITS[key] for key in found & UNITS.keys()]

    assert {"chop"} == {known.unit.motion for known in steps(motions=["chop"])}
    assert all("greek_salad" in {seen.video for seen in known.seen_in} for known in steps(videos=["greek_salad"]))
    soups = {goal_video for goal in demo_foon().goals("soup") for goal_video in goal.videos}
    assert all(soups & {seen.video for seen in known.seen_in} for known in steps(dish_types=["soup"]))
    assert 0 < len(steps(dish_types=["soup"])) < len(steps())


def test_a_video_has_its_dish_and_its_steps_in_their_order(client):
    told = ids(around(client, "video:greek_salad", most=150))
    units = [annotation.unit for annotation in SUBGRAPHS["greek_salad"].annotations]
    assert [name for name in told if name.startswith("step:")] == list(dict.fromkeys(f"step:{u.key}" for u in units))


def test_the_shortest_way_follows_the_food_and_not_the_knife(client):
    told = way(client, "whole potato", "boiled potato").json()
    steps = [UNITS[step["thing"]["id"].partition(":")[2]].unit for step in told["steps"]]
    assert [unit.motion for unit in steps] == ["peel", "wash", "pick-and-place", "dice", "pick-and-place", "boil"]
    stops = [stop["thing"] for stop in told["stops"]]
    assert [stop["name"] for stop in stops] == ["potato"] * 7
    assert stops[0]["states"] == ["whole"]
    assert "boiled" in stops[-1]["states"]
    for unit, (before, after) in zip(steps, pairwise(stops), strict=True):
        assert before["id"] in nodes_of(unit.input_nodes)
        assert after["id"] in nodes_of(unit.output_nodes)
    assert told["steps"][0]["thing"]["note"].startswith("Peel the potato")


def test_raw_is_what_no_step_has_changed_whatever_the_foon_calls_it(client):
    assert way(client, "raw potato", "boiled potato").json() == way(client, "whole potato", "boiled potato").json()


def test_what_was_cooked_together_is_not_made_of_each_other(client):
    assert way(client, "whole garlic", "sauteed garlic").status_code == 200
    assert way(client, "whole onion", "sauteed garlic").status_code == 404


def test_a_food_goes_on_in_what_it_becomes_and_is_made_into(client):
    told = way(client, "cucumber", "greek salad").json()
    assert [stop["name"] for stop in told["stops"]] == ["cucumber"] * 5 + ["greek salad"]
    assert way(client, "whole egg", "omelette").json()["stops"][-1]["thing"]["name"].endswith("omelette")


def test_a_way_is_found_within_the_filters_and_between_objects_by_id(client):
    free = way(client, "whole onion", "soup").json()
    (tomato,) = {v["video"] for v in free["steps"][-1]["places"]}
    bound = way(client, "whole onion", "soup", videos=[tomato]).json()
    assert all(tomato in {place["video"] for place in step["places"]} for step in bound["steps"])
    ends = [bound["stops"][place]["thing"]["id"] for place in (0, -1)]
    assert way(client, *ends, videos=[tomato]).json() == bound
    refused = way(client, "whole onion", "soup", videos=["greek_salad"])
    assert (refused.status_code, refused.json()["error"]["code"]) == (404, "no-way")


@pytest.mark.parametrize(
    ("start", "end", "said"),
    [
        ("mashed potato", "soup", "boiled, browned"),
        ("moon dust", "soup", "no food “moon dust”"),
        ("knife", "soup", "a utensil"),
        ("tomato soup", "whole onion", "no steps"),
        ("boiled potato", "boiled potato", "already"),
    ],
)
def test_what_leads_nowhere_says_why(client, start, end, said):
    answer = way(client, start, end)
    assert answer.status_code == 404
    error = answer.json()["error"]
    assert said in f"{error['message']} {error['hint']}"


def test_a_vessel_with_nothing_in_it_is_no_beginning_and_no_end(client):
    (knife,) = (thing["id"] for thing in around(client, "utensil:knife")["things"][1:])
    for ends in ((knife, "soup"), ("whole onion", knife)):
        answer = way(client, *ends)
        assert (answer.status_code, "holds no food" in answer.json()["error"]["message"]) == (404, True)


def test_an_unknown_thing_is_404(client):
    answer = client.post("/api/explore/around", json={"id": "food:moon dust"})
    assert (answer.status_code, answer.json()["error"]["code"]) == (404, "unknown")


def test_the_filters_and_beginnings_are_those_of_the_foon(client):
    told = client.get("/api/explore/begin").json()
    assert told["videos"] == sorted(SUBGRAPHS)
    assert told["motions"] == sorted({known.unit.motion for known in UNITS.values()})
    assert told["dish_types"] == sorted({goal.dish_type for goal in demo_foon().goals()})
    assert {"food:onion", "utensil:knife", "motion:pick-and-place"} <= {thing["id"] for thing in told["begin"]}


@pytest.mark.neo4j
def test_every_thing_is_told_alike_from_files_and_from_neo4j(of_files, of_neo4j):
    names = {thing["id"] for text in "abcdefghijklmnopqrstuvwxyz" for thing in search(of_files, text, limit=50)}
    assert len(names) > 200
    for name in sorted(names)[::5]:
        assert around(of_files, name, depth=2, utensils=True) == around(of_neo4j, name, depth=2, utensils=True)


def test_a_thing_is_found_by_its_name_alone_and_a_misspelled_one_says_what_may_be_meant(client):
    told = client.post("/api/explore/around", json={"id": "onion"}).json()
    assert told["things"][0]["id"] == "food:onion"
    assert client.post("/api/explore/around", json={"id": "knife"}).json()["things"][0]["id"] == "utensil:knife"
    wrong = client.post("/api/explore/around", json={"id": "onionn"})
    assert wrong.status_code == 404
    assert wrong.json()["error"]["hint"].startswith("Did you mean onion")
