"""The kitchen as it changes: things with identity, vessels with contents, appliances with power.

:class:`World` plays a tree step by step and tells why a step cannot happen (docs/contract.md, W1 to W4). Planner and
judge use it alike; nothing here plans or judges. ``world.py`` says what a step is made of; read it first.
"""

from __future__ import annotations

from foon_kg.model.tree import Mention, Step
from foon_kg.world.played_step import Mishap, PlayedStep
from foon_kg.world.things import Lump, Part, Vessel
from foon_kg.world.world import World

__all__ = ["Lump", "Mention", "Mishap", "Part", "PlayedStep", "Step", "Vessel", "World"]
