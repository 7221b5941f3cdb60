"""The front door: three lines to a plan, and what a plan can say of itself."""

from __future__ import annotations

import doctest
import re
import subprocess
import sys
from contextlib import nullcontext
from pathlib import Path

import pytest

import foon_kg
from foon_kg import Foon, Kitchen, foon
from foon_kg.food.motion_costs import MotionCosts
from foon_kg.foon import answering, changing, collected, drafting, evaluating, exploring, opened, plan
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.loaders import read_paths
from foon_kg.loaders.recipe_collections import RecipeCollections
from foon_kg.model.errors import NoTreeError, ReadError, UsageError
from foon_kg.planning import batch
from foon_kg.planning.batch import Question
from foon_kg.planning.settings import PlanSettings

ASKED = ["chopped onion", "diced tomato", "olive oil"]


@pytest.fixture(scope="module")
def door():
    return Foon.from_files(demo_folder())


@pytest.fixture(scope="module")
def salad(door):
    return door.plan("salad", ASKED)


@pytest.mark.slow
def test_the_examples_of_the_docstrings_are_true(door, salad):
    names = {"Foon": Foon, "foon": door, "plan": salad, "demo_folder": demo_folder}
    done = [
        doctest.testmod(module, extraglobs=names) for module in (foon, answering, drafting, evaluating, opened, plan)
    ]
    assert [one.failed for one in done] == [0] * len(done)
    assert sum(one.attempted for one in done) > 20


@pytest.mark.neo4j
def test_the_examples_of_a_foon_in_neo4j_are_true(empty_graph):
    with Foon(server=empty_graph) as door, RecipeCollections(demo_recipes(), print) as recipes:
        door.load(demo_folder())
        door.recipes.store(recipes)
        names = {"foon": door, "demo_folder": demo_folder}
        done = [doctest.testmod(module, extraglobs=names) for module in (changing, collected, exploring)]
    assert [one.failed for one in done] == [0, 0, 0]
    assert all(one.attempted > 5 for one in done)


@pytest.mark.slow
def test_the_example_of_readme_runs(capsys):
    text = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    exec(compile(example, "README.md", "exec"), {})
    assert "Toss the olive oil, onion and tomato in the salad bowl" in capsys.readouterr().out


def test_a_plan_has_its_steps_as_sentences_and_as_objects(salad):
    assert len(salad) == len(salad.steps) == len(salad.result.units)
    assert str(salad).splitlines()[0] == f"1. {salad.steps[0].text}"
    assert all(step.text.endswith(".") for step in salad)
    assert salad.goal in {node for step in salad for node in step.output_nodes}
    assert salad.check().accepted
    assert salad.notes == ("“olive oil” names no state: taken as liquid",)


def test_a_plan_says_why_and_shows_itself(salad):
    assert {one.want.object for one in salad.explain()} == {"onion", "tomato", "olive oil"}
    assert "<table>" in salad._repr_html_()
    assert salad.to_svg().startswith("<svg")
    assert list(salad.to_frame()["motion"]) == [step.motion for step in salad]


def test_a_plan_is_a_graph_in_which_food_flows_to_the_dish(salad):
    from networkx import has_path

    graph = salad.to_networkx()
    onion = next(node for node, data in graph.nodes(data=True) if data["label"] == "onion" and "whole" in node)
    assert has_path(graph, onion, str(salad.goal))
    assert sum(data["kind"] == "motion" for _, data in graph.nodes(data=True)) == len(salad)


@pytest.mark.parametrize("form", ["foon", "json", "dot", "mermaid", "graphml", "markdown", "behaviour-tree", "pddl"])
def test_a_plan_is_written_in_every_form(salad, form):
    assert "onion" in salad.export(form)


def test_wishes_are_kept(door):
    chosen = door.plan("salad", ["diced courgette", "olive oil"], substitute={"courgette": "cucumber"})
    assert "cucumber" in [one.equivalent for one in chosen.substitutions if one.kind == "object"]
    without = door.plan("salad", ASKED, avoid=["onion"])
    assert "onion" not in {node.label for step in without for node in (*step.input_nodes, *step.output_nodes)}
    assert any("onion" in note for note in without.notes)


def test_a_title_is_read_and_words_and_pairs_ask_the_same(door):
    words = door.plan("salad", ASKED, title="Salad")
    pairs = door.plan("salad", [("onion", "chopped"), ("tomato", "diced"), ("olive oil", "liquid")], title="Salad")
    assert words.to_json() == pairs.to_json()
    with pytest.raises(UsageError):
        door.plan("salad", ["chopped onion", ("tomato", "diced")])


