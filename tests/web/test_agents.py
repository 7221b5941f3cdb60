"""The tools of the MCP server: in this process, and over the standard input and output of a real ``foon mcp``."""

from __future__ import annotations

import json
import re
import sys

import anyio
import pytest
from contract.test_drafts import COOKIE
from mcp import Client, StdioServerParameters
from pictures.demo_plans import demo_foon

from foon_kg import Foon
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders.lessons import lessons_of
from foon_kg.model.errors import WriteRefused
from foon_kg.web.agents import agent_server
from foon_kg.web.foon import FixedFoon
from foon_kg.web.service import FoonService

SALAD = {"dish_type": "salad", "ingredients": ["sliced kohlrabi", "chopped onion"]}


def asked(server, *calls):
    """What ``server`` answers to each (tool, arguments)."""

    async def ask():
        async with Client(server) as client:
            return [await client.call_tool(tool, arguments) for tool, arguments in calls]

    return anyio.run(ask)


def value(answer):
    assert not answer.is_error, answer.content
    return json.loads(answer.content[0].text)


def refusal(answer):
    assert answer.is_error
    return answer.content[0].text


def no_writing(text, parameters, limit):
    if "DELETE" in text:
        raise WriteRefused("this would change the graph", hint="Add --write.")
    return {"columns": ["n"], "rows": [[limit]], "cut": False}


@pytest.fixture(scope="module")
def server():
    with FoonService(FixedFoon(demo_foon())) as service:
        yield agent_server(service, no_writing)


def test_every_tool_says_what_it_does_and_that_it_only_looks(server):
    async def tools():
        async with Client(server) as client:
            return (await client.list_tools()).tools

    found = {tool.name: tool for tool in anyio.run(tools)}
    assert set(found) == {"plan", "explain", "similar", "suggest", "cypher"}
    assert all(tool.description and tool.annotations.read_only_hint for tool in found.values())


def test_an_argument_that_a_tool_has_not_is_refused(server):
    async def asked():
        async with Client(server) as client:
            ingredients = {"ingredients": ["chopped onion", "walnut"], "dish_type": "salad"}
            wrong = await client.call_tool("plan", {**ingredients, "avoids": ["nuts"]})
            return wrong, (await client.list_tools()).tools

    wrong, tools = anyio.run(asked)
    assert "avoids" in refusal(wrong)
    assert all(tool.input_schema["additionalProperties"] is False for tool in tools)


def test_tools_answer(server):
    plan, explain, similar, suggest = map(
        value,
        asked(
            server,
            ("plan", SALAD),
            ("explain", SALAD),
            ("similar", {"names": ["kohlrabi"], "limit": 2}),
            ("suggest", {"foods": ["egg"], "most": 1}),
        ),
    )
    assert plan["units"]
    assert plan["goal"] == explain["goal"]
    assert [one["want"]["object"] for one in explain["explanations"]] == ["kohlrabi", "onion"]
    assert len(similar["similar"][0]["nearest"]) == 2
    assert len(suggest["suggestions"]) == 1


def test_a_substitute_can_be_chosen(server):
    (answer,) = asked(server, ("plan", SALAD | {"substitutes": {"kohlrabi": "onion"}}))
    (one,) = [s for s in value(answer)["substitutions"] if s["kind"] == "object"]
    assert one["equivalent"] == "onion"


def test_what_a_dish_is_called_is_read(server):
    soup = {"dish_type": "soup", "ingredients": ["chopped parsnip", "chopped onion", "water"]}
    told = map(value, asked(server, ("plan", soup), ("plan", soup | {"title": "Cream of parsnip soup"})))
    assert ["blend" in {unit["motion_node"] for unit in one["units"]} for one in told] == [False, True]


def test_a_dish_is_made_after_the_one_that_is_named(server):
    (goal,) = value(asked(server, ("plan", SALAD | {"after": "fruit_salad"}))[0])["reference"]["videos"][:1]
    assert goal == "fruit_salad"
    (unknown,) = asked(server, ("explain", SALAD | {"after": "fruit_sallad"}))
    assert "What suits these foods best: " in refusal(unknown)


