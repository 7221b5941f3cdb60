"""A small FOON to draft from, and narrations in the shapes of the public annotations."""

from __future__ import annotations

import json

from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.loaders.video_tables import read_video_text
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

SOUP = """start,end,motion,inputs,outputs,dish
0:01,0:03,peel,onion (whole); knife,onion (peeled),
0:04,0:06,chop,onion (peeled) on cutting board; knife,onion (chopped) on cutting board,
0:07,0:08,pour,bowl (empty); onion (chopped) on cutting board,bowl {onion}; onion (chopped) in bowl,
0:09,0:10,pick-and-place,cutting board (empty); potato (whole),cutting board {potato}; potato (whole) on cutting board,
0:11,0:12,peel,potato (unpeeled); peeler,potato (peeled),
0:13,0:14,sprinkle,pot; salt (granulated) in shaker,pot {salt}; salt (granulated) in pot,
0:15,0:16,cook,potato (peeled) in pot,potato (cooked) in pot,
0:17,0:18,turn on,stove (off),stove (on),
0:19,0:21,mix,bowl {egg; flour}; egg (cracked) in bowl; flour in bowl,bowl {dough}; dough (mixed) {egg; flour} in bowl,
"""

EPIC_HEADER = "narration_id,video_id,start_timestamp,stop_timestamp,narration,verb,noun,all_nouns"
EPIC_ROWS = (
    "1,P01_01,00:00:01.00,00:00:03.50,peel onion,peel,onion,['onion']",
    "2,P01_01,00:00:05.00,00:00:09.00,chop the onion with knife,chop,onion,\"['onion', 'knife']\"",
    "3,P01_01,00:00:10.00,00:00:12.00,put onion into bowl,put-into,onion,\"['onion', 'bowl']\"",
)
ACTIVITYNET = {
    "v_soup": {"duration": 30.0, "timestamps": [[0, 4.5], [5, 9]], "sentences": ["Peel an onion.", "Chop it."]}
}
YOUCOOK = {
    "database": {
        "GLd3aX16zBg": {
            "recipe_type": "113",
            "annotations": [
                {"segment": [90, 102], "id": 0, "sentence": "peel the onion"},
                {"segment": [114, 127], "id": 1, "sentence": "chop the onion on a cutting board"},
            ],
        }
    }
}


def epic(*rows):
    return "\n".join((EPIC_HEADER, *(rows or EPIC_ROWS))) + "\n"


def activitynet():
    return json.dumps(ACTIVITYNET)


def soup():
    (result,) = read_video_text(SOUP, "soup")
    assert result.notices == ()
    return result.subgraph


def precedents():
    kitchen = Kitchen.default()
    return FoonPrecedents(Snapshot.of([soup()], kitchen).units, kitchen)
