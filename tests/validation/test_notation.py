"""The notation of trees: what is written is read back, what a cook writes is read, and faults name their line."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model import ObjectNode, Recipe, RequiredIngredient, Sighting
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.model.errors import ReadError
from foon_kg.model.levels import Level
from foon_kg.model.tree import TaskTree
from foon_kg.validation.contract import rules
from foon_kg.validation.notation import Remark, read_tree, read_trees, remarks, write_tree
from foon_kg.validation.notation_nodes import RELATIONS, written_node
from foon_kg.world import Mention, Step

# names as a kitchen has them, names that look like the notation itself, and any text at all
names = (
    st.sampled_from(("pot", "cutting board", "half-and-half", "off (ready)", "from faucet", "covered [pot lid]"))
    | st.sampled_from(("nothing", "like", "egg like", "dish: soup", "---", "->", "✗ fatal: no", "at", "attached to be"))
    | st.lists(st.sampled_from([*RELATIONS, *'#+;:,"→(){}', "a", "1", "\n"]), max_size=4).map(" ".join)
    | st.text(max_size=8)
)
numbers = st.none() | st.integers()
nodes = st.builds(
    ObjectNode,
    names,
    st.lists(names, max_size=3).map(tuple),
    st.lists(names, max_size=3).map(tuple),
    st.none() | st.sampled_from(RELATIONS) | names,
    st.none() | names,
)
sides = st.lists(st.builds(Mention, nodes, numbers, numbers), max_size=3).map(tuple)
units = st.builds(
    Step,
    sides,
    names | st.just("Pour") | st.just("pick-and-place"),
    sides,
    st.none() | names,
    st.none() | st.lists(st.builds(Sighting, names, st.integers()), max_size=2).map(tuple),
    st.none() | names,
)
confidences = st.none() | st.floats(allow_nan=False, allow_infinity=False)
substitutions = st.builds(
    Substitution.claimed,
    names,
    names,
    names,
    st.none() | names,
    confidence=confidences,
    alternatives=st.none() | st.lists(st.builds(Alternative.claimed, names, confidences), max_size=2).map(tuple),
)
recipes = st.builds(
    Recipe,
    names,
    st.lists(st.builds(RequiredIngredient, names, names), max_size=2).map(tuple),
    st.none() | names,
    st.none() | names,
)
trees = st.builds(
    TaskTree,
    names,
    st.lists(units, max_size=3).map(tuple),
    st.none() | nodes,
    st.none() | recipes,
    st.none() | st.lists(nodes, max_size=2).map(tuple),
    st.none() | st.lists(substitutions, max_size=2).map(tuple),
    st.none() | st.lists(st.builds(Assumption, nodes, names), max_size=2).map(tuple),
    st.none() | names,
    st.none() | st.sampled_from(Level),
)


@pytest.mark.slow
@given(trees)
def test_a_tree_that_is_written_is_read_back_as_the_same_tree(tree):
    assert read_tree(write_tree(tree), "elsewhere") == tree


@pytest.mark.slow
@given(st.lists(trees, min_size=1, max_size=3))
def test_several_trees_are_kept_apart(several):
    assert read_trees("---\n".join(map(write_tree, several))) == tuple(several)


def tree_or_fault(text):
    try:
        return read_tree(text, "x")
    except ReadError as error:
        return error


@given(st.lists(st.sampled_from(['pot ("a"; {b}; in c#1)', " + ", "→", "\n", *'"(){};,:# ', "seen in:", "like", "1"])))
def test_a_text_is_a_tree_or_is_refused_with_its_line(pieces):
    read = tree_or_fault("".join(pieces))
    if isinstance(read, ReadError):
        assert str(read).startswith("x:")
        assert read.hint
    else:
        assert read_tree(write_tree(read)) == read


@pytest.mark.parametrize("rule", rules(), ids=lambda rule: rule.id)
def test_the_examples_of_the_contract_are_written_as_they_are_read(rule):
    for text in (rule.keeps, rule.breaks):
        for tree in read_trees(text):
            assert read_tree(write_tree(tree)) == tree


@pytest.mark.parametrize(
    "node",
    [
        ObjectNode("knife"),
        ObjectNode("pot", ("empty",), (), "on", "stove"),
        ObjectNode("onion", ("peeled", "chopped"), (), "in", "bowl"),
        ObjectNode("pot", ("hot",), ("water", "salt"), "on", "stove"),
        ObjectNode("jar", (), ("olive oil",), "attached to", "blender"),
        ObjectNode("garlic-parmesan chicken", ("cooked",), (), None, "plate"),
    ],
    ids=str,
)
def test_a_plain_node_is_written_as_it_shows_itself(node):
    assert written_node(Mention(node)) == str(node)


@pytest.mark.parametrize(
    ("text", "node"),
    [
        ("pot", ObjectNode("pot")),
        ("water (liquid; from faucet)", ObjectNode("water", ("liquid",), (), "from", "faucet")),
        ('water (liquid, "from faucet")', ObjectNode("water", ("liquid", "from faucet"))),
        ("stove (on)", ObjectNode("stove", ("on",))),
        ("stove (on; under pot)", ObjectNode("stove", ("on",), (), "under", "pot")),
        ("pot ({b, a}; hot)", ObjectNode("pot", ("hot",), ("a", "b"))),
        ("pot (at stove)", ObjectNode("pot", (), (), None, "stove")),
        ('pot ("at" stove)', ObjectNode("pot", (), (), "at", "stove")),
        ('pot ("next to" sink)', ObjectNode("pot", (), (), "next to", "sink")),
        ("pot (in nothing)", ObjectNode("pot", (), (), "in")),
        ('"pot #1" (in "a, b")', ObjectNode("pot #1", (), (), "in", "a, b")),
    ],
)
def test_a_node_is_read(text, node):
    assert read_tree(f"goal: {text}").goal == node


def test_things_carry_numbers():
    step = read_tree("egg#2 (in bowl#1) + bowl#1 (dirty) → POUR → bowl#3").units[0]
    assert [(mention.thing, mention.container_thing) for mention in step.inputs] == [(2, 1), (1, None)]
    assert step.outputs == (Mention(ObjectNode("bowl"), 3),)


@pytest.mark.parametrize(
    ("text", "motion"),
    [("POUR", "pour"), ("pour", "pour"), ("Pour", "Pour"), ('"POUR"', "POUR"), ("TURN ON", "turn on")],
)
def test_capitals_stand_for_the_small_letters_of_a_motion(text, motion):
    assert read_tree(f"a → {text} → b").units[0].motion == motion


def test_a_line_goes_on_where_an_arrow_or_a_plus_begins_the_next():
    long = read_tree("egg\n  + bowl\n  -> CRACK\n  → egg (cracked; in bowl)\n")
    assert long == read_tree("egg + bowl → CRACK → egg (cracked; in bowl)")
    assert long.units[0].input_nodes == (ObjectNode("egg"), ObjectNode("bowl"))


LEEK, SLICED, KNIFE = ObjectNode("leek", ("whole",)), ObjectNode("leek", ("sliced",)), ObjectNode("knife")


def test_everything_that_is_told_of_a_tree_is_read():
    tree = read_tree(
        """
        name: leek soup
        dish: soup
        asked: leek (sliced); salt
        title: My soup: the "best" one
        id: 17
        goal: soup ({leek})
        kitchen: leek (whole) + knife
        substitution: object (leek): leek like onion (0.87); shallot (0.8), garlic
        substitution: tool (leek): knife like nothing
        assumed: leek (cleaned): nobody washes: it is clean
        level: 3

        leek (whole) + knife → SLICE → leek (sliced)
          seen in: onion_soup 4; 0027 - salad 0
          grounding: like
          origin: adapted
        """
    )
    assert tree == TaskTree(
        "leek soup",
        (
            Step(
                (Mention(ObjectNode("leek", ("whole",))), Mention(ObjectNode("knife"))),
                "slice",
                (Mention(ObjectNode("leek", ("sliced",))),),
                "adapted",
                (Sighting("onion_soup", 4), Sighting("0027 - salad", 0)),
                "like",
            ),
        ),
        ObjectNode("soup", (), ("leek",)),
        Recipe(
            "soup",
            (RequiredIngredient("leek", "sliced"), RequiredIngredient("salt", "")),
            "17",
            'My soup: the "best" one',
        ),
        (LEEK, KNIFE),
        (
            Substitution(
                "object",
                "leek",
                "leek",
                "onion",
                0.87,
                (Alternative("shallot", 0.8), Alternative("garlic", 0.0, frozenset({"confidence"}))),
            ),
            Substitution("tool", "leek", "knife", "", 0.0, (), frozenset({"equivalent", "confidence", "alternatives"})),
        ),
        (Assumption(ObjectNode("leek", ("cleaned",)), "nobody washes: it is clean"),),
        level=Level.INGREDIENTS,
    )


def test_for_what_of_the_dish_a_food_is_asked_is_kept():
    asked = (
        RequiredIngredient("sugar", "powdered", part="glaze"),
        RequiredIngredient("lemon", "", part="serving"),
        RequiredIngredient("salt", "", part="1; 2"),
    )
    tree = TaskTree("cake", (), recipe=Recipe("cake", asked))
    assert read_tree(write_tree(tree)) == tree
    assert "asked: sugar (powdered; for glaze); lemon (; for serving)" in write_tree(tree)


def test_what_a_text_leaves_out_is_not_told():
    assert read_tree("a → POUR → b", "short") == TaskTree("short", read_tree("a -> pour -> b").units)
    assert read_tree("", "empty") == TaskTree("empty", ())
    assert read_tree("asked: nothing").recipe == Recipe("", ())
    nothing = read_tree(
        "kitchen: nothing\nsubstitution: nothing\nassumed: nothing\nnothing → WAIT → nothing\nseen in: nothing"
    )
    assert (nothing.kitchen, nothing.substitutions, nothing.assumptions) == ((), (), ())
    assert nothing.units == (Step((), "wait", (), seen_in=()),)


@pytest.mark.parametrize(
    ("text", "place", "what"),
    [
        ("\n\npot → POUR", "x:3", "expected “→” before the end of the line"),
        ("pot (empty → POUR → pot", "x:1", "expected “)”, found “→ POUR → pot”"),
        ("pot (empty; hot) → POUR → pot", "x:1", "states told twice"),
        ("pot (in a; in b) → POUR → pot", "x:1", "place told twice"),
        ("pot ({a}; {b}) → POUR → pot", "x:1", "ingredients told twice"),
        ("pot () → POUR → pot", "x:1", "a name is missing, found “) → POUR → pot”"),
        ("pot + → POUR → pot", "x:1", "a name is missing"),
        ("pot#one → POUR → pot", "x:1", "expected a number, found “one → POUR → pot”"),
        ("pot → POUR → pot → STIR → pot", "x:1", "nothing was expected any more"),
        ('"pot → POUR → pot', "x:1", "this quote does not end"),
        ("a → B → c\n→ D → e\n", "x:1", "nothing was expected any more"),
        ("→ POUR → pot", "x:1", "this line goes on with nothing"),
        ("a → B → c\n---\n+ d", "x:3", "this line goes on with nothing"),
        ("dish: soup\ndish: cake", "x:2", "“dish” is told twice"),
        ("seen in: a 1", "x:1", "“seen in” stands under no step"),
        ("a → B → c\nseen in: video", "x:2", "expected the name of a video and the place of its unit"),
        ("a → B → c\norigin: foon\norigin: foon", "x:3", "“origin” is told twice"),
        ("level: 4", "x:1", "a FOON has no level 4"),
        ("kitchen: pot#1", "x:1", "only the things of steps have numbers"),
        ("goal: soup (in pot#1)", "x:1", "only the things of steps have numbers"),
        ("substitution: object leek: leek like onion", "x:1", "expected “(”"),
        ("substitution: object (leek): leek", "x:1", "expected “like”"),
        ("substitution: object (leek): leek like onion (very)", "x:1", "expected a number"),
        ("assumed: pot (clean)", "x:1", "expected “:”"),
        ("---", "x", "expected one tree, found 2"),
    ],
)
def test_a_fault_names_its_line(text, place, what):
    with pytest.raises(ReadError) as caught:
        read_tree(text, "x")
    assert str(caught.value).startswith(f"{place}: {what}")
    assert "docs/contract.md" in caught.value.hint


def test_remarks_are_no_part_of_a_tree_and_know_their_step():
    text = """
    dish: soup
    pot
      → POUR → pot
    stove → TURN ON → stove
      seen in: a 1
      ✗ minor: it was on
      ✗ fatal: and nobody cooks
    ✗ fatal at the end: no soup
    ---
    ✗ minor at the end: not again
    pot → STIR → pot
      ✗ minor: no spoon
    """
    assert remarks(text) == (
        Remark(1, True, "it was on"),
        Remark(1, False, "and nobody cooks"),
        Remark(None, False, "no soup"),
        Remark(None, True, "not again"),
        Remark(0, True, "no spoon"),
    )
    assert [len(tree.units) for tree in read_trees(text)] == [2, 1]


@pytest.mark.parametrize(
    "text", ["✗ fatal: too early", "a → B → c\n✗ bad: no level", "a → B → c\n✗", "a → B → c\n✗ fatal:"]
)
def test_a_remark_without_a_level_or_a_step_is_refused(text):
    with pytest.raises(ReadError, match=f"x:{len(text.splitlines())}: this remark tells no level"):
        remarks(text, "x")
