"""foon-kg: task trees for cooking, planned from a functional object-oriented network in Neo4j.

``Foon`` is the front door (:mod:`foon_kg.foon`); it is imported when it is asked for, so that a command which needs
none of it starts at once.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # for who checks types; at run time __getattr__ does it
    from foon_kg.foon import Foon, Plan, Step
    from foon_kg.model import Recipe
    from foon_kg.model.errors import FoonError
    from foon_kg.plans.kitchen import Kitchen

__version__ = "0.1.0"
__all__ = ["Foon", "FoonError", "Kitchen", "Plan", "Recipe", "Step", "__version__"]

_HOMES = {
    "Foon": "foon_kg.foon",
    "FoonError": "foon_kg.model.errors",
    "Kitchen": "foon_kg.plans.kitchen",
    "Plan": "foon_kg.foon",
    "Recipe": "foon_kg.model",
    "Step": "foon_kg.foon",
}
"""Where each name at the front door is defined."""


def __getattr__(name: str) -> object:
    """Return what is at the front door; raises AttributeError for anything else."""
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module foon_kg has no attribute {name}")


def __dir__() -> list[str]:
    """Return the names at the front door."""
    return sorted(__all__)
