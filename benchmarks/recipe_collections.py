"""Collections of recipes of any size: make one of exactly the shape of Recipe1M+, and measure how it is loaded.

    python benchmarks/recipe_collections.py make FOLDER --recipes 100000
    python benchmarks/recipe_collections.py load FOLDER [--parse full]

``load`` runs what ``foon load recipes`` runs against the Neo4j of the environment (else the local one), and prints the
rate of each tenth of the recipes, the peak of this process's memory, and the size of the files. Foods and amounts are
drawn so that few are in most recipes and most in few; the share of lines that come again is printed, because loading is
the quicker the higher it is.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import resource
import time
from collections.abc import Iterator, Sequence
from itertools import accumulate
from pathlib import Path

from foon_kg.collection import CollectionReader, labels_of
from foon_kg.graph import Connection, Neo4jGraph
from foon_kg.graph.recipes import load_recipes, prepare_for_recipes
from foon_kg.loaders.recipe_collections import RecipeCollections
from foon_kg.recipe_lines import LineReader
from foon_kg.server import connection_settings

FOODS = """
salt, sugar, butter, flour, eggs, milk, water, onion, garlic cloves, olive oil, black pepper, vegetable oil, vanilla
extract, lemon juice, brown sugar, baking powder, baking soda, cream cheese, parmesan cheese, cheddar cheese, sour
cream, chicken breasts, ground beef, tomatoes, carrots, celery, potatoes, green onions, red onion, bell pepper,
cilantro, parsley, basil, thyme, oregano, cumin, paprika, cinnamon, nutmeg, ginger, soy sauce, worcestershire sauce,
mayonnaise, ketchup, dijon mustard, honey, vinegar, balsamic vinegar, white wine, chicken broth, heavy cream, yogurt,
mozzarella, feta, bacon, ham, shrimp, salmon, tuna, rice, pasta, spaghetti, egg noodles, bread crumbs, tortillas,
lettuce, spinach, kale, cabbage, cucumber, avocado, corn, peas, green beans, black beans, kidney beans, lentils,
chickpeas, mushrooms, zucchini, eggplant, broccoli, cauliflower, asparagus, apples, bananas, strawberries,
blueberries, raspberries, oranges, limes, lemons, pineapple, mango, peaches, raisins, walnuts, pecans, almonds,
cashews, peanut butter, chocolate chips, cocoa powder, coconut milk, maple syrup, cornstarch, gelatin, powdered sugar,
lime juice, orange juice, cayenne pepper, chili powder, curry powder, bay leaves, rosemary, sage, dill, mint, sesame
oil, sesame seeds, tofu, edamame, quinoa, couscous, bulgur, polenta, goat cheese, blue cheese, ricotta cheese, cottage
cheese, half-and-half, buttermilk, shallots, leeks, fennel, radishes, beets, turnips, parsnips, sweet potatoes,
butternut squash, pumpkin puree, tomato paste, tomato sauce, hot sauce, horseradish, capers, olives, anchovies,
artichoke hearts, pine nuts, dates, figs, apricots, cherries, plums, pears, grapes, kiwi, watermelon, cantaloupe, rum,
vodka, tequila, gin, jicama, kohlrabi, tamarind, sumac, harissa, miso
"""
KINDS = (
    "Salad", "Soup", "Cake", "Cookies", "Bread", "Muffins", "Pie", "Casserole", "Omelette", "Smoothie",
    "Punch", "Chicken", "Pasta", "Stir-Fry", "Sauce", "Rice", "Delight",
)  # fmt: skip
MOODS = ("Easy ", "Grandma's ", "Best Ever ", "Quick ", "Spicy ", "Creamy ", "Grilled ", "Summer ", "Low-Fat ", "")
QUANTITIES = ("1", "2", "3", "4", "1/2", "1/4", "3/4", "1 1/2", "½", "2-3", "8", "12", "")
UNITS = ("cup", "cups", "tablespoons", "teaspoon", "ounces", "pound", "(14 ounce) can", "large", "small", "", "package")
BEFORE = (
    "",
    "",
    "",
    "",
    "chopped",
    "finely chopped",
    "diced",
    "thinly sliced",
    "minced",
    "grated",
    "melted",
    "fresh",
    "dried",
)
AFTER = (
    "",
    "",
    "",
    "",
    ", chopped",
    ", finely diced",
    ", to taste",
    ", drained and rinsed",
    ", peeled and cubed",
    " (optional)",
)
STEPS = (
    "Heat the oven and butter a dish.",
    "Mix everything in a large bowl until no lumps are left.",
    "Cook over medium heat until tender, stirring now and then.",
    "Let it stand for ten minutes before you serve it.",
    "Pour into the pan and bake until a knife comes out clean.",
    "Chill for an hour, better overnight, and bring back to room temperature.",
    "Serve at once with what is left of the herbs.",
)
HEADINGS = ("For the dressing:", "TOPPING", "Filling")
MEAN_INGREDIENTS = 9
VALID = 0.93
"""The share of lines whose food the collection detects."""

NUTRITION = 0.05
"""The share of recipes with nutritional information."""


class Kitchen:
    """Draws foods, lines and recipes."""

    def __init__(self, seed: int) -> None:
        self._random = random.Random(seed)
        self._foods = [food.strip() for food in FOODS.replace("\n", " ").split(",")]
        self._shares = list(accumulate(1 / rank for rank in range(1, len(self._foods) + 1)))

    def food(self) -> str:
        """Answer one food; the first are the commonest."""
        return self._random.choices(self._foods, cum_weights=self._shares)[0]

    def line(self) -> tuple[str, str, bool]:
        """Answer a line, the food that is detected in it, and whether that is valid."""
        pick = self._random.choice
        if self._random.random() < 0.01:
            return pick(HEADINGS), "", False
        food = self.food()
        words = (pick(QUANTITIES), pick(UNITS), pick(BEFORE), food)
        return " ".join(filter(None, words)) + pick(AFTER), food, self._random.random() < VALID

    def recipe(self) -> tuple[dict, dict, dict | None]:
        """Answer a recipe of each of the three files; of the last one only some have one."""
        lines = [self.line() for _ in range(max(2, round(self._random.gauss(MEAN_INGREDIENTS, 3))))]
        draw = self._random
        recipe_id = f"{draw.getrandbits(40):010x}"
        texts = [{"text": text} for text, _, _ in lines]
        layer1 = {
            "ingredients": texts,
            "url": f"http://example.org/recipes/{recipe_id}",
            "partition": draw.choices(("train", "val", "test"), (70, 15, 15))[0],
            "title": f"{draw.choice(MOODS)}{self.food().title()} {draw.choice(KINDS)}",
            "id": recipe_id,
            "instructions": [{"text": draw.choice(STEPS)} for _ in range(draw.randint(3, 14))],
        }
        detected = {
            "valid": [valid for _, _, valid in lines],
            "id": recipe_id,
            "ingredients": [{"text": food or text} for text, food, _ in lines],
        }
        amounts = None
        if draw.random() < NUTRITION:
            quantities = [{"text": draw.choice(QUANTITIES) or "1"} for _ in lines]
            units = [{"text": draw.choice(("cup", "tablespoon", "teaspoon", "ounce"))} for _ in lines]
            amounts = {"id": recipe_id, "ingredients": texts, "quantity": quantities, "unit": units}
        return layer1, detected, amounts


def make(folder: Path, count: int, seed: int) -> None:
    """Write the three files, one recipe at a time; the detected foods come in another order than the recipes."""
    folder.mkdir(parents=True, exist_ok=True)
    kitchen = Kitchen(seed)
    names = ("layer1.json", "det_ingrs.json", "recipes_with_nutritional_info.json")
    streams = [(folder / name).open("w", encoding="utf-8") for name in names]
    first = [True] * len(streams)
    waiting: list[dict] = []

    def write(place: int, value: dict | None) -> None:
        if value is not None:
            streams[place].write(("[" if first[place] else ", ") + json.dumps(value))
            first[place] = False

    for _ in range(count):
        layer1, detected, amounts = kitchen.recipe()
        write(0, layer1)
        waiting.append(detected)
        if len(waiting) >= 1000:
            for value in reversed(waiting):
                write(1, value)
            waiting.clear()
        write(2, amounts)
    for value in reversed(waiting):
        write(1, value)
    for place, stream in enumerate(streams):
        stream.write("[]" if first[place] else "]")
        stream.close()


def load(folder: Path, parse: str) -> None:
    """Load, and print the rate of each tenth."""
    size = sum(file.stat().st_size for file in folder.glob("*.json"))
    settings = connection_settings()
    with (
        RecipeCollections([folder], lambda _: None) as collections,
        LineReader(os.cpu_count() or 1) as lines,
        Connection(settings) as connection,
    ):
        start = time.perf_counter()
        total = collections.check()
        print(f"{total:,} recipes, {size / 1e6:,.0f} MB; read to the end in {time.perf_counter() - start:.1f} s")
        prepare_for_recipes(connection)
        with Neo4jGraph(settings) as graph, graph.reading() as view:
            reader = CollectionReader(labels_of(view.vocabulary()), lines, parse == "full")
        rates = Rates(total)
        stored = load_recipes(connection, collections, reader.understand, stored=rates.add, version=reader.version)
        print(f"{stored}")
    rates.show()
    print(f"peak memory of this process: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:,.0f} MB")


class Rates:
    """The seconds at which each tenth of the recipes was stored."""

    def __init__(self, total: int) -> None:
        self._tenth = max(1, total // 10)
        self._start = time.perf_counter()
        self._done = 0
        self._marks: list[tuple[int, float]] = []

    def add(self, report: Sequence) -> None:
        """Take down that the recipes of ``report`` are stored."""
        before, self._done = self._done, self._done + len(report)
        if before // self._tenth != self._done // self._tenth:
            self._marks.append((self._done, time.perf_counter() - self._start))

    def show(self) -> None:
        """Print the rate over all, and of each tenth."""
        seconds = time.perf_counter() - self._start
        print(f"{self._done:,} recipes in {seconds:.1f} s: {self._done / seconds:,.0f} a second")
        for (done, at), rate in zip(self._marks, self._rates(), strict=True):
            print(f"  to {done:>9,} at {at:8.1f} s   {rate:8,.0f} a second")

    def _rates(self) -> Iterator[float]:
        last_done, last_at = 0, 0.0
        for done, at in self._marks:
            yield (done - last_done) / (at - last_at)
            last_done, last_at = done, at


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    maker, loader = commands.add_parser("make"), commands.add_parser("load")
    maker.add_argument("folder", type=Path)
    maker.add_argument("--recipes", type=int, default=100_000)
    maker.add_argument("--seed", type=int, default=1)
    loader.add_argument("folder", type=Path)
    loader.add_argument("--parse", choices=("quick", "full"), default="quick")
    asked = parser.parse_args()
    if asked.command == "make":
        make(asked.folder, asked.recipes, asked.seed)
    else:
        load(asked.folder, asked.parse)


if __name__ == "__main__":
    main()
