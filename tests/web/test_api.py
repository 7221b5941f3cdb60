"""The API answers what the commands answer, and refuses what it should in one form."""

from __future__ import annotations

import json
import re
import threading
from urllib.parse import urljoin

import pytest
from fastapi.testclient import TestClient
from pictures.demo_plans import demo_foon
from web.serving import SALAD, app, error_of

from foon_kg import Foon
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Subgraph
from foon_kg.planning.batch import Cook, Question
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.durations import Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.schedule import schedule as schedule_of
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.foon import FixedFoon
from foon_kg.web.words import FoonWords


@pytest.fixture(scope="module")
def client():
    with TestClient(app(), base_url="http://localhost") as made:
        yield made


def test_a_plan_is_what_foon_plan_prints(client):
    answer = client.post("/api/plan", json=SALAD)
    assert answer.status_code == 200
    told = answer.json()
    with demo_foon().reading() as view:
        asked = Question(dish_type=SALAD["dish_type"], texts=tuple(SALAD["ingredients"]))
        printed = Cook(view, PlanSettings()).answer(asked).outcome.to_json()
    assert {name: told[name] for name in printed} == json.loads(json.dumps(printed))
    assert len(told["videos"]) == len(told["units"])
    assert told.keys().isdisjoint({"explanations", "judged", "schedules", "pictures"})


def test_a_step_is_a_sentence_and_an_ingredient_has_the_amount_that_was_asked(client):
    asked = ["2 cups kohlrabi, sliced", "chopped onion", "3 tablespoons olive oil"]
    told = client.post("/api/plan", json=SALAD | {"ingredients": asked}).json()
    plan = Foon(snapshot=demo_foon()).plan(SALAD["dish_type"], asked)
    assert told["sentences"] == [step.text for step in plan.steps]
    assert told["amounts"] == ["2 cups", "", "3 tablespoons"]
    assert [line.endswith(" (2 cups kohlrabi).") for line in told["sentences"]].count(True) == 1
    assert told["recipe"]["ingredients"][0]["amount"] == "2 cups"


def test_the_judge_says_what_he_says_of_the_plan_from_python(client):
    told = client.post("/api/plan", json=SALAD | {"explain": True}).json()
    plan = Foon(snapshot=demo_foon()).plan(SALAD["dish_type"], SALAD["ingredients"])
    assert told["judged"] == json.loads(json.dumps(plan.check().to_json()))
    assert told["judged"]["accepted"]


def test_examples_are_what_videos_make_and_each_is_planned_in_so_many_steps(client):
    examples = client.get("/api/examples").json()["examples"]
    assert len({one["name"] for one in examples}) == 6
    assert {one["dish_type"] for one in examples} == set(demo_foon().vocabulary().dish_types)
    made = {(goal.node.label, video) for goal in demo_foon().goals() for video in goal.videos}
    assert made.issuperset((one["name"], one["video"]) for one in examples)
    for one in examples:
        asked = {"dish_type": one["dish_type"], "ingredients": one["ingredients"]}
        assert len(client.post("/api/plan", json=asked).json()["units"]) == one["units"]


def test_reasons_schedules_and_pictures_come_where_they_are_asked(client):
    plain = client.post("/api/plan", json=SALAD).json()
    told = client.post("/api/plan", json=SALAD | {"explain": True, "hands": [1, 2], "pictures": True}).json()
    assert {name: told[name] for name in plain} == plain
    assert [one["want"]["object"] for one in told["explanations"]] == ["kohlrabi", "onion", "olive oil"]
    assert [one["hands"] for one in told["schedules"]] == [1, 2]
    pictures = told["pictures"]
    assert [text[:4] for text in (pictures["tree"], pictures["progress"], *pictures["schedules"])] == ["<svg"] * 4


def test_a_schedule_of_the_api_is_that_of_the_command(client):
    told = client.post("/api/plan", json=SALAD | {"hands": [2]}).json()
    (schedule,) = told["schedules"]
    assert sorted(step["unit"] for step in schedule["steps"]) == list(range(len(told["units"])))
    assert {step["hands"] for step in schedule["steps"]} <= {0, 1, None}
    assert schedule["length"] == max(step["end"] for step in schedule["steps"]) <= schedule["alone"]
    with demo_foon().reading() as view:
        plan = Cook(view, PlanSettings()).answer(Question(dish_type="salad", texts=tuple(SALAD["ingredients"]))).outcome
    expected = schedule_of(plan.units, plan.kitchen, Durations.of_units(demo_foon().units), Kitchen.default(), 2)
    assert schedule == json.loads(json.dumps(expected.to_json()))


