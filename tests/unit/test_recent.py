"""A mapping that keeps what was asked of late."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from foon_kg.food.motions import mixes
from foon_kg.model.recent import MOST_WORDS, Recent


def test_of_more_than_it_keeps_what_was_not_asked_the_longest_goes():
    kept = Recent(2)
    kept["egg"], kept["salt"] = 1, 2
    assert kept["egg"] == 1
    kept["milk"] = 3
    assert dict(kept) == {"egg": 1, "milk": 3}
    assert kept.get("salt") is None


def test_an_entry_that_is_written_anew_is_recent_and_takes_no_more_room():
    kept = Recent(2)
    kept["egg"], kept["salt"], kept["egg"], kept["milk"] = 1, 2, 4, 3
    assert dict(kept) == {"egg": 4, "milk": 3}


ROOT = Path(__file__).parents[2]
OF_A_TABLE = {"ways", "word_list", "_said", "_technique_at", "_word_lists_key", "named_query"}
"""Their argument names a table or a file of the program, of which there are so many; another name raises."""


def caches():
    """Yield the functions whose answers are kept, with the words of the decorator."""
    for folder in ("foon_kg", "loaders", "cypher"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                for one in getattr(node, "decorator_list", ()):
                    said = ast.unparse(one).removeprefix("functools.")
                    if re.match(r"(lru_)?cache\b", said):
                        yield node, said


@pytest.mark.slow
def test_what_is_kept_of_the_words_of_strangers_is_bounded():
    unbounded = {
        node.name
        for node, said in caches()
        if (node.args.args or node.args.kwonlyargs) and ("maxsize=" not in said or "maxsize=None" in said)
    }
    assert unbounded == OF_A_TABLE


def test_motions_that_nobody_knows_do_not_fill_the_memory():
    for number in range(MOST_WORDS + 10):
        mixes(f"motion {number}")
    assert mixes.cache_info().currsize <= MOST_WORDS
