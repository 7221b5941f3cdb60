"""What is said with a finished tree: what its title asks and no step does, and for what its foods were taken."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Tables
from foon_kg.food.named import Named
from foon_kg.food.techniques import Foods
from foon_kg.integration.composing.headed import Inferred
from foon_kg.integration.final_tree import FinalTree
from foon_kg.integration.preparing.preparation import Want
from foon_kg.model import Recipe
from foon_kg.model.claims import Assumption
from foon_kg.model.tree import Step


@dataclass(frozen=True)
class Core:
    """A food that nothing is known of, by its ``name``, taken for the listed ``food`` that its ``dish`` is made of.

    ``among`` is of how many of the asked foods nothing is known.
    """

    name: str
    food: str
    dish: str
    among: int

    @property
    def label(self) -> str:
        """How it is called in the tree, so that everybody knows what it is taken for."""
        return f"{self.name} {self.food}"

    @property
    def why(self) -> str:
        """Why it is taken for that, and how sure that is."""
        only = f"confidence {1 / self.among:.2f}: it is one of {self.among} such foods"
        sure = only if self.among > 1 else "the only such food"
        why = f"nothing is known of “{self.name}”, and no {self.dish} is without a food like {self.food}"
        return f"{why}: taken for that ({sure})"


def with_core_told(tree: FinalTree, core: Core | None) -> FinalTree:
    """Return a ``tree`` that says for what the food was taken of which nothing is known (``core``), if any."""
    if core is None:
        return tree
    leaf = next((node for node in tree.kitchen if core.label in {node.label, *node.ingredients}), None)
    return tree if leaf is None else replace(tree, assumptions=(*tree.assumptions, Assumption(leaf, core.why)))


def with_unheeded(
    tree: FinalTree, asked: Iterable[tuple[Named, str]], wants: Sequence[Want], known: Tables
) -> FinalTree:
    """Return a ``tree`` that says of each word of its title if no step does what is ``asked`` by that.

    ``asked`` has what is to be done, each with the words that say it; ``wants`` are the foods of the recipe, ``known``
    the tables. It is an assumption of the first food that is meant: there has to be a node to say it of.
    """
    unheeded = []
    for one, word in asked:
        names = _first_meant(one, wants)
        leaf = next((node for name in names for node in tree.kitchen if node.label == name), None)
        if leaf is not None and not _is_done_in(one, tree.units, known):
            why = f"the title says “{word}”, and no step of this FOON does it to such a dish"
            unheeded.append(Assumption(leaf, why))
    return replace(tree, assumptions=(*tree.assumptions, *unheeded)) if unheeded else tree


def with_parts_told(tree: FinalTree, inferred: Iterable[Inferred], recipe: Recipe) -> FinalTree:
    """Return a ``tree`` that says of the parts that were ``inferred`` what they were taken for: it is an assumption.

    ``recipe`` lists their foods. There has to be a node to say it of: the first of those foods that the kitchen has.
    """
    names = [food.object for food in recipe.ingredients if food.object]
    told = []
    for one in inferred:
        foods = [names[place] for place in one.places]
        leaf = next((node for name in foods for node in tree.kitchen if node.label == name), None)
        if leaf is not None:
            told.append(
                Assumption(leaf, f"taken to be for the {one.part}, as they are listed side by side: {', '.join(foods)}")
            )
    return replace(tree, assumptions=(*tree.assumptions, *told)) if told else tree


def _first_meant(one: Named, wants: Sequence[Want]) -> Iterator[str]:
    """Yield the asked foods that it is done to: what the table names first comes first."""
    for foods in one.of or (Foods(("*",)),):
        yield from (want.label for want in wants if foods.mean(want.label, want.facts, ()))


def _is_for(one: Named, names: Iterable[str], known: Tables) -> bool:
    """Whether one of these names is that of a food that it is done to."""
    return any(known.utensil(name) is None and one.is_of(name, known.foods.food(name)) for name in names)


def _is_done_in(one: Named, units: Sequence[Step], known: Tables) -> bool:
    """Whether steps of a tree do it to what it is for, as often as that is asked, before or after it is heated."""
    hot, found = [], []
    for number, unit in enumerate(units):
        names = {name for node in unit.input_nodes for name in (node.label, *node.ingredients)}
        if _is_for(one, names, known):
            row = known.motion(unit.motion)
            hot += [number] if "heat" in row.does else []
            found += [number] if one.is_done_by(unit.motion, row) else []
    return len(one.in_time(found, hot)) >= one.times
