"""The readers of files, each with small files to begin from, and what must hold of whatever they are given."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable
from dataclasses import dataclass

import zstandard
from demo_foon import demo_subgraphs
from kitchen_stories import SALAD, subgraph
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.language.reviewing import Review
from foon_kg.loaders import read_json, read_paths, read_weights, write_json
from foon_kg.loaders.lessons import lessons_of, read_drafted
from foon_kg.loaders.muhai import read_muhai
from foon_kg.loaders.narrations import read_narrations
from foon_kg.loaders.recipe_collections import RecipeCollections
from foon_kg.loaders.text_writer import write_text
from foon_kg.loaders.video_tables import read_videos
from foon_kg.model.errors import FoonError, FormatError, UsageError
from foon_kg.planning.kitchen_file import read_kitchen
from foon_kg.planning.recipes import IngredientWords, read_recipe
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.interruptible import interruptible
from foon_kg.store.graph.looking import only_looking
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.teach.telling import ReviewTold

SMALL = Snapshot.of([subgraph("salad", "salad", *SALAD)], Kitchen.default())
WORDS = IngredientWords(SMALL.vocabulary(), Kitchen.default())
FILES = ["--files", str(demo_folder())]
MOST_SEEDS = 3


@dataclass(frozen=True)
class Reader:
    """Who reads files of an ending, and files to begin from. ``read`` may raise FoonErrors and nothing else."""

    ending: str
    read: object
    seeds: tuple[bytes, ...] | Callable[[], tuple[bytes, ...]]

    def begin_from(self):
        """Return the files to begin from, which may have to be made."""
        return self.seeds() if callable(self.seeds) else self.seeds


def subgraphs(read):
    """Return who reads subgraphs: what is understood can be written and is read back the same, or is said not to."""

    def reading(path):
        for result in read([path]):
            if result.subgraph is None:
                assert result.notices
                continue
            try:
                text = write_json(result.subgraph)
            except FormatError:
                continue
            assert read_json(text, result.subgraph.name).subgraph == result.subgraph

    return reading


def narrations(path):
    for told in read_narrations([path]):
        for _ in zip(range(20), told.narrations or (), strict=False):
            pass


def recipes(path):
    with RecipeCollections([path], lambda _: None) as found:
        assert found.check() == sum(1 for _ in found)


def recipe(path):
    read_recipe(path, WORDS)


def kitchen(path):
    read_kitchen(path, WORDS)


def question(path):
    try:
        interruptible(only_looking(path.read_bytes().decode()))
    except UnicodeDecodeError:
        return


def lessons(path):
    """Have drafts of recipes read, and what they teach stored as JSON and read back."""
    for one in lessons_of(read_drafted([path])):
        assert read_json(write_json(one.subgraph), one.subgraph.name).subgraph == one.subgraph


def reviewed(path):
    """Have a draft looked at as on the page that teaches, and each row decided on; it is told all the while."""
    try:
        review = Review.of(path.read_bytes().decode(), "r1")
    except UnicodeDecodeError:
        return
    ReviewTold.of(review)
    for _ in review.rows[:3]:
        for decided in (review.accepted(0), review.dropped(0)):
            ReviewTold.of(decided)
            assert Review.of(decided.text(), "r1") == decided or not decided.rows
        try:
            review = review.edited(0, {"motion": review.rows[0].get("inputs", "")})
        except UsageError:
            review = review.dropped(0)
    write_text(review.subgraph())


def shown(path):
    """Have a plan shown and judged by the commands: exit codes as documented, no error that nobody caught."""
    for words in (["show", str(path)], ["check", str(path), *FILES], ["export", str(path), "--format", "markdown"]):
        done = CliRunner().invoke(app, words)
        if done.exception and not isinstance(done.exception, SystemExit):
            raise done.exception
        assert done.exit_code in {0, 1, 2, 3}


def plans():
    """Made where it is asked for: every process that collects the tests would plan it."""
    done = CliRunner().invoke(app, ["plan", str(demo_recipes()[0]), "--json", *FILES])
    return (done.stdout.encode(),)


TEXTS = tuple(path.read_bytes() for path in sorted(demo_folder().glob("*.txt"))[:MOST_SEEDS])
JSONS = tuple(write_json(one).encode() for one in demo_subgraphs()[:1])
TABLE = b"""start,end,motion,inputs,outputs,dish
0:12,0:31,chop,onion (peeled) on cutting board; knife,*onion (chopped) on cutting board,
0:40,0:44,mix *,bowl {onion; tomato}; spoon,bowl {salad}; salad (mixed) {onion; tomato} in bowl,salad
"""
NETWORK = b"""(defparameter *recipe* '((get-kitchen ?k)
 (fetch-and-proportion ?butter ?k1 ?k ?c1 butter 60 g)
 (transfer-contents ?x ?r1 ?k3 ?k1 ?bowl ?butter ?q1 ?u1)
 (mix ?batter ?k5 ?k3 ?x ?mixing-tool)
 (bake ?bread ?k7 ?k5 ?batter ?oven 60 minute 165 degrees-celsius)))"""
NARRATED = b"""narration_id,participant_id,video_id,narration_timestamp,start_timestamp,stop_timestamp,start_frame,\
stop_frame,narration,verb,verb_class,noun,noun_class,all_nouns,all_noun_classes
P01_01_0,P01,P01_01,00:00:01.0,00:00:00.1,00:00:03.3,8,202,chop onion,chop,7,onion,16,['onion'],[16]
"""
CAPTIONS = b'{"v_1": {"duration": 12.5, "timestamps": [[0, 3.5], [3, 9]], "sentences": ["Chop it.", "Fry it."]}}'
SEGMENTS = b'{"database": {"v": {"annotations": [{"segment": [1, 9], "sentence": "chop it"}], "recipe_type": "1"}}}'
RECIPE = {"id": "r1", "title": "Green Salad", "type": "salad", "ingredients": ["1 onion, chopped", {"object": "egg"}]}
LINE = json.dumps(RECIPE).encode()
ROWS = b'id,title,type,ingredients\nr1,Soup,soup,"[""1 leek""]"\nr2,Pie,,a|b\n'
KITCHEN = b"# here\n- onion, chopped\nknife\nsalt in a jar\n"
KITCHEN_JSON = b'{"foods": ["onion, chopped", {"object": "salt", "state": "ground"}], "utensils": ["knife"]}'
QUESTION = b"MATCH (n:X {label: $x})-[:Y*1..2]->(m) WHERE n.label =~ '.*a' RETURN [x IN m.states WHERE x > 1 | x] AS s"

DRAFT_TABLE = (
    "start,end,motion,inputs,outputs,dish,confidence,doubt,said,source\n"
    "0:12,0:31,chop,onion (peeled);knife,onion (chopped),,0.5,is it peeled?,chop it,r.json\n"
    ",,mix,onion (chopped); bowl,salad (mixed) {onion} in bowl,salad,0.9,,mix,\n"
)
DRAFTED = json.dumps({"id": "r1", "title": "Salad", "dish_type": "salad", "confidence": 0.5, "units": 2,
                      "table": DRAFT_TABLE, "problem": ""}).encode() + b"\n"  # fmt: skip

READERS = {
    "text": Reader(".txt", subgraphs(read_paths), TEXTS),
    "json": Reader(".json", subgraphs(read_paths), JSONS),
    "video table": Reader(".csv", subgraphs(read_videos), (TABLE,)),
    "muhai": Reader(".lisp", subgraphs(read_muhai), (NETWORK,)),
    "narrations": Reader(".csv", narrations, (NARRATED,)),
    "captions": Reader(".json", narrations, (CAPTIONS, SEGMENTS)),
    "recipe lines": Reader(".jsonl", recipes, (LINE + b"\n" + LINE.replace(b"r1", b"r2") + b"\n",)),
    "recipe list": Reader(".json", recipes, (b"[" + LINE + b"]", LINE)),
    "recipe table": Reader(".csv", recipes, (ROWS,)),
    "recipe": Reader(".json", recipe, tuple(path.read_bytes() for path in demo_recipes()[:MOST_SEEDS])),
    "kitchen": Reader(".txt", kitchen, (KITCHEN,)),
    "kitchen in json": Reader(".json", kitchen, (KITCHEN_JSON,)),
    "weights": Reader(".json", read_weights, (b'{"chop": 0.9, "pour": 1}',)),
    "drafts": Reader(".jsonl", lessons, (DRAFTED, DRAFTED * 2)),
    "drafts in gzip": Reader(".jsonl.gz", lessons, (gzip.compress(DRAFTED, mtime=0),)),
    "drafts in zstd": Reader(".jsonl.zst", lessons, (zstandard.compress(DRAFTED),)),
    "draft table": Reader(".csv", reviewed, (DRAFT_TABLE.encode(), TABLE)),
    "question": Reader(".cypher", question, (QUESTION,)),
    "plan": Reader(".json", shown, plans),
}


def fails(reader, path):
    """Return what a reader raised that is no FoonError; None where all is well."""
    try:
        reader.read(path)
    except FoonError as error:
        return None if error.message and error.hint else AssertionError("an error without words or hint")
    except Exception as error:  # noqa: BLE001 - whatever it is, it is a find
        return error
    return None
