"""``--kitchen FILE``, planning without a dish type, ``--enumerate``, and ``foon suggest``, as a person calls them."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.plans.result import PlanFailure, PlanResult

SALAD = ["--dish", "salad", "chopped onion", "chopped tomato", "olive oil", "salt"]
UTENSILS = "knife\ncutting board\nsalad bowl\nbowl\nspoon\nwhisk\n"
PANS = "frying pan\nstove\nmixing bowl\nwhisk\nfork\nspatula\nturner\nplate\nknife\nspoon\n"
FOODS = "onion\ntomato, chopped\nolive oil\nsalt\n"


def foon(command, *arguments, stdin=None):
    return CliRunner().invoke(app, [command, *map(str, arguments), "--files", str(demo_folder())], input=stdin)


@pytest.fixture
def kitchen(tmp_path):
    def write(text, name="kitchen.txt"):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.mark.slow
def test_a_plan_takes_what_the_kitchen_has_and_check_agrees(kitchen):
    file = kitchen(UTENSILS + FOODS)
    answer = foon("plan", *SALAD, "--kitchen", file, "--json")
    assert answer.exit_code == 0, answer.stderr
    leaves = {(leaf["label"], *leaf["states"]) for leaf in json.loads(answer.stdout)["kitchen"]}
    assert ("tomato", "chopped") in leaves
    assert foon("check", "-", "--kitchen", file, stdin=answer.stdout).exit_code == 0
    without = foon("check", "-", stdin=answer.stdout)
    assert (without.exit_code, "C6" in without.stdout) == (1, True)
    other = foon("check", "-", "--kitchen", kitchen("knife\n", "other.txt"), stdin=answer.stdout)
    assert "it is not in the kitchen that was named" in other.stdout


@pytest.mark.slow
def test_places_and_contents_are_said_in_words_and_believed(kitchen):
    placed = kitchen(UTENSILS + FOODS.replace("tomato, chopped", "tomato, chopped on plate"))
    answer = foon("plan", *SALAD, "--kitchen", placed, "--json")
    leaves = [(leaf["label"], *leaf["ingredients"]) for leaf in json.loads(answer.stdout)["kitchen"]]
    assert ("plate", "tomato") in leaves
    assert foon("check", "-", "--kitchen", placed, stdin=answer.stdout).exit_code == 0
    full = kitchen(UTENSILS.replace("salad bowl", "salad bowl {rice}") + FOODS, "full.txt")
    refused = foon("plan", *SALAD, "--kitchen", full)
    assert refused.exit_code == 3
    assert "a salad bowl (there is salad bowl ({rice}))" in refused.stderr
    free = foon("plan", *SALAD, "--kitchen", kitchen(UTENSILS + FOODS, "free.txt"), "--json").stdout
    for other, leaf in ((full, "salad bowl (empty)"), (placed, "tomato (chopped)")):
        judged = foon("check", "-", "--kitchen", other, stdin=free)
        assert judged.exit_code == 1
        assert f"{leaf}: it is not in the kitchen that was named" in judged.stdout


@pytest.mark.slow
@pytest.mark.parametrize(
    ("there", "asked", "taken", "note"),
    [
        ("egg, cracked in bowl", "beaten egg", "cracked", ""),
        ("egg, beaten", "cracked egg", "beaten", ""),
        ("egg, cracked in bowl", "egg", "cracked", "“egg” names no state: taken as cracked, as it is there"),
        (f"{PANS}bowl {{beaten egg}}", "egg", "beaten", "“egg” names no state: taken as beaten, as it is there"),
        ("egg", "beaten egg", "whole", ""),
    ],
)
def test_what_is_there_opened_or_in_the_asked_state_is_taken_as_it_is(kitchen, there, asked, taken, note):
    file = kitchen(f"{there}\nbutter\nsalt\n")
    answer = foon("plan", "--dish", "omelette", asked, "butter", "salt", "--kitchen", file, "--json")
    assert answer.exit_code == 0, answer.stderr
    assert note in answer.stderr
    plan = json.loads(answer.stdout)
    leaves = [leaf for leaf in plan["kitchen"] if leaf["label"] == "egg"]
    assert [leaf["states"] for leaf in leaves] == [[taken]]
    assert ("crack" in {unit["motion_node"] for unit in plan["units"]}) is (taken == "whole")
    assert foon("check", "-", "--kitchen", file, stdin=answer.stdout).exit_code == 0


@pytest.mark.slow
def test_a_stove_that_is_on_is_used_as_it_is_and_turned_off_in_the_end(kitchen):
    file = kitchen(PANS.replace("stove", "stove, on"))
    answer = foon("plan", "--dish", "omelette", "egg", "butter", "salt", "--kitchen", file, "--json")
    plan = json.loads(answer.stdout)
    assert ("stove", ["on"]) in [(leaf["label"], leaf["states"]) for leaf in plan["kitchen"]]
    motions = [unit["motion_node"] for unit in plan["units"]]
    assert ("turn on" in motions, motions.count("turn off")) == (False, 1)
    assert foon("check", "-", "--kitchen", file, stdin=answer.stdout).exit_code == 0
    assert "the stove is said to be on, and nobody turned it on" in foon("check", "-", stdin=answer.stdout).stdout


@pytest.mark.slow
def test_a_kitchen_says_how_many_and_one_too_few_is_told(kitchen):
    def file(boards, name):
        return kitchen(UTENSILS.replace("cutting board", boards), name)

    two = foon("plan", *SALAD, "--kitchen", file("2 cutting boards", "two.txt"))
    assert two.exit_code == 0, two.stderr
    assert "2 x cutting board (empty)" in " ".join(two.stdout.split())
    told = foon("plan", *SALAD, "--json").stdout
    assert foon("check", "-", "--kitchen", file("cutting board", "any.txt"), stdin=told).exit_code == 0
    one = file("1 cutting board", "one.txt")
    refused = foon("plan", *SALAD, "--kitchen", one)
    assert (refused.exit_code, "a cutting board (2 are needed, 1 there)" in refused.stderr) == (3, True)
    judged = foon("check", "-", "--kitchen", one, stdin=told)
    assert judged.exit_code == 1
    assert "C6 cutting board (empty): 2 are needed, and the kitchen that was named has 1" in judged.stdout
    board = {"label": "cutting board", "states": ["empty"]}
    for said, code in ({"count": 1}, 3), ({"things": [4, 7]}, 0), ({"thing": 4}, 3), ({}, 0):
        named = kitchen(
            json.dumps([*UTENSILS.replace("cutting board\n", "").split("\n")[:-1], board | said]), "said.json"
        )
        assert foon("plan", *SALAD, "--kitchen", named).exit_code == code


@pytest.mark.slow
def test_the_kitchen_of_a_plan_is_a_kitchen_in_which_it_is_planned_again(kitchen):
    plain = json.loads(foon("plan", *SALAD, "--json").stdout)
    again = foon("plan", *SALAD, "--json", "--kitchen", kitchen(json.dumps(plain["kitchen"]), "kitchen.json"))
    assert json.loads(again.stdout) == plain


@pytest.mark.slow
def test_what_is_missing_is_told_with_exit_code_3_and_as_a_list(kitchen):
    answer = foon("plan", *SALAD, "--json", "--kitchen", kitchen(UTENSILS.replace("salad bowl\n", "")))
    assert answer.exit_code == 3
    error = json.loads(answer.stdout)["error"]
    assert error["code"] == "missing"
    assert [entry["remedy"] for entry in error["missing"]] == ["get a salad bowl"]
    assert PlanFailure.from_json(json.loads(answer.stdout)).missing
    message, hint = answer.stderr.splitlines()[-2:]
    assert message.startswith("error: the kitchen lacks ")
    assert hint.startswith("hint: Get a ")


@pytest.mark.slow
def test_an_unknown_word_is_said_with_its_line_and_a_file_that_cannot_be_read_is_refused(kitchen):
    file = kitchen(f"{UTENSILS}{FOODS}oniom\n")
    answer = foon("plan", *SALAD, "--kitchen", file)
    assert f"{file}:11: this FOON knows no food “oniom” (near it: onion); it counts as a food at hand" in answer.stderr
    broken = kitchen("{", "broken.json")
    for command in (["plan", *SALAD], ["suggest", "egg"]):
        refused = foon(*command, "--kitchen", broken)
        assert (refused.exit_code, refused.stdout) == (1, "")
        assert f"error: {broken}:1: not JSON" in refused.stderr


def test_without_a_dish_type_the_answer_names_the_one_that_was_taken():
    answer = foon("plan", "beaten egg", "grated cheddar", "--json")
    assert PlanResult.from_json(json.loads(answer.stdout)).recipe.dish_type == "omelette"
    assert "no dish type was asked: omelette is most like these" in answer.stderr


def test_without_a_dish_type_nothing_is_written_to_a_file_that_goes_on(tmp_path):
    answer = foon("plan", "egg", "--output", tmp_path / "plans.jsonl")
    assert (answer.exit_code, answer.stdout) == (2, "")
    assert "--output needs to know the dish type" in answer.stderr


def test_enumerate_lists_candidates_in_order_beside_the_exact_search():
    answer = foon("plan", *SALAD, "--enumerate", "--limit", "50", "--json", "--quiet")
    value = json.loads(answer.stdout)
    ranks = [(tree["penalty"], -tree["overlap"], tree["units"]) for tree in value["candidates"]]
    assert ranks == sorted(ranks)
    assert (value["complete"], value["looked_at"]) == (False, 50)
    exact = value["exact"]
    assert exact["exact"]
    assert (exact["penalty"], -exact["overlap"], exact["units"]) <= ranks[0]
    assert len(exact["seen_in"]) == exact["units"]


@pytest.mark.slow
def test_enumerate_says_when_it_stopped_and_when_these_were_all():
    some = foon("plan", *SALAD, "--enumerate", "--limit", "20")
    assert "Stopped after 20 combinations of producers" in some.stdout
    assert "The exact search chooses" in some.stdout
    every = foon("plan", "--dish", "drinks", "milk", "banana", "--enumerate")
    assert "These are all: " in every.stdout
    assert "The exact search chooses number 1: " in every.stdout


@pytest.mark.parametrize("other", ["--foon", "--explain"])
def test_enumerate_is_a_form_of_its_own(other):
    answer = foon("plan", *SALAD, "--enumerate", other)
    assert (answer.exit_code, answer.stdout) == (2, "")
    assert f"{' and '.join(sorted(('--enumerate', other), key=lambda o: o != '--enumerate'))} ask for" in answer.stderr


def test_suggest_names_dishes_with_what_is_missing_and_left_over():
    answer = foon("suggest", "egg", "onion", "grated cheddar", "--limit", "2")
    assert answer.exit_code == 0, answer.stderr
    for words in ("(omelette): ", "takes cheddar, egg", "missing butter, milk, salt", "leaves onion"):
        assert words in answer.stdout
    assert "23 dishes were compared by name" in answer.stdout


def test_suggest_in_json_is_one_value_with_the_best_first(kitchen):
    file = kitchen("egg\nmilk\nbutter\nsalt\n")
    answer = foon("suggest", "cheddar", "--kitchen", file, "--json", "--quiet")
    assert answer.stderr == ""
    value = json.loads(answer.stdout)
    shares = [one["share"] for one in value["suggestions"]]
    assert shares == sorted(shares, reverse=True)
    first = value["suggestions"][0]
    assert (first["goal"]["label"], first["missing"], first["share"]) == ("cheese omelette", [], 1.0)
    assert {"goal", "dish_type", "videos", "units", "taken", "assumed", "unused", "exact"} <= first.keys()
    assert (value["considered"], len(shares)) == (23, 5)


@pytest.mark.slow
def test_what_is_suggested_as_complete_can_be_planned_from_the_same_kitchen(kitchen):
    file = kitchen("egg\nmilk\nbutter\nsalt\ncheddar\n")
    first = json.loads(foon("suggest", "--kitchen", file, "--json").stdout)["suggestions"][0]
    answer = foon("plan", "--dish", first["dish_type"], *(t["own"] for t in first["taken"]), "--kitchen", file)
    assert answer.exit_code == 0, answer.stderr


@pytest.mark.slow
def test_a_suggestion_lacks_the_utensils_that_the_plan_of_that_dish_lacks(kitchen):
    file = kitchen("frying pan\nfork\nstove\negg\nbutter\nsalt\nmilk\ncheddar\n")
    found = json.loads(foon("suggest", "--kitchen", file, "--json").stdout)["suggestions"]
    shares = [one["share"] for one in found]
    assert shares == sorted(shares, reverse=True)
    one = next(one for one in found if one["goal"]["label"] == "cheese omelette")
    asked = [taken["own"] for taken in one["taken"]]
    plan = foon("plan", "--dish", "omelette", *asked, "--after", one["videos"][0], "--kitchen", file, "--json")
    lacking = {entry["node"]["label"] for entry in json.loads(plan.stdout)["error"]["missing"]}
    assert lacking == set(one["missing"])
    assert len(lacking) > 1


@pytest.mark.parametrize(
    ("foods", "code", "message"),
    [((), 2, "no food is at hand"), (("dragon fruit jam xyz",), 3, "no dish of this FOON takes any of")],
)
def test_suggest_without_anything_to_go_by_says_so(foods, code, message):
    answer = foon("suggest", *foods)
    assert (answer.exit_code, answer.stdout) == (code, "")
    assert message in answer.stderr
    assert "hint: " in answer.stderr
