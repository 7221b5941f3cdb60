"""How much memory and time each loader takes for files of two sizes, in a process of its own for each.

    python benchmarks/file_budgets.py                      # every form and shape, a table
    python benchmarks/file_budgets.py --form json --shape one --bytes 4000000   # one of them, one line of JSON

Memory is how much the process grew, in bytes for each byte of the file; a loader that needs a fixed multiple of a file
has the same figure for both sizes. Time is the quotient of the larger file's seconds for a byte and the smaller one's:
1 is linear, 4 would be quadratic. ``tests/loaders/test_budgets.py`` holds the memory to what is promised.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from foon_kg.foon.demo import demo_folder
from foon_kg.loaders.muhai import read_muhai
from foon_kg.loaders.narrations import read_narrations
from foon_kg.loaders.paths import read_paths
from foon_kg.loaders.recipe_collections import RecipeCollections
from foon_kg.loaders.video_tables import read_videos
from foon_kg.loaders.weights import read_weights
from foon_kg.model.errors import FoonError
from foon_kg.planning.kitchen_file import read_kitchen
from foon_kg.planning.recipes import IngredientWords
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

SMALL = 250_000
TIMES = 4
SPACES = " " * 240
"""Of a kitchen only so many things are read: here their lines are long."""

SHAPES = ("many", "one")
"""Many entries, or one that fills the file."""


@dataclass(frozen=True)
class Form:
    """A form of files: an entry of many, a part of one that fills the file, what stands around; who reads it."""

    ending: str
    read: Callable[[Path], Any]
    entry: Callable[[int], str]
    part: Callable[[int], str]
    around: tuple[str, str] = ("", "")
    one_around: tuple[str, str] = ("", "")
    between: str = "\n"
    part_between: str = "\n"

    def text(self, shape: str, size: int) -> str:
        """Return a file of about ``size`` bytes."""
        make, between = (self.entry, self.between) if shape == "many" else (self.part, self.part_between)
        begins, ends = self.around
        if shape == "one":
            begins, ends = begins + self.one_around[0], self.one_around[1] + ends
        each = max(1, len(make(size // 2)) + len(between))
        return begins + between.join(make(number) for number in range(size // each)) + ends


def _listed(read: Callable[[list[Path]], Iterable[object]]) -> Callable[[Path], list[object]]:
    return lambda path: list(read([path]))


def _counted(path: Path) -> int:
    with RecipeCollections([path], lambda _: None) as recipes:
        recipes.check()
        return sum(1 for _ in recipes)


def _in_the_kitchen(path: Path) -> object:
    subgraphs = [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None]
    everybody = Kitchen.default()
    return read_kitchen(path, IngredientWords(Snapshot.of(subgraphs, everybody).vocabulary(), everybody))


def _object(number: int) -> str:
    return f"O\tonion {number}\t0\nS\tchopped\nS\tin\t[bowl]"


def _node(number: int) -> str:
    return f'{{"label": "onion {number}", "states": ["chopped"]}}'


def _recipe(number: int) -> str:
    return json.dumps({"id": f"r{number}", "title": "Salad", "ingredients": [f"{number} onions, chopped", "salt"]})


_KNIFE = "O\tknife\t1\nM\tchop\t<Assumed>\nO\tonion\t0\nS\tchopped"
_UNIT = '"motion_node": "chop", "output_nodes": [{"label": "onion", "states": ["chopped"]}]'
_COLUMNS = """narration_id,participant_id,video_id,narration_timestamp,start_timestamp,stop_timestamp,start_frame,\
stop_frame,narration,verb,verb_class,noun,noun_class,all_nouns,all_noun_classes
"""
_TOLD = "P01_01_{0},P01,P01_01,00:00:01.0,00:00:00.1,00:00:03.3,8,202,chop onion,chop,7,onion,16,"
_MIX = "(fetch-and-proportion ?f{0} ?k{0} ?k ?c{0} butter 60 g)\n(mix ?m{0} ?l{0} ?k{0} ?f{0} ?t{0})"

FORMS = {
    "text": Form(".txt", _listed(read_paths), lambda n: f"{_object(n)}\n{_KNIFE}\n//", _object,
                 one_around=("", f"\n{_KNIFE}\n//\n")),
    "json": Form(".json", _listed(read_paths), lambda n: f'{{"input_nodes": [{_node(n)}], {_UNIT}}}', _node,
                 ('{"units": [', "]}"), ('{"input_nodes": [', f"], {_UNIT}}}"), ",", ","),
    "video table": Form(".csv", _listed(read_videos), lambda n: f"{n},{n + 1},chop,onion {n}; knife,onion (chopped),",
                        lambda n: f"onion {n}", ("start,end,motion,inputs,outputs,dish\n", ""),
                        ("0,1,chop,", ",onion (chopped),"), part_between="; "),
    "muhai": Form(".lisp", _listed(read_muhai), _MIX.format, lambda n: f"?v{n}",
                  ("(defparameter *recipe* '(", "))"), ("(mix ", ")"), part_between=" "),
    "narrations": Form(".csv", _listed(read_narrations), lambda n: _TOLD.format(n) + "['onion'],[16]",
                       lambda n: f"'onion{n}'", (_COLUMNS, ""), (_TOLD.format(0) + '"[', ']",[16]'), part_between=", "),
    "recipes in lines": Form(".jsonl", _counted, _recipe, lambda n: f'"{n} onions"',
                             one_around=('{"ingredients": [', "]}"), part_between=", "),
    "recipes in a list": Form(".json", _counted, _recipe, lambda n: f'"{n} onions"', ("[", "]"),
                              ('{"ingredients": [', "]}"), ",", ","),
    "recipes in a table": Form(".csv", _counted, lambda n: f"r{n},Salad,{n} onions|salt", lambda n: f"{n} onions",
                               ("id,title,ingredients\n", "\n"), ("r1,Salad,", ""), part_between="|"),
    "kitchen": Form(".txt", _in_the_kitchen, lambda _: f"chopped onion{SPACES}", lambda n: f"onion{n}",
                    part_between=" "),
    "kitchen as JSON": Form(".json", _in_the_kitchen, lambda _: f'"onion{SPACES}"', lambda n: f"onion{n}",
                            ('{"foods": [', "]}"), ('"', '"'), ",", " "),
    "weights": Form(".json", read_weights, lambda n: f'"chop{n}": 0.5', lambda n: f"chop{n}", ("{", "}"),
                    ('"', '": 0.5'), ",", " "),
}  # fmt: skip


def measured(form: Form, shape: str, size: int) -> dict[str, float]:
    """Return how many bytes this process grows while a file is read, the file's bytes, and seconds."""
    with tempfile.TemporaryDirectory() as folder:
        small, path = Path(folder) / f"small{form.ending}", Path(folder) / f"file{form.ending}"
        small.write_text(form.text("many", 4_000), encoding="utf-8")
        path.write_text(form.text(shape, size), encoding="utf-8")
        form.read(small)  # what is imported and read only once is not the file's
        before, start = _most(), time.perf_counter()
        try:
            form.read(path)
            told = ""
        except FoonError as error:
            told = error.code
        return {"bytes": path.stat().st_size, "grew": _most() - before,
                "seconds": time.perf_counter() - start, "told": told}  # fmt: skip


