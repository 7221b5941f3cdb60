"""C8 (docs/contract.md): what a tree says of its sources, kept and broken clause by clause."""

from __future__ import annotations

import pytest
from validation.handled import FOON, LEEK, entries, sliced
from validation.judging import foon_of, found

from foon_kg.validation import KnownFoon

# --- C8: sources ---


def test_c8_a_step_names_a_unit_with_its_motion_food_and_tool():
    assert found("C8", sliced(), FOON) == []


def test_c8_a_step_that_names_nothing():
    assert found("C8", sliced(seen="nothing"), FOON) == ["C8 step 1: it names no unit of the FOON"]


@pytest.mark.parametrize("seen", ["tomatoes 3", "pears 0", "tomatoes -1"])
def test_c8_a_step_that_names_a_unit_that_is_not_there(seen):
    video, _, place = seen.partition(" ")
    assert found("C8", sliced(seen=seen), FOON) == [f"C8 step 1: the FOON has no unit {place} in “{video}”"]


def test_c8_each_source_that_is_not_there_is_told():
    assert len(found("C8", sliced(seen="tomatoes 0; pears 0; pears 1"), FOON)) == 2


def test_c8_a_source_with_another_motion():
    assert found("C8", sliced(motion="CHOP"), FOON) == ["C8 step 1: the unit it names does “slice”"]


@pytest.mark.parametrize(
    ("entry", "helps"),
    [
        ("motion (tomato): chop like slice (0.9); nothing", True),
        ("motion (tomato): chop like dice (0.9); nothing", False),
        ("motion (tomato): dice like slice (0.9); nothing", False),
        ("tool (tomato): chop like slice (0.9); nothing", False),
    ],
)
def test_c8_another_motion_is_declared_as_this_one(entry, helps):
    assert found("C8", sliced(motion="CHOP", head=entries(entry)), FOON) == (
        [] if helps else ["C8 step 1: the unit it names does “slice”"]
    )


def test_c8_a_source_on_a_food_of_another_kind():
    text = sliced(tool="hand", motion="TEAR", seen="breads 0")
    assert found("C8", text, FOON) == ["C8 step 1: the unit it names works on bread, of another kind"]


def test_c7_c8_where_nothing_is_like_a_food_the_step_says_that_the_motion_alone_is_attested():
    text = sliced(tool="hand", motion="TEAR", seen="breads 0", grounding="motion")
    assert found("C7", text, FOON) == found("C8", text, FOON) == []
    assert found("C8", text.replace("TEAR", "GRATE"), FOON) == ["C8 step 1: the unit it names does “tear”"]
    assert found(
        "C8", text.replace("hand", "knife").replace("breads 0", "peppers 0").replace("TEAR", "DICE"), FOON
    ) == ["C8 step 1: the unit it names uses no knife"]


def test_c8_the_foods_of_another_kind_are_told_in_order():
    foon = "name: v\nonion (whole) + leek (whole) + knife → SLICE → onion (sliced) + leek (sliced)"
    assert found("C8", sliced("apple", seen="v 0"), foon) == [
        "C8 step 1: the unit it names works on leek, onion, of another kind"
    ]


def test_c8_a_food_that_both_put_out_is_the_same_food():
    foon = "name: v\nwobble + plate (empty) + spoon → MIX → wubble (mixed; on plate)"
    text = "wibble + plate (empty) + spoon → MIX → wubble (mixed; on plate)\nseen in: v 0\ngrounding: food"
    assert found("C8", text, foon) == []
    held = text.replace("wubble (mixed; on plate)", "plate ({wubble})")
    assert found("C8", held, foon) == []


def test_c8_a_source_without_food():
    text = sliced(motion="TURN ON", seen="tomatoes 1")
    assert found("C8", text, FOON) == ["C8 step 1: the unit it names works on no food, of another kind"]


def test_c8_a_source_on_a_declared_food_or_one_of_its_kind():
    head = entries("object (tomato): tomato like bread (0.9); nothing")
    assert found("C8", sliced(motion="TEAR", tool="hand", seen="breads 0", head=head), FOON) == []
    assert found("C8", sliced("tomatillo"), FOON) == []


def test_c8_a_step_without_food_may_be_seen_with_any():
    text = "stove (off) → TURN ON → stove (on)\nseen in: tomatoes 1"
    assert found("C8", text, FOON) == []
    switch = "oven (off) → SLICE → oven (on)\nseen in: tomatoes 0"
    assert found("C8", switch, FOON) == []


