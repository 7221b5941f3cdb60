"""What is asked for a video that is left out: its dish, and its foods as they first join others."""

from __future__ import annotations

import pytest
from kitchen_stories import subgraph

from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.plans.kitchen import Kitchen

CHOP = "onion(whole); knife > chop > onion(chopped)"
POUR = "onion(chopped); bowl > pour > bowl{onion}; onion(chopped)@in bowl"
TOSS = "bowl{onion}; onion(chopped)@in bowl; tomato(whole) > toss > bowl{onion,tomato}; onion(mixed)@in bowl"


def asked(*lines):
    video = left_out_video(subgraph("video", "salad", *lines), Kitchen.default())
    assert video is not None
    return {want.object: want.state for want in video.recipe.ingredients}, video


def test_a_food_is_asked_in_the_state_in_which_it_joins_and_not_in_what_becomes_of_it():
    mix = "bowl{onion,tomato}; onion(mixed)@in bowl > mix > salad{onion,tomato}"
    foods, video = asked(CHOP, POUR, TOSS, mix)
    assert foods == {"onion": "chopped", "tomato": "whole"}
    assert (video.name, video.recipe.dish_type, len(video.units)) == ("video", "salad", 4)


BATTER = "flour(powder); egg(whole); water(liquid) > mix > batter(raw){flour,egg}"


@pytest.mark.parametrize(
    ("lines", "foods"),
    [
        pytest.param(
            (
                CHOP,
                POUR,
                "onion(chopped)@in bowl; pan > cook > onion(cooked)@in pan",
                "onion(cooked)@in pan; tomato(diced) > mix > salad{onion,tomato}",
            ),
            {"onion": "cooked", "tomato": "diced"},
            id="a bowl of the food alone is no joining",
        ),
        pytest.param(
            (
                "onion(whole) > peel > onion(whole,peeled)",
                "onion(whole,peeled) > dice > onion(diced,peeled,whole)",
                "onion(diced,peeled,whole); tomato > mix > salad{onion,tomato}",
            ),
            {"onion": "diced", "tomato": ""},
            id="of several states the one got last counts, and work before how it is sold",
        ),
        pytest.param(
            (CHOP, "onion(chopped); tomato(diced) > mix > salad{onions,tomatoes}"),
            {"onion": "chopped", "tomato": "diced"},
            id="names in the plural are the same food, asked under the label",
        ),
        pytest.param(
            ("bowl{salt}; onion(chopped) > mix > salad{onion,salt}",),
            {"onion": "chopped", "salt": ""},
            id="a food that the video never shows by itself is asked without a state",
        ),
        pytest.param(
            (BATTER, "batter(raw){flour,egg}; sugar(granulated) > bake > cake(baked){batter,sugar}"),
            {"flour": "powder", "egg": "whole", "sugar": "granulated"},
            id="a mixture that the video makes is asked as what it is made of",
        ),
        pytest.param(
            (
                "lemon(halved) > squeeze > lemon juice(liquid)@in bowl",
                "lemon juice(liquid)@in bowl; sugar > mix > lemonade{lemon juice,sugar}",
            ),
            {"lemon": "halved", "sugar": ""},
            id="what is made of a food of its name is asked as that food",
        ),
        pytest.param(
            (
                "onion(whole); knife > peel > carrot(peeled)",
                "egg white(raw); egg yolk(raw) > beat > egg(beaten)",
                "carrot(peeled); egg(beaten) > mix > salad{carrot,egg}",
            ),
            {"carrot": "peeled", "egg": "beaten"},
            id="a slip of the pen, and a food put together of its parts, are asked as they are",
        ),
        pytest.param(
            (
                "steak(raw); salt(granulated) > sprinkle > steak(salted){salt}",
                "steak(salted){salt}; pan > fry > steak(cooked){salt}",
            ),
            {"steak": "raw", "salt": "granulated"},
            id="a dish called after its main food is asked for with it before anything is on it",
        ),
    ],
)
def test_what_is_asked_for(lines, foods):
    found, _ = asked(*lines)
    assert found == foods


def test_a_video_that_marks_no_dish_of_any_foods_is_no_question():
    assert left_out_video(subgraph("video", "salad", CHOP, "onion(chopped) > mix > salad"), Kitchen.default()) is None
