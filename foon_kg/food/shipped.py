"""The tables that come with foon-kg, as they stand in their files (TOML)."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from typing import Any

from foon_kg.model.kept import kept


def shipped(name: str) -> Mapping[str, Any]:
    """Return the document ``name``.toml. It is parsed once, and kept: to parse all of them takes a command 50 ms."""
    content = files("foon_kg.food").joinpath(f"{name}.toml").read_bytes()
    document: Mapping[str, Any] = kept("tables", content, lambda: _parsed(content))
    return document


def _parsed(content: bytes) -> Mapping[str, Any]:
    import tomllib  # noqa: PLC0415 - seldom needed

    return tomllib.loads(content.decode())
