"""The rules of the contract as docs/contract.md tells them, with one example that keeps each and one that breaks it.

The document is part of the package (``foon_kg.docs``), so that every installation has it. Its examples are in the
notation of :mod:`foon_kg.validation.notation`; those of the rules that compare a tree with a FOON are judged against
:func:`example_foon`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from importlib import resources

from foon_kg.model.errors import UsageError

DOCUMENT = "contract.md"

_BLOCK = re.compile(r"^```(tree keeps|tree breaks|foon)\n(.*?)^```\n", re.MULTILINE | re.DOTALL)
_RULE = re.compile(r"^### ([CWK]\d) (.+)$")
_HEADING = re.compile(r"^(?=#{2,3} )", re.MULTILINE)
_SENTENCE = re.compile(r".+?\.(?=\s|$)", re.DOTALL)


@dataclass(frozen=True)
class Rule:
    """A rule: its id (``W3``), its name, its first sentence, all of its text (Markdown) and its two examples."""

    id: str
    name: str
    summary: str
    text: str
    keeps: str
    breaks: str


@cache
def rules() -> tuple[Rule, ...]:
    """Return the rules in the order of the document: C1 to C9, W1 to W5, K1 to K7."""
    sections = (section.split("\n", 1) for section in _HEADING.split(_document()))
    return tuple(_rule(match[1], match[2], text) for head, text in sections if (match := _RULE.match(head)))


def rule(name: str) -> Rule:
    """Return the rule with the id ``name``, in capitals or not.

    Raises UsageError where there is none.
    """
    for one in rules():
        if one.id == name.upper():
            return one
    raise UsageError(f"there is no rule “{name}”", hint=f"The rules are {', '.join(one.id for one in rules())}.")


@cache
def example_foon() -> str:
    """Return the FOON of the examples, in the notation: one tree a video."""
    return next(block[2] for block in _BLOCK.finditer(_document()) if block[1] == "foon")


@cache
def _document() -> str:
    return resources.files("foon_kg.docs").joinpath(DOCUMENT).read_text(encoding="utf-8")


def _rule(number: str, name: str, text: str) -> Rule:
    examples = dict(_BLOCK.findall(text))
    told = re.sub(r"\n{3,}", "\n\n", _BLOCK.sub("", text)).strip()
    sentence = _SENTENCE.match(told)
    summary = " ".join((sentence[0] if sentence else told).split())
    return Rule(number, name, summary, told, examples["tree keeps"], examples["tree breaks"])
