"""What the variables of a MUHAI network stand for while it is played: vessels with food in them, and tools.

What each primitive does with them is in :mod:`~foon_kg.loaders.muhai_primitives`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.loaders.notices import Journal, NoticeKind, Remark
from foon_kg.model import UNMEASURED, FunctionalUnit, Measures, ObjectNode, Participant

TOOLS = {
    "beating-tool": "whisk",
    "mixing-tool": "spoon",
    "table-spoon": "spoon",
    "cutting-tool": "knife",
    "sifting-tool": "sieve",
    "scraper": "spatula",
    "grinding-tool": "food processor",
}


class NotThere(Exception):  # noqa: N818  # a signal between two modules
    """No food is where a primitive takes it."""


@dataclass(frozen=True)
class Held:
    """A vessel (or a place, or a tool) with the foods in it."""

    vessel: str
    foods: tuple[ObjectNode, ...] = ()
    states: tuple[str, ...] = ()

    def node(self) -> ObjectNode:
        """Return the object node of the vessel as it is now."""
        return ObjectNode(self.vessel, self.states or (() if self.foods else ("empty",)), self._names())

    def _names(self) -> tuple[str, ...]:
        return tuple(food.label for food in self.foods)

    def of(self, foods: Iterable[ObjectNode]) -> Held:
        """Return this vessel with ``foods`` in it, one node for each label and state."""
        placed = (ObjectNode(food.label, food.states, food.ingredients, "in", self.vessel) for food in foods)
        return replace(self, foods=tuple(dict.fromkeys(placed)))

    def put(self, foods: Iterable[ObjectNode]) -> tuple[Held, tuple[ObjectNode, ...]]:
        """Return this vessel with ``foods`` beside what is in it, and how they are there; one that is there stays one.

        >>> bowl, there = Held("bowl").of([ObjectNode("flour"), ObjectNode("sugar")]).put([ObjectNode("flour")])
        >>> [str(food) for food in bowl.foods], [str(food) for food in there]
        (['flour (in bowl)', 'sugar (in bowl)'], ['flour (in bowl)'])
        """
        there = self.of(foods).foods
        return self.of((*self.foods, *there)), there


class Scene:
    """What each variable stands for while a network is played, and the units so far."""

    def __init__(self, journal: Journal) -> None:
        self.units: list[FunctionalUnit] = []
        self.measures: list[Measures] = []
        self.lines: list[int] = []
        self.oven: float | None = None
        """How hot the oven was made, in °C; ``None`` where nothing said so."""
        self.journal = journal
        self._held: dict[str, Held] = {}
        self._became: dict[str, str] = {}
        self._used: list[str] = []
        self._line = 0

    def begin(self, line: int) -> None:
        """Begin the primitive that stands in ``line``: nothing is used for it yet."""
        self._used, self._line = [], line

    def bind(self, variable: str, held: Held) -> None:
        """Let ``variable`` stand for ``held``; what was used for it is that by now."""
        self._held[variable] = held
        self._became.pop(variable, None)
        self._became.update((used, variable) for used in self._used if used != variable)

    def vessel(self, variable: str, otherwise: str) -> Held:
        """Return what ``variable`` stands for; where nothing made it a fresh vessel, called ``otherwise``."""
        return self._held.get(self._now(variable)) or Held(otherwise)

    def filled(self, variable: str) -> Held:
        """Return the vessel with food in it that ``variable`` stands for. Raises ``NotThere`` where there is none."""
        held = self._held.get(self._now(variable))
        if held is None or not held.foods:
            raise NotThere(variable)
        return held

    def beside(self, variable: str) -> Held:
        """Return the vessel of ``variable``, of whose food only some is used.

        Raises ``NotThere`` where there is none.
        """
        used = list(self._used)
        held = self.filled(variable)
        self._used = used
        return held

    def _now(self, variable: str) -> str:
        """Return the variable that stands by now for what ``variable`` stood for, and note that it is used."""
        now = variable
        while now in self._became and now in self._held and self._held[now].foods:  # an empty one is another each time
            now = self._became[now]
        self._used.append(now)
        if now != variable:
            what = f"{variable} was used up by a primitive before"
            action = f"taken for what became of it, {now}"
            self.journal.remark(self._line, Remark(NoticeKind.NOT_PLAYED, what, action))
        return now

    def tool(self, words: Sequence[str], place: int, otherwise: str) -> ObjectNode:
        """Return the tool at ``place`` (from 0) of ``words``: what was fetched for it, or what its name says.

        Where nothing says it, it is called ``otherwise``.
        """
        word = words[place] if len(words) > place else ""
        held = self._held.get(word)
        name = re.sub(r"-\d+$", "", word.lstrip("?"))
        return ObjectNode(held.vessel if held else TOOLS.get(name) or name.replace("-", " ") or otherwise)

    def add(
        self, motion: str, inputs: Iterable[ObjectNode], outputs: Iterable[ObjectNode], *, star: bool = False
    ) -> None:
        """Add the unit in which ``motion`` makes ``outputs`` of ``inputs``; with ``star`` of any number of foods."""
        sides = (tuple(Participant(node) for node in dict.fromkeys(side)) for side in (inputs, outputs))
        self.measures.append(UNMEASURED)
        self.lines.append(self._line)
        self.units.append(FunctionalUnit(next(sides), motion, next(sides), accepts_any=star))

    def change(
        self,
        words: Sequence[str],
        place: int,
        motion: str,
        change: Callable[[ObjectNode], ObjectNode],
        with_: tuple[ObjectNode, ...] = (),
    ) -> None:
        """Add a unit of ``motion`` that does ``change`` to each food of the vessel at ``place`` (from 0) of ``words``.

        ``with_`` are the tools that it takes.
        """
        before = self.filled(words[place])
        after = before.of(map(change, before.foods))
        self.add(motion, (before.node(), *before.foods, *with_), (after.node(), *after.foods))
        self.bind(words[0], after)

    def move(self, out: str, source: Held, target: Held, motion: str, *, with_: tuple[ObjectNode, ...] = ()) -> None:
        """Add a unit of ``motion`` in which all in ``source`` comes to what is in ``target``.

        ``out`` stands for that then; ``with_`` are the tools that it takes.
        """
        after, moved = target.put(source.foods)
        self.add(
            motion,
            (source.node(), *source.foods, target.node(), *with_),
            (after.node(), *moved, replace(source, foods=()).node()),
        )
        self.bind(out, after)
