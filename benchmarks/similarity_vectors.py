"""Make ``foon_kg/similarity/food-vectors.npz`` out of the food GloVe that ships inside ingredient-parser-nlp (MIT).

    pip install --no-deps ingredient-parser-nlp==2.9.1 && python benchmarks/similarity_vectors.py

The source has one vector of 35 numbers for each of 19,850 word stems (English Snowball), learnt from recipes by the
package's author. Kept are the stems made of letters, rounded to half precision:
1.4 MB, read in some 10 ms, with answers equal to the source's in the third decimal.
"""

import argparse
import gzip
import importlib.util
from pathlib import Path

import numpy as np

SOURCE = "en/data/ingredient_embeddings.35d.glove.txt.gz"
TARGET = Path(__file__).parents[1] / "foon_kg" / "similarity" / "food-vectors.npz"


def main() -> None:
    package = importlib.util.find_spec("ingredient_parser")
    if not (package and package.submodule_search_locations):
        raise SystemExit("pip install --no-deps ingredient-parser-nlp==2.9.1")
    with gzip.open(Path(package.submodule_search_locations[0]) / SOURCE, "rt") as file:
        rows = sorted((line.split() for line in file.readlines()[1:]), key=lambda row: row[0])
    rows = [row for row in rows if row[0].isalpha() and row[0].isascii()]
    vectors = np.array([row[1:] for row in rows], dtype=np.float64)
    stems = np.frombuffer("\n".join(row[0] for row in rows).encode(), dtype=np.uint8)
    np.savez(TARGET, stems=stems, vectors=vectors.astype(np.float16))
    print(f"{TARGET.name}: {len(rows)} stems, {TARGET.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    main()
