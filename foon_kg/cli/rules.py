"""The rules of the contract as ``foon check --rules`` and ``foon check --rule`` print them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from foon_kg.cli.console import print_json, print_view

if TYPE_CHECKING:
    from foon_kg.model.json_fields import JsonObject
    from foon_kg.validation.contract import Rule


def show_rules(*, as_json: bool) -> None:
    """Print every rule: its id, its name and one sentence; or ``as_json``."""
    from foon_kg.validation.contract import rules

    if as_json:
        print_json([_summary(rule) for rule in rules()])
        return
    from rich.table import Table

    table = Table.grid(padding=(0, 2))
    for rule in rules():
        table.add_row(rule.id, rule.name, rule.summary)
    print_view(table)


def show_rule(name: str, *, as_json: bool) -> None:
    """Print the rule ``name`` with its text, an example that keeps it and one that breaks it; or ``as_json``.

    Raises UsageError where there is no such rule.
    """
    from foon_kg.validation.contract import rule

    found = rule(name)
    if as_json:
        print_json(_summary(found) | {"text": found.text, "keeps": found.keeps, "breaks": found.breaks})
        return
    typer.echo(f"{found.id} {found.name}\n\n{found.text}\n")
    for title, example in (("Keeps it", found.keeps), ("Breaks it", found.breaks)):
        typer.echo(f"{title}:\n\n{_indented(example)}\n")


def _summary(rule: Rule) -> JsonObject:
    return {"id": rule.id, "name": rule.name, "summary": rule.summary}


def _indented(text: str) -> str:
    return "\n".join(f"  {line}".rstrip() for line in text.splitlines())
