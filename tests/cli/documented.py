"""The commands that documents show, a folder that has the files they name, and how they are typed."""

from __future__ import annotations

import json
import re
import shlex
import shutil
from pathlib import Path

from drafting.kitchen_foon import EPIC_ROWS, YOUCOOK, epic
from typer.testing import CliRunner, Result

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes

DOCS = Path(__file__).parents[2] / "docs"

COOKIES = "Mix the flour, the butter and the sugar in a bowl. Put the dough on a baking sheet. Bake it in the oven."
RECIPES = [
    {
        "id": recipe_id,
        "title": title,
        "ingredients": [{"text": line} for line in lines],
        "instructions": [{"text": text}],
        "url": f"https://example.org/{recipe_id}",
        "partition": "train",
    }
    for recipe_id, title, lines, text in (
        (
            "000018c8a5",
            "Onion salad",
            ("1 chopped onion", "2 tablespoons olive oil", "1 diced tomato"),
            "Toss the onion and the tomato with the olive oil.",
        ),
        (
            "000033e39b",
            "Onion omelette",
            ("2 eggs, beaten", "1 chopped onion", "1 tablespoon butter"),
            "Melt the butter in a pan. Pour the eggs and the onion into the pan.",
        ),
        ("00003a5b12", "Butter cookies", ("2 cups flour", "1 cup butter", "1 cup sugar"), COOKIES),
    )
]
"""A collection as Recipe1M+ has it."""

BANANA_BREAD = """(defparameter *easy-banana-bread-recipe* '((get-kitchen ?k)
 (fetch-and-proportion ?butter ?k1 ?k ?c1 butter 60 g)
 (fetch-and-proportion ?flour ?k2 ?k1 ?c2 self-rising-flour 200 g)
 (transfer-contents ?x ?r1 ?k3 ?k2 ?bowl ?butter ?q1 ?u1)
 (transfer-contents ?y ?r2 ?k4 ?k3 ?x ?flour ?q2 ?u2)
 (mix ?batter ?k5 ?k4 ?y ?mixing-tool)
 (bake ?bread ?k7 ?k5 ?batter ?oven 60 minute 165 degrees-celsius)))"""
"""A recipe in the shape of MUHAI's."""


def commands(page: Path) -> list[str]:
    """Return the commands of ours that ``page`` has, in their order, without what a shell takes for a comment."""
    blocks = re.findall(r"```sh\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    lines = (line for block in blocks for line in block.replace("\\\n", " ").splitlines())
    return [re.sub(r"\s+# .*", "", line) for line in lines if line.startswith("foon ")]


def typed(line: str) -> Result:
    """Return what comes of what a person types, as a shell takes it: ``*``, a pipe and ``>``."""
    line, _, target = line.replace(r"\$", "$").partition(" > ")
    taken = None
    for command in line.split(" | "):
        answer = CliRunner().invoke(app, _words(command)[1:], input=taken)
        taken = answer.stdout
    if target:
        Path(target).write_text(answer.stdout, encoding="utf-8")
    return answer


def _words(command: str) -> list[str]:
    """Return the words of ``command``; one with a ``*`` that is not quoted becomes the files that it names."""
    words = []
    for word in shlex.split(command):
        names = sorted(map(str, Path().glob(word))) if "*" in word and f'"{word}"' not in command else []
        words += names or [word]
    return words


def fill(there: Path) -> None:
    """Put into the folder ``there`` each file that documents name and that no command there has to make first."""
    shutil.copytree(demo_folder(), there / "subgraphs")
    shutil.copytree(demo_folder().parent, there / "foon_kg" / "foon" / "demo")
    for folder in ("recipes", "recipe1m", "annotated", "recipe-annotations", "theirs", "drafts"):
        (there / folder).mkdir()
    for recipe in (path for path in demo_recipes() if path.stem in {"leek_omelette", "onion_omelette", "tomato_salad"}):
        shutil.copy(recipe, there / "recipes")
    shutil.copy(there / "recipes" / "leek_omelette.json", there / "recipe.json")
    for name in ("recipe1m/layer1.json", "recipes.json"):
        (there / name).write_text(json.dumps(RECIPES), encoding="utf-8")
    table = "title,ingredients\nOnion soup,\"['1 onion', '2 cups water']\"\n"
    (there / "recipes.csv").write_text(table, encoding="utf-8")
    for name in ("kitchen.txt", "at_home.txt"):
        (there / name).write_text("onion\ntomato\negg\n", encoding="utf-8")
    table = re.findall(r"```text\n(start.*?)```", (DOCS / "tutorial.md").read_text(encoding="utf-8"), re.DOTALL)
    for name in ("my_salad.csv", "greek_salad.csv", "new_salad.csv", "annotated/salad.csv"):
        (there / name).write_text(table[0], encoding="utf-8")
    for name in ("0001.txt", "new_salad.txt"):
        shutil.copy(demo_folder() / "greek_salad.txt", there / name)
    (there / "motion_cost.json").write_text(json.dumps({"chop": 0.4, "pour": 0.1}), encoding="utf-8")
    for name in ("easy-banana-bread.lisp", "recipe-annotations/easy-banana-bread.lisp"):
        (there / name).write_text(BANANA_BREAD, encoding="utf-8")
    narrated = (*EPIC_ROWS, *(row.replace("P01_01", "P01_11") for row in EPIC_ROWS))
    shutil.copy(
        demo_folder() / "bean_salad.txt", there / "drafts" / "P01_11.txt"
    )  # as a review at a terminal writes it
    (there / "EPIC_100_validation.csv").write_text(epic(*narrated), encoding="utf-8")
    (there / "youcookii.json").write_text(json.dumps(YOUCOOK), encoding="utf-8")
    for name in ("pancakes.txt", "salad.txt"):
        (there / name).write_text("Beat the eggs. Chop the onion. Pour the eggs into a pan.\n", encoding="utf-8")


FIRST = (
    "foon load foon subgraphs/",
    "foon load recipes recipe1m/",
    "foon load weights motion_cost.json",
    "foon plan recipe.json --json > plan.json",
    "foon export plan.json --format foon --output tree.txt",
    "foon export plan.json --format json --output 0002.json",
    "foon export plan.json --format foon --output theirs/tree.txt",
    "foon draft recipes recipe1m/ --output drafts.jsonl",
    "foon draft recipes recipe1m/ --output drafts.jsonl.zst",
    "foon plan recipes/ --output ours.jsonl",
)
"""What is typed in that folder before a page is: it makes the files that pages take as given."""
