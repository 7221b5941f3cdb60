"""How fast ingredient lines are read, how many are read as they were meant, and how often rules and parser agree.

    python benchmarks/similarity_lines.py [--jobs 2]

The lines are made: foods of the table of groups, with an amount, in one of ten wordings, six that the rules read and
four that they leave to the parser. Right is a line whose food (less a state that stands before it, as in "dried basil")
and state come back. A collection is these lines again and again, as in real recipes: nine in ten lines came before.
"""

import argparse
import random
import time
from collections.abc import Callable
from dataclasses import replace

from foon_kg.language.recipe_lines import LineReader, RecipeLine, read_fully, read_quickly
from foon_kg.model.names import canonical
from foon_kg.similarity.groups import food_groups

PLAIN = [
    ("{q} cups {state} {food}", "chopped"),
    ("{q} (14 ounce) cans {food}, {state}", "drained"),
    ("{q} tablespoons {food}, finely {state}", "chopped"),
    ("{q} large {food}, peeled and {state}", "diced"),
    ("{q} ounces {state} {food}, or to taste", "grated"),
    ("{q} {food}, {state}, divided", "sliced"),
]
OTHER = [
    ("{q}-5 {food}, thinly {state}", "sliced"),
    ("{q} lb. {food}, peeled and {state}", "diced"),
    ("{q} cups {food}, {state}, plus more for serving", "grated"),
    ("{q} cups {food} (such as Best Brand), {state}", "drained"),
]
NUMBERS = ["1", "2", "3", "1 1/2", "8", "3/4"]
LINES, REPEATS = 600, 10


def made_lines(wordings: list[tuple[str, str]], count: int) -> dict[str, tuple[str, str]]:
    """Return lines, each with the food and the state that it is made of."""
    dice = random.Random(count)
    lines = {}
    for _ in range(count):
        (wording, state), food = dice.choice(wordings), dice.choice(food_groups().foods)
        lines[wording.format(q=dice.choice(NUMBERS), food=food, state=state)] = (food, state)
    return lines


def timed(what: str, lines: list[str], read: Callable[[str], RecipeLine | None]) -> list[RecipeLine | None]:
    start = time.process_time()
    answers = [read(line) for line in lines]
    print(f"{what}: {len(lines) / (time.process_time() - start):.0f} a second of CPU")
    return answers


def right(answers: list[RecipeLine], lines: dict[str, tuple[str, str]]) -> str:
    food = state = 0
    for answer in answers:
        meant, done = lines[answer.text]
        food += bool(answer.object) and canonical(meant).endswith(canonical(answer.object or ""))
        state += done in answer.state or done in answer.states
    return f"food right {100 * food / len(answers):.1f} %, state right {100 * state / len(answers):.1f} %"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--jobs", type=int, default=2, help="processes that read the collection")
    jobs = parser.parse_args().jobs
    plain, other = made_lines(PLAIN, LINES), made_lines(OTHER, LINES // 3)
    read_fully("1 cup sugar")
    quick = timed("plain lines by rules, each for the first time", list(plain), read_quickly)
    timed("the same again", list(plain), read_quickly)
    answered = [answer for answer in quick if answer is not None]
    print(f"    {100 * len(answered) / len(plain):.0f} % read so; {right(answered, plain)}")
    full = timed("the same by the parser", [answer.text for answer in answered], read_fully)
    print(f"    {right(full, plain)}")
    alike = [replace(a, confidence=0) == replace(b, confidence=0) for a, b in zip(answered, full, strict=True)]
    print(f"rules and parser say the same of {100 * sum(alike) / len(alike):.1f} %; where they differ:")
    for one, two, same in zip(answered, full, alike, strict=True):
        if not same:
            print(
                f"    {one.text!r}: {one.object!r}, {one.states} by rules, {two.object!r}, {two.states} by the parser"
            )
    print(f"other lines: {right(timed('other lines by the parser', list(other), read_fully), other)}")
    collection(list(made_lines(PLAIN, 2 * LINES)) + list(made_lines(OTHER, LINES)), jobs)


def collection(distinct: list[str], jobs: int) -> None:
    """Measure elapsed time, as the work is done in other processes; run it on a quiet machine."""
    lines = distinct * REPEATS
    random.Random(1).shuffle(lines)
    with LineReader(jobs) as reader:
        reader.read([f"{number} cups sugar or honey ({number})" for number in range(300)])  # start the processes
        start = time.perf_counter()
        reader.read(lines)
        spent = time.perf_counter() - start
    rates = f"{len(lines) / spent:.0f} lines a second, {len(distinct) / spent:.0f} different ones"
    print(f"a collection with {jobs} jobs: {rates}")


if __name__ == "__main__":
    main()
