"""From narrated actions to the draft of a subgraph, one action after another."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from foon_kg.food import motions, singular, tables
from foon_kg.food.lists import word_list
from foon_kg.food.words import words
from foon_kg.language.drafting.appliances import Appliances, is_appliance, source_of
from foon_kg.language.drafting.calibration import probability
from foon_kg.language.drafting.hands import brings_back, takes
from foon_kg.language.drafting.larder import Larder
from foon_kg.language.drafting.naming import rename, renamed
from foon_kg.language.drafting.nodes import NodeDrafter
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.drafting.referents import Referents
from foon_kg.language.drafting.scene import Scene
from foon_kg.language.drafting.told_states import done
from foon_kg.language.drafting.units import UnitDrafter
from foon_kg.language.drafting.verbs import Reading
from foon_kg.model import DISH_TYPES, Annotation, FunctionalUnit, Participant
from foon_kg.model.drafts import Draft, DraftUnit, LeftOut
from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place

_MOST_OBJECTS = 40
"""More objects than this are no one action of a cook."""

_NOT_IN_NAMES = re.compile(r"[^\w&'%/ -]+|_")
_ARTICLES = frozenset({"a", "an", "the", "some", "more", "of", "remaining", "other", "another", "your", "each"})
_ROOM = word_list("belongs to the room")
"""What belongs to the room and not to the dish; no FOON has it."""
_PREPARES_A_VESSEL = frozenset({"coat", "cover"})
_INTO = frozenset({"in", "into", "inside", "on", "onto"})
_ITSELF, _SEVERAL = word_list("speaks of the thing itself"), word_list("speaks of several")
_PUT_IT = re.compile(r"[\w-]+\s+(?:(?:it|them|this|that)\s+)?(?:in|into|inside|on|onto)\s", re.IGNORECASE)
_RELATIONS = re.compile(r"\b(?:attached to|covered with|covered|below|under|over|with|from|on|in)\b")


def draft(narration: Narration, precedents: FoonPrecedents, *, dish_type: str | None = None) -> Draft:
    """Return the draft of ``narration`` (its ``actions``) by the ``precedents`` of a FOON.

    Every action gives units, or is left out and told why; ``dish_type`` marks the last thing made as the goal. The same
    narration and FOON give the same draft.
    """
    drafter = _Drafter(precedents, narration)
    drafter.look_ahead(narration.actions)
    for action in narration.actions:
        drafted = drafter.rows(action)  # it may name anew what was told before
        drafter.told += drafted
    rows = [_calibrated(row, parsed=bool(narration.sentences)) for row in drafter.told]
    if dish_type in DISH_TYPES:
        _mark_goal(rows, dish_type, precedents)
    return Draft(narration.name, tuple(rows), narration.source, dish_type)


def _calibrated(row: DraftUnit | LeftOut, *, parsed: bool) -> DraftUnit | LeftOut:
    """Return ``row`` with a probability, in hundredths, in place of the shares that speak for it."""
    if isinstance(row, LeftOut):
        return row
    return replace(row, confidence=round(probability(row.confidence, parsed=parsed), 2))


class _Drafter:
    """Reads the names of actions, and hands what is meant on to the drafting of units."""

    def __init__(self, precedents: FoonPrecedents, narration: Narration) -> None:
        free = bool(narration.sentences)
        title, larder = _dish_of(narration.name), Larder.of(narration.ingredients)
        self.told: list[DraftUnit | LeftOut] = []
        self._precedents = precedents
        self._kitchen = precedents.kitchen
        self._scene = Scene(precedents.kitchen)
        self._free = free
        self._appliances = Appliances(precedents, free=free)
        self._units = UnitDrafter(NodeDrafter(precedents, self._scene), free=free)
        self._referents = Referents(precedents, self._scene, title if free else None, larder=larder)

    def look_ahead(self, actions: Sequence[NarratedAction]) -> None:
        """Note what will be done to each food, so that what will be chopped is not taken as chopped before."""
        for action in actions:
            reading = self._precedents.verbs.reading(action.verb)
            changing = [motion for motion in reading.motions if motions.opens(motion) or motions.heats(motion)]
            for mention in action.objects if changing else ():
                name = canonical(plain_name(mention.name))
                self._scene.coming.setdefault(name, changing[0])

    def rows(self, action: NarratedAction) -> Sequence[DraftUnit | LeftOut]:
        """Return the units of one action."""
        if (held := self._taken(action)) is not None:
            return (held,)
        reading = self._precedents.verbs.reading(action.verb)
        self._look_at_fixtures(action, reading)
        if not reading.motions and self._keeps_cold(action):
            action, reading = self._appliances.chilled(action)
        if not reading.motions:
            return (LeftOut(action.said, f"{reading.why}: left out", action.timing, settled=reading.idle),)
        if len(action.objects) > _MOST_OBJECTS:
            reason = f"{len(action.objects)} objects are no one action: left out"
            return (LeftOut(action.said, reason, action.timing),)
        plain = self._put_there(self._plain(action), reading)
        if self._are_of_the_room(plain.objects):
            reason = f"“{plain.objects[0].name}” belongs to the room and not to the dish: left out"
            return (LeftOut(action.said, reason, action.timing, settled=True),)
        drafted = tuple(row if self._changes(row) else _idle(action, row) for row in self._drafted(plain, reading))
        return drafted or (
            LeftOut(action.said, f"nobody says what “{action.verb}” is done to: left out", action.timing),
        )

    def _taken(self, action: NarratedAction) -> LeftOut | None:
        """Hold what an action takes; it gives a unit when somebody says where it is put, or does something with it."""
        if not (action.objects and takes(action.verb)):
            return None
        if self._free and self._precedents.verbs.reading(action.verb).motions:
            return None  # of recipes: a cake is taken out of the oven
        origin = self._known_as(plain_name(action.origin)) if action.origin else None
        names = [self._known_as(plain_name(one.name)) for one in action.objects]
        for name in names:
            self._scene.hands.take(name, origin)
        reason = f"{names[0]} is held until it is put somewhere: left out"
        return LeftOut(action.said, reason, action.timing, settled=True)

    def _look_at_fixtures(self, action: NarratedAction, reading: Reading) -> None:
        does = tables().motion(reading.likeliest).does
        for one in action.objects if not does.isdisjoint({"open", "close"}) else ():
            self._scene.hands.see(self._known_as(plain_name(one.name)), opened="open" in does)

    def _drafted(self, action: NarratedAction, reading: Reading) -> Sequence[DraftUnit]:
        """Return the units of an action whose names are plain; none where nobody says what it is done to."""
        action = self._referents.turned(self._brought_back(action))
        action, reading = self._appliances.used(replace(action, places=self._referents.places(action)), reading)
        action, doubts = self._with_referents(action)
        if not action.objects:
            return ()
        foods = tuple(one for one in action.objects if not self._kitchen.is_utensil(one.name))
        motion = self._motion(action, reading, prepares=not foods)
        doubts = (*doubts, *_doubts_of(action, reading, motion))
        if foods:
            action = replace(action, objects=foods)
        return self._units.units(action, motion, reading.confidence, doubts)

    def _motion(self, action: NarratedAction, reading: Reading, *, prepares: bool) -> str:
        """Return what the FOON calls the verb; a tray that one ``prepares`` is greased, though butter is spread."""
        if prepares and tables().motion(action.verb).does & _PREPARES_A_VESSEL:
            return action.verb
        return self._precedents.motion(reading.motions, action.objects[0].name)

    def _brought_back(self, action: NarratedAction) -> NarratedAction:
        """Return the action with the place where its object was, if it says no other and is brought back there."""
        if action.places or not brings_back(action.verb, action.said):
            return action
        homes = [self._scene.hands.place_of(one.name) for one in action.objects[:1]]
        return replace(action, places=tuple(Place("in", home) for home in homes if home is not None))

    def _with_referents(self, action: NarratedAction) -> tuple[NarratedAction, tuple[str, ...]]:
        """Return the action with the foods that its objects refer to, and the doubts of that.

        A food that is called by another name from here on has that name in what was told before, too.
        """
        objects, doubts = self._referents.objects(action)
        places = action.places
        for label, name in self._referents.called.items():
            self.told = renamed(self.told, label, name)
            rename(self._scene, label, name)
            objects = tuple(replace(one, name=name) if one.name == label else one for one in objects)
            places = tuple(replace(one, name=name) if one.name == label else one for one in places)
        self._referents.called.clear()
        return replace(action, objects=objects, places=places), doubts

    def _changes(self, row: DraftUnit) -> bool:
        """Whether anything is otherwise after a unit than before it, or a food is by itself no more."""
        before, after = (set(side) for side in (row.annotation.unit.input_nodes, row.annotation.unit.output_nodes))
        return not after <= before or any(self._kitchen.is_food(node) for node in before - after)

    def _keeps_cold(self, action: NarratedAction) -> bool:
        """Whether something is kept in what cools."""
        return any(source_of(self._known_as(plain_name(place.name))) == "cold" for place in action.places)

    def _are_of_the_room(self, objects: Sequence[Mention]) -> bool:
        return bool(objects) and all(self._is_of_the_room(one.name) for one in objects)

    def _is_of_the_room(self, name: str) -> bool:
        known = canonical(name)
        return known not in self._precedents.labels and not {known, known.split()[-1]}.isdisjoint(_ROOM)

    def _plain(self, action: NarratedAction) -> NarratedAction:
        """Return ``action`` with names that a table of units can hold, and with utensils where utensils belong."""
        mentions, instruments = self._mentions(action)
        objects, utensils = self._apart(mentions)
        if self._are_of_the_room(objects):
            objects = self._switched_at(action.places) or objects
        used = [name for name in utensils if self._precedents.is_tool(name)]
        around = [name for name in utensils if name not in used]
        return replace(
            action,
            objects=tuple(objects),
            places=self._plain_places(action, around),
            origin=_plain_or_none(action.origin),
            product=_plain_or_none(action.product),
            instruments=(*instruments, *used),
        )

    def _plain_places(self, action: NarratedAction, utensils: Sequence[str]) -> tuple[Place, ...]:
        """Return the places of an action by plain names, and ``utensils`` among its objects, which are places, too."""
        places = [Place(place.relation, self._place_known_as(plain_name(place.name))) for place in action.places]
        places += [Place("", name) for name in utensils]
        return tuple(place for place in places if place.name and not self._is_no_place(place))

    def _mentions(self, action: NarratedAction) -> tuple[list[Mention], list[str]]:
        """Return objects and instruments by plain names; a food among the instruments is an object.

        "Fill a bowl with water" brings the water.
        """
        named = [Mention(self._known_as(plain_name(one.name)), one.states) for one in action.objects]
        used = list(filter(None, (self._known_as(plain_name(one)) for one in action.instruments)))
        foods = [name for name in used if self._is_food(name)]
        objects = [one for one in named if one.name] + [Mention(name) for name in foods]
        return objects, [name for name in used if name not in foods]

    def _is_food(self, name: str) -> bool:
        return not (self._kitchen.is_utensil(name) or self._is_of_the_room(name))

    def _apart(self, mentions: list[Mention]) -> tuple[list[Mention], list[str]]:
        """Return the foods and the names of the utensils beside them; of utensils alone the first is the object."""
        utensils = [one.name for one in mentions if self._kitchen.is_utensil(one.name)]
        if len(utensils) < len(mentions):
            return [one for one in mentions if one.name not in utensils], utensils
        return mentions[:1], utensils[1:]

    def _is_no_place(self, place: Place) -> bool:
        """Whether nothing is brought there: "fold it over itself", "rinse under cold water"."""
        return place.name.lower() in _ITSELF or (place.relation == "under" and not self._kitchen.is_utensil(place.name))

    def _known_as(self, name: str) -> str:
        """Return a name as the kitchen knows it: the plate that a dirty plate is; else the name itself."""
        words = name.split()
        ends = (" ".join(words[place:]) for place in range(1, len(words)))
        if self._kitchen.is_utensil(name) or canonical(name) in self._precedents.labels:
            return self._precedents.appliance(name)
        listed = tables().foods.is_listed(singular(name))
        return name if listed else next((end for end in ends if self._kitchen.is_utensil(end)), name)

    def _place_known_as(self, name: str) -> str:
        """Return a place as the kitchen knows it: a hot pot is a dish, but what is put there comes into a pot."""
        parts = name.split()
        if parts and parts[0].lower() in tables().states and self._kitchen.is_utensil(parts[-1]):
            return parts[-1]
        return self._known_as(name)

    def _put_there(self, action: NarratedAction, reading: Reading) -> NarratedAction:
        """Return an action of a table whose only noun is where a thing is put: "put it on the shelf"."""
        _, _, particle = action.verb.replace("-", " ").partition(" ")
        objects = action.objects
        if self._free or len(objects) != 1 or action.places or particle not in _INTO:
            return action
        if _PUT_IT.match(action.said) is None:
            return action
        row = tables().utensil(objects[0].name)
        if row is None or row.role not in {"vessel", "place"} or not motions.transfers(reading.motions[0]):
            return action
        held = self._scene.hands.latest()
        named = () if held is None else (Mention(held),)
        return replace(action, objects=named, places=(Place(particle, objects[0].name),))

    def _switched_at(self, places: Sequence[Place]) -> list[Mention]:
        """Return the appliances that are meant where "the heat on the oven" is turned off."""
        names = [self._known_as(plain_name(place.name)) for place in places]
        return [Mention(name) for name in names if name and is_appliance(name)]


def _idle(action: NarratedAction, row: DraftUnit) -> LeftOut:
    """Return why a unit is left out that changes nothing, as far as anybody knows."""
    unit, name = row.annotation.unit, action.objects[0].name if action.objects else ""
    node = next((one for one in unit.output_nodes if canonical(one.label) == canonical(name)), None)
    told = done(action.verb)
    reason, settled = f"nothing is said that {unit.motion} would change", True
    if node is not None and motions.transfers(unit.motion):
        known = f"{node.label} is {node.relation} the {node.container} already"
        reason = known if node.container else f"nobody says where {node.label} comes from or goes to"
        settled = bool(node.container) or tables().utensil(node.label) is not None
    elif node is not None and told in node.states:
        reason = f"{node.label} is {told} already"
    return LeftOut(action.said, f"{reason}: left out", action.timing, settled=settled)


def _doubts_of(action: NarratedAction, reading: Reading, motion: str) -> Iterator[str]:
    """Yield why ``motion`` may be another one than the verb of ``action`` says, as it was read."""
    taken = f"“{action.verb}” taken as {motion}"
    if len(reading.motions) > 1 and reading.motions[0] != motion:
        yield f"{taken}, as the FOON does it with {action.objects[0].name}"
    elif canonical(motion) != canonical(action.verb) and reading.confidence < 1 and not reading.why:
        yield taken
    if reading.why:
        yield reading.why


def _dish_of(name: str) -> str:
    """Return the dish in the name of a recipe, the bread of "easy banana bread 2"; ``""`` where there is none."""
    last = next((word for word in reversed(words(name)) if len(word) > 1), "")
    return last if last in tables().dishes else ""


def plain_name(name: str) -> str:
    """Return ``name`` without what no label can have: brackets, marks, articles, and words that begin a place.

    >>> plain_name("the [red] onion; DROP")
    'red onion DROP'
    """
    words = _RELATIONS.sub(" ", _NOT_IN_NAMES.sub(" ", name)).split()
    if name.lower() in _SEVERAL:
        return name  # spread each with butter
    return " ".join(word for word in words if word.lower() not in _ARTICLES)[:80].strip()


def _plain_or_none(name: str | None) -> str | None:
    return plain_name(name or "") or None


def _mark_goal(rows: list[DraftUnit | LeftOut], dish_type: str, precedents: FoonPrecedents) -> None:
    """Mark the last food that is made of several, else the last that is made; it stands last in its unit."""
    made = list(_foods_made(rows, precedents))
    several = [one for one in made if len(one[2].node.ingredients) > 1]
    for place, row, goal in (several or made)[-1:]:
        unit = row.annotation.unit
        node = replace(goal.node, ingredients=goal.node.ingredients or (goal.node.label,))
        outputs = (*(one for one in unit.outputs if one is not goal), Participant(node, dish_type=dish_type))
        marked = FunctionalUnit(unit.inputs, unit.motion, outputs, unit.accepts_any)
        rows[place] = replace(row, annotation=Annotation(marked, row.annotation.timing))


def _foods_made(
    rows: Sequence[DraftUnit | LeftOut], precedents: FoonPrecedents
) -> Iterator[tuple[int, DraftUnit, Participant]]:
    """Yield the food with most in it that comes out of each unit, with the unit and its place among the rows."""
    for place, row in enumerate(rows):
        if isinstance(row, DraftUnit):
            outputs = row.annotation.unit.outputs
            foods = [one for one in outputs if not precedents.kitchen.is_utensil(one.node.label)]
            if foods:
                yield place, row, max(foods, key=lambda one: len(one.node.ingredients))
