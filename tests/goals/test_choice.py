"""Which recorded dish a recipe is made after: what cannot be comes last, what is most natural first."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from integration import videos
from integration.school import SALAD
from integration.told import Likes, snapshot_of

from foon_kg.food import singular, tables
from foon_kg.goals.asked import Asked, weight
from foon_kg.goals.choice import MOST_FITTED, fits, refusals, shortlisted
from foon_kg.goals.names import is_baked, named_alike
from foon_kg.goals.recorded import recorded
from foon_kg.goals.score import missing_core
from foon_kg.integration.joining.joiners import Joiners
from foon_kg.integration.joining.layouts import MAIN, is_need
from foon_kg.integration.joining.outlines import Outline, Outlines, closing_heat
from foon_kg.integration.joining.places import Matcher
from foon_kg.integration.joining.spots import NATURAL
from foon_kg.integration.preparing.understanding import wants_of
from foon_kg.model import RequiredIngredient

KNOWN = tables()
METHODS = snapshot_of(SALAD, *videos.ALL).methods()
LAYOUTS = list(METHODS.layouts.values())
OUTLINES = [Outline.of(layout, KNOWN) for layout in LAYOUTS]
LIKES = Likes({("leek", "onion"): 0.8, ("kohlrabi", "potato"): 0.9, ("spaghetti", "pasta"): 0.95})


def wants(**foods):
    asked = [RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items()]
    return wants_of(asked, KNOWN, METHODS.operators)


def chosen(asked, dish_type, title="", layouts=LAYOUTS):
    return fits(layouts, Asked(asked, dish_type, title, KNOWN), Matcher(METHODS.joining_counts, LIKES.alike, asked))


def layout(video):
    return next(one for one in LAYOUTS if one.frame.video == video)


SOUP = wants(kohlrabi="diced", leek="chopped", salt="granulated", water="liquid")
CAKE = wants(flour="powder", sugar="granulated", egg="whole", butter="stick")


@pytest.mark.parametrize(
    ("asked", "dish_type", "video"),
    [
        (SOUP, "soup", "forgetful_soup"),
        (CAKE, "cake", "plain_cake"),
        (wants(spaghetti="dried", tomato="diced", olive_oil="liquid"), "pasta", "pasta_with_sauce"),
        (wants(bread="sliced", ham="sliced", butter="creamy"), "sandwich", "tomato_sandwich"),
        (wants(mango="sliced", milk="liquid", honey="liquid"), "drinks", "banana_drink"),
        (wants(tomato="diced", cucumber="sliced", lemon="juiced", olive_oil="liquid"), "salad", "mixed_salad"),
        (wants(lettuce="chopped", cucumber="sliced", salt="granulated"), "salad", "salad"),
    ],
)
def test_a_recipe_is_made_after_the_dish_in_which_its_foods_have_a_natural_place(asked, dish_type, video):
    best = chosen(asked, dish_type)[0]
    assert best.frame.video == video
    assert best.vetoes == ()


def test_each_food_joins_once_and_in_its_own_form_where_the_dish_has_such_a_food():
    best = chosen(SOUP, "soup")[0]
    assert [join.want for join in best.joins] == list(SOUP)
    assert [join.slot.food for join in best.joins] == ["potato", "onion", "salt", "water"]
    assert all(0 <= join.fit <= 1 for join in best.joins)
    assert best.similarity == 1.0


def test_of_equally_like_foods_the_first_is_the_place():
    both = Likes({("kohlrabi", "onion"): 0.9, ("kohlrabi", "potato"): 0.9})
    asked = Asked(wants(kohlrabi="diced"), "soup", "", KNOWN)
    (best,) = fits([layout("forgetful_soup")], asked, Matcher(METHODS.joining_counts, both.alike, asked.wants))
    assert [slot.food for slot in layout("forgetful_soup").frame.line.all_slots()].index("potato") == 1
    assert best.joins[0].slot.food == "potato"


@pytest.mark.parametrize(("food", "taken"), [("olive oil", "butter"), ("milk", None)])
def test_what_does_the_same_in_a_dish_takes_the_slot_as_sure_as_that_is(food, taken):
    likes = Likes({(food, "butter"): 0.6})
    asked = Asked(wants(**{food.replace(" ", "_"): "liquid"}), "cake", "", KNOWN)
    (best,) = fits([layout("plain_cake")], asked, Matcher(METHODS.joining_counts, likes.alike, asked.wants))
    assert (best.joins[0].slot and best.joins[0].slot.food) == taken


def test_what_has_to_be_baked_or_hot_is_not_made_after_what_is_cold():
    vetoed = {fit.frame.video: fit.vetoes for fit in chosen(CAKE, "cake")}
    assert vetoed["plain_cake"] == ()
    assert any("is baked" in why for why in vetoed["mixed_salad"])
    assert any("is baked" in why for why in vetoed["forgetful_soup"])
    soup = {fit.frame.video: fit.vetoes for fit in chosen(SOUP, "soup")}
    assert any("is hot" in why for why in soup["mixed_salad"])


def test_vetoes_come_before_any_score():
    for asked, dish_type in ((CAKE, "cake"), (SOUP, "soup")):
        found = [len(fit.vetoes) for fit in chosen(asked, dish_type)]
        assert found == sorted(found)


def test_more_foods_in_place_score_higher():
    few = chosen(wants(tomato="diced", salmon="raw", rice="uncooked"), "salad", "", [layout("mixed_salad")])[0]
    many = chosen(wants(tomato="diced", cucumber="sliced", salt="granulated"), "salad", "", [layout("mixed_salad")])[0]
    assert many.score > few.score
    assert many.similarity == 1.0 > few.similarity


def test_a_dish_that_is_called_as_the_title_says_scores_higher():
    asked, one = wants(tomato="sliced", cheese="sliced"), [layout("tomato_sandwich")]
    assert chosen(asked, "", "a sandwich for two", one)[0].score > chosen(asked, "", "supper", one)[0].score
    assert named_alike("tomato soup", "soup", "a hot soup of tomatoes") == 1.0
    assert named_alike("tomato soup", "soup", "supper") == 0.6
    assert named_alike("fruit punch", "soup", "supper") == 0.0


def test_a_dish_is_baked_only_where_it_is_called_so():
    cake = [layout("plain_cake")]
    asked = wants(egg="whole", butter="stick")
    plain, oven = (chosen(asked, "soup", title, cake)[0].score for title in ("a thick supper", "a thick casserole"))
    assert oven > plain
    assert any("not to be baked" in why for why in chosen(asked, "soup", "stovetop supper", cake)[0].vetoes)


def test_what_is_called_so_is_cooked_in_a_pan_and_flesh_is_blended_nowhere():
    cake = [layout("plain_cake")]
    (fit,) = chosen(wants(egg="whole", butter="stick"), "soup", "egg curry", cake)
    assert any("not to be baked" in why for why in fit.vetoes)
    (fit,) = chosen(wants(banana="whole", chicken="raw"), "drinks", "", [layout("banana_drink")])
    assert "chicken would be blended" in fit.vetoes


def test_a_frame_that_lost_half_of_its_goal_scores_lower():
    sound = layout("mixed_salad")
    damaged = replace(sound, frame=replace(sound.frame, weak=sound.frame.goal.ingredients))
    asked = wants(tomato="diced", cucumber="sliced")
    assert chosen(asked, "salad", "", [sound])[0].score - 0.5 > chosen(asked, "salad", "", [damaged])[0].score


def test_what_defines_a_dish_is_asked_of_type_and_title():
    assert refusals(wants(salt="granulated"), "omelette", "", KNOWN) == ["no omelette without egg"]
    assert refusals(wants(egg="whole"), "omelette", "", KNOWN) == []
    assert any("dumpling" in why for why in refusals(wants(egg="whole"), "omelette", "egg dumplings", KNOWN))
    assert refusals(wants(salt="granulated"), "salad", "", KNOWN) == []


def test_a_goal_promises_what_its_name_says():
    sandwich = recorded(layout("tomato_sandwich"), KNOWN)
    assert missing_core(sandwich, Asked(wants(salt="granulated"), "sandwich", "", KNOWN))
    assert missing_core(sandwich, Asked(wants(bread="sliced"), "sandwich", "", KNOWN)) == ()


@pytest.mark.parametrize(
    ("video", "closing"),
    [
        ("mixed_salad", ("", "")),
        ("tomato_sandwich", ("", "")),
        ("banana_drink", ("", "")),
        ("plain_cake", ("bake", "")),
    ],
)
def test_dishes_end_cold_or_baked(video, closing):
    assert closing_heat(layout(video), KNOWN) == closing


def test_what_is_heated_over_a_fire_tells_the_vessel():
    kind, group = closing_heat(layout("forgetful_soup"), KNOWN)
    assert (kind, group) == ("heat", KNOWN.utensil("pot").group)


def test_what_a_dish_is_built_on_weighs_most_and_what_seasons_least():
    built, other, seasoning = wants(potato="whole", tomato="whole", salt="granulated")
    assert weight(built, KNOWN) > weight(other, KNOWN) > weight(seasoning, KNOWN)


def test_the_shortlist_has_the_type_first_and_no_dish_that_ends_otherwise():
    keys = shortlisted(Outlines(OUTLINES), Asked(SOUP, "soup", "", KNOWN), LIKES)
    found = [next(one for one in OUTLINES if one.key == key) for key in keys]
    assert found[0].dish_type == "soup"
    ends = next(one.ends for one in OUTLINES if one.dish_type == "soup")
    assert all(one.ends == ends for one in found)
    assert len(keys) == len(set(keys)) <= MOST_FITTED


def test_an_outline_tells_foods_and_kinds_of_the_slots():
    one = next(one for one in OUTLINES if one.label == "soup")
    assert one.foods == {"water", "potato", "onion", "salt"}
    assert one.kinds == {KNOWN.foods.find(food)[0] for food in one.foods}


@settings(max_examples=30, deadline=None)
@given(st.randoms(use_true_random=False), st.sampled_from(("soup", "cake", "salad", "drinks", "")))
def test_the_order_of_frames_does_not_matter(chance: random.Random, dish_type):
    shuffled = chance.sample(LAYOUTS, len(LAYOUTS))
    for asked in (SOUP, CAKE):
        assert chosen(asked, dish_type, "", shuffled) == chosen(asked, dish_type)
        outlines = Outlines(chance.sample(OUTLINES, len(OUTLINES)))
        question = Asked(asked, dish_type, "", KNOWN)
        assert shortlisted(outlines, question, LIKES) == shortlisted(Outlines(OUTLINES), question, LIKES)


FOODS = [
    *SOUP,
    *CAKE,
    *wants(spaghetti="dried", tomato="diced", leek="sliced", honey="liquid", chicken="raw", salmon="raw", cucumber=""),
    *wants(tomato="canned", potato="mashed", chicken="cooked", salmon="smoked", egg="hard-boiled", cucumber="pickled"),
]
RECIPES = st.lists(st.sampled_from(FOODS), min_size=1, max_size=5).map(
    lambda foods: tuple(replace(food, number=number) for number, food in enumerate(dict.fromkeys(foods), start=1))
)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(RECIPES, st.sampled_from(("soup", "cake", "sandwich"))), min_size=2, max_size=4))
def test_what_is_kept_of_other_recipes_changes_no_choice(asked):
    joiners = Joiners()
    for foods, dish_type in asked * 2:
        question = Asked(foods, dish_type, "", KNOWN)
        kept = fits(LAYOUTS, question, Matcher(METHODS.joining_counts, LIKES.alike, foods, joiners))
        assert kept == chosen(foods, dish_type)
        assert all([join.want for join in fit.joins] == list(foods) for fit in kept)


def is_plain(one):
    """Whether only its slots say where a food joins a dish that has a place for it."""
    ways = (one.laid, one.bound, one.pan, one.turned, one.batter)
    side = any(spot.side for spot in one.spots) or any(place.slot.cooked for place in one.places)
    return not side and not one.made and all(way is None for way in ways)


def best_place(one, food, alike):
    """Return the slot that a food takes and how well: of all places that are looked at, the first of the best."""
    likely = {kind: METHODS.joining_counts.likely(food, kind, one.frame.dish_type) for kind in one.stage_types}
    needs = {n for dish in KNOWN.dishes_named(one.frame.dish_type) for ns in dish.needs for n in ns}
    mine = {need for need in needs if is_need(need, food.facts)}
    rows = [(NATURAL - 1e-9, None)]
    for place in one.places:
        slot, same = place.slot, place.slot.kind == food.facts.kind
        if slot.kind == "water" and not food.facts.is_a("liquid", "water", "creamy", "frozen"):
            continue
        fit = alike(singular(food.label), slot.food)
        fit = max(fit, 0.6) if same else fit if slot.kind in food.facts.kinds or fit >= 0.8 else 0.7 * fit
        fit = 1.0 if slot.food in {singular(food.label), food.facts.taken_for} else fit
        if mine & place.needs or (mine and place.main and food.facts.is_a(*MAIN)):
            fit = max(fit, 0.55)
        share = likely[place.spot.stage_type] / max(likely.values())
        if NATURAL <= fit < 0.99 and not same:
            fit *= 0.6 + 0.4 * share if share >= 0.75 else 0.0
        rows.append((fit, slot))
    return max(rows, key=lambda row: row[0])


PLAIN = [one for one in LAYOUTS if is_plain(one)]


@settings(max_examples=100, deadline=None)
@given(
    RECIPES, st.sampled_from(PLAIN), st.lists(st.sampled_from((0.0, 0.5, 0.72, 0.8, 0.9, 1.0)), min_size=9, max_size=9)
)
def test_a_food_takes_the_best_place_of_all(foods, one, sure):
    kept = [food for food in foods if not food.facts.is_a("herb", "made", "dough", "ready")]
    pairs = ((food, place) for food in kept for place in one.places)
    likes = Likes({(singular(f.label), p.slot.food): sure[n % 9] for n, (f, p) in enumerate(pairs)})
    for join in Matcher(METHODS.joining_counts, likes.alike, kept).joins(one, kept):
        fit, slot = best_place(one, join.want, likes.alike)
        assert join.slot is slot
        assert slot is None or join.fit == pytest.approx(fit)


@pytest.mark.parametrize(
    ("title", "baked"),
    [
        ("Roasted beet salad", True),
        ("Grilled corn salad", True),
        ("Baked bean salad", True),
        ("Swiss chard salad", False),  # no char in it
        ("Poppy seed salad", False),
        ("Popcorn salad", False),
        ("Smoky bean salad", False),
    ],
)
def test_only_a_form_of_a_verb_says_that_a_dish_comes_out_of_an_oven(title, baked):
    assert is_baked("salad", title, KNOWN) is baked


def test_a_food_of_which_nothing_is_known_may_be_what_a_title_names():
    asked = wants(chilli="chopped", datshixyz="crumbled")
    assert refusals(asked, "vegetables", "chillies and cheese", KNOWN) == []
    assert refusals(wants(chilli="chopped"), "vegetables", "chillies and cheese", KNOWN)


def test_a_food_of_which_nothing_is_known_is_no_flesh_that_somebody_has_to_cook():
    assert refusals(wants(onion="chopped", ternascoxyz="whole"), "vegetables", "onions with lamb", KNOWN)


def test_what_gives_a_broth_makes_a_soup_of_water_from_the_tap():
    assert refusals(wants(pork="chopped", onion="chopped"), "soup", "", KNOWN) == []
    assert refusals(wants(salt="granulated"), "soup", "", KNOWN)