def test_another_equivalent_can_be_chosen(client):
    asked = {"dish_type": "salad", "ingredients": ["chopped zucchini", "chopped onion", "olive oil"]}
    first = client.post("/api/plan", json=asked).json()["substitutions"][0]
    other = first["alternatives"][0]["name"]
    again = client.post("/api/plan", json=asked | {"substitutes": [{"food": "zucchini", "like": other}]}).json()
    assert again["substitutions"][0]["equivalent"] == other != first["equivalent"]


def test_an_avoided_food_is_left_out(client):
    told = client.post("/api/plan", json=SALAD | {"avoid": ["onion"]}).json()
    assert "onion" not in {one["object"] for one in told["recipe"]["ingredients"]}


def test_what_is_at_hand_is_all_there_is(client):
    answer = client.post("/api/plan", json=SALAD | {"kitchen": ["kohlrabi", "onion", "olive oil"]})
    assert answer.status_code == 200
    foods = [node["label"] for node in answer.json()["shopping"]]
    assert set(foods) <= {"kohlrabi", "onion", "olive oil", "water"}


def test_what_is_at_hand_chopped_is_not_chopped_again(client):
    answer = client.post("/api/plan", json=SALAD | {"kitchen": ["chopped onion", "olive oil", "kohlrabi"]})
    onions = [node for node in answer.json()["kitchen"] if node["label"] == "onion"]
    assert [node["states"] for node in onions] == [["chopped"]]


def test_what_the_kitchen_lacks_is_named_with_a_remedy(client):
    answer = client.post("/api/plan", json=SALAD | {"kitchen": ["spoon"]})
    assert answer.status_code == 404
    told = error_of(answer)
    assert told["code"] == "missing"
    assert any(one["remedy"].startswith("get a ") for one in told["missing"])


def test_a_thing_at_hand_that_nobody_knows_comes_with_a_note(client):
    told = client.post("/api/plan", json=SALAD | {"kitchen": ["onionn", "kohlrabi", "olive oil", "onion"]}).json()
    assert any("onionn" in note and "onion" in note for note in told["notes"])


def test_no_tree_is_404_and_says_why(client):
    answer = client.post("/api/plan", json={"dish_type": "pizza", "ingredients": ["tomato"]})
    assert answer.status_code == 404
    assert error_of(answer)["code"] == "no-goal"
    assert answer.json()["recipe"]["dish_type"] == "pizza"


def test_a_substitute_that_nobody_knows_is_refused(client):
    answer = client.post("/api/plan", json=SALAD | {"substitutes": [{"food": "kohlrabi", "like": "moon dust"}]})
    assert answer.status_code == 422
    assert "moon dust" in error_of(answer)["message"]


def test_suggestions_say_what_is_missing(client):
    told = client.post("/api/suggest", json={"foods": ["egg", "chopped onion"], "most": 2}).json()
    assert len(told["suggestions"]) == 2
    assert told["considered"] >= told["proven"] >= 2


def test_completion_knows_that_an_ingredient_begins_with_a_state(client):
    def words(text, kind="ingredient"):
        return client.get("/api/complete", params={"text": text, "kind": kind}).json()

    assert "chopped onion" in words("chopped on")
    assert "chopped onion" in words("chopped "), "behind the state a food is begun"
    assert words("chopped") == ["chopped"], "the state itself may go on"
    assert words("kni", "object") == ["knife"]
    assert words("om", "dish") == ["omelette"]
    assert all(word.startswith("chop") or " chop" in word for word in words("chop", "state"))
    assert words("zzzz") == []


def test_typing_errors_of_a_foon_are_not_offered():
    sticks = [ObjectNode("cinnamon", (state,)) for state in ("chopped", "choppped")]
    begun = Participant(ObjectNode("cinammon", ("whole",)))
    units = [FunctionalUnit((begun,), "chop", (Participant(one),)) for one in sticks]
    words = FoonWords(Snapshot.of([Subgraph("odd", tuple(map(Annotation, units)))], Kitchen.default()))
    assert {"choppped", "chopped"} <= set(words.states)
    assert words.complete("state", "chopp", 9) == ["chopped"]
    assert words.complete("object", "cin", 9) == ["cinnamon"]


