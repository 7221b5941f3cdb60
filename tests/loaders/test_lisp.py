"""The Lisp subset: whatever is written is read, with its lines; what is broken is told with its line."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.loaders.lisp import DEEPEST, LONGEST, Form, Symbol, read_lisp
from foon_kg.loaders.notices import UnreadableFile

Tree = str | list["Tree"]
WORDS = st.from_regex(r"[a-z0-9?*.:-]{1,8}", fullmatch=True)
TREES: st.SearchStrategy[Tree] = st.recursive(WORDS, lambda inner: st.lists(inner, max_size=4), max_leaves=20)


def written(tree: Tree, space: str) -> str:
    return tree if isinstance(tree, str) else f"({space.join(written(one, space) for one in tree)})"


def plain(item: Form | Symbol) -> Tree:
    return item.text if isinstance(item, Symbol) else [plain(one) for one in item.items]


@given(st.lists(TREES, max_size=4), st.sampled_from([" ", "\n", " ; a (comment\n", " #| a (\n block |# "]))
def test_what_is_written_is_read_back(trees: list[Tree], space: str) -> None:
    assert plain(read_lisp(written(trees, space)).forms[0]) == trees


@given(st.text(alphabet="()ab\"\\;#|'` \n", max_size=60))
def test_any_text_is_read_or_refused(text: str) -> None:
    line = 1
    try:
        read_lisp(text)
    except UnreadableFile as error:
        line = error.line or 0

    assert 1 <= line <= text.count("\n") + 1


@given(st.integers(min_value=0, max_value=30))
def test_a_form_has_the_line_on_which_it_begins(lines: int) -> None:
    form = read_lisp("\n" * lines + "(a\n(b))").forms[0]

    assert (form.line, [inner.line for inner in form.forms()]) == (lines + 1, [lines + 2])


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ("(a)\n)", 2, "without an opening one"),
        ("\n\n(a (b)", 3, "never closed"),
        ('(a)\n(b "c', 2, "does not end"),
        ("\n#| a", 2, "does not end"),
        ("\n" + "(" * (DEEPEST + 1), 2, "inside one another"),
        (" " * (LONGEST + 1), None, "characters"),
    ],
)
def test_what_is_broken_is_told_with_its_line(text: str, line: int | None, what: str) -> None:
    with pytest.raises(UnreadableFile) as told:
        read_lisp(text)

    assert told.value.line == line
    assert what in told.value.problem.message


def test_a_definition_in_the_first_column_ends_what_is_open() -> None:
    document = read_lisp("(setf a '((b)\n\n(defparameter c 1)")

    assert ([form.head for form in document.forms], document.unclosed) == (["setf", "defparameter"], (1,))
