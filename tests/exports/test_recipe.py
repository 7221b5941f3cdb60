"""A recipe that a person can cook from: sentences that say what is done to what, where and with what."""

from __future__ import annotations

import re

import pytest
from exports.odd_trees import of_file, trees
from hypothesis import given, settings
from kitchen_stories import ADD_ONION, ADD_SALT, CHOP_ONION, MIX, SALAD, node, subgraph, unit

from foon_kg.formats.exports.phrases import listed
from foon_kg.formats.exports.recipe import write_recipe
from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.formats.video_address import video_address
from foon_kg.model import Recipe, RequiredIngredient, Sighting
from foon_kg.model.claims import Assumption, Substitution
from foon_kg.model.tree import Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult, ReferenceSummary

KITCHEN = Kitchen.default()


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (CHOP_ONION[0], "Put the onion onto the cutting board."),
        (CHOP_ONION[1], "Chop the onion on the cutting board with the knife."),
        (ADD_ONION, "Pour the onion from the cutting board into the bowl."),
        (ADD_SALT, "Sprinkle the salt from the shaker into the bowl."),
        (MIX, "Mix the onion, salt and tomato in the bowl with the spoon to make the salad."),
        ("stove(off)@under pan > turn on > stove(on)@under pan", "Turn on the stove."),
        (
            "pan(empty)@on stove; stove(on)@under pan > heat > pan(empty,hot)@on stove",
            "Heat the pan on the stove until hot.",
        ),
        (
            "bowl(empty); egg(whole) > crack > bowl{egg white,egg yolk}; egg white@bowl; egg yolk@bowl",
            "Crack the egg into the bowl.",
        ),
        ("bowl{a,b}; batter(mixed){a,b}@bowl; spoon > stir > bowl{a,b}; batter(smooth){a,b}@bowl",
         "Stir the batter in the bowl with the spoon until smooth."),
        ("onion(whole) > peel > onion(whole,peeled)", "Peel the onion."),
        ("onion(whole); cutting board(empty); knife > dice > onion(diced)@on cutting_board; cutting board{onion}",
         "Dice the onion on the cutting board with the knife."),
        ("carrot@on cutting_board; knife > slice > carrot(halved)@on cutting_board",
         "Slice the carrot on the cutting board with the knife until halved."),
        ("lettuce@on cutting_board; knife > break apart > lettuce(pieces)@on cutting_board",
         "Break apart the lettuce on the cutting board with the knife into pieces."),
        ("celery; faucet(on); water(liquid)@from faucet > wash > celery(washed)", "Wash the celery under the faucet."),
        ("cup(empty); faucet(on); water(liquid)@from faucet > fill > cup{water}; water(liquid)@cup",
         "Fill the cup with the water from the faucet."),
        ("blender cup{milk}; blender lid > cover > blender cup{milk}@covered blender_lid; blender lid@on blender_cup",
         "Cover the blender cup with the blender lid."),
        ("blender cup{milk}; blender(off) > attach > blender cup{milk}@on blender; blender(off)@under blender_cup",
         "Attach the blender cup to the blender."),
        ("cooking pan{a,b}@on stove; oven(on) > insert > oven(on){cooking pan}; cooking pan{a,b}@oven",
         "Put the cooking pan from the stove into the oven."),
        ("oven(off){cooking pan}; cooking pan{pie}@oven > remove > oven(off,empty); cooking pan{pie}@hand",
         "Remove the cooking pan from the oven."),
        ("garlic@on cutting_board; knife > cut off ends > garlic(derooted)@on cutting_board",
         "Cut off the ends of the garlic on the cutting board with the knife."),
        ("onion@on cutting_board; knife > cut in half > onion(halved)@on cutting_board",
         "Cut the onion in half on the cutting board with the knife."),
        ("bowl{a,b,c,d}; a@bowl; mayonnaise(creamy); spoon > mix > salad(mixed){a,b,c,d,mayonnaise}@bowl",
         "Add the mayonnaise, then mix everything in the bowl with the spoon to make the salad."),
        ("salt(ground) > pour > mixing bowl{salt}", "Pour the salt into the mixing bowl."),
        (("loaf pan(hot){a,b}@oven; oven(off)@with loaf_pan; bread(baked){a,b}@loaf_pan > remove > "
         "loaf pan(hot){a,b}; bread(baked){a,b}@loaf_pan; oven(off)"),
         "Remove the loaf pan with the bread from the oven."),
        (("bowl{egg,milk}; bowl{flour,salt}; flour mixture(mixed){flour,salt}@bowl > pour > "
         "bowl{egg,milk,flour,salt}; flour mixture(mixed){flour,salt}@bowl; bowl(empty)"),
         "Pour the flour mixture from one bowl into the other."),
        (("bowl{broth,egg}; bowl{cheese}; cheese(grated)@bowl; soup(cooked){broth,egg}@bowl > pour > "
         "bowl{broth,cheese,egg}; soup(cooked){broth,cheese,egg}@bowl; bowl(empty)"),
         "Pour the cheese from one bowl into the other."),
        (("plate{chicken}; bowl{flour}; chicken@on plate; flour(powder)@bowl > dip > "
         "plate{chicken,flour}; chicken(coated)@on plate; flour(powder)@on plate; bowl{flour}"),
         "Dip the chicken into the flour in the bowl until coated."),
        ("bowl(empty); bowl{salmon}; salmon(flaked)@bowl > pour > bowl{salmon}; salmon(flaked)@bowl; bowl(empty)",
         "Pour the salmon from one bowl into an empty one."),
        ("pot{bay leaf,rice}; bay leaf@pot; plate; tong > remove > pot{rice}; bay leaf@on plate; plate{bay leaf}",
         "Remove the bay leaf from the pot onto the plate with the tongs."),
        (("jar{mustard}; mustard(creamy)@jar; plate{bread}; knife; bread@on plate > spread > "
         "plate{bread,mustard}; bread@on plate; mustard(creamy)@on plate; jar"),
         "Spread the mustard from the jar over the bread on the plate with the knife."),
        (("pot{spaghetti,water}@on stove; spaghetti(dry)@pot; water(boiling)@pot > boil > "
          "pot{spaghetti,water}@on stove; spaghetti(cooked)@pot; water(boiling)@pot"),
         "Boil the spaghetti in the water in the pot until cooked."),
        ("bowl{dough}; dough(kneaded)@bowl > ferment > bowl{dough}; dough(fermented,kneaded,rested)@bowl",
         "Let the dough rise in the bowl."),
        (("pan{onion,butter}; onion(chopped)@pan; butter(melted)@pan; spoon > cook and stir > pan{onion,butter}; "
         "onion(chopped,mixed,partly cooked)@pan; butter(melted,mixed)@pan"),
         "Cook and stir the butter and onion in the pan with the spoon until partly cooked."),
        ("onion@on cutting_board; knife > chop > onion(finely chopped)@on cutting_board",
         "Finely chop the onion on the cutting board with the knife."),
        ("fig@on cutting_board; knife > cut > fig(quartered)@on cutting_board",
         "Cut the fig on the cutting board with the knife into quarters."),
        ("pot{onion}; onion@pot; stove(on) > cook > pot{onion}; onion(cooked)@pot",
         "Cook the onion in the pot on the stove."),
        ("chicken@on cutting_board; knife > chop > chicken(cut)@on cutting_board",
         "Chop the chicken on the cutting board with the knife."),
        ("tray{cookie}; refrigerator(on); cookie@on tray > chill > cookie(cold)@on tray",
         "Chill the cookie on the tray in the refrigerator until cold."),
    ],
)  # fmt: skip
def test_a_unit_is_said_as_a_cook_would(line, said):
    assert sentence(unit(line), KITCHEN) == said