def test_what_is_around_an_object(client):
    told = client.get("/api/object", params={"label": "onion"}).json()
    assert not told["utensil"]
    assert all(node["label"] == "onion" for node in told["nodes"])
    for unit in told["made_by"]["units"]:
        assert "onion" in {node["label"] for node in unit["output_nodes"]}
    assert told["taken_by"]["count"] >= len(told["taken_by"]["units"]) > 0


def test_an_unknown_object_has_near_names(client):
    answer = client.get("/api/object", params={"label": "onionn"})
    assert answer.status_code == 404
    assert "onion" in error_of(answer)["hint"]


def test_likeness_says_why(client):
    (told,) = client.get("/api/similar", params={"name": "kohlrabi", "limit": 2}).json()
    assert told["name"] == "kohlrabi"
    confidences = [one["confidence"] for one in told["nearest"]]
    assert confidences == sorted(confidences, reverse=True)
    assert len(confidences) == 2
    assert told["nearest"][0]["why"]


def test_likeness_in_a_role_is_asked_with_as(client):
    asked = {"name": "broth", "limit": 3}
    (plain,) = client.get("/api/similar", params=asked).json()
    (liquid,) = client.get("/api/similar", params={**asked, "as": "liquid"}).json()
    assert {one["name"]: one["confidence"] for one in plain["nearest"]} != {
        one["name"]: one["confidence"] for one in liquid["nearest"]
    }
    refused = client.get("/api/similar", params={**asked, "as": "frob"})
    assert refused.status_code == 422
    assert "liquid" in error_of(refused)["hint"]


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"[]",
        b"{",
        b'{"ingredients": []}',
        b'{"ingredients": "onion"}',
        b'{"ingredients": [" , "]}',
        b'{"ingredients": ["onion"], "dish_type": "stew"}',
        b'{"ingredients": ["onion"], "files": "/etc/passwd"}',
        b'{"ingredients": ["onion\\u0000"]}',
        b'{"ingredients": ["\xff"]}',
        json.dumps({"ingredients": ["onion"] * 61}).encode(),
        json.dumps({"ingredients": ["o" * 101]}).encode(),
        b'{"ingredients": ' + b"[" * 20_000 + b"]" * 20_000 + b"}",
    ],
)
def test_a_body_that_is_no_question_is_refused(client, body):
    answer = client.post("/api/plan", content=body, headers={"content-type": "application/json"})
    assert answer.status_code in {400, 422}
    assert error_of(answer)["code"] == "request"


def test_a_media_type_is_written_in_any_letters_and_may_have_parameters(client):
    told = {"content-type": "Application/JSON ; charset=utf-8"}
    assert client.post("/api/plan", content=json.dumps(SALAD), headers=told).status_code == 200


def test_a_body_of_another_type_is_refused(client):
    answer = client.post("/api/plan", content=b"a=b", headers={"content-type": "text/plain"})
    assert answer.status_code == 415
    assert error_of(answer)["code"] == "content-type"


def test_a_huge_body_is_refused_whether_or_not_it_says_its_length(client):
    def pieces():
        for _ in range(100):
            yield b" " * 1000

    for body in (b" " * 100_000, pieces()):
        answer = client.post("/api/plan", content=body, headers={"content-type": "application/json"})
        assert answer.status_code == 413
        assert error_of(answer)["code"] == "size"


def test_a_whole_draft_may_be_sent_where_it_is_reviewed_and_no_more(client):
    rows = "0:01,0:04,chop,onion; knife,onion (chopped),,0.90,,,\n" * 4_000
    table = f"start,end,motion,inputs,outputs,dish,confidence,doubt,said,source\n{rows}"
    answer = client.post("/api/teach/review", json={"name": "long", "table": table})
    assert (answer.status_code, answer.json()["units"]) == (200, 4_000)
    assert client.post("/api/teach/review", json={"name": "long", "table": table * 6}).status_code == 413


@pytest.mark.parametrize("method", ["PUT", "PATCH", "DELETE", "POST"])
def test_there_is_nothing_to_write_to(client, method):
    headers = {"content-type": "application/json"}
    assert client.request(method, "/api/summary", content=b"{}", headers=headers).status_code == 405
    assert client.request(method, "/index.html", content=b"{}", headers=headers).status_code == 405


def test_files_beside_the_page_are_not_served(client):
    for path in ("/../api.py", "/%2e%2e/api.py", "/..%2fapi.py", "//etc/passwd", "/api/../../models.py"):
        assert client.get(path).status_code in {404, 405}


