"""A FOON in which every craft of a kitchen is seen once, each on one food, and a salad into which anything may go."""

from __future__ import annotations

from integration.told import KITCHEN, snapshot_of

from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings

SALAD = """
name: salad
dish: salad
goal: salad (mixed; {cucumber, lettuce, olive oil, salt}; in bowl)
lettuce (whole) + cutting board (empty) + knife → CHOP → lettuce (chopped; on cutting board) + cutting board ({lettuce})
lettuce (chopped; on cutting board) + cutting board ({lettuce}) + bowl (empty) → POUR
  → lettuce (chopped; in bowl) + bowl ({lettuce}) + cutting board (empty)
cucumber (whole) + peeler → PEEL → cucumber (peeled)
cucumber (peeled) + cutting board (empty) + knife → SLICE
  → cucumber (sliced; on cutting board) + cutting board ({cucumber})
cucumber (sliced; on cutting board) + cutting board ({cucumber}) + bowl ({lettuce}) → POUR
  → cucumber (sliced; in bowl) + bowl ({cucumber, lettuce}) + cutting board (empty)
olive oil (liquid; in bottle) + bowl ({cucumber, lettuce}) → POUR
  → olive oil (liquid; in bowl) + bowl ({cucumber, lettuce, olive oil})
salt (granulated; in shaker) + bowl ({cucumber, lettuce, olive oil}) → SPRINKLE
  → salt (granulated; in bowl) + bowl ({cucumber, lettuce, olive oil, salt})
lettuce (chopped; in bowl) + cucumber (sliced; in bowl) + olive oil (liquid; in bowl) + salt (granulated; in bowl)
  + bowl ({cucumber, lettuce, olive oil, salt}) + spoon → MIX
  → salad (mixed; {cucumber, lettuce, olive oil, salt}; in bowl) + bowl ({salad})
"""

CRAFTS = """
name: boiling
water (liquid; from faucet) + pot (empty) → POUR → water (liquid; in pot) + pot ({water})
pot ({water}) + stove (off) → PICK-AND-PLACE → pot ({water}; on stove) + stove (off; under pot)
stove (off; under pot) → TURN ON → stove (on; under pot)
potato (whole) + pot ({water}; on stove) → PICK-AND-PLACE → potato (whole; in pot) + pot ({potato, water}; on stove)
potato (whole; in pot) + water (liquid; in pot) + pot ({potato, water}; on stove) + stove (on; under pot) → BOIL
  → potato (boiled; in pot) + water (hot; in pot) + pot (hot; {potato, water}; on stove)
potato (boiled; in pot) + pot (hot; {potato, water}; on stove) + strainer (empty) → DRAIN
  → potato (boiled; in strainer) + strainer ({potato}) + pot (empty; on stove)
stove (on; under pot) → TURN OFF → stove (off; under pot)
---
name: eggs
egg (whole) + bowl (empty) → CRACK → egg (cracked; in bowl) + bowl ({egg})
egg (cracked; in bowl) + bowl ({egg}) + whisk → BEAT → egg (beaten; in bowl) + bowl ({egg})
egg (boiled) + water (liquid; from faucet) → RINSE → egg (boiled, washed)
egg (boiled, washed) → PEEL → egg (boiled, peeled)
egg (boiled, peeled) + cutting board (empty) + knife → SLICE → egg (sliced; on cutting board) + cutting board ({egg})
---
name: cutting
carrot (whole) + peeler → PEEL → carrot (peeled)
carrot (peeled) + bowl (empty) + grater → GRATE → carrot (grated; in bowl) + bowl ({carrot})
onion (whole) + knife → PEEL → onion (peeled)
onion (peeled) + cutting board (empty) + knife → DICE → onion (diced; on cutting board) + cutting board ({onion})
garlic (peeled) + cutting board (empty) + knife → MINCE → garlic (minced; on cutting board) + cutting board ({garlic})
cheese (block) + bowl (empty) + grater → GRATE → cheese (grated; in bowl) + bowl ({cheese})
walnut (whole) + cutting board (empty) + knife → CHOP → walnut (chopped; on cutting board) + cutting board ({walnut})
---
name: opening
avocado (whole) + knife → CUT → avocado (halved)
avocado (halved) + spoon → PIT → avocado (pitted)
apple (whole) + knife → CORE → apple (cored)
banana (whole) → PEEL → banana (peeled)
lemon (whole) + knife → CUT → lemon (halved)
lemon (halved) + bowl (empty) + squeezer → SQUEEZE → lemon (juice; in bowl) + bowl ({lemon})
bean (canned; in can) + strainer (empty) → DRAIN → bean (canned; in strainer) + strainer ({bean})
---
name: warming
pan (empty) + stove (off) → PICK-AND-PLACE → pan (empty; on stove) + stove (off; under pan)
stove (off; under pan) → TURN ON → stove (on; under pan)
butter (stick; in packet) + pan (empty; on stove) → PICK-AND-PLACE → butter (stick; in pan) + pan ({butter}; on stove)
butter (stick; in pan) + pan ({butter}; on stove) + stove (on; under pan) → MELT
  → butter (melted; in pan) + pan (hot; {butter}; on stove)
chicken (raw) + pan (hot; {butter}; on stove) → PICK-AND-PLACE
  → chicken (raw; in pan) + pan (hot; {butter, chicken}; on stove)
chicken (raw; in pan) + butter (melted; in pan) + pan (hot; {butter, chicken}; on stove) + stove (on; under pan) → FRY
  → chicken (fried; in pan) + butter (hot; in pan) + pan (hot; {butter, chicken}; on stove)
stove (on; under pan) → TURN OFF → stove (off; under pan)
potato (boiled) + bowl (empty) → PICK-AND-PLACE → potato (boiled; in bowl) + bowl ({potato})
potato (boiled; in bowl) + bowl ({potato}) + masher → MASH → potato (mashed; in bowl) + bowl ({potato})
"""

SNAPSHOT = snapshot_of(SALAD, CRAFTS)
PLANNER = Planner(SNAPSHOT, PlanSettings(KITCHEN, time_limit=None), SNAPSHOT.units)


def planned(food, state):
    """Return the plan of a salad with lettuce, salt and this food."""
    foods = [("lettuce", "chopped"), ("salt", "granulated"), (food, state)]
    return PLANNER.plan(Recipe("salad", tuple(RequiredIngredient(*one) for one in foods)))


def life_of(food, result):
    """Return what is done to the asked food as long as it is a thing of its own: motion and its states then."""
    number = next(thing for unit in result.units for node, thing, _ in unit.inputs if node.label == food)
    found = []
    for unit in result.units:
        nodes = [node for node, thing, _ in unit.outputs if thing == number and node.label == food]
        if any(one.thing == number for one in unit.inputs):
            found.append((unit.motion, nodes[0].states if nodes else ()))
    return found
