"""Recipes of other dish types, written for this project as people write recipes; some name unseen foods.

The planner's rules were made with the first seventy-five before the eyes; the last thirty were written before and
measured afterwards.

One a line, indented lines go on: the dish type, then each food with the state that it is asked in.
"""

from __future__ import annotations

from foon_kg.model import Recipe, RequiredIngredient

LINES = """
bread: bread/whole, butter/softened, garlic/minced, parsley/chopped
bread: baguette/sliced, butter/softened, garlic/crushed, oregano/dried, parmesan/grated
bread: bread/sliced, egg/whole, milk/liquid, cinnamon/ground, sugar/granulated, butter/solid
bread: flour/ground, sugar/granulated, yeast/ground, water/liquid, salt/ground, butter/melted, rosemary/chopped
bread: flour/ground, banana/mashed, egg/whole, sugar/granulated, butter/softened, baking soda/powder, walnut/chopped
bread: cornmeal/ground, flour/ground, buttermilk/liquid, egg/whole raw, butter/melted, baking powder/powder,
  honey/thick liquid
cake: flour/ground, sugar/granulated, butter/softened, egg/whole raw, milk/liquid, baking powder/powder,
  vanilla extract/liquid
cake: flour/ground, cocoa powder/powder, sugar/granulated, egg/whole, oil/liquid, buttermilk/liquid,
  baking soda/powder, coffee/liquid
cake: carrot/grated, flour/ground, sugar/granulated, egg/whole, vegetable oil/liquid, cinnamon/ground,
  walnut/chopped, cream cheese/softened
cake: apple/diced, flour/ground, brown sugar/granulated, butter/melted, egg/whole, nutmeg/ground, raisin/dried
cake: cake mix/powder, egg/whole, vegetable oil/liquid, water/liquid, strawberry/sliced
cake: blueberry/berries, flour/ground, sugar/granulated, egg/whole, lemon zest/grated, milk/liquid, butter/melted
noodle: ramen noodle/dried, egg/whole, scallion/sliced, soy sauce/liquid, chicken broth/liquid, ginger/grated
noodle: egg noodle/uncooked, butter/solid, parsley/chopped, salt/granulated
noodle: rice noodle/dried, shrimp/peeled, egg/whole, bean sprout/sprout, lime juice/liquid, peanut/chopped,
  fish sauce/liquid
noodle: noodle/uncooked, olive oil/liquid, salt/granulated
noodle: flour/ground, egg/whole, salt/granulated, milk/liquid
noodle: udon noodle/whole, beef broth/liquid, mushroom/sliced, green onion/chopped, soy sauce/liquid, garlic/minced
rice: rice/grain, garlic/minced, butter/solid, cilantro/chopped, lime juice/juice, salt/granulated
rice: white rice/grain, egg/whole, carrot/diced, pea/frozen, soy sauce/liquid, green onion/sliced, sesame oil/liquid
rice: brown rice/grain, black bean/canned, tomato/diced, onion/chopped, cumin/ground, water/liquid
rice: basmati rice/grain, onion/sliced, cardamom/ground, cinnamon/stick, raisin/dried, almond/sliced, butter/melted
rice: rice/grain, mushroom/sliced, onion/chopped, white wine/liquid, chicken broth/liquid, parmesan/grated,
  butter/solid
soup: potato/peeled, leek/sliced, butter/solid, chicken broth/liquid, heavy cream/liquid, salt/granulated
soup: tomato/canned, onion/chopped, garlic/minced, basil/leaves, vegetable broth/liquid, olive oil/liquid
soup: carrot/sliced, ginger/grated, onion/chopped, vegetable stock/liquid, coconut milk/liquid
soup: black bean/canned, onion/diced, garlic/minced, jalapeno/chopped, cumin/ground, sour cream/creamy
soup: chicken/shredded, egg noodle/uncooked, carrot/sliced, celery/sliced, chicken broth/liquid, thyme/dried,
  bay leaf/leaf
soup: lentil/dried, onion/chopped, carrot/diced, spinach/leaves, cumin/ground, lemon juice/juice, water/liquid
soup: tofu/cubed, miso/paste, green onion/sliced, water/liquid
soup: pumpkin/pureed, onion/chopped, butter/solid, nutmeg/ground, heavy cream/liquid, chicken broth/liquid
soup: corn/canned, potato/diced, bacon/chopped, onion/diced, milk/liquid, flour/ground, black pepper/ground
pasta: spaghetti/uncooked, bacon/diced, egg/whole, parmesan/grated, black pepper/ground
pasta: penne/uncooked, broccoli/floret, heavy cream/liquid, parmesan/grated, garlic/minced, chicken/diced
pasta: macaroni/uncooked, cheddar/shredded, milk/liquid, butter/solid, flour/ground, salt/granulated
pasta: linguine/uncooked, basil/leaves, pine nut/whole, garlic/minced, olive oil/liquid, parmesan/grated
pasta: beef/ground, onion/chopped, tomato sauce/sauce, lasagna noodle/uncooked, ricotta/creamy, mozzarella/shredded
sandwich: bread/sliced, turkey/sliced, lettuce/leaf, tomato/sliced, mayonnaise/creamy, mustard/sauce
sandwich: bread/sliced, cheddar/sliced, butter/softened, ham/sliced
sandwich: tuna/canned, mayonnaise/creamy, celery/diced, onion/diced, bread/sliced, lemon juice/juice
sandwich: tortilla/whole, chicken/shredded, cheddar/shredded, onion/sliced, bell pepper/sliced, salsa/sauce
sandwich: peanut butter/creamy, banana/sliced, bread/sliced, honey/thick liquid
sandwich: avocado/mashed, egg/boiled, bread/toasted, chili flake/flakes, lemon juice/juice
stir-fry: chicken/sliced, broccoli/floret, soy sauce/liquid, garlic/minced, ginger/grated, cornstarch/ground,
  vegetable oil/liquid
stir-fry: beef/sliced, bell pepper/sliced, onion/sliced, soy sauce/liquid, sesame oil/liquid, sugar/granulated
stir-fry: tofu/diced, rice/grain, carrot/sliced, zucchini/sliced, curry powder/ground, onion/chopped,
  olive oil/liquid
stir-fry: shrimp/peeled, snow pea/whole, garlic/minced, oyster sauce/sauce, scallion/chopped
stir-fry: potato/diced, sausage/sliced, olive oil/liquid, black pepper/ground
stir-fry: cabbage/shredded, carrot/julienned, mushroom/sliced, soy sauce/liquid, chili/chopped
pizza: flour/ground, yeast/ground, water/liquid, salt/granulated, olive oil/liquid, marinara/sauce,
  mozzarella/shredded
pizza: pizza dough/solid, tomato sauce/sauce, mozzarella/grated, pepperoni/sliced, oregano/dried
pizza: egg/whole, bacon/chopped, onion/chopped, sour cream/creamy, pepper/ground
pizza: pizza crust/whole, pesto/sauce, chicken/shredded, tomato/sliced, mozzarella/sliced
pizza: flour/ground, yeast/powder, olive oil/liquid, tomato/crushed, basil/chopped, mozzarella/sliced,
  mushroom/sliced
pie: apple/sliced, sugar/granulated, cinnamon/ground, butter/solid, flour/ground
pie: pie crust/frozen, pumpkin/canned, egg/whole, condensed milk/canned, cinnamon/ground, ginger/ground
pie: apple/peeled, dough/sheet, egg/beaten, sugar/granulated, lemon juice/juice, salt/granulated
pie: potato/diced, carrot/diced, beef/ground, onion/chopped, flour/ground, butter/solid
cookie: butter/softened, sugar/granulated, egg/whole, flour/ground, chocolate chip/pieces, vanilla extract/liquid
cookie: oat/rolled, brown sugar/granulated, butter/melted, raisin/dried, flour/ground, egg/beaten
cookie: peanut/whole, sugar/granulated, corn syrup/liquid, butter/solid, baking soda/powder
chicken: chicken/whole raw, garlic/minced, lemon juice/juice, olive oil/liquid, rosemary/chopped, salt/granulated
chicken: chicken/diced, coconut milk/liquid, curry paste/paste, onion/sliced
chicken: chicken/raw, breadcrumb/crumbs, parmesan/grated, butter/melted, paprika/ground
steak: beef/steaks, salt/granulated, black pepper/ground, garlic/minced, butter/solid
pudding: milk/liquid, sugar/granulated, cornstarch/ground, cocoa powder/powder, vanilla extract/liquid
burger: beef/ground, onion/chopped, bun/bun, lettuce/leaf, tomato/sliced, ketchup/sauce
meatball: beef/ground, breadcrumb/crumbs, egg/whole, parsley/chopped, garlic/minced, salt/granulated
seafood: shrimp/peeled, garlic/minced, butter/melted, lemon juice/juice, parsley/chopped
vegetables: broccoli/floret, olive oil/liquid, garlic/minced, lemon juice/juice, salt/granulated
vegetables: brussels sprout/halved, olive oil/liquid, balsamic vinegar/liquid, salt/granulated, bacon/chopped
potatoes: potato/mashed, butter/softened, milk/liquid, salt/granulated, chive/chopped
roast: green bean/whole, garlic/minced, olive oil/liquid, onion/chopped, salt/granulated
sausage: sausage/sliced, onion/sliced, bell pepper/sliced, mustard/sauce
sauce: tomato/chopped, onion/chopped, jalapeno/minced, cilantro/chopped, lime juice/juice
"""


