"""Integration as re-execution: run a task tree again with other foods in it (paper, algorithm 4).

A script (units in their order) is executed step by step. Every object node of the script stands for a *current*
node, or for nothing any more: a leaf food is recast as the food that the recipe wants, or dropped; what a unit
outputs holds only what really went in; a unit whose foods are all gone does nothing, and what it would have
moved stays where it is. Foods may be added at units that accept any number, and flow from there with whatever
holds them. Removing, renaming and adding are therefore consistent by construction, up to the goal.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from foon_kg.model import ObjectNode
from foon_kg.moment import SPENT, UNSEEN, USED, Found
from foon_kg.performance import Performer
from foon_kg.script import Casting, Item, Performance, Performances, Replayed, Scene, Script, Step, spot_of

Additions = Mapping[int, Sequence[Item]]
"""What joins the units of a script, by their places."""


def replay(script: Script, casting: Casting, additions: Additions | None = None) -> Replayed:
    """Execute ``script`` with the foods of ``casting``; ``additions`` join at the unit of that place."""
    stage = Stage(casting, script)
    joining = additions or {}
    steps = []
    for place, scene in enumerate(script.scenes):
        step = stage.perform(place, scene, tuple(joining.get(place, ())))
        if step is not None:
            steps.append(step)
    return Replayed(tuple(steps), stage.items)


class Stage:
    """What stands in the kitchen while a script is performed."""

    def __init__(self, casting: Casting, script: Script) -> None:
        self.casting = casting
        self.script = script
        self.items: dict[ObjectNode, Item | None] = {}
        self.leaf_foods: set[str] = set()
        self.used: set[ObjectNode] = set()
        self.later: dict[ObjectNode, Item] = {}
        self._known: dict[Scene, Performances] = {}

    def copy(self) -> Stage:
        """Answer a stage on which everything stands as it does here."""
        other = Stage(self.casting, self.script)
        other.items, other.leaf_foods = self.items.copy(), self.leaf_foods.copy()
        other.used, other.later = self.used.copy(), self.later.copy()
        other._known = self._known
        return other

    def perform(self, place: int, scene: Scene, added: tuple[Item, ...]) -> Step | None:
        """Execute one unit; answer what happens, or ``None`` where nothing does."""
        performance = self._performance(place, scene, added)
        self.items.update(performance.fetched)
        self.leaf_foods.update(performance.labels)
        if not performance.happens:
            self._pass_through(performance)
            return None
        self.used |= performance.used
        for node, item in performance.made:
            self.items[node] = item
            self.used.discard(node)
        for node in performance.renewed:
            self.later.pop(node, None)
        self.later.update(performance.become)
        return performance.told_at(place)

    def _performance(self, place: int, scene: Scene, added: tuple[Item, ...]) -> Performance:
        """Answer what comes of a unit as things stand, known or worked out now."""
        known = self._known.get(scene)
        if known is None:
            known = self._known[scene] = self._performances(scene)
        found = tuple(map(self._found, scene.inputs))
        if self.casting.spent:
            pairs = zip(scene.inputs, found, strict=True)
            found = tuple([SPENT if (place, node) in self.casting.spent else there for node, there in pairs])
        key = (found, added, scene.spoken & self.leaf_foods, self._carried(scene, found, added))
        performance = known.get(key)
        if performance is None:
            alone, kitchen = self.script.taken_alone, self.script.repertoire.kitchen
            performer = Performer(scene, self.casting, kitchen, self.leaf_foods, alone)
            performance = known[key] = performer.perform(found, added)
        return performance

    def _performances(self, scene: Scene) -> Performances:
        """Answer what came so far of a unit with such a casting, in whatever script."""
        casting, alone = self.casting, self.script.taken_alone.intersection(scene.outputs)
        roles = tuple([casting.roles.get(name, UNSEEN) for name in scene.names])
        goal = casting.goal if casting.goal in scene.outputs else None
        return self.script.repertoire.performances(scene, alone, roles, goal, casting.cut)

    def _found(self, node: ObjectNode) -> Found:
        item = self.items.get(node, UNSEEN)
        if item is UNSEEN:
            node = self.script.same.get(node, node)
            item = self.items.get(node, UNSEEN)
        if node in self.used:
            return USED
        if not isinstance(item, Item):
            return item
        while (later := self.later.get(item.node)) is not None and later.node != item.node:
            item = later
        return item

    def _carried(self, scene: Scene, found: Sequence[Found], added: Sequence[Item]) -> frozenset[str]:
        """Answer the names that mixtures must carry, as far as they can come up here."""
        if not self.casting.carried:
            return self.casting.carried
        inside = {now for item in (*found, *added) if isinstance(item, Item) for _, now in item.atoms}
        roles = (self.casting.foods.get(name) for name in scene.names)
        return self.casting.carried & inside.union(scene.names, (role.label for role in roles if role is not None))

    def _pass_through(self, performance: Performance) -> None:
        for node, same, away in performance.passed:
            self.items.setdefault(node, None)
            if same is not None:
                self.items[node] = (self._standing(node) if away else None) or same

    def _standing(self, node: ObjectNode) -> Item | None:
        """Answer the vessel that stands, empty, where the script has ``node`` with something in it; the last one."""
        items = (item for item in reversed(self.items.values()) if item is not None and not item.atoms)
        return next((i for i in items if i.node.label == node.label and spot_of(i.node) == spot_of(node)), None)
