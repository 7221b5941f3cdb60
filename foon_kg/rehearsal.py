"""One script executed again and again, to see which foods can join it where."""

from __future__ import annotations

from foon_kg.replay import Additions, Stage
from foon_kg.script import Casting, Item, Replayed, Scene, Script, Step


class Rehearsal:
    """A script that is executed with one casting again and again, each time with other foods that join.

    What happens up to the first unit at which other foods join than ever before is executed once, and kept.
    """

    def __init__(self, script: Script, casting: Casting) -> None:
        self.script = script
        self.casting = casting
        self._opening = _Tableau(Stage(casting, script), None)

    def replay(self, additions: Additions) -> Replayed:
        """Execute the script; ``additions`` join at the unit of that place."""
        there = self._opening
        steps = []
        for place, scene in enumerate(self.script.scenes):
            there = there.after(place, scene, tuple(additions.get(place, ())))
            if there.step is not None:
                steps.append(there.step)
        return Replayed(tuple(steps), there.stage.items)


class _Tableau:
    """What stands in the kitchen after a unit, and what comes of it at the next one, by what joins there."""

    def __init__(self, stage: Stage, step: Step | None) -> None:
        self.stage = stage
        self.step = step
        self._next: dict[tuple[Item, ...], _Tableau] = {}

    def after(self, place: int, scene: Scene, added: tuple[Item, ...]) -> _Tableau:
        """Answer what stands there after ``scene``, the next unit."""
        if added not in self._next:
            stage = self.stage.copy()
            self._next[added] = _Tableau(stage, stage.perform(place, scene, added))
        return self._next[added]
