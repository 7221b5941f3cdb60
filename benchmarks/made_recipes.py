"""A collection of recipes of exactly the shape of Recipe1M+ and of any size (``recipe_collections.py make``).

Foods and amounts are drawn so that few are in most recipes and most in few. Of the lines of 20,000 recipes 73 % are
different ones: fewer come again than in a real collection, so loading is not quicker than in life for that.
"""

from __future__ import annotations

import json
import random
from itertools import accumulate
from pathlib import Path

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
        """Return one food; the first are the commonest."""
        return self._random.choices(self._foods, cum_weights=self._shares)[0]

    def line(self) -> tuple[str, str, bool]:
        """Return a line, the food that is detected in it, and whether that is valid."""
        pick = self._random.choice
        if self._random.random() < 0.01:
            return pick(HEADINGS), "", False
        food = self.food()
        words = (pick(QUANTITIES), pick(UNITS), pick(BEFORE), food)
        return " ".join(filter(None, words)) + pick(AFTER), food, self._random.random() < VALID

    def recipe(self) -> tuple[dict, dict, dict | None]:
        """Return a recipe of each of the three files; of the last one only some have one."""
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