class ChangedFoon(FixedFoon):
    """A FOON that was changed since it was read, and is being read without end."""

    changed = False

    def __init__(self, snapshot):
        super().__init__(snapshot)
        self.let = threading.Event()

    def edition(self):
        return "later" if self.changed else super().edition()

    def read(self):
        assert not self.changed or self.let.wait(60)
        return super().read()


def test_an_answer_says_of_which_edition_it_is():
    foon = ChangedFoon(demo_foon())
    asked = [
        *(
            ("get", f"/api/{path}", {})
            for path in ("summary", "complete?text=on", "similar?name=caper", "object?label=onion")
        ),
        *(
            ("post", f"/api/{path}", {"json": body})
            for path, body in (("plan", SALAD), ("suggest", {"foods": ["onion"]}))
        ),
    ]
    with TestClient(app(foon=foon, patience=0), base_url="http://localhost") as asking:
        now = {asking.request(*words, **body).headers["foon-edition"] for *words, body in asked}
        assert len(now) == 1
        foon.changed = True
        for *words, body in asked:
            answer = asking.request(*words, **body)
            assert answer.status_code == 200
            assert {answer.headers["foon-edition"]} == now
            assert answer.headers["foon-newer"] == "later"
        foon.let.set()


def test_a_recorded_dish_is_followed_as_wished_by_either_method(client):
    posted = client.post("/api/plan", json=SALAD | {"after": "winter salad", "explain": True}).json()
    assert posted["reference"]["goal"]["label"] == "winter salad"
    assert "winter salad" not in {one["goal"]["label"] for one in posted["considered"]}
    asked = {"dish_type": "salad", "ingredient": SALAD["ingredients"], "after": "winter_salad"}
    assert client.get("/api/plan", params=asked).json()["reference"] == posted["reference"]
    refused = client.post("/api/plan", json=SALAD | {"after": "moon salad"})
    assert (refused.status_code, refused.json()["error"]["code"]) == (404, "no-goal")
    assert client.get("/api/complete", params={"kind": "goal", "text": "winter"}).json() == ["winter salad"]


def test_what_a_dish_is_called_is_read_by_either_method(client):
    soup = {"dish_type": "soup", "ingredients": ["chopped parsnip", "chopped onion", "water"]}
    named = {"title": "Cream of parsnip soup"}
    plain, creamy = (client.post("/api/plan", json=soup | more).json() for more in ({}, named))
    assert ["blend" in {unit["motion_node"] for unit in one["units"]} for one in (plain, creamy)] == [False, True]
    assert creamy["recipe"]["title"] == named["title"]
    asked = {"dish_type": "soup", "ingredient": soup["ingredients"]} | named
    assert client.get("/api/plan", params=asked).json()["units"] == creamy["units"]
    assert client.post("/api/plan", json=soup | {"title": "a\nb"}).status_code == 422


def test_each_error_points_to_the_page_that_describes_the_api(client):
    for answer in (client.get("/api/complete"), client.get("/nothing"), client.put("/api/summary", json={})):
        assert answer.status_code in {404, 405, 422}
        assert answer.json()["error"]["hint"] == "See /api/docs."


def test_what_is_too_long_is_told_in_plain_words(client):
    told = client.post("/api/plan", json={"dish_type": "salad", "ingredients": ["onion", "x" * 101]})
    assert told.status_code == 422
    assert told.json()["error"]["message"] == f"“{'x' * 40}…” is longer than 100 characters"
    assert "body.ingredients.1" in told.json()["error"]["hint"]


@pytest.mark.parametrize(
    ("path", "here"), [("/", "#"), ("/explore", "explore"), ("/teach", "teach"), ("/api/docs", None)]
)
def test_each_page_leads_to_all_and_asks_for_the_token(client, path, here):
    page = client.get(path).text
    (links,) = re.findall(r'<nav aria-label="Pages">(.*?)</nav>', page, re.DOTALL)
    assert re.findall(r">([\w ]+)</a>", links) == ["Plan a dish", "Explore", "Teach"]
    assert re.findall(r'href="([^"]*)" aria-current="page"', links) == ([here] if here else [])
    assert page.count('<form id="token-form">') == (1 if here else 0)
    addresses = re.findall(r'href="([^"]*)"', links)
    assert {client.get(urljoin(path, one)).status_code for one in addresses} == {200}
