"""``foon mcp``: the planner as tools for agents."""

from __future__ import annotations

from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

from foon_kg.cli.console import Files, Quiet, examples, sayer

if TYPE_CHECKING:
    from foon_kg.foon import Foon
    from foon_kg.model.json_fields import JsonObject
    from foon_kg.web.agents import Cypher

EXAMPLES = examples("foon mcp", "foon mcp --files subgraphs/ --quiet")

SECONDS = 60.0
"""How long an agent waits for a plan."""


def mcp(files: Files = None, quiet: Quiet = False) -> None:
    """Serve the planner as tools to an agent (MCP).

    The tools are plan, explain, similar, suggest and read-only Cypher, over standard input and output, with prompts for
    them. The agent's own program starts it: its settings name the command. It ends with its input.
    """
    from foon_kg.cli.serve import served_foon
    from foon_kg.foon import Foon
    from foon_kg.planning.processes import collect_often
    from foon_kg.web.agents import agent_server
    from foon_kg.web.service import FoonService

    say = sayer(quiet=quiet)
    collect_often()
    with (
        FoonService(served_foon(files, say), processes=1, seconds=SECONDS) as service,
        nullcontext() if files else Foon.connect(say=say) as foon,
    ):
        agent_server(service, None if foon is None else _cypher(foon)).run("stdio")


def _cypher(foon: Foon) -> Cypher:
    def ask(text: str, parameters: dict[str, Any], limit: int) -> JsonObject:
        answer = foon.cypher(text, parameters, limit=limit)
        return {
            "columns": list(answer.columns),
            "rows": answer.plain_rows(),
            "cut": answer.cut,
            "warnings": list(answer.warnings),
        }

    return ask
