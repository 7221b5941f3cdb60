"""Units of other languages are read as units, and stay out of the names of foods."""

from __future__ import annotations

import pytest

from foon_kg.food.shipped import shipped
from foon_kg.language.foreign_units import with_english_units
from foon_kg.language.recipe_lines import read_recipe_lines


@pytest.mark.parametrize(
    ("line", "english"),
    [
        ("3 dl flour", "300 ml flour"), ("1,5 dl milk", "150 ml milk"), ("1 1/2 dl cream", "150 ml cream"),
        ("1 ½ dl cream", "150 ml cream"), ("½ dl oil", "50 ml oil"), ("2-3 msk oil", "2-3 tablespoons oil"),
        ("2 EL Zucker", "2 tablespoons Zucker"), ("2 xícaras de farinha", "2 cups farinha"),
        ("20 cl lait", "200 ml lait"),
        ("1 cda. aceite de oliva", "1 tablespoons aceite de oliva"),
        ("2 cuillères à soupe d'huile", "2 tablespoons huile"), ("1½ dl milk", "150 ml milk"),
        ("1 colher (sopa) de sal", "1 tablespoons sal"), ("2 łyżki soli", "2 tablespoons soli"),
        ("1 łyżeczka soli", "1 teaspoons soli"),
    ],
)  # fmt: skip
def test_a_unit_is_said_in_english(line, english):
    assert with_english_units(line) == english


@pytest.mark.parametrize(
    "line",
    [
        "2 eggs",
        "1 stalk celery",
        "2 elderflowers",
        "dl",
        "3 dl",
        "1 cup milk",
        "salt",
        "½",
        "2 dosas",
        "1/0 dl milk",
        "2 m\N{LATIN SMALL LETTER LONG S}k oil",
    ],
)
def test_any_other_line_stays_as_it_is(line):
    assert with_english_units(line) == line


def test_the_food_is_called_by_its_name_alone():
    lines = ("3 dl flour", "2 EL butter, melted", "1 krm salt", "2 siung garlic, chopped")
    told = [(one.object, one.state, one.unit) for one in read_recipe_lines(lines)]
    assert told == [
        ("flour", "", "ml"), ("butter", "melted", "tablespoons"), ("salt", "", "pinch"),
        ("garlic", "chopped", "cloves"),
    ]  # fmt: skip


def test_no_unit_is_told_twice():
    names = [name for row in shipped("units")["units"].values() for name in row["names"]]
    assert len(names) == len(set(names))
    assert all(name == name.lower() for name in names)
