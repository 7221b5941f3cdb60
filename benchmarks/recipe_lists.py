"""Recipes as people write them, made into the recipe files that ``foon plan`` reads, for measurements of the planner.

    python benchmarks/recipe_lists.py OUT [--lists benchmarks/recipes] [--half all|development|blind]

There is a text file for each dish type, called after it: ``recipes/soup.txt``. A line "# Title" begins a recipe, below
it stands a line for each ingredient, and a blank line ends it:

    # Onion Soup
    4 large onions, thinly sliced
    2 tbsp butter

What comes of it is ``OUT/soup/soup-01.json`` and so on, numbered as they stand in the file. Odd numbers are for
development; even ones are blind: nobody looks at them, nor at their trees, only at figures over all of them.

The lines are read by ``foon_kg.language.recipe_lines``, and nothing is put right by hand: what it makes of a line is
what the planner is asked. A food without a state is written with an empty one, for which ``foon plan`` takes the usual
state. Of foods that stand in for each other the first is taken. A line that names none is told on stderr; of a blind
recipe only the place, not the text.
"""

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from foon_kg.food.words import heading_part, without_part
from foon_kg.language.collection import bare_headings, is_heading
from foon_kg.language.recipe_lines import read_recipe_lines
from foon_kg.model import DISH_TYPES

LISTS = Path(__file__).parent / "recipes"
HALVES = ("development", "blind")


@dataclass(frozen=True)
class WrittenRecipe:
    """A recipe of a text file; each of ``lines`` with its number in the file."""

    dish_type: str
    number: int
    title: str
    lines: tuple[tuple[int, str], ...]

    @property
    def id(self) -> str:
        """The dish type and the number, as in soup-03."""
        return f"{self.dish_type}-{self.number:02d}"

    @property
    def half(self) -> str:
        """What the recipe is for: odd numbers are for development, even ones are blind."""
        return HALVES[self.number % 2 == 0]


def written_recipes(path: Path) -> Iterator[WrittenRecipe]:
    """Yield the recipes of a text file in their order."""
    title, number, lines = "", 0, []
    for place, text in enumerate([*path.read_text(encoding="utf-8").splitlines(), ""], start=1):
        line = text.strip()
        if line.startswith("#"):
            if title:
                raise SystemExit(f"{path}:{place}: a blank line is missing before this title")
            title, number = line.lstrip("# "), number + 1
        elif line and not title:
            raise SystemExit(f"{path}:{place}: this ingredient belongs to no recipe; “# Title” begins one")
        elif line:
            lines.append((place, line))
        elif title:
            yield WrittenRecipe(path.stem, number, title, tuple(lines))
            title, lines = "", []


def ingredients_of(recipe: WrittenRecipe, path: Path) -> tuple[list[dict[str, str]], int]:
    """Return what the reader makes of the lines, and how many it cannot use; those are told on stderr."""
    wanted, part, rejected = [], "", 0
    read = read_recipe_lines(line for _, line in recipe.lines)
    bare = bare_headings([line for _, line in recipe.lines])
    for at, ((place, line), answer) in enumerate(zip(recipe.lines, read, strict=True)):
        if at in bare or is_heading(line):
            part = heading_part(line)
        elif answer.object is None:
            said = f": {line}" if recipe.half == "development" else ""
            print(f"{path}:{place}: {recipe.id}: no food is read here{said}", file=sys.stderr)
            rejected += 1
        else:
            said = without_part(line)[1] or part
            more = {"part": said} if said else {}
            wanted += [{"object": one.object or "", "state": one.state} | more for one in answer.foods]
    return wanted, rejected


def convert(path: Path, out: Path, halves: tuple[str, ...]) -> tuple[int, int, int]:
    """Write the recipes of a text file; return how many, how many lines they have, and how many were rejected."""
    folder = out / path.stem
    folder.mkdir(parents=True, exist_ok=True)
    recipes = [recipe for recipe in written_recipes(path) if recipe.half in halves]
    lines = rejected = 0
    for recipe in recipes:
        wanted, unread = ingredients_of(recipe, path)
        content = {"id": recipe.id, "title": recipe.title, "type": recipe.dish_type, "ingredients": wanted}
        text = json.dumps(content, indent=2, ensure_ascii=False)
        (folder / f"{recipe.id}.json").write_text(f"{text}\n", encoding="utf-8")
        lines += len(recipe.lines)
        rejected += unread
    return len(recipes), lines, rejected


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("out", type=Path, help="the folder that gets a folder of recipe files for each dish type")
    parser.add_argument("--lists", type=Path, default=LISTS, help="the folder of text files, one for each dish type")
    parser.add_argument("--half", choices=("all", *HALVES), default="all", help="write these recipes alone")
    options = parser.parse_args()
    paths = sorted(options.lists.glob("*.txt"))
    for path in paths:
        if path.stem not in DISH_TYPES:
            raise SystemExit(f"{path}: there is no dish type {path.stem}; one of: {', '.join(DISH_TYPES)}")
    halves = HALVES if options.half == "all" else (options.half,)
    counts = {path.stem: convert(path, options.out, halves) for path in paths}
    for dish_type, (recipes, lines, rejected) in counts.items():
        print(f"{dish_type}: {recipes} recipes, {lines} lines, {rejected} rejected")
    recipes, lines, rejected = (sum(column) for column in zip(*counts.values(), strict=True)) if counts else (0, 0, 0)
    print(f"all: {recipes} recipes, {lines} lines, {rejected} rejected")


if __name__ == "__main__":
    main()
