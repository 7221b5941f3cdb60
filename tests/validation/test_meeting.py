"""K3 (docs/contract.md): what comes hot to what stays cold, and dry to what is hot."""

from __future__ import annotations

import pytest
from validation.judging import found

POT = """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
"""


def salad(cooling="", title="", cold="lettuce", dish="salad"):
    """A salad of what was grilled, and of something cold; ``cooling`` is done to it in between."""
    hot = "chicken (grilled; on grill)"
    cooled = f"{hot} + grill (off) → {cooling} → chicken (grilled, cooled; on grill) + grill (off)" if cooling else ""
    hot = "chicken (grilled, cooled; on grill)" if cooling else hot
    return f"""
dish: {dish}
title: {title}
asked: chicken (raw); {cold} (chopped)
{cold} (chopped) + bowl (empty) → PUT → {cold} (chopped; in bowl) + bowl ({{{cold}}})
chicken (raw) + grill (off) → PUT → chicken (raw; on grill) + grill (off)
grill (off) → TURN ON → grill (on)
chicken (raw; on grill) + grill (on) → GRILL → chicken (grilled; on grill) + grill (on)
grill (on) → TURN OFF → grill (off)
{cooled}
{hot} + bowl ({{{cold}}}) → PUT → chicken (grilled; in bowl) + bowl ({{chicken, {cold}}})
chicken (grilled; in bowl) + {cold} (chopped; in bowl) + bowl ({{chicken, {cold}}}) + spoon → MIX
  → salad (mixed; {{chicken, {cold}}}; in bowl) + bowl ({{salad}})
""".replace("title: \n", "")


@pytest.mark.parametrize(("cold", "step"), [("lettuce", 6), ("mayonnaise", 6), ("yogurt", 6)])
def test_k3_what_is_hot_wilts_leaves_and_melts_what_is_creamy(cold, step):
    assert found("K3", salad(cold=cold)) == [f"K3 (minor) step {step}: chicken comes hot to {cold}"]


@pytest.mark.parametrize("cooling", ["COOL", "CHILL", "RINSE"])
def test_k3_what_cooled_or_was_rinsed_is_hot_no_more(cooling):
    assert found("K3", salad(cooling)) == []


def test_k3_a_whole_salad_that_is_chilled_at_last_has_wilted_before():
    end = "salad (mixed; {chicken, lettuce}; in bowl) + bowl ({salad}) → CHILL → salad (chilled, mixed; in bowl)"
    assert found("K3", salad() + end) == ["K3 (minor) step 6: chicken comes hot to lettuce"]


def test_k3_what_suffers_nothing_what_is_called_warm_and_what_is_no_salad_may_be_hot():
    assert found("K3", salad(cold="cucumber")) == []
    assert found("K3", salad(title="Warm Chicken Salad")) == []
    assert found("K3", salad(dish="sandwich")) == []


def sauce(binder="flour", states="powder", liquid="milk", *, hot=True, more=""):
    """A sauce in a pot to which something that binds it comes out of its packet, after it was heated or before."""
    heat = f"""
stove (off; under pot) → TURN ON → stove (on; under pot)
{liquid} (liquid; in pot) + pot ({{{liquid}}}; on stove) + stove (on; under pot) → HEAT
  → {liquid} (hot; in pot) + pot ({{{liquid}}}; on stove)
"""
    add = f"""
{binder} ({states}; in packet) + pot ({{{liquid}}}; on stove) → POUR
  → {binder} ({states}; in pot) + pot ({{{binder}, {liquid}}}; on stove)
"""
    return (
        POT
        + f"""
{more}
{liquid} (liquid; in bottle) + pot (empty; on stove) → POUR → {liquid} (liquid; in pot) + pot ({{{liquid}}}; on stove)
{heat if hot else add}
{add if hot else heat}
{liquid} (liquid; in pot) + {binder} ({states}; in pot) + pot ({{{binder}, {liquid}}}; on stove) + spoon → COOK AND STIR
  → sauce (cooked; {{{binder}, {liquid}}}; in pot) + pot ({{sauce}}; on stove)
"""
    )


@pytest.mark.parametrize("binder", ["flour", "cornstarch", "potato starch"])
@pytest.mark.parametrize("liquid", ["milk", "water", "chicken broth"])
def test_k3_what_binds_a_sauce_makes_lumps_where_it_comes_dry_to_a_hot_liquid(binder, liquid):
    assert found("K3", sauce(binder, liquid=liquid)) == [f"K3 step 5: {binder} comes dry into hot {liquid}"]


def test_k3_it_makes_none_in_fat_in_what_is_cold_or_stirred_smooth_before():
    assert found("K3", sauce(liquid="oil")) == []
    assert found("K3", sauce(hot=False)) == []
    assert found("K3", sauce(states="liquid, mixed")) == []
    assert found("K3", sauce("cornmeal")) == []  # strewn into what boils
