"""foon-kg: task trees for cooking, planned from a functional object-oriented network in Neo4j.

``Foon`` is the front door (:mod:`foon_kg.foon`); it is imported when it is asked for, so that a command which needs
none of it starts at once.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # for who checks types; at run time __getattr__ does it
    from foon_kg.foon import Foon, Plan, Step

__version__ = "0.1.0"
__all__ = ["Foon", "Plan", "Step", "__version__"]

_AT_THE_DOOR = ("Foon", "Plan", "Step")


def __getattr__(name: str) -> object:
    """Return what is at the front door; raises AttributeError for anything else."""
    if name in _AT_THE_DOOR:
        return getattr(import_module("foon_kg.foon"), name)
    raise AttributeError(f"module foon_kg has no attribute {name}")


def __dir__() -> list[str]:
    """Return the names at the front door."""
    return sorted(__all__)
