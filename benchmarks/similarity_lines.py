"""How fast ingredient lines are read, and how many are read as they were meant.

    python benchmarks/similarity_lines.py

The lines are made: every tenth food of the table of groups, with an amount, in one of six wordings. Right is a line
whose food (less a state that stands before it, as in "dried basil") and state come back. Then the same lines come with
other numbers, as in a collection of recipes: of those only the number is read anew.
"""

import time

from foon_kg.names import canonical
from foon_kg.recipe_lines import read_recipe_lines
from foon_kg.similarity.groups import food_groups

WORDINGS = [
    ("2 cups {state} {food}", "chopped"),
    ("1 (14 ounce) can {food}, {state}", "drained"),
    ("3 tablespoons {food}, finely {state}", "chopped"),
    ("1/2 lb. {food}, peeled and {state}", "diced"),
    ("250 g {state} {food}, or to taste", "grated"),
    ("1-2 {food}, thinly {state}", "sliced"),
]


def main() -> None:
    foods = food_groups().foods[::10]
    cases = []
    for place, food in enumerate(foods):
        wording, state = WORDINGS[place % len(WORDINGS)]
        cases.append((wording.format(food=food, state=state), food, state))
    read_recipe_lines(["1 cup sugar"])
    lines = [line for line, _, _ in cases]
    start = time.process_time()
    answers = read_recipe_lines(lines)
    spent = time.process_time() - start
    again = [line.replace(line.split()[0], number, 1) for line in lines for number in ("3", "1 1/2", "8", "3/4")]
    start = time.process_time()
    read_recipe_lines(again)
    spent_again = time.process_time() - start
    wrong = [
        (answer.text, answer.object)
        for answer, (_, food, _) in zip(answers, cases, strict=True)
        if not (answer.object and canonical(food).endswith(canonical(answer.object)))
    ]
    right_state = sum(state in a.state for a, (_, _, state) in zip(answers, cases, strict=True))
    print(f"{len(lines)} different lines: {len(lines) / spent:.0f} a second of CPU")
    print(f"the same with other numbers: {len(again) / spent_again:.0f} a second")
    right_food = len(lines) - len(wrong)
    print(f"food right: {100 * right_food / len(lines):.0f} %, state right: {100 * right_state / len(lines):.0f} %")
    for line, read in wrong[:8]:
        print(f"    {line!r} read as {read!r}")


if __name__ == "__main__":
    main()
