"""What comes of one unit of a script: which foods and vessels it finds, whether it happens, what it makes of them.

It turns on nothing but what the unit finds and who plays in it, and so is worked out once for all replays in which it
finds the same (:class:`foon_kg.script.Repertoire`).
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from foon_kg import motions
from foon_kg.kitchen import Kitchen
from foon_kg.model import ObjectNode
from foon_kg.script import EMPTY, Atom, Casting, Item, Performance, Scene, Step, changed, emptied, spot_of


class Unseen:
    """The mark of a node with which nothing was done so far, and of a food that no casting names."""


UNSEEN = Unseen()

Found = Item | Unseen | str | None
"""What a unit finds in the place of a node: what it has become, nothing, or that it is gone (``USED``, ``SPENT``)."""

USED = "used"
"""A food that went elsewhere before: it is taken once (sense, S1 and S4), and is now in what took it."""

SPENT = "spent"
"""What an earlier unit took away or poured out, whatever the script says: a food is not there, a vessel is empty."""


class _Moment:
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
        return [item for node, item in self.present.items() if node.label == label]


class Performer:
    """Plays one unit, once.

    ``leaf_foods`` are the foods that were taken from the kitchen before, ``alone`` the vessels that some unit of the
    script takes without naming the food in them.
    """

    def __init__(
        self,
        scene: Scene,
        casting: Casting,
        kitchen: Kitchen,
        leaf_foods: Collection[str],
        alone: Collection[ObjectNode],
    ) -> None:
        self.scene = scene
        self.casting = casting
        self.kitchen = kitchen
        self.leaf_foods = set(leaf_foods)
        self.taken_alone = alone

    def perform(self, found: Sequence[Found], added: tuple[Item, ...]) -> Performance:
        """Answer what comes of the unit where it finds ``found``, one for each of its inputs, and ``added`` join."""
        present: dict[ObjectNode, Item] = {}
        gone: list[ObjectNode] = []
        fetched: list[tuple[ObjectNode, Item | None]] = []
        for node, there in zip(self.scene.inputs, found, strict=True):
            if there is USED or (there is UNSEEN and self._is_food(node) and node.label in self.leaf_foods):
                continue
            if there is SPENT:
                if not self._is_food(node):
                    present[node] = Item(emptied(node))
                continue
            item = there if isinstance(there, Item) else None
            if there is UNSEEN:
                item = self._leaf(node)
                fetched.append((node, item))
            if item is None:
                gone.append(node)
            else:
                present[node] = item
        spent = frozenset(node for node, there in zip(self.scene.inputs, found, strict=True) if there is SPENT)
        here = _Moment(self.scene, present, frozenset(gone), added, spent)
        labels = tuple(node.label for node, _ in fetched if self._is_food(node))
        if not self._happens(here):
            return Performance(tuple(fetched), labels, happens=False, passed=tuple(self._passed(here)))
        return self._happened(here, tuple(fetched), labels)

    def _happened(
        self, here: _Moment, fetched: tuple[tuple[ObjectNode, Item | None], ...], labels: tuple[str, ...]
    ) -> Performance:
        made = self._make(here)
        untouched = self._left_behind(here, made) - self._poured_out(here)
        stays = {node: self._stays(node, here, untouched) for node in made}
        shown = [item.node for node, item in made.items() if item is not None and stays[node] is None]
        return Performance(
            fetched,
            labels,
            happens=True,
            used=self.scene.taken & here.present.keys(),
            made=tuple((node, stays[node] or item) for node, item in made.items()),
            renewed=tuple(shown),
            become=tuple(self._become(here, made)),
            step=self._step(here, made, untouched, tuple(dict.fromkeys(shown))),
        )

    def _is_food(self, node: ObjectNode) -> bool:
        return node in self.scene.foods

    # ---- what is there

    def _leaf(self, node: ObjectNode) -> Item | None:
        if not self._is_food(node):
            return self._leaf_vessel(node)
        inside = self._atoms_in(node)
        names = tuple(now for _, now in inside)
        self.leaf_foods.add(node.label)
        recast = self.casting.foods.get(node.label)
        if self._name_now(node.label) is None:
            return None
        made_apart = recast is not None and node in recast.ready
        current = recast.ready[node] if recast is not None and made_apart else self._recast(node, names)
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
        inside = ((name, self._name_now(name)) for name in node.ingredients)
        return frozenset((name, now) for name, now in inside if now is not None)

    def _name_now(self, name: str) -> str | None:
        recast = self.casting.foods.get(name, UNSEEN)
        if recast is None:
            return None
        return name if isinstance(recast, Unseen) else recast.label

    def _recast(self, node: ObjectNode, ingredients: Iterable[str]) -> ObjectNode:
        recast = self.casting.foods.get(node.label)
        if recast is None:
            return changed(node, ingredients=ingredients)
        return changed(node, label=recast.label, states=recast.states_of(node), ingredients=ingredients)

    # ---- does it happen

    def _happens(self, here: _Moment) -> bool:
        scene = here.scene
        if here.added:
            return True
        if any(node in here.present for node in scene.turned) and (not scene.has_foods or here.atoms):
            return True
        acted = [node for node in scene.acted if node in here.present or node in here.gone]
        if acted:
            if not any(node in here.present for node in acted):
                return False
            return not here.gone or not self._only_brought(here)
        there = {node: here.present[node] for node in scene.holders if node in here.present}
        if motions.transfers(scene.known.unit.motion):
            kept = {node.label for node in scene.outputs if node.ingredients}
            givers = [item for node, item in there.items() if node.label not in kept]
            if givers and not any(item.atoms for item in givers):
                return False  # a cup out of which nothing comes
        return not scene.holders or any(item.atoms for item in there.values())

    def _only_brought(self, here: _Moment) -> bool:
        """Say whether the unit did no more than bring what is gone: pepper that was ground over the beans."""
        motion = here.scene.known.unit.motion
        if motions.mixes(motion) or motions.heats(motion) or not self._all_stay(here):
            return False
        states = {(node.label, node.states) for node in here.scene.outputs}
        left = (node for node in here.scene.acted if node in here.present)
        return motions.transfers(motion) or all((node.label, node.states) in states for node in left)

    def _all_stay(self, here: _Moment) -> bool:
        """Say whether everything that is left of what the unit moves is there before and after, in its place."""
        goal = self.casting.goal
        if goal in here.scene.outputs and not any(node.label == goal.label for node in here.scene.inputs):
            return False  # with what is left the dish is made, and gets its name
        places = {(node.label, node.container) for node in here.scene.outputs}
        left = [node for node in here.scene.acted if node in here.present]
        return all((node.label, node.container) in places for node in left)

    def _passed(self, here: _Moment) -> Iterator[tuple[ObjectNode, Item | None, bool]]:
        for node in here.scene.outputs:
            names = {node.label} if self._is_food(node) else set(node.ingredients)
            if names and names <= self.casting.cut:
                continue  # at hand: asked for later, it is a leaf
            same = next(iter(here.of_label(node.label)), None)
            away = same is not None and spot_of(same.node) != spot_of(node) and not self._is_food(node)
            yield node, same, away

    # ---- what comes of it

    def _make(self, here: _Moment) -> dict[ObjectNode, Item | None]:
        outputs = here.scene.outputs
        foods = [node for node in outputs if self._is_food(node)]
        made = {node: self._food(node, here) for node in foods}
        alive = {node.label: item for node, item in made.items() if item is not None}
        made |= {node: self._vessel(node, here, alive) for node in outputs if not self._is_food(node)}
        return {node: made[node] for node in outputs}

    def _food(self, node: ObjectNode, here: _Moment) -> Item | None:
        same = here.of_label(node.label)
        if node.label in self.leaf_foods or same or self._was_input(node.label, here):
            return self._same_food(node, here, same)
        sources = self._sources(node, here)
        if node.label in here.scene.springs:
            return Item(changed(node, ingredients=()), frozenset({(node.label, node.label)}))
        if not sources:
            return None
        atoms = frozenset().union(*(item.atoms for item in sources))
        current = changed(node, ingredients=self._listed(node, atoms, here))
        return Item(current, atoms | {(node.label, node.label)})

    def _was_input(self, label: str, here: _Moment) -> bool:
        return any(node.label == label for node in here.gone)

    def _same_food(self, node: ObjectNode, here: _Moment, same: Sequence[Item]) -> Item | None:
        names = {now for name, now in here.atoms if name == node.label}
        if not names:
            return None
        if same and (not node.ingredients or not self._is_mixed(node, here)):
            sources = [*same, *(item for n, item in here.present.items() if n in here.scene.vanishing)]
        else:
            sources = [*self._sources(node, here), *same]
        atoms = frozenset().union(*(item.atoms for item in sources)) if sources else here.atoms
        own = {(node.label, min(names))}
        listed = self._listed(node, atoms - own, here)
        if listed and min(names) in self.casting.carried:
            listed.add(min(names))  # a goal that is called like a food of it: noodles with oil are made of noodles
        current = self._recast(node, listed)
        if current.label not in names:
            current = changed(current, label=min(names))
        if node == self.casting.goal and current.label != node.label:  # the dish keeps its name
            current = changed(current, label=node.label, ingredients={*current.ingredients, current.label})
        return Item(current, atoms | own)

    def _is_mixed(self, node: ObjectNode, here: _Moment) -> bool:
        """Say whether a food takes others in here: it names some that it did not name before."""
        before = {name for n in here.present if n.label == node.label for name in n.ingredients}
        return not set(node.ingredients) <= before

    def _sources(self, node: ObjectNode, here: _Moment) -> list[Item]:
        """Answer the inputs that go into a mixture: what is acted on, and the vessels that hold it."""
        foods = [item for n, item in here.present.items() if self._is_food(n) and n not in here.scene.kept]
        holders = [item for n, item in here.present.items() if not self._is_food(n) and n.ingredients and item.atoms]
        if not foods and not holders:
            return list(here.added)
        named = set(node.ingredients)
        relevant = [
            item for item in (*foods, *holders) if not named or any(name in named or not name for name, _ in item.atoms)
        ]
        return [*(relevant or [*foods, *holders]), *here.added]

    def _listed(self, node: ObjectNode, atoms: frozenset[Atom], here: _Moment) -> set[str]:
        """Answer the ingredients that a food names now: those it named, those that joined, those it must carry."""
        names = self._named(node, atoms, here) | {now for name, now in atoms if not name}
        names -= {self._name_now(node.label) or node.label}
        return names | {now for _, now in atoms if now in self.casting.carried}

    def _named(self, node: ObjectNode, atoms: frozenset[Atom], here: _Moment) -> set[str]:
        """Answer the names that ``node`` said and still can say: what inputs say, or what only the script knew of."""
        visible, written = here.visible, here.scene.written
        known = {now for name, now in atoms if name in node.ingredients and (now in visible or name not in written)}
        known |= {now for name, now in atoms if not name and now in node.ingredients and now in visible}
        return known | {name for name in node.ingredients if name in visible and self.kitchen.is_utensil(name)}

    def _vessel(self, node: ObjectNode, here: _Moment, foods: Mapping[str, Item]) -> Item | None:
        if not node.ingredients:
            return Item(node)
        brought = here.atoms
        own = {(name, foods[name].node.label) for name in node.ingredients if name in foods}
        turned = {name for name in node.ingredients if name not in foods and not self._known(name, here) and brought}
        named = self._named(node, brought, here) | {now for _, now in own} | turned
        inside = {atom for atom in brought if atom[0] in node.ingredients or not atom[0]} | own
        inside = inside.union({(name, name) for name in turned}, *(foods[name].atoms for name, _ in own))
        springs = here.scene.springs.intersection(node.ingredients)
        named, inside = named | springs, inside | {(name, name) for name in springs}
        kept = {atom for item in here.of_label(node.label) for atom in item.atoms}
        if not turned and node in self.scene.filled:
            in_foods = {now for name, _ in own for _, now in foods[name].atoms}
            told = {atom for atom in brought if atom[1] in here.visible and atom[1] not in in_foods}
            carried = {(name, now) for name, now in told if now in self.casting.carried}
            named |= {now for name, now in told if not name or (name, now) in carried}
            inside |= carried
        if not named:
            return Item(emptied(node))
        if node in self.taken_alone and node in self.scene.filled:
            named |= {now for name, now in (*inside, *kept) if not name or now in self.casting.carried}
        return Item(changed(node, ingredients=named), frozenset(inside | kept))

    def _known(self, name: str, here: _Moment) -> bool:
        """Say whether ``name`` is a food of the script by itself, here or in the kitchen: no name of a mixture."""
        return name in here.scene.written or name in self.leaf_foods or name in self.casting.foods

    # ---- telling it

    def _step(
        self,
        here: _Moment,
        made: Mapping[ObjectNode, Item | None],
        untouched: set[ObjectNode],
        outputs: tuple[ObjectNode, ...],
    ) -> Step | None:
        known = here.scene.known
        added = tuple(item.node for item in here.added)
        inputs = [item.node for node, item in here.present.items() if node not in untouched]
        inputs = list(dict.fromkeys([*inputs, *added]))
        if set(outputs) <= set(inputs):
            return None
        moved = [p.node for p in (*known.unit.inputs, *known.unit.outputs) if p.moving]
        items = (made.get(node) or here.present.get(node) for node in moved)
        moving = {item.node for item in items if item is not None}
        motion = self._motion(known.unit.motion, here)
        strained = any(self._is_strange(node, item) for node, item in here.present.items() if node not in untouched)
        taken = tuple((node, item.node) for node, item in here.present.items() if node not in untouched)
        return Step(0, known, tuple(inputs), motion, outputs, added, frozenset(moving.union(added)), strained, taken)

    def _is_strange(self, node: ObjectNode, item: Item) -> bool:
        recast = self.casting.foods.get(node.label)
        states = node.states if recast is None else recast.states_of(node)
        return bool((set(states) ^ set(item.node.states)) - {EMPTY}) or spot_of(node) != spot_of(item.node)

    def _stays(self, node: ObjectNode, here: _Moment, untouched: set[ObjectNode]) -> Item | None:
        """Answer the vessel that was not touched, where the script empties it: it stays as it is."""
        if node.ingredients or not untouched or self._is_food(node):
            return None
        return next(
            (here.present[other] for other in here.present if other in untouched and other.label == node.label), None
        )

    def _left_behind(self, here: _Moment, made: Mapping[ObjectNode, Item | None]) -> set[ObjectNode]:
        """Vessels of the script that bring nothing any more and take nothing: they are not touched."""
        receiving = {node.label for node, item in made.items() if item is not None and item.atoms}
        return {
            node
            for node, item in here.present.items()
            if node in self.scene.filled and not item.atoms and node.label not in receiving
        }

    def _poured_out(self, here: _Moment) -> set[ObjectNode]:
        """Vessels that were poured out before, beside what was in them: empty, they are taken all the same."""
        names = {name for name, _ in here.atoms}
        return {node for node in here.spent if node in here.present and not names.isdisjoint(node.ingredients)}

    def _become(self, here: _Moment, made: Mapping[ObjectNode, Item | None]) -> Iterator[tuple[ObjectNode, Item]]:
        """Answer what a vessel has become, for a later unit of the script that still knows it as it was."""
        for node, item in here.present.items():
            if self._is_food(node) or not item.node.ingredients:
                continue
            for output, now in made.items():
                if now is None or output.label != node.label or now.node == item.node:
                    continue
                if _place(now.node) == _place(item.node) and set(now.node.ingredients) > set(item.node.ingredients):
                    yield item.node, now

    def _motion(self, motion: str, here: _Moment) -> str:
        acted = {node.label for node in here.present if self._is_food(node) and node not in here.scene.kept}
        if len(acted) != 1:
            return motion
        recast = self.casting.foods.get(next(iter(acted)))
        return recast.motions.get(motion, motion) if recast is not None else motion


def _place(node: ObjectNode) -> tuple[tuple[str, ...], str | None, str | None]:
    return (node.states, node.relation, node.container)
