"""How often a state that no class lists is placed rightly: each listed state is left out in turn and guessed.

    python benchmarks/similarity_states.py

Two guesses are measured apart: by the words in a state of several words, and by the nearest states in the food
vectors. The mean confidence should be the share that is right.
"""

import dataclasses

from foon_kg.similarity.state_classes import BY_WORD, StateClasses, state_classes


def guess_without(state: str, classes: StateClasses) -> tuple[str, float]:
    class_of = {name: group for name, group in classes.class_of.items() if name != state}
    return dataclasses.replace(classes, class_of=class_of, _placed={}).guess(state)


def main() -> None:
    classes = state_classes()
    parts: dict[str, list[tuple[bool, float]]] = {"by words": [], "by vectors": []}
    for state, group in sorted(classes.class_of.items()):
        guessed, confidence = guess_without(state, classes)
        parts["by words" if confidence >= BY_WORD else "by vectors"].append((guessed == group, confidence))
    for name, results in parts.items():
        right = sum(was for was, _ in results) / len(results)
        said = sum(confidence for _, confidence in results) / len(results)
        print(f"{name}: {len(results)} states, {100 * right:.0f} % right, said {100 * said:.0f} %")
    bands = [(0.0, 0.2), (0.2, 0.4), (0.4, 0.6), (0.6, 0.7)]
    for low, high in bands:
        inside = [was for was, confidence in parts["by vectors"] if low <= confidence < high]
        if inside:
            print(f"  said {low:.1f}-{high:.2f}: {len(inside)} states, {100 * sum(inside) / len(inside):.0f} % right")


if __name__ == "__main__":
    main()