@pytest.mark.parametrize(
    ("names", "said"), [((), ""), (("a",), "a"), (("a", "b", "a"), "a and b"), ("abc", "a, b and c")]
)
def test_names_are_listed_once_with_an_and(names, said):
    assert listed(names) == said


@settings(max_examples=40, deadline=None)
@given(trees)
def test_any_tree_is_one_numbered_line_a_step_and_its_names_are_no_markup(tree):
    text = write_recipe(tree)
    steps = text.split("## Steps\n\n")[1].split("\n\n## Notes")[0].splitlines()
    assert [line.split(". ")[0] for line in steps] == [str(place) for place in range(1, len(tree.units) + 1)]
    without_escapes = re.sub(r"\\[^a-z\d\s]", "", re.sub(r"\(\[video[^]]*\]\([^)]*\)\)", "", text))
    assert not set("`*_[]<>|~&") & set(without_escapes)
    headings = [line for line in without_escapes.splitlines() if line.startswith("#")]
    assert [line for line in headings[1:] if line != "## Notes"] == ["## Ingredients", "## Utensils", "## Steps"]


def plan(**changes):
    steps = [unit(line) for line in SALAD]
    seen = (Sighting("greek", 3, "https://www.youtube.com/watch?v=abc", 70.0, 75.0),)
    salad = node("salad(mixed){onion,salt,tomato}@bowl")
    onion = RequiredIngredient("onion", "chopped")
    fields = {
        "recipe": Recipe("salad", (onion, RequiredIngredient("tomato", "diced"), onion), title="My salad"),
        "reference": ReferenceSummary(salad, 8, 2, exact=True),
        "goal": salad,
        "units": tuple(Step.of_unit(step, "foon", seen) for step in steps),
        "kitchen": (
            node("knife"),
            node("onion(whole)"),
            node("salt(granulated)@shaker"),
            node("bowl(empty)"),
            node("knife"),
        ),
    }
    return ExportedTree.of_plan(PlanResult(**fields | changes))


