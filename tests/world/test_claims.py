"""Which states nothing earned, and which are believed."""

from __future__ import annotations

import pytest
from world.playing import faults, play, story, told_treatment
from world.starts import HEATED

STORIES = [
    story(
        "a state that nobody earned",
        """
carrot (whole) + plate (empty) → PUT → carrot (peeled, washed; on plate)
beef (raw) + plate (empty) → PUT → beef (cooked; on plate)
""",
        [
            "carrot:",
            "beef:",
            "K7 (minor) step 1 carrot (peeled, washed; on plate): it is peeled, and nobody made it so",
            "K7 (minor) step 1 carrot (peeled, washed; on plate): it is washed, and nobody made it so",
            "K7 (minor) step 2 beef (cooked; on plate): it is cooked, and nobody made it so",
        ],
    ),
    story(
        "what a motion can give of what nobody is judged by is believed",
        """
lettuce (whole) + bowl (empty) → SOAK → lettuce (soaked; in bowl)
bean (dry) + strainer (empty) → STRAIN → bean (drained; in strainer)
raspberry (frozen) + bowl (empty) → THAW → raspberry (thawed; in bowl)
""",
        [
            "lettuce: soak 0",
            "bean: drain 1",
            "raspberry: core -1 cut -1 husk -1 peel -1 shell -1 soak 2 stone -1 thaw 2 heated 2",
        ],
    ),
    story(
        "thawed is what was frozen",
        """
raspberry (fresh) + bowl (empty) → THAW → raspberry (thawed; in bowl)
salmon (frozen) + bowl (empty) → DEFROST → salmon (defrosted; in bowl)
""",
        [
            "raspberry: soak 0 thaw 0 heated 0",
            "salmon: core -1 cut -1 husk -1 peel -1 shell -1 soak 1 stone -1 thaw 1 heated 1",
            "K7 (minor) step 1 raspberry (thawed; in bowl): it is thawed, and it was never frozen",
        ],
    ),
    story(
        "over the heat a food may become cooked by itself",
        HEATED
        + """
beef (raw) + pot (empty; on stove) → PUT → beef (raw; in pot) + pot ({beef}; on stove)
beef (raw; in pot) + pot ({beef}; on stove) + stove (on; under pot) → FRY
  → beef (raw; in pot) + pot (hot; {beef}; on stove)
beef (raw; in pot) + pot (hot; {beef}; on stove) → FLIP → beef (browned; in pot)
""",
        ["beef: cook 3 heated 3"],
    ),
    story(
        "a state that it had before or is sold in is no claim",
        """
carrot (sliced) + plate (empty) → PUT → carrot (sliced; on plate)
pea (whole) + plate (empty) → PUT → pea (frozen; on plate)
""",
        ["carrot: cut -1 fine 2", "pea:"],
    ),
    story(
        "a product claims what it likes",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → salad (peeled; {onion, tomato}; in bowl) + bowl ({salad})
""",
        ["tomato: cut -1 fine 2 joined 0", "onion: cut -1 fine 2 joined 0"],
    ),
    story(
        "an unknown motion gives whatever it says",
        """
carrot (whole) + knife → FROBNICATE → carrot (ready, wet)
carrot (ready, wet) + knife → FROBNICATE → carrot (sliced)
""",
        ["carrot:", "K7 (minor) step 2 carrot (sliced): it is sliced, and nobody made it so"],
    ),
    story(
        "a portion has the history of the whole and its own after it",
        """
apple (whole) + knife → PEEL → apple (peeled)
apple (peeled) + bowl (empty) + cup (empty) → SEPARATE → apple (halved; in bowl) + apple (halved; in cup)
apple (halved; in cup) + knife → DICE → apple (diced; in cup)
""",
        ["apple: peel 0 shell 0", "apple: cut 2 peel 0 shell 0 fine 3"],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_claims(text, told, asked):
    assert told_treatment(play(text, asked)) == told


@pytest.mark.parametrize("treatment", ["thaw", "soak", "drain", "wash", "open"])
def test_what_nobody_is_judged_by_is_believed_of_a_motion_that_can_give_it(treatment):
    states = {"thaw": "thawed", "soak": "soaked", "drain": "drained", "wash": "washed", "open": "opened"}
    motions = {"thaw": "thaw", "soak": "soak", "drain": "drain", "wash": "rinse", "open": "open"}
    world = play(
        f"salmon (frozen) + bowl (empty) → {motions[treatment].upper()} → salmon ({states[treatment]}; in bowl)"
    )
    (part,) = world.supply.parts
    assert part.done[treatment] == 0
    assert faults(world) == []
    put = play(f"salmon (frozen) + bowl (empty) → PUT → salmon ({states[treatment]}; in bowl)")
    assert treatment not in put.supply.parts[0].done
    assert any("nobody made it so" in told for told in faults(put))
