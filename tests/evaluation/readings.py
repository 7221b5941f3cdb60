"""Trees for a reading, made by hand, and what readers may say of one."""

from __future__ import annotations

from pathlib import Path

from hypothesis import strategies as st

from foon_kg.evaluation.reading import (
    ReadingTree,
)
from foon_kg.evaluation.reading_sheet import Verdict
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Subgraph

PROGRAM = Path(__file__).parents[2] / "benchmarks" / "reading.py"

DISHES = ("salad", "soup", "rice")

YES, BUT, NO = Verdict(True, True, True), Verdict(True, True, False), Verdict(False, False, False)
words = st.text(st.characters(exclude_categories=("C", "Z")) | st.just(" "), max_size=20).map(str.strip)
verdicts = st.builds(
    lambda robot, cook, said: Verdict(robot, cook != "no", cook == "yes", said),
    st.booleans(),
    st.sampled_from(["yes", "yes, but", "no"]),
    words,
)


def node(label, *states, inside=None):
    relation = "in" if inside else None
    return {"label": label, "states": list(states), "ingredients": [], "relation": relation, "container": inside}


def plan(name, dish_type="salad", **more):
    """A plan result of one step."""
    return {
        "recipe": {
            "id": name,
            "title": None,
            "dish_type": dish_type,
            "ingredients": [{"object": "egg", "state": "raw"}],
        },
        "goal": node(dish_type),
        "units": [
            {
                "input_nodes": [node("egg", "whole"), node("knife")],
                "motion_node": "chop",
                "output_nodes": [node("egg", "chopped", inside="bowl")],
                "origin": "adapted",
                "seen_in": [{"video": "secret-video", "unit": 3, "source": None, "start": 1.0, "end": 2.0}],
            }
        ],
        "kitchen": [node("egg", "whole")],
        "substitutions": [],
        "assumptions": [],
        **more,
    }


def failure(name):
    given = plan(name)
    return {"recipe": given["recipe"], "error": {"code": "no-goal", "message": "no way", "hint": ""}}


def planned(count, dishes=DISHES):
    names = [(f"{dish}{number}", dish) for dish in dishes for number in range(count)]
    return [ReadingTree(name, dish, plan(name, dish)) for name, dish in names]


def video(name, dish_type="soup"):
    taken = (Participant(ObjectNode("onion", ("chopped",))), Participant(ObjectNode("egg", ("beaten",))))
    goal = Participant(ObjectNode("omelette", ("cooked",), ("egg", "onion")), dish_type=dish_type)
    return Subgraph(name, (Annotation(FunctionalUnit(taken, "cook", (goal,))),))


def written(tmp_path, text, name="file"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path
