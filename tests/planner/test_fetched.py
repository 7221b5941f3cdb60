"""What can be fetched out of a pot or pan, and what cannot: sauces are poured, leaves come out before a crust."""

from __future__ import annotations

import pytest

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]


def test_no_turner_takes_a_stew_out_of_its_pot(steps):
    done = steps(
        "chicken", "Yassa au Poulet", "chicken leg:raw", "onion:sliced", "lemon juice:juice", "mustard:creamy",
        "peanut oil:liquid", "garlic:chopped", "salt:granulated", "white rice:cooked",
    )  # fmt: skip
    served = [there for there, motion, _ in done if "chicken" in there and {"bowl", "plate"} & there]
    assert served
    assert not any("turner" in there for there in served)


def test_leaves_come_out_of_the_pan_before_what_they_flavoured_lies_on_a_dough(steps):
    done = steps(
        "pizza", "Pissaladiere", "flour:powder", "yeast:dried", "water:liquid", "salt:granulated", "olive oil:liquid",
        "onion:sliced", "bay leaf:sprig", "thyme:sprig", "anchovy:canned", "olive:whole",
    )  # fmt: skip
    motions = [motion for _, motion, _ in done]
    taken_out = [number for number, (there, motion, _) in enumerate(done) if motion == "remove" and "tong" in there]
    assert taken_out
    assert max(taken_out) < motions.index("bake")


def test_cloves_stay_in_a_stew_and_that_is_told(public_plans):
    plan = public_plans(
        "vegetables", "Braised Red Cabbage", "red cabbage:shredded", "clove:whole", "apple:sliced", "onion:sliced",
        "butter:stick", "vinegar:liquid", "sugar:granulated", "bay leaf:whole",
    )  # fmt: skip
    assert any("too small to be taken out" in one.why for one in plan.assumptions if one.node.label == "clove")
    lifted = [unit for unit in plan.units if "tong" in {node.label for node in unit.input_nodes}]
    assert all("clove" not in {node.label for node in unit.output_nodes} for unit in lifted)
    assert lifted