def test_c8_a_food_that_the_source_holds_in_braces_is_the_same_food():
    text = (
        "salt (granulated; in shaker) + bowl ({tomato}) → SPRINKLE → salt (granulated; in bowl) + bowl ({salt, tomato})"
    )
    assert found("C8", f"{text}\nseen in: tomatoes 2\ngrounding: food", FOON) == []


def test_c8_a_source_with_another_tool():
    assert found("C8", sliced(tool="peeler"), FOON) == ["C8 step 1: the unit it names uses no peeler"]


def test_c8_each_tool_that_the_source_lacks_is_told_in_order():
    assert found("C8", sliced(tool="peeler + grater + knife"), FOON) == [
        "C8 step 1: the unit it names uses no grater",
        "C8 step 1: the unit it names uses no peeler",
    ]


@pytest.mark.parametrize(
    ("entry", "helps"),
    [
        ("tool (tomato): peeler like knife (0.9); nothing", True),
        ("tool (tomato): peelers like knives (0.9); nothing", True),
        ("tool (tomato): peeler like spoon (0.9); nothing", False),
        ("object (tomato): peeler like knife (0.9); nothing", False),
    ],
)
def test_c8_another_tool_is_declared_as_this_one(entry, helps):
    assert (found("C8", sliced(tool="peeler", head=entries(entry)), FOON) == []) is helps


def test_c8_a_source_that_names_no_tool_leaves_the_tool_open():
    head = entries("object (tomato): tomato like bread (0.9); nothing")
    assert found("C8", sliced(motion="TEAR", seen="breads 0", tool="fork", head=head), FOON) == []


def test_c8_fewer_tools_than_the_source_and_another_vessel_are_no_difference():
    assert found("C8", sliced(tool="cup"), FOON) == []


# --- C8: grounding ---


@pytest.mark.parametrize("claim", ["food", "like", "kind", "motion"])
def test_c8_a_step_may_claim_less_than_its_evidence(claim):
    assert found("C8", sliced(grounding=claim), FOON) == []


@pytest.mark.parametrize(
    ("text", "evidence", "allowed"),
    [
        (sliced(grounding="{}"), "food", ["food", "like", "kind", "motion"]),
        (sliced(head=entries(LEEK), motion="DICE", tool="peeler", seen="peppers 0", grounding="{}"), "like",
         ["like", "kind", "motion"]),
        (sliced("tomatillo", grounding="{}"), "kind", ["kind", "motion"]),
    ],
)  # fmt: skip
def test_c8_a_step_claims_no_more_than_its_evidence(text, evidence, allowed):
    for claim in ("food", "like", "kind", "motion"):
        told = found("C8", text.replace("{}", claim), FOON)
        assert told == ([] if claim in allowed else [f"C8 step 1: it claims “{claim}”, and its evidence is {evidence}"])


def test_c8_the_motion_alone_is_the_farthest_evidence():
    told = found("C8", sliced(motion="TEAR", tool="hand", seen="breads 0", grounding="kind"), FOON)
    assert told[-1] == "C8 step 1: it claims “kind”, and its evidence is motion"


def test_c8_foods_of_one_kind_need_no_name_in_common():
    foon = "name: v\ncucumber (whole) + plate (empty) + knife → SLICE → cucumber (sliced; on plate)"
    assert found("C8", sliced("zucchini", seen="v 0", grounding="kind"), foon) == []
    assert found("C8", sliced("onion", seen="v 0", grounding="kind"), foon) != []


def test_c8_of_several_sources_the_nearest_counts():
    assert found("C8", sliced("tomatillo", seen="tomatoes 0; tomatoes 0", grounding="kind"), FOON) == []
    both = sliced(seen="tomatoes 0; breads 0", grounding="food")
    assert not [told for told in found("C8", both, FOON) if "claims" in told]


def test_c8_a_claim_in_an_unknown_word():
    assert found("C8", sliced(grounding="certain"), FOON) == [
        "C8 step 1: its grounding is “certain”, not food, like, kind, motion"
    ]


def test_c8_without_a_source_no_claim_is_asked():
    assert found("C8", sliced(seen="nothing", grounding="certain"), FOON) == ["C8 step 1: it names no unit of the FOON"]


SWITCHED = "{0} (off) → TURN ON → {0} (on)\nseen in: tomatoes 1\ngrounding: {1}"