def test_drafts_count_only_where_they_are_asked():
    biscuits = {"dish_type": "cookie", "ingredients": ["flour", "butter", "sugar"]}
    with FoonService(FixedFoon(demo_foon(), lessons_of([COOKIE]))) as service:
        tools = agent_server(service)
        without, drafted = asked(tools, ("plan", biscuits), ("plan", biscuits | {"with_drafts": True}))
    assert "(no-goal)" in refusal(without)
    assert value(drafted)["reference"]["draft_confidence"] == pytest.approx(0.52)


def test_a_kitchen_can_be_named(server):
    at_hand = ["kohlrabi", "chopped onion"]
    plan, suggest = map(
        value,
        asked(
            server,
            ("plan", SALAD | {"kitchen": at_hand}),
            ("suggest", {"foods": ["egg"], "most": 1, "kitchen": ["salt"]}),
        ),
    )
    assert {"onion", "kohlrabi"} <= {node["label"] for node in plan["kitchen"]}
    assert all(unit["motion_node"] != "chop" for unit in plan["units"])
    assert {one["own"] for one in suggest["suggestions"][0]["taken"]} <= {"egg", "salt"}


def test_what_is_wrong_comes_with_a_hint(server):
    no_tree, unknown, empty, write = asked(
        server,
        ("plan", {"dish_type": "pizza", "ingredients": ["tomato"]}),
        ("plan", SALAD | {"substitutes": {"kohlrabi": "moon dust"}}),
        ("plan", {"ingredients": []}),
        ("cypher", {"query": "MATCH (n) DELETE n"}),
    )
    assert "(no-goal). It has goals of these dish types" in refusal(no_tree)
    assert "moon dust" in refusal(unknown)
    assert "ingredients" in refusal(empty)
    assert "(read-only)" in refusal(write)
    assert "--write" not in refusal(write)


def test_files_have_no_cypher():
    with FoonService(FixedFoon(demo_foon())) as service:
        (answer,) = asked(agent_server(service), ("cypher", {"query": "RETURN 1"}))
    assert "without --files" in refusal(answer)


@pytest.mark.slow
def test_foon_mcp_speaks_over_its_standard_input_and_output():
    program = "import sys; from foon_kg.cli import main; sys.exit(main())"
    arguments = ["-c", program, "mcp", "--files", str(demo_folder()), "--quiet"]
    server = StdioServerParameters(command=sys.executable, args=arguments)
    (answer,) = asked(server, ("plan", SALAD))
    assert value(answer)["recipe"]["dish_type"] == "salad"


@pytest.mark.slow
def test_prompts_come_over_standard_input_and_output_and_name_tools_that_there_are():
    program = "import sys; from foon_kg.cli import main; sys.exit(main())"
    arguments = ["-c", program, "mcp", "--files", str(demo_folder()), "--quiet"]
    given = {
        "cook_with": {"ingredients": "chopped onion, egg", "dish": "omelette"},
        "what_can_i_make": {"foods": "egg, leek"},
        "explore_graph": {"question": "What is done to eggs?"},
    }

    async def ask():
        async with Client(StdioServerParameters(command=sys.executable, args=arguments)) as client:
            tools = {tool.name for tool in (await client.list_tools()).tools}
            prompts = (await client.list_prompts()).prompts
            told = {name: await client.get_prompt(name, values) for name, values in given.items()}
            return tools, prompts, {name: one.messages[0].content.text for name, one in told.items()}

    tools, prompts, told = anyio.run(ask)
    assert {prompt.name for prompt in prompts} == set(given)
    assert all(prompt.description for prompt in prompts)
    for name, values in given.items():
        assert all(value in told[name] for value in values.values())
        named = set(re.findall(r"“(\w+)”", told[name]))
        assert named
        assert named <= tools


@pytest.mark.neo4j
def test_cypher_of_a_real_graph_only_looks(empty_graph):
    from foon_kg.cli.demo import demo_subgraphs
    from foon_kg.cli.mcp import _cypher

    with FoonService(FixedFoon(demo_foon())) as service, Foon(server=empty_graph) as foon:
        foon.store(demo_subgraphs()[:2])
        count = ("cypher", {"query": "MATCH (v:Video) RETURN count(v) AS videos"})
        write = ("cypher", {"query": "MATCH (n) DETACH DELETE n"})
        before, refused, after = asked(agent_server(service, _cypher(foon)), count, write, count)
    assert value(before) == value(after) == {"columns": ["videos"], "rows": [[2]], "cut": False, "warnings": []}
    assert "(read-only)" in refusal(refused)
