"""What a step goes back to: the second of the video that is followed, and the foods that stand for others there."""

from __future__ import annotations

from dataclasses import replace
from urllib.parse import urlencode

import httpx
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pictures.demo_plans import demo_foon, demo_plan, demo_recipe_names
from web.driving import PLANNED, text_of, until
from web.serving import app, served

from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.model import Sighting
from foon_kg.model.nodes import Timing
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.evidence import by_place, stands_in
from foon_kg.web.foon import FixedFoon
from foon_kg.web.words import place_to_see, seen_at


def test_every_place_of_the_foon_has_its_unit():
    places = by_place(demo_foon().units)
    for subgraph in demo_foon().subgraphs:
        for number, annotation in enumerate(subgraph.annotations):
            assert places[subgraph.name, number].unit.motion == annotation.unit.motion


def test_a_food_stands_for_one_that_the_video_shows_and_the_step_does_not_have_by_chance():
    places = by_place(demo_foon().units)
    found = 0
    for name in demo_recipe_names():
        plan = demo_plan(name)
        for unit in plan.units:
            own = {
                label for node in (*unit.input_nodes, *unit.output_nodes) for label in (node.label, *node.ingredients)
            }
            for one in stands_in(unit, plan.substitutions, places):
                found += 1
                assert one["object"] in own
                shown = {
                    label
                    for seen in unit.seen_in
                    for part in [places[seen.video, seen.position].unit]
                    for node in (*part.input_nodes, *part.output_nodes)
                    for label in (node.label, *node.ingredients)
                }
                assert one["equivalent"] in shown
                assert one["object"] not in shown
            if unit.origin == "foon":
                assert stands_in(unit, plan.substitutions, places) == []
    assert found, "some step is done to a like food"


def timed():
    """The demo's FOON as if every video had been timed and could be opened: step 3 of each begins at 1:05."""
    subgraphs = [
        replace(
            one,
            sources=(f"https://youtu.be/{one.name}",),
            annotations=tuple(
                replace(annotation, timing=Timing(((65.0 + 10 * (place - 2), 70.0 + 10 * (place - 2)),)))
                for place, annotation in enumerate(one.annotations)
            ),
        )
        for one in demo_foon().subgraphs
    ]
    return Snapshot.of(subgraphs, demo_foon().kitchen)


def recipe_of(video):
    """What the dish of a video asks, as the API is asked for it."""
    subgraph = next(one for one in demo_foon().subgraphs if one.name == video)
    recipe = left_out_video(subgraph, demo_foon().kitchen).recipe
    return {
        "dish_type": recipe.dish_type,
        "ingredients": [f"{one.state} {one.object}".strip() for one in recipe.ingredients],
    }


@pytest.fixture(scope="module")
def timed_address():
    with served(app(foon=FixedFoon(timed()))) as found:
        yield found


@pytest.mark.parametrize("video", ["bean_salad", "farmhouse_omelette", "mushroom_soup"])
def test_a_plan_that_follows_a_video_is_seen_in_that_video_wherever_that_shows_it(timed_address, video):
    told = httpx.post(f"{timed_address}/api/plan", json=recipe_of(video), timeout=60).json()
    assert told["reference"]["videos"] == [video]
    for unit, seen, address in zip(told["units"], told["seen"], told["videos"], strict=True):
        assert seen in unit["seen_in"]
        assert (seen["video"] == video) == any(one["video"] == video for one in unit["seen_in"])
        assert address == f"https://youtu.be/{seen['video']}?t={seen['start']:.0f}s"
    assert any(seen["video"] == video for seen in told["seen"])


def test_every_view_says_in_which_second_it_is_as_in_the_video(page, timed_address):
    asked = recipe_of("farmhouse_omelette")
    told = httpx.post(f"{timed_address}/api/plan", json=asked, timeout=60).json()
    exact = next(
        i for i, (unit, seen) in enumerate(zip(told["units"], told["seen"], strict=True))
        if unit["origin"] == "foon" and seen["video"] == "farmhouse_omelette"
        and unit["seen_in"][0]["video"] != "farmhouse_omelette"
    )  # fmt: skip
    start = int(told["seen"][exact]["start"])
    said = f"As in video farmhouse_omelette at {start // 60}:{start % 60:02}"
    question = urlencode({"dish": asked["dish_type"], "with": asked["ingredients"]}, doseq=True)
    places = {
        "steps": f".steps li:nth-child({exact + 1}) .where",
        "tree": ".tree [aria-current] + .where",
        "cook": ".cook .now-doing",
    }
    for name, place in places.items():
        page.get("about:blank")
        page.get(f"{timed_address}/#{question}&view={name}&step={exact + 1}")
        until(page, PLANNED)
        assert said in text_of(page, place)
        link = page.find_element("css selector", f"{place} a[target]")
        assert link.get_attribute("href") == told["videos"][exact]


@given(
    st.lists(st.tuples(st.sampled_from("abc"), st.one_of(st.none(), st.floats(0, 9))), max_size=6),
    st.sets(st.sampled_from("abc")),
)
def test_the_place_to_see_is_in_the_video_that_is_followed_and_has_a_time_where_one_has(places, videos):
    sightings = [Sighting(video, number, None, start) for number, (video, start) in enumerate(places)]
    found = place_to_see(sightings, videos)
    if not sightings:
        assert found is None
        return
    best = max((one.video in videos, one.start is not None) for one in sightings)
    assert (found.video in videos, found.start is not None) == best
    assert all((one.video in videos, one.start is not None) != best for one in sightings[: found.position])


@pytest.mark.parametrize(
    ("source", "address"),
    [("http://x.org/a.mp4", "http://x.org/a.mp4#t=3"), ("http://[oops", None), ("javascript:alert(1)", None)],
)
def test_only_what_opens_a_page_is_an_address(source, address):
    assert seen_at([Sighting("salad", 0, source, 3.0)]) == address
