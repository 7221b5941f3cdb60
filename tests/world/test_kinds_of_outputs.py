"""What may come of what: foods of one word, of one kind, and what is left over of them."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_outputs

STORIES = [
    story(
        "tea does not come of water",
        """
water (liquid; in bottle) + cup (empty) → POUR → tea (hot; in cup) + cup ({tea})
""",
        [
            "cup: tea (hot) of water",
            "made: tea",
            "moved: water bottle → nowhere; tea nowhere → cup",
            "taken: water",
            "treated: tea; tea",
            "W2 step 1 tea (hot; in cup): tea does not come of water",
        ],
    ),
    story(
        "a food comes of one that shares a word with it",
        """
lemon (whole) + glass (empty) + squeezer → SQUEEZE → lemon juice (liquid; in glass) + glass ({lemon juice})
""",
        [
            "glass: lemon juice (liquid) of lemon",
            "free: lemon (whole)",
            "made: lemon juice",
            "moved: lemon juice nowhere → glass",
            "taken: lemon",
            "treated: lemon juice; lemon juice; lemon",
        ],
    ),
    story(
        "juice and what is left of the fruit",
        """
lemon (halved) + glass (empty) + squeezer → SQUEEZE
  → lemon juice (liquid; in glass) + lemon (squeezed) + glass ({lemon juice})
""",
        [
            "glass: lemon juice (liquid) of lemon",
            "free: lemon (halved); lemon (squeezed)",
            "made: lemon juice",
            "moved: lemon juice nowhere → glass",
            "taken: lemon",
            "treated: lemon; lemon juice; lemon juice; lemon",
        ],
    ),
    story(
        "juice and fruit under one name",
        """
lemon (halved) + glass (empty) + squeezer → SQUEEZE → lemon (juice; in glass) + lemon (squeezed) + glass ({lemon})
""",
        [
            "glass: lemon (juice); lemon (squeezed)",
            "moved: lemon nowhere → glass",
            "taken: lemon",
            "treated: lemon; lemon",
        ],
    ),
    story(
        "a food comes of one of its kind",
        """
cucumber (whole) + plate (empty) + knife → SLICE → zucchini (sliced; on plate) + plate ({zucchini})
""",
        [
            "plate: zucchini (sliced) of cucumber",
            "free: cucumber (whole)",
            "made: zucchini",
            "moved: zucchini nowhere → plate",
            "taken: cucumber",
            "treated: zucchini",
        ],
    ),
    story(
        "a food does not come of another kind",
        """
beef (raw) + plate (empty) + knife → SLICE → zucchini (sliced; on plate) + plate ({zucchini})
""",
        [
            "plate: zucchini (sliced) of beef",
            "free: beef (raw)",
            "made: zucchini",
            "moved: zucchini nowhere → plate",
            "taken: beef",
            "treated: zucchini",
            "W2 step 1 zucchini (sliced; on plate): zucchini does not come of beef",
        ],
    ),
    story(
        "an unknown food may come of anything",
        """
beef (raw) + plate (empty) + knife → SLICE → wibble (sliced; on plate) + plate ({wibble})
""",
        [
            "plate: wibble (sliced) of beef",
            "free: beef (raw)",
            "made: wibble",
            "moved: wibble nowhere → plate",
            "taken: beef",
            "treated: wibble",
        ],
    ),
    story(
        "dough needs flour",
        """
water (liquid; in bottle) + salt (granulated; in bag) + bowl (empty) → KNEAD
  → dough ({salt, water}; in bowl) + bowl ({dough})
""",
        [
            "bowl: dough of salt + water",
            "made: dough",
            "moved: water bottle → nowhere; salt bag → nowhere; dough nowhere → bowl",
            "taken: water; salt",
            "treated: dough; dough",
            "W2 step 1 dough ({salt, water}; in bowl): dough does not come of salt, water",
        ],
    ),
    story(
        "an egg gives white and yolk",
        """
egg (whole) + bowl (empty) + cup (empty) → SEPARATE
  → egg white (in bowl) + egg yolk (in cup) + bowl ({egg white}) + cup ({egg yolk})
""",
        [
            "bowl: egg white of egg",
            "cup: egg yolk of egg",
            "free: egg (whole)",
            "made: egg white; egg yolk",
            "moved: egg white nowhere → bowl; egg yolk nowhere → cup",
            "taken: egg",
            "treated: egg white; egg yolk; egg white; egg yolk; egg",
        ],
    ),
    story(
        "peeling leaves a skin",
        """
banana (whole) + hand + plate (empty) → PEEL → banana (peeled; on plate) + banana (skin) + plate ({banana})
""",
        [
            "plate: banana (peeled); banana (skin)",
            "moved: banana nowhere → plate",
            "taken: banana",
            "treated: banana; banana",
        ],
    ),
    story(
        "a numbered food comes out as the same number",
        """
tomato#1 (whole) + plate (empty) + knife → SLICE → tomato#1 (sliced; on plate)
tomato#1 (sliced; on plate) + onion#2 (sliced) + bowl (empty) → MIX
  → salad#3 ({onion, tomato}; in bowl) + bowl ({salad})
salad#3 ({onion, tomato}; in bowl) + cup (empty) → PUT → salad#3 ({onion, tomato}; in cup) + cup ({salad})
""",
        ["cup: salad of onion + tomato", "moved: salad bowl → cup", "treated: salad"],
    ),
    story(
        "of several foods of a name the one in that state comes out",
        """
tomato (whole) + tomato (sliced) + plate (empty) → PUT → tomato (sliced; on plate) + tomato (whole; on plate)
""",
        [
            "plate: tomato (sliced); tomato (whole)",
            "moved: tomato nowhere → plate; tomato nowhere → plate",
            "taken: tomato; tomato",
            "treated: tomato; tomato",
            "W1 (minor) step 1 tomato (sliced): more of it is used than is left: it is whole since step 1",
        ],
    ),
    story(
        "gnocchi come of flour though nothing of their name does",
        """
flour (whole) + egg (cracked) + plate (empty) → PUT → gnocchi (raw; on plate) + plate ({gnocchi})
""",
        [
            "plate: gnocchi (raw) of egg + flour",
            "made: gnocchi",
            "moved: flour nowhere → nowhere; egg nowhere → nowhere; gnocchi nowhere → plate",
            "taken: flour; egg",
            "treated: gnocchi; gnocchi",
        ],
    ),
    story(
        "a food comes of one of a broader kind",
        """
broccoli (whole) + plate (empty) + knife → SLICE → floret (sliced; on plate) + plate ({floret})
""",
        [
            "plate: floret (sliced) of broccoli",
            "free: broccoli (whole)",
            "made: floret",
            "moved: floret nowhere → plate",
            "taken: broccoli",
            "treated: floret",
        ],
    ),
    story(
        "a food comes of one of a narrower kind",
        """
pearl onion (whole) + plate (empty) + knife → SLICE → shallot (sliced; on plate) + plate ({shallot})
""",
        [
            "plate: shallot (sliced) of pearl onion",
            "free: pearl onion (whole)",
            "made: shallot",
            "moved: shallot nowhere → plate",
            "taken: pearl onion",
            "treated: shallot",
        ],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_kinds_of_outputs(text, told, asked):
    assert told_outputs(play(text, asked)) == told
