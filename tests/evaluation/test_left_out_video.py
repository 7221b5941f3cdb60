"""What is asked for a video that is left out: its dish, and its foods as they first join others."""

from __future__ import annotations

from kitchen_stories import subgraph

from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.kitchen import Kitchen

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


def test_a_bowl_of_the_food_alone_is_no_joining():
    cook = "onion(chopped)@in bowl; pan > cook > onion(cooked)@in pan"
    foods, _ = asked(CHOP, POUR, cook, "onion(cooked)@in pan; tomato(diced) > mix > salad{onion,tomato}")
    assert foods["onion"] == "cooked"


def test_of_several_states_the_one_got_last_counts_and_work_before_how_it_is_sold():
    peel = "onion(whole) > peel > onion(whole,peeled)"
    dice = "onion(whole,peeled) > dice > onion(diced,peeled,whole)"
    foods, _ = asked(peel, dice, "onion(diced,peeled,whole); tomato > mix > salad{onion,tomato}")
    assert foods == {"onion": "diced", "tomato": ""}


def test_names_in_the_plural_are_the_same_food_asked_under_the_label():
    foods, _ = asked(CHOP, "onion(chopped); tomato(diced) > mix > salad{onions,tomatoes}")
    assert foods == {"onion": "chopped", "tomato": "diced"}


def test_a_food_that_the_video_never_shows_by_itself_is_asked_without_a_state():
    foods, _ = asked("bowl{salt}; onion(chopped) > mix > salad{onion,salt}")
    assert foods == {"onion": "chopped", "salt": ""}


def test_a_video_that_marks_no_dish_of_any_foods_is_no_question():
    assert left_out_video(subgraph("video", "salad", CHOP, "onion(chopped) > mix > salad"), Kitchen.default()) is None


BATTER = "flour(powder); egg(whole); water(liquid) > mix > batter(raw){flour,egg}"
BAKE = "batter(raw){flour,egg}; sugar(granulated) > bake > cake(baked){batter,sugar}"


def test_a_mixture_that_the_video_makes_is_asked_as_what_it_is_made_of():
    foods, _ = asked(BATTER, BAKE)
    assert foods == {"flour": "powder", "egg": "whole", "sugar": "granulated"}


def test_what_is_made_of_a_food_of_its_name_is_asked_as_that_food():
    squeeze = "lemon(halved) > squeeze > lemon juice(liquid)@in bowl"
    foods, _ = asked(squeeze, "lemon juice(liquid)@in bowl; sugar > mix > lemonade{lemon juice,sugar}")
    assert foods == {"lemon": "halved", "sugar": ""}


def test_a_slip_of_the_pen_and_a_food_put_together_of_its_parts_are_asked_as_they_are():
    slip = "onion(whole); knife > peel > carrot(peeled)"
    beat = "egg white(raw); egg yolk(raw) > beat > egg(beaten)"
    foods, _ = asked(slip, beat, "carrot(peeled); egg(beaten) > mix > salad{carrot,egg}")
    assert foods == {"carrot": "peeled", "egg": "beaten"}


def test_a_dish_that_is_called_after_its_main_food_is_asked_for_with_it_before_anything_is_on_it():
    salt = "steak(raw); salt(granulated) > sprinkle > steak(salted){salt}"
    foods, _ = asked(salt, "steak(salted){salt}; pan > fry > steak(cooked){salt}")
    assert foods == {"steak": "raw", "salt": "granulated"}
