"""A newly loaded video teaches its dish, and takes it along when it is removed: no line of code knows it."""

from __future__ import annotations

from pathlib import Path

import pytest
from demo_foon import demo_subgraphs
from integration.told import KITCHEN
from planner.judged import judge
from planner.public_foon import public_snapshot

from foon_kg.loaders import read_paths
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.store.snapshot import Snapshot

DATA = Path(__file__).parent / "data"
NEW = {one.subgraph.name: one.subgraph for one in read_paths([DATA])}


def recipe(title, dish_type, **foods):
    asked = (RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items())
    return Recipe(dish_type, tuple(asked), title.replace(" ", "_"), title)


ASKED = {
    "quark_dumplings": recipe(
        "ricotta dumplings", "noodle", ricotta="creamy", egg="whole", flour="powder", nutmeg="ground", salt="granulated"
    ),
    "pea_risotto": recipe(
        "mushroom risotto", "rice", arborio_rice="uncooked", shallot="chopped", olive_oil="liquid", mushroom="sliced",
        chicken_stock="liquid", pecorino="grated",
    ),
    "strawberry_trifle": recipe(
        "raspberry trifle", "pudding", ladyfinger="whole", raspberry="whole", custard="creamy", whipping_cream="liquid",
        sugar="granulated",
    ),
}  # fmt: skip
MADE = {
    "quark_dumplings": ("dumpling", "plate", ["crack", "knead", "shape", "boil"]),
    "pea_risotto": ("risotto", "bowl", ["chop", "grate", "cook and stir", "simmer"]),
    "strawberry_trifle": ("trifle", "glass bowl", ["whip", "pour", "chill"]),
}
"""What the dish is called, in or on what it is served, and what is done in this order."""

BY_TABLE = {"pea_risotto": "rice", "strawberry_trifle": "pudding"}
"""What a technique of the tables makes, too, as a plain dish of its type; it is called so only after a video of it."""

every_new_dish = pytest.mark.parametrize("video", sorted(NEW))


@pytest.fixture(scope="module")
def demo():
    return list(demo_subgraphs())


def planned(asked, subgraphs):
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    return snapshot, Planner(snapshot, PlanSettings(KITCHEN, time_limit=None), snapshot.units).plan(asked)


def goal_of(asked, subgraphs):
    """What a recipe becomes, or the code of the error that says why there is no tree."""
    try:
        return planned(asked, subgraphs)[1].goal.label
    except NoTreeError as error:
        return error.code


def in_order(wanted, motions):
    """Whether the wanted motions are among all in their order."""
    rest = iter(motions)
    return all(motion in rest for motion in wanted)


def amiss(video, snapshot, result):
    """Return what is wrong with the tree of a video's dish: its name, its foods, its steps, what the judge finds."""
    label, vessel, motions = MADE[video]
    done = [unit.motion for unit in result.units]
    lacking = {one.object for one in ASKED[video].ingredients} - set(result.goal.ingredients)
    report = judge(result, snapshot, KITCHEN)
    checked = {
        f"it is {result.goal}": (result.goal.label, result.goal.container) == (label, vessel),
        f"it is made after {result.reference.videos}": result.reference.videos == (video,),
        f"it lacks {lacking}": not lacking,
        f"it is done so: {done}": in_order(motions, done),
        "the judge does not accept it": report.accepted,
    }
    fatal = [str(finding) for finding in report.findings if not finding.minor]
    return [why for why, holds in checked.items() if not holds] + fatal


@pytest.mark.parametrize("video", sorted(NEW))
def test_the_videos_are_as_annotators_write_them(video):
    (read,) = read_paths([DATA / f"{video}.txt"])
    assert read.notices == ()
    assert 10 <= len(read.subgraph.annotations) <= 20
    assert ASKED.keys() == MADE.keys() == NEW.keys()


@pytest.mark.slow
@every_new_dish
def test_beside_the_demo_a_new_video_teaches_its_dish_and_takes_it_along(video, demo):
    before = goal_of(ASKED[video], demo)
    assert before == BY_TABLE.get(video, "no-goal")
    assert amiss(video, *planned(ASKED[video], [*demo, NEW[video]])) == []
    others = [one for name, one in NEW.items() if name != video]
    assert goal_of(ASKED[video], [*demo, *others]) == before


def test_all_three_at_once_teach_all_three(demo):
    for video, asked in ASKED.items():
        assert amiss(video, *planned(asked, [*NEW.values(), *demo])) == []


@pytest.mark.parametrize(
    ("video", "told"),
    [
        ("quark_dumplings", [("ricotta", "quark")]),
        ("pea_risotto", [("shallot", "onion"), ("pecorino", "parmesan"), ("arborio rice", "rice")]),
        ("strawberry_trifle", [("raspberry", "strawberry"), ("whipping cream", "cream")]),
    ],
)
def test_foods_that_the_video_does_not_have_are_declared_with_what_they_are_handled_like(video, told, demo):
    _, result = planned(ASKED[video], [*demo, NEW[video]])
    found = {(one.object, one.equivalent): one.confidence for one in result.substitutions if one.kind == "object"}
    assert {pair for pair, sure in found.items() if sure > 0.5} >= set(told)


def test_what_is_boiled_is_boiled_in_something(demo):
    _, result = planned(ASKED["quark_dumplings"], [*demo, NEW["quark_dumplings"]])
    assert "water" in {node.label for node in result.kitchen}


def test_what_is_laid_in_layers_is_not_stirred(demo):
    _, result = planned(ASKED["strawberry_trifle"], [*demo, NEW["strawberry_trifle"]])
    motions = [unit.motion for unit in result.units]
    assert not {"stir", "mix"} & set(motions[motions.index("whip") :])


@pytest.mark.shared_data
def test_beside_the_public_foon_new_videos_teach_their_dishes():
    snapshot = public_snapshot()
    public = Planner(snapshot, PlanSettings(KITCHEN), snapshot.units)
    more = Snapshot.of([*snapshot.subgraphs, *NEW.values()], KITCHEN)
    taught = Planner(more, PlanSettings(KITCHEN), more.units)
    for video, asked in ASKED.items():
        assert public.plan(asked).goal.label != MADE[video][0]
        assert amiss(video, more, taught.plan(asked)) == []