UNSEEN = """
bread: white bread/sliced, butter/softened, garlic/minced, mozzarella/shredded, parsley/dried
bread: flour/ground, baking powder/powder, salt/granulated, butter/cubed, milk/liquid, cheddar/grated
bread: flour/ground, yeast/powder, warm water/liquid, olive oil/liquid, salt/granulated, black olive/chopped
bread: brioche/sliced, egg/beaten, cream/liquid, vanilla extract/liquid, maple syrup/thick liquid
bread: zucchini/grated, flour/ground, egg/whole, sugar/granulated, vegetable oil/liquid, cinnamon/ground,
  baking soda/powder
bread: rye bread/sliced, cream cheese/softened, chive/chopped, black pepper/ground
cake: flour/ground, sugar/granulated, egg/whole, butter/softened, lemon juice/juice, lemon zest/grated,
  baking powder/powder
cake: almond flour/ground, egg/whole, honey/thick liquid, orange zest/grated, orange juice/juice
cake: flour/ground, peach/sliced, sugar/granulated, butter/melted, egg/whole, sour cream/creamy,
  vanilla extract/liquid
cake: dark chocolate/melted, butter/melted, egg/whole, sugar/granulated, flour/ground
cake: pumpkin/pureed, flour/ground, brown sugar/granulated, egg/whole, vegetable oil/liquid, nutmeg/ground,
  pecan/chopped
cake: banana/mashed, oat/rolled, egg/whole, milk/liquid, baking powder/powder, cinnamon/ground
noodle: soba noodle/dried, soy sauce/liquid, sesame oil/liquid, scallion/chopped, sesame seed/seeds
noodle: rice noodle/dried, beef/sliced, beef stock/liquid, onion/sliced, ginger/sliced, basil/leaves, lime/whole
noodle: egg noodle/uncooked, butter/melted, poppy seed/seeds, sour cream/creamy
noodle: ramen noodle/dried, chicken stock/liquid, mushroom/sliced, spinach/leaves, garlic/minced, soy sauce/liquid
noodle: noodle/uncooked, peanut butter/creamy, soy sauce/liquid, lime juice/juice, chili/flakes, cucumber/julienned
noodle: flour/ground, egg/whole, spinach/chopped, salt/granulated
rice: rice/grain, coconut milk/liquid, salt/granulated, sugar/granulated, mango/sliced
rice: white rice/grain, bacon/chopped, egg/beaten, onion/diced, soy sauce/liquid, corn/frozen
rice: jasmine rice/grain, pineapple/diced, cashew/whole, curry powder/powder, onion/chopped, bell pepper/diced
rice: rice/grain, saffron/threads, shrimp/peeled, pea/frozen, onion/chopped, garlic/minced, chicken stock/liquid,
  olive oil/liquid
rice: wild rice/grain, mushroom/sliced, celery/diced, butter/solid, thyme/dried, vegetable broth/liquid
rice: rice/grain, milk/liquid, sugar/granulated, cinnamon/ground, raisin/dried, vanilla extract/liquid
soup: tomato/diced, red lentil/dried, onion/chopped, garlic/minced, cumin/ground, vegetable stock/liquid
soup: broccoli/chopped, cheddar/shredded, milk/liquid, butter/solid, flour/ground, onion/chopped
soup: butternut squash/diced, apple/diced, onion/chopped, chicken broth/liquid, nutmeg/ground, cream/liquid
soup: mushroom/sliced, onion/diced, beef broth/liquid, butter/solid, thyme/sprig, salt/granulated
soup: potato/diced, carrot/diced, cabbage/shredded, sausage/sliced, chicken stock/liquid, black pepper/ground
soup: corn/frozen, coconut milk/liquid, red bell pepper/diced, cilantro/chopped, lime juice/juice, salt/granulated
"""


def other_dishes() -> list[Recipe]:
    """Return the seventy-five recipes in their order; ``id`` is the dish type and a number."""
    return [_recipe(str(number), line) for number, line in enumerate(_joined(LINES))]


def unseen_dishes() -> list[Recipe]:
    """Return the thirty recipes of bread, cake, noodle, rice and soup that no rule was made for."""
    return [_recipe(f"unseen-{number}", line) for number, line in enumerate(_joined(UNSEEN))]


def _joined(lines: str) -> list[str]:
    return lines.strip().replace("\n  ", " ").splitlines()


def _recipe(number: str, line: str) -> Recipe:
    dish_type, _, foods = line.partition(": ")
    wanted = (food.strip().partition("/") for food in foods.split(","))
    ingredients = tuple(RequiredIngredient(name, state) for name, _, state in wanted)
    return Recipe(dish_type, ingredients, f"{dish_type}-{number}")
