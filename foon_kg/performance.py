"""What comes of one unit of a script: which foods and vessels it finds, whether it happens, what it makes of them.

It turns on nothing but what the unit finds and who plays in it, and so is worked out once for all replays in which it
finds the same (:class:`foon_kg.script.Repertoire`).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from foon_kg import motions
from foon_kg.kitchen import Kitchen
from foon_kg.model import ObjectNode
from foon_kg.moment import SPENT, UNSEEN, USED, Found, Larder, Moment
from foon_kg.script import EMPTY, Atom, Casting, Item, Performance, Scene, Step, changed, emptied, spot_of


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
        self.larder = Larder(scene, casting, kitchen, leaf_foods)
        self.taken_alone = alone

    def perform(self, found: Sequence[Found], added: tuple[Item, ...]) -> Performance:
        """Answer what comes of the unit where it finds ``found``, one for each of its inputs, and ``added`` join."""
        present: dict[ObjectNode, Item] = {}
        gone: list[ObjectNode] = []
        fetched: list[tuple[ObjectNode, Item | None]] = []
        for node, there in zip(self.scene.inputs, found, strict=True):
            if there is USED or (there is UNSEEN and self._is_food(node) and node.label in self.larder.leaf_foods):
                continue
            if there is SPENT:
                if not self._is_food(node):
                    present[node] = Item(emptied(node))
                continue
            item = there if isinstance(there, Item) else None
            if there is UNSEEN:
                item = self.larder.leaf(node)
                fetched.append((node, item))
            if item is None:
                gone.append(node)
            else:
                present[node] = item
        spent = frozenset(node for node, there in zip(self.scene.inputs, found, strict=True) if there is SPENT)
        here = Moment(self.scene, present, frozenset(gone), added, spent)
        labels = tuple(node.label for node, _ in fetched if self._is_food(node))
        if not self._happens(here):
            return Performance(tuple(fetched), labels, happens=False, passed=tuple(self._passed(here)))
        return self._happened(here, tuple(fetched), labels)

    def _happened(
        self, here: Moment, fetched: tuple[tuple[ObjectNode, Item | None], ...], labels: tuple[str, ...]
    ) -> Performance:
        made = self._make(here)
        untouched = here.left_behind(made) - here.poured_out()
        stays = {node: here.stays(node, untouched) for node in made}
        shown = [item.node for node, item in made.items() if item is not None and stays[node] is None]
        return Performance(
            fetched,
            labels,
            happens=True,
            used=self.scene.taken & here.present.keys(),
            made=tuple((node, stays[node] or item) for node, item in made.items()),
            renewed=tuple(shown),
            become=tuple(here.become(made)),
            step=self._step(here, made, untouched, tuple(dict.fromkeys(shown))),
        )

    def _is_food(self, node: ObjectNode) -> bool:
        return node in self.scene.foods

    # ---- does it happen

    def _happens(self, here: Moment) -> bool:
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

    def _only_brought(self, here: Moment) -> bool:
        """Say whether the unit did no more than bring what is gone: pepper that was ground over the beans."""
        motion = here.scene.known.unit.motion
        if motions.mixes(motion) or motions.heats(motion) or not self._all_stay(here):
            return False
        states = {(node.label, node.states) for node in here.scene.outputs}
        left = (node for node in here.scene.acted if node in here.present)
        return motions.transfers(motion) or all((node.label, node.states) in states for node in left)

    def _all_stay(self, here: Moment) -> bool:
        """Say whether everything that is left of what the unit moves is there before and after, in its place."""
        goal = self.casting.goal
        if goal in here.scene.outputs and not any(node.label == goal.label for node in here.scene.inputs):
            return False  # with what is left the dish is made, and gets its name
        places = {(node.label, node.container) for node in here.scene.outputs}
        left = [node for node in here.scene.acted if node in here.present]
        return all((node.label, node.container) in places for node in left)

    def _passed(self, here: Moment) -> Iterator[tuple[ObjectNode, Item | None, bool]]:
        for node in here.scene.outputs:
            names = {node.label} if self._is_food(node) else set(node.ingredients)
            if names and names <= self.casting.cut:
                continue  # at hand: asked for later, it is a leaf
            same = next(iter(here.of_label(node.label)), None)
            away = same is not None and spot_of(same.node) != spot_of(node) and not self._is_food(node)
            yield node, same, away

    # ---- what comes of it

    def _make(self, here: Moment) -> dict[ObjectNode, Item | None]:
        outputs = here.scene.outputs
        foods = [node for node in outputs if self._is_food(node)]
        made = {node: self._food(node, here) for node in foods}
        alive = {node.label: item for node, item in made.items() if item is not None}
        made |= {node: self._vessel(node, here, alive) for node in outputs if not self._is_food(node)}
        return {node: made[node] for node in outputs}

    def _food(self, node: ObjectNode, here: Moment) -> Item | None:
        same = here.of_label(node.label)
        if node.label in self.larder.leaf_foods or same or self._was_input(node.label, here):
            return self._same_food(node, here, same)
        sources = self._sources(node, here)
        if node.label in here.scene.springs:
            return Item(changed(node, ingredients=()), frozenset({(node.label, node.label)}))
        if not sources:
            return None
        atoms = frozenset().union(*(item.atoms for item in sources))
        current = changed(node, ingredients=self._listed(node, atoms, here))
        return Item(current, atoms | {(node.label, node.label)})

    def _was_input(self, label: str, here: Moment) -> bool:
        return any(node.label == label for node in here.gone)

    def _same_food(self, node: ObjectNode, here: Moment, same: Sequence[Item]) -> Item | None:
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
        current = self.larder.recast(node, listed)
        if current.label not in names:
            current = changed(current, label=min(names))
        if node == self.casting.goal and current.label != node.label:  # the dish keeps its name
            current = changed(current, label=node.label, ingredients={*current.ingredients, current.label})
        return Item(current, atoms | own)

    def _is_mixed(self, node: ObjectNode, here: Moment) -> bool:
        """Say whether a food takes others in here: it names some that it did not name before."""
        before = {name for n in here.present if n.label == node.label for name in n.ingredients}
        return not set(node.ingredients) <= before

    def _sources(self, node: ObjectNode, here: Moment) -> list[Item]:
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

    def _listed(self, node: ObjectNode, atoms: frozenset[Atom], here: Moment) -> set[str]:
        """Answer the ingredients that a food names now: those it named, those that joined, those it must carry."""
        names = self._named(node, atoms, here) | {now for name, now in atoms if not name}
        names -= {self.larder.name_now(node.label) or node.label}
        return names | {now for _, now in atoms if now in self.casting.carried}

    def _named(self, node: ObjectNode, atoms: frozenset[Atom], here: Moment) -> set[str]:
        """Answer the names that ``node`` said and still can say: what inputs say, or what only the script knew of."""
        visible, written = here.visible, here.scene.written
        known = {now for name, now in atoms if name in node.ingredients and (now in visible or name not in written)}
        known |= {now for name, now in atoms if not name and now in node.ingredients and now in visible}
        return known | {name for name in node.ingredients if name in visible and self.kitchen.is_utensil(name)}

    def _vessel(self, node: ObjectNode, here: Moment, foods: Mapping[str, Item]) -> Item | None:
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

    def _known(self, name: str, here: Moment) -> bool:
        """Say whether ``name`` is a food of the script by itself, here or in the kitchen: no name of a mixture."""
        return name in here.scene.written or name in self.larder.leaf_foods or name in self.casting.foods

    # ---- telling it

    def _step(
        self,
        here: Moment,
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

    def _motion(self, motion: str, here: Moment) -> str:
        acted = {node.label for node in here.present if self._is_food(node) and node not in here.scene.kept}
        if len(acted) != 1:
            return motion
        recast = self.casting.foods.get(next(iter(acted)))
        return recast.motions.get(motion, motion) if recast is not None else motion
