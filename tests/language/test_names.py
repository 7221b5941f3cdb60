from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model.errors import ReadError
from foon_kg.model.names import ALIASES_VARIABLE, alias_table, canonical

SAME_THING = [
    ("Courgettes", "zucchini"),
    ("prawns", "shrimp"),
    ("half & half", "half-and-half"),
    ("half and half", "Half-and-Half"),
    ("Crème fraîche", "creme fraiche"),
    ("aubergine", "eggplants"),
    ("spring onions", "scallion"),
    ("green onion", "scallion"),
    ("salad   greens", "salad green"),
    ("goat\N{RIGHT SINGLE QUOTATION MARK}s cheese", "goat cheese"),
]

TYPING_ERRORS = [
    ("asparagu", "asparagus"),
    ("molass", "molasses"),
    ("couscou", "couscous"),
    ("lemon gras", "lemongrass"),
    ("lemon grass", "lemongrass"),
    ("choppped", "chopped"),
    ("watercres", "watercress"),
    ("cinammon", "cinnamon"),
    ("choocolate chip", "chocolate chip"),
    ("sauted onions", "sauteed onion"),
    ("brussel sprout", "brussels sprout"),
]

SINGULARS = [
    ("bay leaves", "bay leaf"),
    ("radishes", "radish"),
    ("olives", "olive"),
    ("chives", "chive"),
    ("cloves", "clove"),
    ("cookies", "cookie"),
    ("cherries", "cherry"),
    ("anchovies", "anchovy"),
    ("potatoes", "potato"),
    ("avocados", "avocado"),
    ("peas", "green pea"),
    ("loaves", "loaf"),
    ("egg whites", "egg white"),
    ("peaches", "peach"),
    ("kiwis", "kiwi"),
    ("quiches", "quiche"),
    ("artichoke hearts", "artichoke heart"),
    ("glazes", "glaze"),
    ("cheeses", "cheese"),
    ("glasses", "glass"),
    ("hearts of palm", "heart of palm"),
]

TRAPS = [
    "couscous",
    "asparagus",
    "hummus",
    "molasses",
    "swiss cheese",
    "watercress",
    "bass",
    "octopus",
    "citrus",
    "gas",
]


@pytest.mark.parametrize(("written", "meant"), [*SAME_THING, *TYPING_ERRORS, *SINGULARS])
def test_names_of_one_thing_are_equal(written, meant):
    assert canonical(written) == canonical(meant)


@pytest.mark.parametrize(("written", "one"), SINGULARS[:8])
def test_plurals_fold_to_the_singular(written, one):
    assert canonical(written) == one


@pytest.mark.parametrize("word", TRAPS)
def test_words_that_only_look_plural_stay_whole(word):
    assert canonical(word) == word


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("pepper", "bell pepper"),
        ("coriander", "cilantro"),
        ("rice", "rice vinegar"),
        ("olive", "olive oil"),
        ("sugar", "powdered sugar"),
        ("peanut", "pea"),
        ("corn", "corn starch"),
    ],
)
def test_different_things_stay_different(one, other):
    assert canonical(one) != canonical(other)


@given(st.text(max_size=40))
def test_canonical_twice_is_canonical_once(text):
    assert canonical(canonical(text)) == canonical(text)


@given(st.lists(st.sampled_from(sorted(alias_table().wholes)), min_size=1, max_size=3))
def test_canonical_twice_is_canonical_once_for_names_made_of_aliases(names):
    name = " ".join(names)
    assert canonical(canonical(name)) == canonical(name)


@given(st.text(max_size=40))
def test_case_and_white_space_never_matter(text):
    assert canonical(f"  {text} ") == canonical(text.replace(" ", "   "))
    assert canonical("Olive  OIL" + text.casefold()) == canonical("olive oil" + text.casefold())


def test_every_alias_leads_to_a_name_that_stays():
    for alias, name in alias_table().wholes.items():
        assert canonical(alias) == canonical(name), alias


def test_people_add_aliases_in_a_file(tmp_path: Path, monkeypatch):
    own = tmp_path / "own.txt"
    own.write_text("# our market's words\npak soi = tatsoi\nkeep: triticales\n", encoding="utf-8")
    assert canonical("tatsoi") != canonical("pak soi")
    monkeypatch.setenv(ALIASES_VARIABLE, str(own))
    assert canonical("Tatsoi") == canonical("pak soi")
    assert canonical("triticales") == "triticales"
    assert canonical("courgette") == "zucchini"


def test_aliases_that_go_in_a_ring_meet_in_one_name(tmp_path: Path, monkeypatch):
    own = tmp_path / "ring.txt"
    own.write_text("b one = a one\na one = c one\nc one = b one\n", encoding="utf-8")
    monkeypatch.setenv(ALIASES_VARIABLE, str(own))
    assert len({canonical("a one"), canonical("b one"), canonical("c one")}) == 1


def test_a_broken_alias_line_is_named_with_its_place(tmp_path: Path, monkeypatch):
    own = tmp_path / "own.txt"
    own.write_text("fine = good\nno equals sign\n", encoding="utf-8")
    monkeypatch.setenv(ALIASES_VARIABLE, str(own))
    with pytest.raises(ReadError, match=r"own\.txt:2") as caught:
        canonical("anything")
    assert "another name" in caught.value.hint


def test_a_missing_alias_file_is_said(tmp_path: Path, monkeypatch):
    monkeypatch.setenv(ALIASES_VARIABLE, str(tmp_path / "none.txt"))
    with pytest.raises(ReadError, match=r"none\.txt"):
        canonical("anything")