def _most() -> int:
    """Return the most memory that this process had, in bytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def asked(form: str, shape: str, size: int) -> dict[str, Any]:
    """Return what :func:`measured` tells in a process of its own."""
    words = [sys.executable, __file__, "--form", form, "--shape", shape, "--bytes", str(size)]
    told = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    return dict(json.loads(told))


def main() -> None:
    """Print the table, or one measurement."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--form", choices=FORMS)
    parser.add_argument("--shape", choices=SHAPES, default="many")
    parser.add_argument("--bytes", type=int, default=SMALL)
    given = parser.parse_args()
    if given.form:
        print(json.dumps(measured(FORMS[given.form], given.shape, given.bytes)))
        return
    print(f"{'form':20} {'shape':5} {'memory':>14} {'s/MB':>7} {'time':>5}")
    for form in FORMS:
        for shape in SHAPES:
            small, large = asked(form, shape, given.bytes), asked(form, shape, TIMES * given.bytes)
            memory = " → ".join(f"{one['grew'] / one['bytes']:.0f}" for one in (small, large))
            rates = [one["seconds"] / one["bytes"] for one in (small, large)]
            print(f"{form:20} {shape:5} {memory:>14} {rates[1] * 1e6:7.2f} {rates[1] / rates[0]:5.2f} {large['told']}")


if __name__ == "__main__":
    main()