def test_what_is_at_hand_is_all_there_is(door, tmp_path):
    (tmp_path / "kitchen.txt").write_text("spoon\nbowl\n")
    kitchen = door.kitchen(tmp_path / "kitchen.txt").kitchen
    with pytest.raises(NoTreeError):
        door.plan("salad", ASKED, kitchen=kitchen)


def test_other_questions_are_answered(door):
    nearest = door.similar("caper", limit=2)
    assert len(nearest) == 2
    assert nearest[0].confidence >= nearest[1].confidence
    assert door.retrieve("omelette").units
    assert door.suggest(["egg", "butter", "salt"], most=2)[0].goal.node.label.endswith("omelette")


def test_dishes_are_suggested_for_a_kitchen_as_for_the_names_in_it(door, tmp_path):
    (tmp_path / "kitchen.txt").write_text("egg\nbutter\nsalt\n", encoding="utf-8")
    read = door.kitchen(tmp_path / "kitchen.txt")
    named = door.suggest(["egg", "butter", "salt"], most=2)
    assert len(named) == 2
    assert door.suggest(read, most=2) == door.suggest(read.kitchen, most=2) == named


@pytest.mark.parametrize("foods", [Kitchen.default(), "egg"], ids=["everything", "one word"])
def test_what_names_no_foods_is_refused(door, foods):
    with pytest.raises(UsageError) as error:
        door.suggest(foods)
    assert error.value.hint


def test_what_a_plan_says_of_itself_prints_as_sentences(salad):
    told = str(salad.explain()).splitlines()
    assert [line for line in told if not line.startswith(" ")] == [
        "onion (chopped)",
        "tomato (diced)",
        "olive oil (liquid)",
    ]
    assert "  joins the others in step 6 (scrape), where onion joins in the recorded dish (1.00 like it)" in told
    assert str(salad.check()) == "plan: accepted (robot yes, cook yes, form kept)"


def test_many_questions_have_the_answers_that_each_has_alone(door):
    questions = [Question(dish_type="salad", texts=(food, "olive oil")) for food in ("chopped onion", "diced tomato")]
    questions.append(Question(dish_type="soop", texts=("carrot",)))
    with door.answers(questions, PlanSettings(), jobs=1) as answers:
        told = [(one.outcome.to_json(), one.notes) for one in answers]
    alone = [door.answer(question, PlanSettings()) for question in questions]
    assert told == [(one.outcome.to_json(), one.notes) for one in alone]
    assert [one.error is None for one in alone] == [True, True, False]
    with door.answers([], PlanSettings()) as none:
        assert list(none) == []


def test_questions_that_nobody_counted_are_taken_for_many(door, monkeypatch):
    processes = []
    monkeypatch.setattr(batch, "cores", lambda: 8)
    monkeypatch.setattr(Foon, "_of_whole", lambda *asked: processes.append(asked[-1]) or nullcontext(()))
    questions = [Question(dish_type="salad", texts=("olive oil",))] * 4
    for asked, count in ((questions, None), (iter(questions), 4), (iter(questions), None)):
        with door.answers(asked, PlanSettings(), count=count):
            pass
    assert processes == [1, 1, 8]


def test_a_process_has_one_recipe_at_least(door, monkeypatch):
    recipes = []
    monkeypatch.setattr(Foon, "_is_cheaper_in_parts", lambda _, settings, count: bool(recipes.append(count)))
    monkeypatch.setattr(Foon, "_of_whole", lambda *_: nullcontext(()))
    with door.answers([Question(dish_type="salad", texts=("olive oil",))] * 4, PlanSettings(), jobs=8):
        assert recipes == [1]


def test_a_tree_is_retrieved_as_it_is_asked_for(door, tmp_path):
    with pytest.raises(UsageError, match="at level 1"):
        door.retrieve("omelette", ["cooked"], level=1)
    (tmp_path / "kitchen.txt").write_text("spoon\nbowl\n")
    with pytest.raises(NoTreeError):
        door.retrieve("omelette", kitchen=door.kitchen(tmp_path / "kitchen.txt").kitchen)
    likely = door.retrieve("omelette", by="success", costs=MotionCosts({"crack": 0.5}))
    assert likely.units[-1].success is not None


