"""``foon cypher``: ask the graph in its own language."""

from __future__ import annotations

import csv
import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from foon_kg.cli.console import Json, Quiet, examples, print_json, sayer
from foon_kg.cli.data_frames import driver_without_arrays
from foon_kg.cli.streams import data
from foon_kg.model.json_text import json_value

if TYPE_CHECKING:
    from foon_kg.foon import Foon
    from foon_kg.store.graph.free_cypher import Answer

Form = Literal["table", "json", "csv"]

MOST_NAMES = 100_000
"""Among so many names of a graph a misspelt one is looked for."""

EXAMPLES = examples(
    'foon cypher "MATCH (v:Video) RETURN v.name ORDER BY v.name"',
    'foon cypher "MATCH (o:Object {label: $x}) RETURN o.states" -P x=onion --json',
    "foon cypher 'PROFILE MATCH (m:Motion {verb: \"chop\"}) RETURN count(m)'",
    "foon cypher 'SHOW INDEXES YIELD name, type' --format csv",
    "foon cypher --list",
    "foon cypher --name motion_on_food -P food=onion -P motion=chop",
)


def cypher(
    query: Annotated[
        str | None, typer.Argument(metavar="CYPHER", help="The Cypher text; - reads it from standard input.")
    ] = None,
    *,
    name: Annotated[
        str | None, typer.Option(metavar="NAME", help="Ask one of the queries that come with foon-kg instead.")
    ] = None,
    show_list: Annotated[bool, typer.Option("--list", help="Show those queries, and how to ask them.")] = False,
    write: Annotated[bool, typer.Option("--write", help="Let the query change the graph.")] = False,
    param: Annotated[
        list[str] | None,
        typer.Option("--param", "-P", metavar="NAME=VALUE", help="A parameter; the value as JSON, or as it stands."),
    ] = None,
    limit: Annotated[
        int, typer.Option("--limit", "-n", metavar="N", min=1, help="Show no more rows than this.")
    ] = 1000,
    timeout: Annotated[float, typer.Option(min=0.1, metavar="SECONDS", help="Give up after this time.")] = 30,
    form: Annotated[
        Form | None,
        typer.Option(
            "--format",
            "-f",
            help="How the answer is printed; in CSV a text that a spreadsheet would take for a formula gets a '.",
        ),
    ] = None,
    as_json: Json = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="The same as --format csv.")] = False,
    quiet: Quiet = False,
) -> None:
    """Ask the graph in Cypher; only --write lets a question change it.

    Without it these are refused: writes, changes of schema and users, LOAD CSV, SHOW (but for indexes and constraints)
    and TERMINATE, CALL {...} IN TRANSACTIONS, and procedures that do more than look at the graph. Labels, types and
    properties that nothing in the graph has are told. EXPLAIN and PROFILE are answered with the plan, row by row.
    """
    from foon_kg.foon import Foon
    from foon_kg.model.errors import UsageError

    form = _one_form(form, as_json=as_json, as_csv=as_csv)
    if [query is not None, name is not None, show_list].count(True) != 1:
        raise UsageError("say what to ask: Cypher, --name or --list", hint='See "foon cypher --help".')
    if show_list:
        return _list_queries(as_json=form == "json")
    text, parameters = _question(query, name, dict(map(_parameter, param or ())))
    say = sayer(quiet=quiet)
    with Foon.connect(say=say) as foon, driver_without_arrays():
        answer = foon.cypher(text, parameters, write=write, limit=limit, timeout=timeout)
        doubts = () if answer.rows else _doubts(foon, name, parameters)
    _show(answer, form)
    for told in _told(answer, doubts, limit):
        say(told)
    return None


def _told(answer: Answer, doubts: Sequence[str], limit: int) -> Iterator[str]:
    """Yield what there is to say beside the rows of an answer."""
    yield from (f"warning: {warning}" for warning in answer.warnings)
    if answer.columns and not answer.rows:
        yield " ".join(("Nothing in this graph answers that.", *doubts))
    if answer.cut:
        yield f"There are more rows than {limit}: show more with --limit."
    if answer.changes:
        yield "Changed: " + ", ".join(f"{count} {name.replace('_', ' ')}" for name, count in answer.changes.items())


