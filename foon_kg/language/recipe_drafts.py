"""Recipes of a collection drafted from their instructions, one by one, in as many processes as are given."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.language.collection import classes_of
from foon_kg.language.drafting.drafting import draft
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.instructions import with_actions
from foon_kg.language.recipe_text import ingredients
from foon_kg.loaders.draft_tables import write_draft
from foon_kg.model import KnownUnit
from foon_kg.model.collected import CollectedRecipe
from foon_kg.model.drafted import DraftedRecipe
from foon_kg.model.errors import FoonError
from foon_kg.model.extras import missing
from foon_kg.model.narration import Narration, Sentence
from foon_kg.plans.kitchen import Kitchen

MOST_STEPS = 200
"""A recipe with more is none: the longest of real collections stay far below."""


@dataclass(frozen=True)
class RecipeDrafter:
    """Drafts recipes with what the ``units`` of a FOON say of such actions. It travels to other processes."""

    units: tuple[KnownUnit, ...]
    kitchen: Kitchen

    @cached_property
    def precedents(self) -> FoonPrecedents:
        """What the FOON knows."""
        return FoonPrecedents(self.units, self.kitchen)

    def draft(self, recipe: CollectedRecipe) -> DraftedRecipe:
        """Return the draft of one recipe; one that cannot be drafted is an answer that says why.

        Raises :class:`~foon_kg.model.errors.UsageError` where what parses sentences is not installed.
        """
        dish_type = next((dish.name for dish in classes_of(recipe) if dish.sure), "")
        empty = DraftedRecipe(recipe.id, recipe.title, dish_type, "")
        if not recipe.instructions:
            return _unable(empty, "it has no instructions")
        if len(recipe.instructions) > MOST_STEPS:
            return _unable(empty, f"{len(recipe.instructions)} steps, and no recipe has over {MOST_STEPS}")
        try:
            return self._drafted(recipe, dish_type)
        except FoonError as error:
            if error.code in {"text", "recipes"}:  # what reads is not installed
                raise
            return _unable(empty, error.message)
        except ModuleNotFoundError as error:
            raise missing(error) or error from error
        except (LookupError, ValueError, RecursionError) as error:  # one odd recipe ends no batch
            return _unable(empty, f"it could not be drafted: {error!r}")

    def _drafted(self, recipe: CollectedRecipe, dish_type: str) -> DraftedRecipe:
        narration = Narration(
            recipe.title or recipe.id,  # what a dish is called says what it is
            sentences=tuple(map(Sentence, recipe.instructions)),
            source=recipe.url or recipe.place,
            ingredients=ingredients(line.text for line in recipe.lines if line.is_readable),
        )
        told = with_actions(narration, self.precedents.verbs, self.precedents.names)
        made = draft(told, self.precedents, dish_type=dish_type or None)
        return DraftedRecipe(
            recipe.id,
            recipe.title,
            dish_type,
            write_draft(made) if made.units else "",
            len(made.units),
            len(made.left_out),
            _mean([unit.confidence for unit in made.units]),
            "" if made.units else "no step of it is an action of this FOON",
        )


def _unable(empty: DraftedRecipe, why: str) -> DraftedRecipe:
    return DraftedRecipe(empty.id, empty.title, empty.dish_type, "", problem=why)


def _mean(confidences: Sequence[float]) -> float:
    return round(sum(confidences) / len(confidences), 2) if confidences else 0.0
