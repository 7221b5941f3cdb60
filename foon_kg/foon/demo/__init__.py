"""A small FOON written for this project: salads, omelettes, drinks and soups, and recipes that nobody recorded.

The subgraphs are FOON text of common cooking knowledge. Each can be executed from the kitchen, and they share their
steps and part ways: an onion is chopped whole or sliced first, an egg beaten with a fork or a whisk.
"""

from importlib import resources
from pathlib import Path


def demo_folder() -> Path:
    """Return the folder of the demo's subgraphs, one ``.txt`` file each."""
    return _package() / "subgraphs"


def demo_recipes() -> tuple[Path, ...]:
    """Return the demo's recipe files (JSON), by name: dishes that the demo's FOON does not hold as they are asked."""
    return tuple(sorted((_package() / "recipes").glob("*.json")))


def _package() -> Path:
    return Path(str(resources.files(__name__)))
