"""Whether a step does what the title of a recipe names (docs/contract.md, K5)."""

from __future__ import annotations

from collections.abc import Iterator

from foon_kg.food.named import Named, named_by
from foon_kg.validation.case import Case
from foon_kg.validation.report import Finding
from foon_kg.world import Part, PlayedStep


def unheeded(case: Case) -> Iterator[Finding]:
    """Yield a finding for each word of the title of ``case`` that names what no step does.

    It is minor where the tree says so itself.
    """
    if case.recipe is None or not case.title or case.goal is None:
        return
    foods = [(wanted.object, case.tables.foods.food(wanted.object, (wanted.state,))) for wanted in case.required]
    for one, said in named_by(case.title, case.recipe.dish_type, foods):
        meant = [part for part in case.parts if one.is_of(part.name, part.food)]
        if not any(_is_done_to(case, one, part) for part in meant):
            minor = _is_told(case, said)
            yield Finding("K5", f"the title says “{said}”, and no step does it", None, (case.goal,), minor=minor)


def _is_told(case: Case, said: str) -> bool:
    """Whether the tree says why it does not what a word of the title names."""
    return any(f"“{said}”" in entry.why for entry in case.tree.assumptions or ())


def _is_done_to(case: Case, one: Named, part: Part) -> bool:
    """Whether a part of the dish was treated so, as often as it is asked, before or after it was heated."""
    done = [played_step for played_step in case.played_steps if _treats(played_step, part)]
    hot = [played_step.number for played_step in done if played_step.does("heat")]
    found = [played_step.number for played_step in done if one.is_done_by(played_step.step.motion, played_step.motion)]
    return len(one.in_time(found, hot)) >= one.times


def _treats(played_step: PlayedStep, part: Part) -> bool:
    lumps = (*played_step.treated, *(lump for vessel in played_step.heated for lump in vessel.lumps))
    return any(part.origin == other.origin for lump in lumps for other in lump.parts)
