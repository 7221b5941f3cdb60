"""Videos and recipes into what is staged for an import: by the writers of the graph, one part after another."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from foon_kg.model import Subgraph
from foon_kg.model.collected import CollectedRecipe, UnderstoodRecipe
from foon_kg.model.nodes import two_of_one_name
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.loading import UNITS_PER_TRANSACTION, batches
from foon_kg.store.graph.recipes import RecipesStored, Understand, write_recipes
from foon_kg.store.graph.recipes import batches as recipe_batches
from foon_kg.store.graph.writing import Writer
from foon_kg.store.offline.staged import Staged


@dataclass
class Stager:
    """Writes videos into ``staged``, each once; ``told`` hears of each part how many it has. ``videos`` counts them."""

    staged: Staged
    kitchen: Kitchen
    told: Callable[[int], None] = lambda _count: None
    videos: int = 0

    def stage(self, subgraphs: Iterable[Subgraph]) -> None:
        """Write ``subgraphs``, of which only a part is in memory at a time.

        Raises :class:`~foon_kg.model.errors.ReadError` where two that differ have one name.
        """
        for batch in batches(subgraphs, UNITS_PER_TRANSACTION):
            new = self._new(batch)
            writer = Writer(self.staged.ask, self.kitchen)
            writer.add(new)
            writer.finish()
            self.staged.commit()
            self.videos += len(new)
            self.told(len(batch))

    def _new(self, batch: Iterable[Subgraph]) -> list[Subgraph]:
        """Return those of ``batch`` that are not staged yet."""
        members = list(batch)
        contents = {row.name: row.content for row in self.staged.video_contents([one.name for one in members])}
        new: list[Subgraph] = []
        for subgraph in members:
            known = contents.setdefault(subgraph.name, "")
            if not known:
                contents[subgraph.name] = subgraph.content_key
                new.append(subgraph)
            elif known != subgraph.content_key:
                raise two_of_one_name(subgraph.name)
        return new


def stage_recipes(
    staged: Staged,
    recipes: Iterable[CollectedRecipe],
    understand: Understand,
    *,
    version: str = "",
    stored: Callable[[RecipesStored], None] = lambda _: None,
    left_over: Callable[[UnderstoodRecipe], None] = lambda _: None,
) -> RecipesStored:
    """Write ``recipes`` into what is ``staged``, of which only a part is in memory at a time; each id comes once.

    ``understand``, ``stored``, ``left_over`` and ``version``: see :func:`~foon_kg.store.graph.recipes.load_recipes`.
    """
    total = RecipesStored()
    for batch in recipe_batches(recipes):
        understood = understand(batch)
        write_recipes(staged.ask, understood, version)
        staged.commit()
        for recipe in understood:
            if recipe.left_over:
                left_over(recipe)
        done = RecipesStored(
            inserted=len(understood),
            foods=sum(len(recipe.ingredients) for recipe in understood),
            left_over=sum(len(recipe.left_over) for recipe in understood),
        )
        stored(done)
        total += done
    return total
