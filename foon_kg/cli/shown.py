"""What ``foon show`` shows of a tree: for the terminal, as JSON, as a picture, as a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from foon_kg.cli.console import sayer
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from rich.console import RenderableType

    from foon_kg.formats.views.shown_tree import ShownTree
    from foon_kg.model.json_fields import JsonObject
    from foon_kg.plans.schedule import Schedule
    from foon_kg.plans.step_changes import StepChange


@dataclass(frozen=True)
class Shown:
    """A tree and what is asked to be seen of it: its ``matter``, one of those of ``foon show``, or ``tree``."""

    tree: ShownTree
    matter: str
    hands: int
    files: Sequence[Path] | None
    quiet: bool
    folded: bool

    def as_json(self) -> JsonObject:
        """Return what there is to see as JSON; a tree is its steps as sentences."""
        from foon_kg.formats.exports.sentences import sentence
        from foon_kg.model.node_json import node_to_json
        from foon_kg.model.tree_json import unit_to_json
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.plans.shopping import shopping_list

        kitchen, units = Kitchen.default(), self.tree.units
        told: JsonObject = {"title": self.tree.title}
        match self.matter:
            case "schedule":
                return told | self.schedule().to_json()
            case "difference":
                return told | {"steps": [one.to_json() for one in self.difference()]}
            case "shopping":
                return told | {"shopping": list(map(node_to_json, shopping_list(self.tree.kitchen, kitchen)))}
            case "progress":
                return told | {"progress_lines": [line.to_json() for line in self.tree.lines]}
            case "units":
                return told | {"units": list(map(unit_to_json, units))}
            case _:
                return told | {"steps": [sentence(unit.as_unit(), kitchen) for unit in units]}

    def printed(self) -> RenderableType:
        """Return it for the terminal."""
        from foon_kg.formats.views.schedule import schedule_view, shopping_view
        from foon_kg.formats.views.step_changes import step_changes_view
        from foon_kg.formats.views.tree import progress_view, tree_view
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.plans.shopping import shopping_list

        match self.matter:
            case "schedule":
                return schedule_view(self.tree, self.schedule())
            case "difference":
                return step_changes_view(self.tree, self.difference())
            case "shopping":
                return shopping_view(shopping_list(self.tree.kitchen, Kitchen.default()), tuple(self.tree.unseen))
            case "progress":
                return progress_view(self.tree)
            case _:
                return tree_view(self.tree, as_units=self.matter == "units")

    def drawn(self) -> str:
        """Return it as SVG."""
        from foon_kg.formats.pictures.gantt import schedule_svg
        from foon_kg.formats.pictures.progress import progress_svg
        from foon_kg.formats.pictures.step_changes import step_changes_svg
        from foon_kg.formats.pictures.tree import tree_svg
        from foon_kg.plans.kitchen import Kitchen

        match self.matter:
            case "schedule":
                return schedule_svg(self.tree, self.schedule())
            case "difference":
                return step_changes_svg(self.tree, self.difference())
            case "progress":
                return progress_svg(self.tree)
            case _:
                return tree_svg(self.tree, Kitchen.default(), folded=self.folded)

    def page(self) -> str:
        """Return the page that stands on its own."""
        from foon_kg.formats.pictures.page import page_of
        from foon_kg.plans.kitchen import Kitchen

        return page_of(self.tree, Kitchen.default(), folded=self.folded)

    def schedule(self) -> Schedule:
        """Return who does what when, by the times of a FOON."""
        from foon_kg.cli.knowledge import whole_foon
        from foon_kg.plans.durations import Durations
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.plans.schedule import schedule

        foon = whole_foon(self.files, sayer(quiet=self.quiet))
        text = self.tree.units if self.tree.result is None else ()  # of a plan the FOON has all that was seen
        durations = Durations.of_units(foon.units, [(u.motion, seen) for u in text for seen in u.sightings])
        return schedule(self.tree.units, self.tree.kitchen, durations, Kitchen.default(), self.hands)

    def difference(self) -> tuple[StepChange, ...]:
        """Return what became of the steps of the reference tree.

        Raises UsageError for a tree that names no reference, and where the FOON has another one than the plan had.
        """
        from foon_kg.cli.knowledge import front_door
        from foon_kg.plans.step_changes import step_changes

        plan = self.tree.result
        if plan is None:
            raise UsageError("FOON text does not say what its reference was", hint="Give a plan result (JSON).")
        with front_door(self.files, sayer(quiet=self.quiet)) as foon:
            reference = foon.reference_of(plan)
        if len(reference) != plan.reference.units:
            told = f"this FOON's reference tree has {len(reference)} steps, and the plan's had {plan.reference.units}"
            raise UsageError(told, hint="Give the FOON from which it was planned, or plan it anew.")
        return step_changes(reference, self.tree.units)


def pixels(drawn: str) -> bytes:
    """Return the picture ``drawn`` (SVG) as PNG."""
    from foon_kg.formats.pictures.png import png_of

    return png_of(drawn)
