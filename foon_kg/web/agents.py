"""The service as tools for agents (Model Context Protocol)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any, TypeVar

from mcp.server import MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp.server.mcpserver.prompts import Prompt
from mcp.server.mcpserver.tools import Tool
from mcp_types import ToolAnnotations
from pydantic import Field

from foon_kg import __version__
from foon_kg.foon import Substitute
from foon_kg.model.errors import FoonError, UsageError, WriteRefused
from foon_kg.model.json_fields import JsonObject
from foon_kg.web.asking import AT_HAND, AVOIDED, DRAFTS, MOST_INGREDIENTS, MOST_THINGS, DishType, Words
from foon_kg.web.questions import PlanQuestion, Question, SuggestQuestion
from foon_kg.web.service import FoonService

T = TypeVar("T")

Cypher = Callable[[str, dict[str, Any], int], JsonObject]
"""Asks the graph a query with parameters for at most so many rows; raises what :func:`ask_freely` raises."""

_LOOKS = ToolAnnotations(read_only_hint=True, destructive_hint=False, idempotent_hint=True, open_world_hint=False)
_INSTRUCTIONS = (
    "A knowledge graph of cooking actions seen in videos (a FOON). plan answers the steps that make a dish from given "
    "ingredients, also from ones that no video shows: they are handled like the known food that is most like them. "
    "Nothing here changes the graph."
)

Dish = Annotated[DishType, Field(description="The dish type; empty for the one most like these ingredients.")]
Ingredients = Annotated[
    list[Words], Field(min_length=1, max_length=MOST_INGREDIENTS, description="State first: “chopped onion”.")
]
Substitutes = Annotated[
    dict[str, str], Field(max_length=MOST_INGREDIENTS, description="Handle this food like that known one.")
]
Avoided = Annotated[list[Words], Field(max_length=20, description=AVOIDED)]
Title = Annotated[
    str, Field(max_length=200, description="What the dish is called, which is read: a lasagna is laid in layers.")
]
After = Annotated[
    str, Field(max_length=200, description="The recorded dish, or the video, to make it after; else what suits best.")
]
Drafts = Annotated[bool, Field(description=DRAFTS)]
AtHand = Annotated[list[Words], Field(max_length=MOST_THINGS, description=AT_HAND)]
Names = Annotated[list[Words], Field(min_length=1, max_length=20, description="Foods, known or not.")]
Role = Annotated[str, Field(max_length=40, description="What it does in a dish: acid, fat, liquid, milk, protein …")]
Rows = Annotated[int, Field(ge=1, le=1000, description="Answer no more rows than this.")]
Most = Annotated[int, Field(ge=1, le=20)]


def agent_server(service: FoonService, cypher: Cypher | None = None) -> MCPServer:
    """Return the server with its tools, which ask ``service``.

    Without ``cypher`` (a FOON of files) that one says so.
    """
    tools = _Tools(service, cypher)
    known = [_strict(tool) for tool in (tools.plan, tools.explain, tools.similar, tools.suggest, tools.cypher)]
    server = MCPServer("foon-kg", instructions=_INSTRUCTIONS, version=__version__, log_level="WARNING", tools=known)
    for prompt in (cook_with, what_can_i_make, explore_graph):
        server.add_prompt(Prompt.from_function(prompt))
    return server


def _strict(function: Callable[..., Any]) -> Tool:
    """Return the tool that calls ``function``, and refuses arguments that it has not: who misspells avoid is told."""
    tool = Tool.from_function(function, annotations=_LOOKS)
    taken = tool.fn_metadata.arg_model
    taken.model_config["extra"] = "forbid"
    taken.model_rebuild(force=True)
    tool.parameters = {**tool.parameters, "additionalProperties": False}
    return tool


def cook_with(
    ingredients: Annotated[str, Field(description="What there is, with commas: “chopped onion, egg, cheddar”.")],
    dish: Annotated[str, Field(description="The dish type (salad, soup, …); empty for the one that fits best.")] = "",
) -> str:
    """Plan a dish from these ingredients, and tell a cook how to make it."""
    wanted = f"a {dish}" if dish else "the dish that fits best"
    return (
        f"I have: {ingredients}. Plan {wanted} with the tool “plan” (one entry an ingredient, its state first). "
        "Tell me the steps in order in plain sentences, with the video that shows each. Then say what was guessed: "
        "every substitution with its confidence, every assumption, and every food that is like nothing known. Add no "
        "step that the plan does not have. Where there is no tree, say what is missing."
    )


def what_can_i_make(
    foods: Annotated[str, Field(description="What is at hand, with commas.")],
) -> str:
    """Name the dishes nearest to what is at hand, and what is missing for each."""
    return (
        f"I have: {foods}. Ask the tool “suggest” what can be made of it. Name the best three dishes, what each takes "
        "of mine, and what is missing. For what is missing ask “similar” whether something of mine can stand for it, "
        "and say how sure that is."
    )


def explore_graph(question: Annotated[str, Field(description="What you want to know of the FOON.")]) -> str:
    """Find something out about the FOON, by questions in Cypher that only look."""
    return (
        f"Answer from the graph: {question} Ask with the tool “cypher”; its description has the model of the graph. "
        "Begin with a count, take parameters for names, show the query that gave the answer, and say so where the "
        "graph has no answer. Labels and properties that the answer's warnings name do not exist."
    )


class _Tools:
    """Each public method is a tool; its docstring is what an agent reads."""

    def __init__(self, service: FoonService, cypher: Cypher | None) -> None:
        self._service = service
        self._cypher = cypher

    def plan(
        self, ingredients: Ingredients, dish_type: Dish = "", substitutes: Substitutes | None = None,
        avoid: Avoided | None = None, kitchen: AtHand | None = None, *, title: Title = "", after: After = "",
        with_drafts: Drafts = False,
    ) -> dict[str, Any]:  # fmt: skip
        """Plan a dish: its steps in order (units), what the kitchen must have, substitutions and assumptions."""
        wishes = _wishes(substitutes, avoid, kitchen, after)
        return self._answer(PlanQuestion(dish_type, tuple(ingredients), *wishes, with_drafts=with_drafts, title=title))

    def explain(
        self, ingredients: Ingredients, dish_type: Dish = "", substitutes: Substitutes | None = None,
        avoid: Avoided | None = None, kitchen: AtHand | None = None, *, title: Title = "", after: After = "",
        with_drafts: Drafts = False,
    ) -> dict[str, Any]:  # fmt: skip
        """Say why each ingredient of a plan is made as it is: like which food, where it joins, what was passed over."""
        wishes = _wishes(substitutes, avoid, kitchen, after)
        question = PlanQuestion(
            dish_type, tuple(ingredients), *wishes, with_drafts=with_drafts, title=title, explain=True
        )
        told = self._answer(question)
        return {name: told[name] for name in ("recipe", "goal", "explanations", "substitutions", "notes")}

    def similar(self, names: Names, limit: Most = 5, role: Role | None = None) -> dict[str, Any]:
        """Name the known foods that can best stand for each of these, and how likely a cook is to accept them."""
        return {"similar": _explained(lambda: self._service.similar(list(names), limit, role))}

    def suggest(self, foods: Ingredients, most: Most = 5, kitchen: AtHand | None = None) -> dict[str, Any]:
        """Name the dishes that the foods at hand make best: what each takes, what is missing, what is left over."""
        return self._answer(SuggestQuestion(tuple(foods), most, tuple(kitchen or ())))

    def cypher(self, query: str, parameters: dict[str, Any] | None = None, limit: Rows = 100) -> dict[str, Any]:
        """Ask the graph in Cypher; whatever does more than look at the graph is refused.

        (:Object {label, states, ingredients, relation, container})-[:INPUT_OF]->(:Motion {verb})-[:OUTPUTS]->(:Object);
        (:Motion)-[:SEEN_IN {position, start, end}]->(:Video {name}); (:Object)-[:CALLED]->(:Label {name});
        (:Motion)-[:NEXT {video, position}]->(:Motion); o.utensil marks knives and bowls.
        """
        ask = self._cypher
        if ask is None:
            raise ToolError(_said(UsageError("these are files, and no graph", hint="Start foon mcp without --files.")))

        def looked() -> JsonObject:
            try:
                return ask(query, parameters or {}, limit)
            except WriteRefused as error:  # an agent can add no option
                raise WriteRefused(error.message, hint="This tool only looks at the graph.") from error

        return _explained(looked)

    def _answer(self, question: Question) -> JsonObject:
        reply = _explained(lambda: self._service.answer(question))
        told = reply.value()
        if reply.status != 200:  # noqa: PLR2004 - what HTTP calls all right
            said = told["error"]
            raise ToolError(f"{said['message']} ({said['code']}). {said['hint']}")
        return told


def _wishes(
    substitutes: dict[str, str] | None, avoid: Sequence[str] | None, kitchen: Sequence[str] | None, after: str
) -> tuple[tuple[Substitute, ...], tuple[str, ...], tuple[str, ...], str]:
    chosen = tuple(Substitute(food, like) for food, like in (substitutes or {}).items())
    return chosen, tuple(avoid or ()), tuple(kitchen or ()), after


def _explained(ask: Callable[[], T]) -> T:
    try:
        return ask()
    except FoonError as error:
        raise ToolError(_said(error)) from error


def _said(error: FoonError) -> str:
    return f"{error.message} ({error.code}). {error.hint}"