def test_a_kitchen_says_what_had_to_be_decided_to_read_it(door, tmp_path):
    (tmp_path / "kitchen.txt").write_text("spoon\nunheard-of thing\n")
    read = door.kitchen(tmp_path / "kitchen.txt", ["chopped onion"])
    assert any("unheard-of thing" in note for note in read.notes)
    assert {"spoon"} == {node.label for node in read.kitchen.utensils_named}
    assert "onion" in {node.label for node in read.kitchen.foods_named}
    assert door.suggestions(read.kitchen, 1).found == door.suggestions(read.kitchen, 5).found[:1]


def test_what_is_named_beside_a_file_says_numbers_and_contents_as_a_file_does(door, tmp_path):
    (tmp_path / "kitchen.txt").write_text("spoon\n")
    for file in (None, tmp_path / "kitchen.txt"):
        named = door.kitchen(file, ["2 cutting boards", "bowl {beaten egg}"])
        assert (named.kitchen.numbers, named.notes) == ({"cutting board": 2}, ())
        assert [str(food) for food in named.kitchen.inside] == ["egg (beaten; in bowl)"]
    assert door.kitchen().kitchen.utensils_named is None


def test_what_needs_a_graph_says_so(door, tmp_path):
    asks = (
        lambda: door.cypher("RETURN 1"),
        lambda: door.load(demo_folder()),
        lambda: door.remove(["greek_salad"]),
        lambda: door.drafting.remove(["draft:1"]),
    )
    for ask in asks:
        with pytest.raises(UsageError, match="in files"):
            ask()
    with pytest.raises(ReadError):
        Foon.from_files(tmp_path)
    with pytest.raises(UsageError):
        Foon()


def test_the_door_is_opened_only_when_somebody_comes():
    code = "import sys, foon_kg; print('foon_kg.foon' in sys.modules, sorted(dir(foon_kg)))"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert told == f"False {sorted(foon_kg.__all__)}\n"
    with pytest.raises(AttributeError):
        _ = foon_kg.nothing


@pytest.mark.neo4j
def test_a_graph_is_asked_and_loaded_through_the_same_door(empty_graph):
    settings = (empty_graph.uri, empty_graph.user, empty_graph.password, empty_graph.database)
    with Foon.connect(*settings) as door:
        report = door.load(demo_folder())
        assert report.inserted
        assert door.cypher("MATCH (v:Video) RETURN count(v) AS n").rows == ((len(report.inserted),),)
        assert door.cypher("RETURN $limit AS n", {"limit": 3}).rows == ((3,),)
        in_memory = Foon.from_files(demo_folder()).plan("salad", ASKED)
        assert door.plan("salad", ASKED).to_json() == in_memory.to_json()
        assert door.plan("salad", ASKED).check().accepted
        door.close()
        assert door.cypher("RETURN 1 AS n").rows == ((1,),)


@pytest.mark.neo4j
def test_what_somebody_else_loads_is_evidence_at_once(empty_graph):
    settings = (empty_graph.uri, empty_graph.user, empty_graph.password, empty_graph.database)
    with Foon.connect(*settings) as door, Foon.connect(*settings) as other:
        other.load(demo_folder() / "greek_salad.txt")
        assert len(door.known.goals) == 1
        assert door.known is door.known
        other.load(demo_folder() / "garden_salad.txt")
        assert len(door.known.goals) == 2


@pytest.mark.parametrize("named", [{"user": "cook"}, {"password": "secret"}, {"database": "mine"}])
def test_what_opens_a_neo4j_is_refused_without_its_address(named):
    with pytest.raises(UsageError, match="of which Neo4j"):
        Foon.connect(**named)


@pytest.mark.neo4j
def test_a_video_is_taken_out_through_the_door_and_what_it_would_bring_is_told(empty_graph):
    settings = (empty_graph.uri, empty_graph.user, empty_graph.password, empty_graph.database)
    (salad,) = (one.subgraph for one in read_paths([demo_folder() / "greek_salad.txt"]))
    with Foon.connect(*settings) as door:
        door.store([salad])
        (told,) = door.remove(["greek_salad"], dry_run=True)
        assert [one.name for one in door.snapshot().subgraphs] == ["greek_salad"]
        assert list(door.remove(["greek_salad"])) == [told]
        assert door.snapshot().subgraphs == ()
        (again,) = door.differences([salad])
        assert again.added == told.dropped != ()
        with pytest.raises(UsageError, match="greek_salad"):
            door.remove(["greek_salad"])
