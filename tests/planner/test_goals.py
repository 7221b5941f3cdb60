import itertools

from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import node

from foon_kg.goals.ranking import LOOKED_AT, likeliest, rank_goals
from foon_kg.knowledge import LikelyGoals
from foon_kg.model import Goal, RequiredIngredient

FOODS = frozenset(
    {"blueberry", "muffin", "rice", "blood orange", "potato", "carrot", "egg", "onion", "orange", "salad"}
)


def goal(text, dish_type="salad"):
    made = node(text)
    return Goal(made, dish_type, made.ingredients, ("video",))


def same(required, known):
    return 1.0 if required == known else 0.8 if required[0] == known[0] else 0.0


def wants(*names):
    return [RequiredIngredient(name, "whole") for name in names]


def ranked(goals, *names, dish_type="salad"):
    return rank_goals(goals, wants(*names), name_confidence=same, known_foods=FOODS, dish_type=dish_type)


def test_the_goal_that_shares_more_foods_comes_first():
    less, more = goal("salad{onion,salt}@bowl"), goal("green salad{onion,lettuce}@bowl")
    assert [r.goal for r in ranked([less, more], "onion", "lettuce")] == [more, less]


def test_a_goal_that_names_a_food_the_recipe_has_not_comes_last_however_like_it_is():
    potato, plain = goal("potato salad{onion,salt,egg}@bowl"), goal("salad{onion}@bowl")
    first, last = ranked([potato, plain], "onion", "salt", "egg")
    assert (first.goal, last.goal) == (plain, potato)
    assert last.misnamed == ("potato",)


def test_the_word_of_the_dish_type_and_plurals_are_no_other_foods():
    eggs = goal("scrambled eggs{egg}@plate", "omelette")
    assert ranked([eggs], "egg", dish_type="omelette")[0].misnamed == ()
    assert ranked([eggs], "onion", dish_type="omelette")[0].misnamed == ("egg",)
    assert ranked([goal("carrot salad{onion}@bowl")], "carrot")[0].misnamed == ()


def test_an_orange_is_no_blood_orange_and_a_blood_orange_is_an_orange():
    blood = goal("blood orange salad{blood orange,onion}@bowl")
    assert ranked([blood], "orange")[0].misnamed == ("blood orange",)
    assert ranked([blood], "blood orange")[0].misnamed == ()
    assert ranked([goal("orange salad{orange}@bowl")], "blood orange")[0].misnamed == ()


def test_each_ingredient_of_the_goal_counts_once():
    two = goal("salad{onion}@bowl")
    assert ranked([two], "onion", "olive")[0].score == 1.0


def test_equal_goals_are_ordered_by_fewer_other_ingredients_then_by_content():
    big, small = goal("salad{onion,x}@bowl"), goal("salad{onion}@bowl")
    assert [r.goal for r in ranked([big, small], "onion")] == [small, big]
    here, there = goal("salad{onion}@bowl"), goal("salad{onion}@plate")
    assert [r.goal for r in ranked([there, here], "onion")] == [here, there]


goals = st.lists(
    st.sets(st.sampled_from(["onion", "salt", "egg", "potato"]), min_size=1).map(
        lambda names: goal("salad{" + ",".join(sorted(names)) + "}@bowl")
    ),
    min_size=1,
    max_size=4,
    unique=True,
)


@given(goals)
def test_the_order_in_which_goals_come_does_not_matter(found):
    orders = {tuple(r.goal for r in ranked(list(order), "onion", "egg")) for order in itertools.permutations(found)}
    assert len(orders) == 1


def test_the_kind_of_dish_at_the_end_of_a_name_is_no_missing_food():
    muffin, rice = goal("blueberry muffin{blueberry,flour}", "cake"), goal("fried rice{rice,egg}", "cake")
    first, last = ranked([muffin, rice], "blueberry", "egg", dish_type="cake")
    assert (first.goal, first.misnamed) == (muffin, ())
    assert (last.goal, last.misnamed) == (rice, ("rice",))


contents = st.sets(st.sampled_from(sorted(FOODS)), max_size=4).map(",".join)


@given(st.sets(contents, min_size=1, max_size=12), st.integers(1, 6), st.integers(1, 4))
def test_the_likeliest_goals_are_told_without_looking_at_those_that_cannot_be(filled, least, at_once):
    goals = [goal(f"{name}{{{food}}}") for name in ("salad", "egg salad") for food in sorted(filled)]
    whole = ranked(goals, "onion", "egg", "rice")
    by_score = sorted(whole, key=lambda r: -r.score)
    looked_at = []

    def ask(count):
        looked_at.append(count)
        shown = count * at_once // LOOKED_AT
        most = by_score[shown].score if shown < len(by_score) else None
        return LikelyGoals(tuple(r.goal for r in by_score[:shown]), FOODS, most)

    found = likeliest(ask, lambda likely: ranked(likely.goals, "onion", "egg", "rice"), least)
    assert list(found) == list(whole[: len(found)])
    assert len(found) >= min(least, len(whole))
    assert looked_at == sorted(set(looked_at))
