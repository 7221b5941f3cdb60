"""Integration as re-execution: run a task tree again with other foods in it (paper, algorithm 4).

A script (units in their order) is executed step by step. Every object node of the script stands for a *current*
node, or for nothing any more: a leaf food is recast as the food that the recipe wants, or dropped; what a unit
outputs holds only what really went in; a unit whose foods are all gone does nothing, and what it would have
moved stays where it is. Foods may be added at units that accept any number, and flow from there with whatever
holds them. Removing, renaming and adding are therefore consistent by construction, up to the goal.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property

from foon_kg import motions
from foon_kg.model import ObjectNode
from foon_kg.script import EMPTY, Atom, Casting, Item, Replayed, Scene, Script, Step, changed, emptied, spot_of

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


class _Moment:
    """A scene while it is performed: which of its inputs are there, and what they bring."""

    def __init__(
        self, scene: Scene, present: Mapping[ObjectNode, Item], gone: frozenset[ObjectNode], added: tuple[Item, ...]
    ) -> None:
        self.scene = scene
        self.present = present
        self.gone = gone
        self.added = added

    @cached_property
    def atoms(self) -> frozenset[Atom]:
        """All the foods in what is there."""
        return frozenset().union(*(item.atoms for item in self.present.values()), *(i.atoms for i in self.added))

    @cached_property
    def visible(self) -> frozenset[str]:
        """The names that the inputs say now: only these can be named in what comes of them."""
        items = (*self.present.values(), *self.added)
        return frozenset(name for item in items for name in (item.node.label, *item.node.ingredients))

    def of_label(self, label: str) -> list[Item]:
        return [item for node, item in self.present.items() if node.label == label]


class Stage:
    """What stands in the kitchen while a script is performed."""

    def __init__(self, casting: Casting, script: Script) -> None:
        self.casting = casting
        self.script = script
        self.kitchen = script.kitchen
        self.taken_alone = script.taken_alone
        self.items: dict[ObjectNode, Item | None] = {}
        self.leaf_foods: set[str] = set()
        self.used: set[ObjectNode] = set()
        self.later: dict[ObjectNode, Item] = {}

    def copy(self) -> Stage:
        """Answer a stage on which everything stands as it does here."""
        other = Stage(self.casting, self.script)
        other.items, other.leaf_foods = self.items.copy(), self.leaf_foods.copy()
        other.used, other.later = self.used.copy(), self.later.copy()
        return other

    def perform(self, place: int, scene: Scene, added: tuple[Item, ...]) -> Step | None:
        """Execute one unit; answer what happens, or ``None`` where nothing does."""
        present: dict[ObjectNode, Item] = {}
        gone: list[ObjectNode] = []
        for node in scene.inputs:
            if self._is_used(node):
                continue
            item = self._fetch(node, scene.beside)
            if item is None:
                gone.append(node)
            else:
                present[node] = item
        here = _Moment(scene, present, frozenset(gone), added)
        if not self._happens(here):
            self._pass_through(here)
            return None
        made = self._make(here)
        self.used.update(scene.taken & present.keys())
        return self._step(place, here, made)

    def _is_food(self, node: ObjectNode) -> bool:
        return not self.kitchen.is_utensil(node.label)

    # ---- what is there

    def _is_used(self, node: ObjectNode) -> bool:
        """Say whether a food went elsewhere before: it is taken once (sense, S1 and S4), and is now in what took it."""
        if node in self.used:
            return True
        return self._is_food(node) and node not in self.items and node.label in self.leaf_foods

    def _fetch(self, node: ObjectNode, beside: frozenset[str]) -> Item | None:
        if node in self.items:
            item = self.items[node]
            while item is not None and item.node in self.later and self.later[item.node].node != item.node:
                item = self.later[item.node]
            return item
        item = self._leaf(node, beside)
        self.items[node] = item
        return item

    def _leaf(self, node: ObjectNode, beside: frozenset[str]) -> Item | None:
        if not self._is_food(node):
            return self._leaf_vessel(node, beside)
        inside = self._atoms_in(node)
        names = tuple(now for _, now in inside)
        self.leaf_foods.add(node.label)
        recast = self.casting.foods.get(node.label)
        if self._name_now(node.label) is None:
            return None
        made_apart = recast is not None and node in recast.ready
        current = recast.ready[node] if recast is not None and made_apart else self._recast(node, names)
        return Item(current, inside | {(node.label, current.label)})

    def _leaf_vessel(self, node: ObjectNode, beside: frozenset[str]) -> Item | None:
        if not node.ingredients:
            return Item(node)
        roles = (self.casting.foods.get(name) for name in node.ingredients)
        left = any(role is not None and role.comes_from_elsewhere(node) for role in roles)
        atoms = frozenset() if left else self._atoms_in(node)
        if self.kitchen.is_storage(node.label):
            return self._holding(node, atoms) if atoms else None
        if not set(self.kitchen.foods_in(node)) <= beside or not atoms:
            return Item(emptied(node))  # nobody filled it, so it is taken empty
        return self._holding(node, atoms)

    def _holding(self, node: ObjectNode, atoms: frozenset[Atom]) -> Item:
        return Item(changed(node, ingredients=tuple(now for _, now in atoms)), atoms)

    def _atoms_in(self, node: ObjectNode) -> frozenset[Atom]:
        inside = ((name, self._name_now(name)) for name in node.ingredients)
        return frozenset((name, now) for name, now in inside if now is not None)

    def _name_now(self, name: str) -> str | None:
        recast = self.casting.foods.get(name, _AS_IT_IS)
        if recast is None:
            return None
        return name if isinstance(recast, _AsItIs) else recast.label

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
            return not (here.gone and motions.transfers(scene.known.unit.motion) and self._all_stay(here))
        there = {node: here.present[node] for node in scene.holders if node in here.present}
        if motions.transfers(scene.known.unit.motion):
            kept = {node.label for node in scene.outputs if node.ingredients}
            givers = [item for node, item in there.items() if node.label not in kept]
            if givers and not any(item.atoms for item in givers):
                return False  # a cup out of which nothing comes
        return not scene.holders or any(item.atoms for item in there.values())

    def _all_stay(self, here: _Moment) -> bool:
        """Say whether everything that is left of what the unit moves is there before and after, in its place."""
        goal = self.casting.goal
        if goal in here.scene.outputs and not any(node.label == goal.label for node in here.scene.inputs):
            return False  # with what is left the dish is made, and gets its name
        places = {(node.label, node.container) for node in here.scene.outputs}
        left = [node for node in here.scene.acted if node in here.present]
        return all((node.label, node.container) in places for node in left)

    def _pass_through(self, here: _Moment) -> None:
        for node in here.scene.outputs:
            names = {node.label} if self._is_food(node) else set(node.ingredients)
            if names and names <= self.casting.cut:
                continue  # at hand: asked for later, it is a leaf
            same = here.of_label(node.label)
            self.items.setdefault(node, None)
            if same:
                away = spot_of(same[0].node) != spot_of(node) and not self._is_food(node)
                self.items[node] = (self._standing(node) if away else None) or same[0]

    def _standing(self, node: ObjectNode) -> Item | None:
        """Answer the vessel that stands, empty, where the script has ``node`` with something in it; the last one."""
        items = (item for item in reversed(self.items.values()) if item is not None and not item.atoms)
        return next((i for i in items if i.node.label == node.label and spot_of(i.node) == spot_of(node)), None)

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
        if not turned and self.kitchen.foods_in(node):
            in_foods = {now for name, _ in own for _, now in foods[name].atoms}
            named |= {now for name, now in brought if not name and now in here.visible and now not in in_foods}
        if not named:
            return Item(emptied(node))
        if node in self.taken_alone and self.kitchen.foods_in(node):
            named |= {now for name, now in (*inside, *kept) if not name or now in self.casting.carried}
        return Item(changed(node, ingredients=named), frozenset(inside | kept))

    def _known(self, name: str, here: _Moment) -> bool:
        """Say whether ``name`` is a food of the script by itself, here or in the kitchen: no name of a mixture."""
        return name in here.scene.written or name in self.leaf_foods or name in self.casting.foods

    # ---- telling it

    def _step(self, place: int, here: _Moment, made: Mapping[ObjectNode, Item | None]) -> Step | None:
        known = here.scene.known
        untouched = self._left_behind(here, made)
        outputs = self._put_down(here, made, untouched)
        self._remember(here, made)
        added = tuple(item.node for item in here.added)
        inputs = [item.node for node, item in here.present.items() if node not in untouched]
        inputs = list(dict.fromkeys([*inputs, *added]))
        if set(outputs) <= set(inputs):
            return None
        there = {**here.present, **{node: item for node, item in made.items() if item is not None}}
        participants = (*known.unit.inputs, *known.unit.outputs)
        moving = {there[p.node].node for p in participants if p.moving and p.node in there}
        motion = self._motion(known.unit.motion, here)
        strained = any(self._is_strange(node, item) for node, item in here.present.items() if node not in untouched)
        return Step(
            place, known, tuple(inputs), motion, tuple(outputs), added, frozenset(moving.union(added)), strained
        )

    def _is_strange(self, node: ObjectNode, item: Item) -> bool:
        states = self._recast(node, ()).states
        return bool((set(states) ^ set(item.node.states)) - {EMPTY}) or spot_of(node) != spot_of(item.node)

    def _put_down(
        self, here: _Moment, made: Mapping[ObjectNode, Item | None], untouched: set[ObjectNode]
    ) -> list[ObjectNode]:
        """Keep what every output has become; answer those that the step shows."""
        shown = []
        for node, item in made.items():
            same = None
            if not self._is_food(node) and not node.ingredients:
                same = next((other for other in here.present if other in untouched and other.label == node.label), None)
            self.items[node] = item if same is None else here.present[same]
            self.used.discard(node)
            if item is not None and same is None:
                shown.append(item.node)
                self.later.pop(item.node, None)  # it is there again as it was
        return list(dict.fromkeys(shown))

    def _left_behind(self, here: _Moment, made: Mapping[ObjectNode, Item | None]) -> set[ObjectNode]:
        """Vessels of the script that bring nothing any more and take nothing: they are not touched."""
        receiving = {node.label for node, item in made.items() if item is not None and item.atoms}
        return {
            node
            for node, item in here.present.items()
            if self.kitchen.foods_in(node)
            and not self._is_food(node)
            and not item.atoms
            and node.label not in receiving
        }

    def _remember(self, here: _Moment, made: Mapping[ObjectNode, Item | None]) -> None:
        """Keep what a vessel has become, for a later unit of the script that still knows it as it was."""
        for node, item in here.present.items():
            if self._is_food(node) or not item.node.ingredients:
                continue
            for output, now in made.items():
                if now is None or output.label != node.label or now.node == item.node:
                    continue
                if _place(now.node) == _place(item.node) and set(now.node.ingredients) > set(item.node.ingredients):
                    self.later[item.node] = now

    def _motion(self, motion: str, here: _Moment) -> str:
        acted = {node.label for node in here.present if self._is_food(node) and node not in here.scene.kept}
        if len(acted) != 1:
            return motion
        recast = self.casting.foods.get(next(iter(acted)))
        return recast.motions.get(motion, motion) if recast is not None else motion


class _AsItIs:
    """The mark of a label that the casting does not name."""


_AS_IT_IS = _AsItIs()


def _place(node: ObjectNode) -> tuple[tuple[str, ...], str | None, str | None]:
    return (node.states, node.relation, node.container)