@pytest.mark.parametrize(
    ("appliance", "claim", "evidence"),
    [
        ("stove", "food", ""),
        ("hot plate", "kind", ""),
        ("hot plate", "food", "kind"),
        ("oven", "motion", ""),
        ("oven", "kind", "motion"),
        ("oven", "food", "motion"),
    ],
)
def test_c8_a_step_without_food_is_attested_by_the_appliance_that_its_evidence_shows(appliance, claim, evidence):
    told = [f"C8 step 1: it claims “{claim}”, and its evidence is {evidence}"] if evidence else []
    assert found("C8", SWITCHED.format(appliance, claim), FOON) == told


def test_c8_a_step_without_food_and_appliance_may_claim_anything():
    text = "plate (empty) + knife → SLICE → plate (dirty)\nseen in: tomatoes 0\ngrounding: food"
    assert found("C8", text, FOON) == []


def test_c7_a_step_without_food_whose_evidence_is_another_appliance_says_so():
    text = "oven (off) → TURN ON → oven (on)\nseen in: tomatoes 1"
    assert found("C7", text, FOON) == ["C7 step 1: no unit that it names has oven, and no grounding says so"]


def test_c8_a_declared_equivalent_counts_in_one_direction():
    wrong = entries("object (tomato): bell pepper like tomato (0.9); nothing")
    text = sliced(head=wrong, motion="DICE", tool="peeler", seen="peppers 0", grounding="like")
    assert "C8 step 1: it claims “like”, and its evidence is motion" in found("C8", text, FOON)


def test_c8_unknown_foods_are_of_no_common_kind():
    foon = foon_of("name: v\nwobble (whole) + plate (empty) + knife → SLICE → wobble (sliced; on plate)")
    assert found("C8", sliced("wibble", seen="v 0"), foon) == [
        "C8 step 1: the unit it names works on wobble, of another kind"
    ]


# --- C8: trees that name no sources ---


def test_c8_foon_text_has_the_unit_itself_or_its_motion_with_one_of_its_outputs():
    assert found("C8", sliced(seen=""), FOON) == []
    assert found("C8", "tomato (raw) + cup → SLICE → tomato (sliced; in cup)", FOON) == []
    assert found("C8", "tomatoes (raw) + cup → SLICE → tomatoes (sliced; in cup)", FOON) == []


@pytest.mark.parametrize(
    "text",
    [
        "cucumber (whole) + knife → SLICE → cucumber (sliced)",
        "tomato (whole) + knife → PURÉE → tomato (pureed)",
        "tomato (whole) + knife → SLICE → cucumber (sliced)",
    ],
)
def test_c8_foon_text_whose_motion_gave_none_of_its_outputs(text):
    assert found("C8", text, FOON) == ["C8 step 1: the FOON has no unit with this motion and any of these outputs"]


def test_c8_steps_with_and_without_sources_are_each_asked():
    text = f"{sliced(seen='')}\n{sliced(motion='CHOP')}"
    assert found("C8", text, FOON) == ["C8 step 2: the unit it names does “slice”"]


def test_c8_a_reference_tree_has_units_of_the_foon_as_they_stand():
    assert found("C8", f"level: 3\n{sliced(seen='')}", FOON) == []
    assert found("C8", f"level: 3\n{sliced()}", FOON) == []
    assert found("C8", "level: 3\ntomato (raw) + knife → SLICE → tomato (sliced; on plate)", FOON) == [
        "C8 step 1: the FOON has no such unit"
    ]


def test_c8_is_not_asked_without_a_foon():
    assert found("C8", sliced(motion="CHOP")) == []
    assert found("C8", sliced(), KnownFoon(())) == ["C8 step 1: the FOON has no unit 0 in “tomatoes”"]


def test_each_step_is_told_with_its_own_number():
    text = f"{sliced()}\n{sliced(motion='CHOP')}"
    assert found("C8", text, FOON) == ["C8 step 2: the unit it names does “slice”"]
    assert found("C7", f"{sliced()}\n{sliced(seen='breads 0')}", FOON) == [
        "C7 step 2: no substitution says what tomato is handled like"
    ]


def test_c8_a_tree_is_judged_alike_whatever_was_judged_before():
    foon = foon_of("name: v\nwrap (whole) + knife + plate → CUT → wrap (halved; on plate)")
    text = "wrap (whole) + knife + plate → CUT → wrap (halved; on plate)\nseen in: v 0"
    found("C8", text, foon)  # a wrap is a utensil where no recipe asks for it
    assert found("C8", f"dish: sandwich\nasked: wrap (whole)\n{text}", foon) == []
