"""The API described for people: a plain page that is written from the OpenAPI document, and needs no program."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from html import escape
from typing import Any

from foon_kg.web.pages import navigation

Described = Mapping[str, Any]
"""A part of an OpenAPI document."""

_ROLE = re.compile(r":\w+:`~?(?:[\w.]+\.)?(\w+)`")
"""How a docstring refers to something by its name."""

_TYPES = {"string": "text", "integer": "whole number", "boolean": "true or false", "object": "fields"}

_HEAD = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>foon: the API</title>
<link rel="icon" href="../icon.svg" type="image/svg+xml">
<link rel="stylesheet" href="../page.css">
</head>
<body>
<header>
  <p class="brand"><strong>foon</strong> <span class="aside">the API</span></p>
  <!-- navigation -->
</header>
<main>
<h1>The API of this service</h1>
<p>Questions are JSON or in the address, answers are JSON. The same for programs is
<a href="openapi.json">openapi.json</a> (OpenAPI). A service that asks for its token wants
<code>Authorization: Bearer TOKEN</code> with every question.</p>
<p>Every error has the status that says what kind it is, and the body
<code>{"error": {"code", "message", "hint"}}</code>: a word for programs, what is wrong, and what to do about it.</p>
<p>For who keeps it running: <code>GET /health</code> answers 200 where it can plan, <code>GET /metrics</code> what was
counted, as Prometheus reads it (with the token, where there is one).</p>
"""


def api_page(document: Described) -> str:
    """Return the page that describes the API of an OpenAPI ``document``."""
    asked = [
        (path, method.upper(), one) for path, methods in document["paths"].items() for method, one in methods.items()
    ]
    schemas: Described = document.get("components", {}).get("schemas", {})
    shown = sorted(name for name in schemas if name not in {"HTTPValidationError", "ValidationError"})
    return "".join(
        (
            _HEAD.replace("<!-- navigation -->", navigation(up="../")),
            _list(_link(_anchor(path, method), f"{method} {path}") for path, method, _ in asked),
            *(_operation(path, method, one, schemas) for path, method, one in asked),
            "<h2>What is asked and answered</h2>",
            *(_schema(name, schemas[name]) for name in shown),
            "</main>\n</body>\n</html>\n",
        )
    )


def _operation(path: str, method: str, one: Described, schemas: Described) -> str:
    body = one.get("requestBody", {}).get("content", {}).get("application/json", {}).get("schema", {})
    asked = schemas.get(_name_of(body), {})
    rows = [*map(_parameter, one.get("parameters", ())), *_fields(asked)]
    answers = one["responses"].get("200", {}).get("content", {}).get("application/json", {}).get("schema", {})
    errors = (f"<b>{status}</b> {escape(told['description'])}" for status, told in one["responses"].items())
    return "\n".join(
        (
            f'<h2 id="{_anchor(path, method)}">{method} {escape(path)}</h2>',
            f"<p>{_paragraph(one.get('description', ''))}</p>",
            _table("Fields", rows) if rows else "",
            f"<pre><code>{escape(_example(path, method, one, asked))}</code></pre>",
            f"<p>Answer: {_type_of(answers)}</p>",
            f"<details><summary>Statuses</summary>{_list(errors)}</details>\n",
        )
    )


def _example(path: str, method: str, one: Described, asked: Described) -> str:
    address = f"http://localhost:8000{path}"
    if method == "GET":
        known = [(p["name"], value) for p in one.get("parameters", ()) for value in _values(p["schema"], p)]
        data = "".join(f" \\\n  --data-urlencode {_quoted(f'{name}={value}')}" for name, value in known)
        return f"curl {'--get ' if known else ''}{address}{data}"
    fields = {name: asked["properties"][name].get("examples", [""])[0] for name in asked.get("required", ())}
    return f"curl {address} \\\n  --json {_quoted(json.dumps(fields, ensure_ascii=False))}"


def _values(schema: Described, parameter: Described) -> Iterator[str]:
    """Yield the examples of a parameter, each value of a list by itself."""
    for value in (parameter.get("examples") or schema.get("examples") or ())[:1]:
        yield from map(str, value if isinstance(value, list) else [value])


def _quoted(text: str) -> str:
    return "'" + text.replace("'", "'\\''") + "'"


def _parameter(one: Described) -> tuple[str, str, str]:
    need = "" if one.get("required") else _default(one["schema"])
    return one["name"], _type_of(one["schema"]), f"{escape(one.get('description', ''))} {need}".strip()


def _fields(schema: Described) -> Iterator[tuple[str, str, str]]:
    required = schema.get("required", ())
    for name, field in schema.get("properties", {}).items():
        need = "" if name in required else _default(field)
        yield name, _type_of(field), f"{escape(field.get('description', ''))} {need}".strip()


def _default(field: Described) -> str:
    if "default" not in field:
        return "(may be left out)"
    return f"(else <code>{escape(json.dumps(field['default'], ensure_ascii=False))}</code>)"


def _schema(name: str, schema: Described) -> str:
    rows = list(_fields(schema))
    about = _paragraph(schema.get("description", ""))
    return f'<h3 id="{escape(name)}">{escape(name)}</h3>\n<p>{about}</p>\n' + (_table(name, rows) if rows else "")


def _type_of(field: Described) -> str:
    """Return the type of a value in words; one that is described on this page as a link to there."""
    if "$ref" in field:
        return _link(_name_of(field), _name_of(field))
    for way in ("anyOf", "oneOf"):
        if way in field:
            return " or ".join(dict.fromkeys(map(_type_of, field[way])))
    if "enum" in field:
        return "one of " + ", ".join(f"<code>{escape(json.dumps(value))}</code>" for value in field["enum"])
    if "const" in field:
        return f"<code>{escape(json.dumps(field['const']))}</code>"
    if field.get("type") == "array":
        return f"list of {_type_of(field.get('items', {}))}"
    name = str(field.get("type", "any"))
    return escape(_TYPES.get(name, name))


def _name_of(field: Described) -> str:
    return str(field.get("$ref", "")).rpartition("/")[2]


def _table(name: str, rows: list[tuple[str, str, str]]) -> str:
    head = "".join(f'<th scope="col">{title}</th>' for title in ("Field", "Type", "What it says"))
    body = "".join(f"<tr><td><code>{escape(a)}</code></td><td>{b}</td><td>{c}</td></tr>" for a, b, c in rows)
    table = f'<table class="api"><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>'
    return f'<div class="wide" tabindex="0" role="group" aria-label="{escape(name)}">{table}</div>'


def _list(items: Iterator[str]) -> str:
    return "<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>\n"


def _link(anchor: str, words: str) -> str:
    return f'<a href="#{escape(anchor)}">{escape(words)}</a>'


def _anchor(path: str, method: str) -> str:
    return f"{method.lower()}{path.replace('/', '-')}"


def _paragraph(text: str) -> str:
    """Return a description with what is marked as code in it: ``so``; examples in Python are left out."""
    words = _ROLE.sub(r"``\1``", " ".join(text.partition(">>>")[0].split()))
    parts = escape(words).split("``")
    return "".join(f"<code>{part}</code>" if place % 2 else part for place, part in enumerate(parts))
