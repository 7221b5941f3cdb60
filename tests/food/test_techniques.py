"""The table of techniques: every row can be carried out, and what is not of its form is refused."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from functools import cache
from importlib.resources import files
from itertools import chain
from pathlib import Path

import pytest

import foon_kg
from foon_kg.food import tables
from foon_kg.food.foods import UNKNOWN
from foon_kg.food.listed import runs
from foon_kg.food.lists import word_list, word_lists
from foon_kg.food.rows import Dish
from foon_kg.food.shipped import shipped
from foon_kg.food.techniques import (
    Around,
    Foods,
    Part,
    Technique,
    _technique_rows,
    components,
    preparations,
    techniques,
    ways,
    works,
)
from foon_kg.food.words import is_part, singular, words
from foon_kg.model import DISH_TYPES

SAID = {
    *("as mash", "coarse", "dark", "due", "in one piece", "in pieces", "portion", "raw", "runs", "several"),
    *("stale", "wing", "wings"),
}
"""What rows ask of how a food is named, said to be and comes, and no state of a table."""

PLANS = {"by table", "cold", "one pot", "whole"}


def techniques_and_ways():
    return (*techniques(), *(row for when in ("ways", "dipped", "flesh", "warmed", "blended") for row in ways(when)))


def rows():
    """Return every row of the tables that tells how something is made."""
    return (*techniques_and_ways(), *components(), *runs())


def technique_of(row):
    return row if isinstance(row, Technique) else row.technique


def parts(technique):
    return [part for parts in technique.lines.values() for part in parts]


def foods(technique):
    return [one for part in parts(technique) for one in part.foods]


def meant(row):
    """Yield all texts that name foods in a row, in whatever field of it."""
    if isinstance(row, Foods):
        yield row
    elif isinstance(row, Mapping):
        yield from meant(tuple(row.values()))
    elif is_dataclass(row):
        yield from meant(tuple(getattr(row, field.name) for field in fields(row)))
    elif isinstance(row, tuple):
        yield from (one for part in row for one in meant(part))


@cache
def is_known(term):
    """Whether a term is a kind, a trait or the name of a food, as foods are compared with it."""
    table = tables().foods
    traits = {trait for kind in table.kinds.values() for trait in kind.traits}
    if term.startswith("kind:"):
        return term.removeprefix("kind:") in table.kinds
    return term in table.kinds or term in traits or (term == singular(term) and table.food(term).known)


def no_utensils(names):
    """Return which of ``names`` the table of utensils does not have."""
    return {name for name in names if name and tables().utensil(name) is None}


def unknown_words(technique):
    """Return what a technique names and no table has."""
    shown = {name.removeprefix("!") for name in technique.video}
    return (
        {part.stage for part in parts(technique)} - works().keys()
        | {one.made for one in foods(technique)} - {"", *preparations()}
        | {line for part in parts(technique) for line in part.lines} ^ (technique.lines.keys() - {"dish"})
        | no_utensils(part.vessel for part in parts(technique))
        | technique.plan - PLANS
        | (technique.types | technique.or_types) - set(DISH_TYPES)
        | {name.removeprefix("!") for name in technique.dishes} - Dish.__dataclass_fields__.keys()
        | shown - {"baked", "blend", "heat", "oven", "shape", "turn", "warm"}
    )


def test_a_technique_names_only_what_the_tables_know():
    unknown = {one.name: unknown_words(one) for one in map(technique_of, rows())}
    assert {name: words for name, words in unknown.items() if words} == {}


def test_a_stage_is_done_by_a_motion_with_utensils_that_there_are():
    known = tables()
    for name, work in works().items():
        assert no_utensils((work.vessel, work.over, work.appliance, *work.tools)) == set(), name
        assert not work.motion or known.motion(work.motion).does, name
        assert set(work.states) <= known.states.keys(), name
        assert not work.appliance or known.utensil(work.appliance).source == work.source, name


def test_a_preparation_names_states_and_ways_of_cooking_that_there_are():
    for name, row in shipped("techniques")["preparations"].items():
        assert {row[key] for key in ("make", "then") if key in row} <= tables().states.keys(), name
        assert row.get("cooked", "cook") in {"bake", "boil", "cook", "toast"}, name


def test_what_a_motion_asks_of_its_tool_some_utensil_can_do():
    abilities = {ability for one in tables().utensils.values() for ability in one.can}
    motions = [tables().motion(name) for name in (*tables().motions, *tables().motion_words)]
    assert {ability for one in motions for ability in chain.from_iterable(one.tools)} <= abilities | {"hand"}


def test_a_word_that_no_table_has_is_found():
    (row, *_) = techniques()
    for wrong in ({"plan": {"hot"}}, {"types": {"stew"}}, {"video": ("frost",)}):
        assert unknown_words(replace(row, **wrong))


def unknown_foods_and_states(row):
    """Return the states and foods that a row asks for and no table has."""
    asked = {name.removeprefix("!") for one in meant(row) for name in one.state.split("&")}
    terms = {term.lstrip("!%") for one in meant(row) for term in one.terms} - {"*", "^"}
    return {name for name in asked if not name.startswith("for ")} - {"", *SAID, *tables().states} | {
        term for term in terms if not (term.startswith("#") or term.removeprefix("@") in word_lists() or is_known(term))
    }


def test_a_row_asks_for_foods_and_states_that_there_are():
    assert [(technique_of(row).name, wrong) for row in rows() if (wrong := unknown_foods_and_states(row))] == []


def test_what_a_component_or_run_is_for_is_a_part_of_a_dish():
    parts_named = {part for one in components() for part in one.parts} | {one.part for one in runs()}
    assert {part for part in parts_named if not is_part(part)} == set()
    assert {one.by for one in components()} <= works().keys()


@pytest.mark.parametrize("row", shipped("workings")["workings"], ids=lambda row: f"{row['motion']}: {row['state'][0]}")
def test_a_working_names_only_what_the_tables_know(row):
    known = tables()
    assert {term for term in (*row["of"], *row.get("not", ())) if not is_known(term)} == set()
    assert set(row["state"]) <= known.states.keys()
    assert {name for name in (row["tool"], row["on"]) if name and known.utensil(name) is None} == set()
    assert {name for name in (row["motion"], *row["like"]) if not known.motion(name).does} == set()


def lists_of_foods():
    """Return the lists that the program asks whether a food is one of theirs."""
    asked = re.compile(r'(?:is_any\(word_list|\.has)\("([^"]+)"\)')
    programs = Path(foon_kg.__file__).parent.rglob("*.py")
    return {name for path in programs for name in asked.findall(path.read_text(encoding="utf-8"))} & set(word_lists())


@cache
def texts(ending):
    """Return all that stands in the files of the package with an ``ending``."""
    package = Path(foon_kg.__file__).parent
    return "\n".join(path.read_text(encoding="utf-8") for path in sorted(package.rglob(f"*{ending}")))


@cache
def shapes():
    """Return patterns of the names that the program makes of a part and a word."""
    programs = texts(".py")
    made = re.findall(r'(?:word_list|word_lists\(\)\.get|says)\([^\n]*?f"([^"\n]+)"', programs)
    starts = re.findall(r'"([a-z]+(?: [a-z]+)+ )"', programs)
    patterns = [".+".join(map(re.escape, re.split(r"\{[^}]*\}", one))) for one in made]
    return re.compile("|".join([*patterns, *(f"{re.escape(start)}.+" for start in starts)]))


def is_read(name):
    """Return whether the program reads a list: by its name, by a row that has it, or by a part of its name."""
    programs = texts(".py")
    told = f'"{name}"' in programs or f"'{name}'" in programs or re.search(rf"@{re.escape(name)}\b", texts(".toml"))
    return bool(told) or shapes().fullmatch(name) is not None


def test_every_list_is_read():
    assert not is_read("a list that nobody reads")
    assert [name for name in word_lists() if not is_read(name)] == []


def test_a_list_of_foods_has_only_such_as_there_are():
    found = lists_of_foods()
    assert found
    words_of = [(name, word) for name in sorted(found) for word in word_list(name)]
    assert [(name, word) for name, word in words_of if word != UNKNOWN.name and not is_known(word)] == []


def test_every_food_has_a_place_in_a_technique():
    assert [one.name for one in techniques_and_ways() if sum(food.is_rest for food in foods(one)) != 1] == []


def test_a_stage_is_read_with_all_that_it_says():
    part = Part.read("mix as dough @ bowl < one line, other line: flour&!#bread, +butter=melted>whipped")
    assert (part.stage, part.label, part.vessel, part.lines) == ("mix", "dough", "bowl", ("one line", "other line"))
    assert part.foods == (Foods(("flour", "!#bread")), Foods(("butter",), "melted", "whipped", again=True))


@pytest.mark.parametrize("text", ["", ": flour", "mix: =melted"])
def test_what_is_no_stage_is_refused(text):
    with pytest.raises(ValueError, match=r"is no stage|names no foods"):
        Part.read(text)


def test_a_word_of_a_label_is_meant_in_the_plural_too():
    assert Foods.read("chocolate&!#chips").terms == ("chocolate", "!#chip")


def called_by(**row):
    return Technique(**{
        "name": "x", "called": (), "never": (), "types": frozenset(), "needs": (), "without": (), "lines": {},
        "plan": frozenset(), **row,
    })  # fmt: skip


@pytest.mark.parametrize(
    ("title", "is_so"),
    [("Pumpkin Pie", True), ("No-Bake Pie", False), ("Pumpkin Bake", True), ("Pie with No Crust", True)],
)
def test_what_a_dish_must_not_be_called_is_a_whole_phrase(title, is_so):
    assert called_by(never=(("no", "bake"),)).is_called("pie", words(title)) is is_so


def test_a_stage_may_be_left_out():
    assert Part.read("?pan < one line: onion") == Part(
        "pan", "", "", ("one line",), (Foods(("onion",)),), optional=True
    )


@pytest.mark.parametrize(
    ("text", "food", "is_meant"),
    [
        ("egg&%flour", "egg", True),
        ("egg&!%flour", "egg", False),
        ("flour&%flour", "flour", False),  # none but itself
        ("fish&^", "trout", True),
        ("fish&^", "salmon", False),
        ("stock", "black pepper", True),  # a trait: there is more of it
        ("kind:stock", "black pepper", False),
        ("kind:stock", "beef stock", True),
    ],
)
def test_foods_are_meant_by_what_is_around_them(text, food, is_meant):
    names = ("egg", "flour", "trout", "salmon", "black pepper", "beef stock")
    facts = {name: tables().foods.food(name) for name in names}
    around = Around(list(facts.values()), ("stuffed", "trout"))
    assert Foods.read(text).mean(food, facts[food], (), around) is is_meant


@pytest.mark.parametrize(
    ("text", "states", "is_meant"),
    [
        ("butter", (), True),
        ("fat&!oil", (), True),
        ("fat&!butter", (), False),
        ("#unsalted", (), True),
        ("@is creamed", (), True),
        ("butter=melted", ("melted",), True),
        ("butter=melted", ("stick",), False),
        ("butter=melted&!salted", ("melted",), True),
        ("butter=melted&!salted", ("melted", "salted"), False),
        ("*", (), True),
    ],
)
def test_foods_are_meant_by_kind_word_list_and_state(text, states, is_meant):
    assert Foods.read(text).mean("unsalted butter", tables().foods.food("unsalted butter"), states) is is_meant


@cache
def rows_with_names():
    """Return every row that has a name, with it and its file."""
    return tuple(_rows_with_names())


def _rows_with_names():
    for file in sorted(files("foon_kg.food").iterdir(), key=lambda one: one.name):
        if file.name.endswith(".toml") and file.name != "called.toml":
            table = tomllib.loads(file.read_text(encoding="utf-8"))
            for section in filter(lambda one: isinstance(one, dict), table.values()):
                yield from ((file.name, name, row) for name, row in section.items() if isinstance(row, dict))


@pytest.mark.parametrize("field", ["called", "never"])
def test_no_name_stands_twice_in_a_row_of_a_table(field):
    """Names and titles are read in the singular: a plural beside it says nothing more."""
    twice = [
        (file, name, text)
        for file, name, row in rows_with_names()
        for text, count in Counter(" ".join(words(text)) for text in row.get(field, ()) if text[0] != "@").items()
        if count > 1
    ]
    assert twice == []


def test_lines_that_belong_to_no_row_are_refused(monkeypatch):
    bare = {"techniques": {"a misspelt name": {"lines": {"dish": ["bake: *"]}}}}
    monkeypatch.setattr("foon_kg.food.techniques.shipped", lambda _: bare)
    _technique_rows.cache_clear()
    with pytest.raises(ValueError, match="a misspelt name"):
        _technique_rows()
    _technique_rows.cache_clear()