def _one_form(form: Form | None, *, as_json: bool, as_csv: bool) -> Form:
    """Return how the answer is printed; raises UsageError where two ways are asked."""
    from foon_kg.model.errors import UsageError

    asked: dict[str, Form | None] = {"--format": form, "--json": "json" if as_json else None}
    asked["--csv"] = "csv" if as_csv else None
    forms = {option: one for option, one in asked.items() if one is not None}
    if len(set(forms.values())) > 1:
        raise UsageError(f"{' and '.join(forms)} exclude each other", hint="Leave one of them out.")
    return next(iter(forms.values()), "table")


def _question(query: str | None, name: str | None, given: dict[str, str]) -> tuple[str, dict[str, object]]:
    """Return the text to ask and its parameters: of a query of ours, or as the person typed them."""
    from foon_kg.cli.named_queries import explore_query, values

    if name is not None:
        ours = explore_query(name)
        return ours.text, values(ours, given)
    text = sys.stdin.read() if query == "-" else str(query)
    return text, {key: _as_json_or_text(value) for key, value in given.items()}


def _doubts(foon: Foon, name: str | None, parameters: Mapping[str, object]) -> Sequence[str]:
    """Return what is odd about the ``parameters`` of our query ``name`` that nothing answers; of no other one.

    Of a graph with more than ``MOST_NAMES`` names it is not known what has none: nothing is said.
    """
    from foon_kg.cli.named_queries import explore_query, unknown_names

    if name is None or not parameters:
        return ()
    known = foon.cypher(explore_query("names").text, limit=MOST_NAMES)
    return () if known.cut else tuple(unknown_names(parameters.values(), {str(row[1]) for row in known.rows}))


def _list_queries(*, as_json: bool) -> None:
    from foon_kg.cli.named_queries import command
    from foon_kg.cypher import explore_queries

    if as_json:
        rows = (
            {"name": ours.name, "answers": ours.answers, "parameters": ours.parameters, "example": command(ours)}
            for ours in explore_queries()
        )
        return print_json(list(rows))
    from rich.padding import Padding
    from rich.text import Text

    for ours in explore_queries():
        data().print(ours.name, style="bold", markup=False)
        data().print(Padding(Text(ours.answers), (0, 0, 0, 2), expand=False))
        data().print(f"  $ {command(ours)}", style="green", markup=False, highlight=False, soft_wrap=True)
    return None


def _parameter(text: str) -> tuple[str, str]:
    from foon_kg.model.errors import UsageError

    name, equals, value = text.partition("=")
    if not equals or not name:
        raise UsageError(f"--param {text}: there is no name before a “=”", hint="Write --param food=onion.")
    return name, value


def _as_json_or_text(value: str) -> object:
    try:
        return json_value(value)
    except json.JSONDecodeError:
        return value


def _show(answer: Answer, form: Form) -> None:
    rows = answer.plain_rows()
    if form == "json":
        print_json([dict(zip(answer.columns, row, strict=True)) for row in rows])
    elif form == "csv":
        writer = csv.writer(sys.stdout, lineterminator="\n")
        writer.writerows([answer.columns, *([_in_a_cell(value) for value in row] for row in rows)])
    elif answer.columns:
        _print_table(answer.columns, rows)


def _print_table(columns: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    from rich.table import Table
    from rich.text import Text

    table = Table()
    for name, values in zip(columns, zip(*rows, strict=True) if rows else [()] * len(columns), strict=True):
        table.add_column(name, justify="right" if values and all(map(_is_number, values)) else "left")
    for row in rows:
        table.add_row(*(Text(_to_read(value)) for value in row))
    data().print(table)


def _is_number(value: object) -> bool:
    return value is None or (isinstance(value, int | float) and not isinstance(value, bool))


def _to_read(value: object) -> str:
    """Return a value for people: names of a list stand side by side."""
    if isinstance(value, list) and all(isinstance(item, str) for item in value):
        return ", ".join(value)
    return _in_a_cell(value)


def _in_a_cell(value: object) -> str:
    from foon_kg.model.cells import as_cell

    if value is None:
        return ""
    return as_cell(value) if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