def test_ingredients_are_what_was_asked_with_amounts_where_they_are_known_and_what_else_is_needed():
    text = write_recipe(plan(), {RequiredIngredient("onion", "chopped"): "2 cups"})
    section = text.split("## Ingredients\n\n")[1].split("\n\n")[0]
    assert section.splitlines() == ["- 2 cups onion, chopped", "- tomato, diced", "- salt, granulated"]
    assert text.split("## Utensils\n\n")[1].split("\n\n")[0].splitlines() == ["- knife", "- bowl"]


def test_each_step_links_to_the_second_of_its_video():
    text = write_recipe(plan())
    assert text.startswith("# My salad\n\nA salad, made like salad.\n")
    step = "2. Dice the tomato on the cutting board with the knife."
    assert f"{step} ([video at 1:10](https://www.youtube.com/watch?v=abc&t=70s))" in text


def test_what_was_substituted_and_assumed_is_told():
    text = write_recipe(
        plan(
            substitutions=(
                Substitution("object", "onion", "onion", "leek", 0.875),
                Substitution("state", "tomato", "diced", "chopped", 0.9),
                Substitution("motion", "egg", "cook", "boil", 1.0),
            ),
            assumptions=(Assumption(node("onion(whole)"), "nothing makes it"),),
        )
    )
    assert text.split("## Notes\n\n")[1].splitlines() == [
        "- onion is handled like leek (confidence 0.88)",
        "- tomato is diced where the video has chopped (confidence 0.90)",
        "- cook the egg where the video has boil (confidence 1.00)",
        "- onion (whole): nothing makes it",
    ]


def test_a_foon_file_without_addresses_names_its_video():
    text = write_recipe(of_file(subgraph("my_video", "salad", *SALAD)))
    assert "1. Put the tomato onto the cutting board. (my\\_video)" in text
    assert "- tomato, whole" in text


@pytest.mark.parametrize(
    ("source", "start", "address"),
    [
        ("https://www.youtube.com/watch?v=a", 70.9, "https://www.youtube.com/watch?v=a&t=70s"),
        ("https://youtu.be/a", 5.0, "https://youtu.be/a?t=5s"),
        ("https://youtu.be/a#notes", 5.0, "https://youtu.be/a?t=5s#notes"),
        ("http://x.org/a.mp4", 70.5, "http://x.org/a.mp4#t=70.5"),
        ("http://x.org/a.mp4", None, "http://x.org/a.mp4"),
    ],
)
def test_an_address_leads_to_the_second(source, start, address):
    assert video_address(source, start) == address
