"""A unit of a script while it is performed: what it finds, and what it takes from the kitchen itself."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from foon_kg.kitchen import Kitchen
from foon_kg.model import ObjectNode
from foon_kg.script import Atom, Casting, Item, Scene, changed, emptied


class Unseen:
    """The mark of a node with which nothing was done so far, and of a food that no casting names."""


UNSEEN = Unseen()

Found = Item | Unseen | str | None
"""What a unit finds in the place of a node: what it has become, nothing, or that it is gone (``USED``, ``SPENT``)."""

USED = "used"
"""A food that went elsewhere before: it is taken once (sense, S1 and S4), and is now in what took it."""

SPENT = "spent"
"""What an earlier unit took away or poured out, whatever the script says: a food is not there, a vessel is empty."""


class Moment:
    """A scene while it is performed: which of its inputs are there, and what they bring.

    ``atoms`` are all the foods in what is there, ``visible`` the names that the inputs say now: only these can be named
    in what comes of them.
    """

    def __init__(
        self,
        scene: Scene,
        present: Mapping[ObjectNode, Item],
        gone: frozenset[ObjectNode],
        added: tuple[Item, ...],
        spent: frozenset[ObjectNode],
    ) -> None:
        self.scene = scene
        self.present = present
        self.gone = gone
        self.added = added
        items = (*present.values(), *added)
        self.atoms: frozenset[Atom] = frozenset().union(*[item.atoms for item in items])
        self.visible = frozenset([name for item in items for name in (item.node.label, *item.node.ingredients)])
        self.spent = spent

    def of_label(self, label: str) -> list[Item]:
        """Answer what is there of the script's inputs called ``label``."""
        return [item for node, item in self.present.items() if node.label == label]

    def stays(self, node: ObjectNode, untouched: set[ObjectNode]) -> Item | None:
        """Answer the vessel that was not touched, where the script empties it: it stays as it is."""
        if node.ingredients or not untouched or node in self.scene.foods:
            return None
        return next(
            (self.present[other] for other in self.present if other in untouched and other.label == node.label), None
        )

    def left_behind(self, made: Mapping[ObjectNode, Item | None]) -> set[ObjectNode]:
        """Vessels of the script that bring nothing any more and take nothing: they are not touched."""
        receiving = {node.label for node, item in made.items() if item is not None and item.atoms}
        return {
            node
            for node, item in self.present.items()
            if node in self.scene.filled and not item.atoms and node.label not in receiving
        }

    def poured_out(self) -> set[ObjectNode]:
        """Vessels that were poured out before, beside what was in them: empty, they are taken all the same."""
        names = {name for name, _ in self.atoms}
        return {node for node in self.spent if node in self.present and not names.isdisjoint(node.ingredients)}

    def become(self, made: Mapping[ObjectNode, Item | None]) -> Iterator[tuple[ObjectNode, Item]]:
        """Answer what a vessel has become, for a later unit of the script that still knows it as it was."""
        for node, item in self.present.items():
            if node in self.scene.foods or not item.node.ingredients:
                continue
            for output, now in made.items():
                if now is None or output.label != node.label or now.node == item.node:
                    continue
                if _place(now.node) == _place(item.node) and set(now.node.ingredients) > set(item.node.ingredients):
                    yield item.node, now


def _place(node: ObjectNode) -> tuple[tuple[str, ...], str | None, str | None]:
    return (node.states, node.relation, node.container)


class Larder:
    """What one unit takes from the kitchen, under the names and in the states in which a casting has the foods.

    ``leaf_foods`` are the foods that were taken from the kitchen before; those that it takes come to them.
    """

    def __init__(self, scene: Scene, casting: Casting, kitchen: Kitchen, leaf_foods: Iterable[str]) -> None:
        self.scene = scene
        self.casting = casting
        self.kitchen = kitchen
        self.leaf_foods = set(leaf_foods)

    def leaf(self, node: ObjectNode) -> Item | None:
        """Answer what is taken for ``node``, with which nothing was done so far; ``None`` for a dropped food."""
        if node not in self.scene.foods:
            return self._leaf_vessel(node)
        inside = self._atoms_in(node)
        names = tuple(now for _, now in inside)
        self.leaf_foods.add(node.label)
        recast = self.casting.foods.get(node.label)
        if self.name_now(node.label) is None:
            return None
        made_apart = recast is not None and node in recast.ready
        current = recast.ready[node] if recast is not None and made_apart else self.recast(node, names)
        return Item(current, inside | {(node.label, current.label)})

    def _leaf_vessel(self, node: ObjectNode) -> Item | None:
        if not node.ingredients:
            return Item(node)
        roles = (self.casting.foods.get(name) for name in node.ingredients)
        left = any(role is not None and role.comes_from_elsewhere(node) for role in roles)
        atoms = frozenset() if left else self._atoms_in(node)
        if self.kitchen.is_storage(node.label):
            return self._holding(node, atoms) if atoms else None
        if not set(self.kitchen.foods_in(node)) <= self.scene.beside or not atoms:
            return Item(emptied(node))  # nobody filled it, so it is taken empty
        return self._holding(node, atoms)

    def _holding(self, node: ObjectNode, atoms: frozenset[Atom]) -> Item:
        return Item(changed(node, ingredients=tuple(now for _, now in atoms)), atoms)

    def _atoms_in(self, node: ObjectNode) -> frozenset[Atom]:
        inside = ((name, self.name_now(name)) for name in node.ingredients)
        return frozenset((name, now) for name, now in inside if now is not None)

    def name_now(self, name: str) -> str | None:
        """Answer what a food of the script is called now; ``None`` where it was dropped."""
        recast = self.casting.foods.get(name, UNSEEN)
        if recast is None:
            return None
        return name if isinstance(recast, Unseen) else recast.label

    def recast(self, node: ObjectNode, ingredients: Iterable[str]) -> ObjectNode:
        """Answer a food as it appears now, with these ``ingredients``."""
        recast = self.casting.foods.get(node.label)
        if recast is None:
            return changed(node, ingredients=ingredients)
        return changed(node, label=recast.label, states=recast.states_of(node), ingredients=ingredients)
