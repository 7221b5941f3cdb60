"""``--kitchen FILE``: what is at hand, as people write it down.

Plain text, one thing a line (``onion`` · ``onion, chopped`` · ``chopped onion`` · ``egg in carton`` · ``knife`` ·
``2 cutting boards`` · ``onion, chopped on cutting board`` · ``pot {cooked rice}`` · ``oven, preheated``; ``#`` begins a
comment), or JSON: a list of such texts, of object nodes as a plan result has them, or of recipe ingredients; or
``{"utensils": […], "foods": […]}`` with one of the two or both. What that means is said in
:mod:`foon_kg.plans.stock`. Nothing is decided silently: what was not understood as it stands comes with a note.
"""

from __future__ import annotations

import difflib
import json
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain, islice
from pathlib import Path

from foon_kg.food import singular, tables
from foon_kg.model import ObjectNode
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.json_fields import Fields
from foon_kg.model.json_text import json_value
from foon_kg.model.names import canonical
from foon_kg.model.regular_files import read_text
from foon_kg.planning.recipes import IngredientWords
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.stock import StockedKitchen
from foon_kg.similarity import food_similarity

_PLACED = re.compile(
    r"^(?P<thing>.+?),?\s+(?P<relation>in|on|under)\s+(?:(?:an?|the)\s+)?(?P<place>[^,]+)$", re.IGNORECASE
)
_FILLED = re.compile(r"^(?P<vessel>[^{}]+?)\s*\{(?P<foods>[^{}]+)\}(?P<rest>.*)$")
_NUMBERED = re.compile(r"^(?P<number>[1-9][0-9]{0,2})\s+(?P<thing>.+)$")
_BULLET = re.compile(r"^[-*•]\s+")
_CLOSE = 3
"""How many names are proposed for one that the FOON does not know."""

_SPELLED_ALIKE = 0.75
"""From how much likeness on (0 to 1, of letters) a name may be a slip of another."""

_ALIKE = 0.3
"""From how much confidence on a food is worth to be proposed: where none is spelled alike, one that is like it."""

_FIELDS = ("foods", "utensils")
LONGEST_THING = 300
"""Characters of one thing: to find out what a longer text may mean takes longer than anybody waits."""

MOST_THINGS = 1_000

_HINT = "Write one thing a line, as in “onion, chopped”, or JSON with “utensils”, “foods” or both."


@dataclass(frozen=True)
class ReadKitchen:
    """What is at hand, and what had to be decided to read it, one sentence a note.

    >>> from foon_kg import Foon
    >>> from foon_kg.foon.demo import demo_folder
    >>> read = Foon.from_files(demo_folder()).kitchen(foods=["chopped onion", "olive oil", "knife"])
    >>> read.kitchen.food_names, read.kitchen.utensils_named[0].label, read.notes
    (('olive oil', 'onion'), 'knife', ())
    """

    kitchen: StockedKitchen
    notes: tuple[str, ...]


def read_kitchen(path: Path, words: IngredientWords, more: Sequence[Entry] = ()) -> ReadKitchen:
    """Return the kitchen of a file at ``path`` that names things at hand; ``more`` are there beside these.

    ``words`` are the FOON's, and the kitchen in which all that is not named stands. Raises
    :class:`~foon_kg.model.errors.ReadError` with the file and the line (in JSON the field) that cannot be read, and for
    a file that names nothing; :class:`~foon_kg.model.errors.UsageError` where there is no such file.
    """
    text = _text_of(path)
    is_json = path.suffix.lower() == ".json" or text.lstrip()[:1] in {"[", "{"}
    entries = list(islice(_json_entries(path, text) if is_json else _lines(path, text), MOST_THINGS + 1))
    if len(entries) > MOST_THINGS:
        raise ReadError(f"{path}: it names more than {MOST_THINGS} things", hint="Name what one kitchen has.")
    if not entries:
        raise ReadError(f"{path}: it names nothing", hint=_HINT)
    return kitchen_with([*entries, *more], words)


def kitchen_with(entries: Sequence[Entry], words: IngredientWords) -> ReadKitchen:
    """Return the kitchen in which just ``entries`` are at hand; ``words`` as for :func:`read_kitchen`."""
    reader = ThingReader(words)
    entries = [reader.numbered(entry) for entry in entries]
    read = [reader.read(entry) for entry in entries]
    said: dict[str, set[str]] = {kind: set() for kind in (*_FIELDS, "")}
    for entry, (thing, _) in zip(entries, read, strict=True):
        said[entry.kind].add(thing.label)
    kitchen = words.kitchen.with_foods(said["foods"]).with_utensils(said["utensils"])
    things = [thing for thing, _ in read]
    numbers = _numbers(zip(things, (entry.number for entry in entries), strict=True), kitchen)
    inside = _not_placed(chain.from_iterable(map(reader.held, entries, things)), things)
    return ReadKitchen(StockedKitchen.of(kitchen, things, numbers, inside), tuple(n for _, ns in read for n in ns))


def _not_placed(held: Iterable[ObjectNode], things: Sequence[ObjectNode]) -> list[ObjectNode]:
    """Return those of the foods ``held`` by vessels that ``things`` do not name as being there, too."""
    placed = {(singular(thing.label), thing.container) for thing in things}
    return [food for food in held if (singular(food.label), food.container) not in placed]


def _numbers(things: Iterable[tuple[ObjectNode, int | None]], kitchen: Kitchen) -> dict[str, int]:
    """Return how many there are of each utensil that is numbered; ``things`` come with their numbers.

    Of what is named by its name alone, without a number, there are as many as needed; what more is said of is one.
    ``kitchen`` knows utensils.
    """
    said: dict[str, list[tuple[ObjectNode, int | None]]] = {}
    for thing, number in things:
        if kitchen.is_utensil(thing.label):
            said.setdefault(singular(thing.label), []).append((thing, number))
    return {name: sum(number or 1 for _, number in of_it) for name, of_it in said.items() if _are_numbered(of_it)}


def _are_numbered(of_it: Sequence[tuple[ObjectNode, int | None]]) -> bool:
    plain = any(number is None and thing == ObjectNode(thing.label) for thing, number in of_it)
    return not plain and any(number is not None for _, number in of_it)


@dataclass(frozen=True)
class Entry:
    """One thing as it stands in a file: ``where``, under which field (``kind``, of JSON), as text or as a node.

    ``number``: how many there are, where a JSON node says so; text says it itself.
    """

    where: str
    value: str | ObjectNode
    kind: str = ""
    number: int | None = None


@dataclass(frozen=True)
class ThingReader:
    """Reads things in the words of one FOON."""

    words: IngredientWords

    def numbered(self, entry: Entry) -> Entry:
        """Return an entry with how many there are of it: ``2 cutting boards``; of a food a number says nothing."""
        counted = _NUMBERED.match(entry.value) if isinstance(entry.value, str) else None
        if counted is None or not self.words.kitchen.is_utensil(self._spoken(counted["thing"])[0].label):
            return entry
        return replace(entry, value=counted["thing"], number=int(counted["number"]))

    def read(self, entry: Entry) -> tuple[ObjectNode, tuple[str, ...]]:
        """Return the thing that an entry names, and notes on what was decided or is not known."""
        if isinstance(entry.value, ObjectNode):
            thing, notes = self._known(entry.value), list[str]()
        else:
            thing, notes = self._spoken(entry.value)
        notes += self._unknown(thing, entry.kind)
        return thing, tuple(f"{entry.where}: {note}" for note in notes)

    def held(self, entry: Entry, vessel: ObjectNode) -> list[ObjectNode]:
        """Return the foods in a ``vessel``, as an ``entry`` names it; what is sold in it, or is always there, is none.

        A text says their states, too: ``pot {cooked rice}``.
        """
        kitchen = self.words.kitchen
        if not kitchen.is_utensil(vessel.label) or kitchen.is_storage(vessel.label):
            return []
        filled = _FILLED.match(entry.value) if isinstance(entry.value, str) else None
        foods = map(ObjectNode, vessel.ingredients) if filled is None else (food for food, _ in self._contents(filled))
        own = (food for food in foods if not kitchen.is_utensil(food.label) and not kitchen.is_free(food.label))
        return [replace(food, relation="in", container=vessel.label) for food in own]

    def _contents(self, filled: re.Match[str]) -> list[tuple[ObjectNode, list[str]]]:
        """Return each of the foods between the braces of a text, with the notes on it."""
        return [self._unplaced(name) for name in filter(None, map(str.strip, filled["foods"].split(",")))]

    def _spoken(self, text: str) -> tuple[ObjectNode, list[str]]:
        filled = _FILLED.match(text)
        if filled is not None:
            thing, notes = self._spoken(f"{filled['vessel']}{filled['rest']}")
            for food, said in self._contents(filled):
                notes += (*said, *self._unknown(food))
                thing = replace(thing, ingredients=(*thing.ingredients, food.label))
            return thing, notes
        placed = _PLACED.match(text)
        place = self._utensil(placed["place"]) if placed else None
        if placed is None or place is None:
            return self._unplaced(text)
        thing, notes = self._unplaced(placed["thing"])
        return replace(thing, relation=placed["relation"].lower(), container=place), notes

    def _unplaced(self, text: str) -> tuple[ObjectNode, list[str]]:
        utensil = self._utensil_in_words(text)
        if utensil is not None:
            return utensil, []
        food, states, rest = self.words.parts(text)
        if not rest:
            return ObjectNode(food, tuple(states)), []
        said = " ".join(rest)
        if "," not in text or said[0].isnumeric():
            return ObjectNode(food, tuple(states)), [f"“{text}” is read as {food}: “{said}” is left out"]
        near = _listed(difflib.get_close_matches(said, sorted(self.words.states), n=_CLOSE))
        return ObjectNode(food, (*states, said)), [f"this FOON knows no state “{said}”{near}; it is kept as it stands"]

    def _utensil_in_words(self, text: str) -> ObjectNode | None:
        """Return ``oven, preheated`` and ``preheated oven``; other words before a utensil make it another thing."""
        name, comma, after = (part.strip() for part in text.partition(","))
        if (utensil := self._utensil(name)) is not None:
            states = tuple(" ".join(state.lower().split()) for state in after.split(",") if state.strip())
            return ObjectNode(utensil, states)
        before, _, last = name.partition(" ")
        known = self.words.kitchen.rest_states | self.words.kitchen.running_states
        if not comma and before.lower() in known and (utensil := self._utensil(last)) is not None:
            return ObjectNode(utensil, (before.lower(),))
        return None

    def _known(self, node: ObjectNode) -> ObjectNode:
        """Return ``node`` under the name that the FOON has for it."""
        return replace(node, label=self._utensil(node.label) or self.words.label(node.label))

    def _utensil(self, name: str) -> str | None:
        """Return the utensil that is called ``name``, be it in the plural."""
        folded = " ".join(name.lower().split())
        row = tables().utensil(name)
        if not self.words.kitchen.is_utensil(folded):
            return None
        return folded if row is None else row.written

    def _unknown(self, thing: ObjectNode, kind: str = "") -> Iterator[str]:
        """Yield the note that the FOON does not know ``thing``, if so; ``kind`` says under which heading it stands."""
        may_be_food = kind != "utensils"
        if self.words.kitchen.is_utensil(thing.label) or (may_be_food and canonical(thing.label) in self._foods):
            return
        what = "food" if may_be_food else "utensil"
        near = self._near(thing.label, self._labels if may_be_food else frozenset())
        yield f"this FOON knows no {what} “{thing.label}”{_listed(near)}; it counts as a {what} at hand"

    def _near(self, name: str, foods: frozenset[str]) -> list[str]:
        """Return the utensils and ``foods`` that are spelled like ``name``, else the foods that are like it."""
        known = sorted({row.written for row in tables().utensils.values()} | foods)
        spelled = difflib.get_close_matches(name.lower(), known, n=_CLOSE, cutoff=_SPELLED_ALIKE)
        if spelled or not foods:
            return spelled
        alike = food_similarity().nearest(name, sorted(foods), limit=_CLOSE)
        return [found.name for found in alike if found.confidence >= _ALIKE]

    @cached_property
    def _labels(self) -> frozenset[str]:
        return frozenset(row.label for row in self.words.vocabulary.foods)

    @cached_property
    def _foods(self) -> frozenset[str]:
        return frozenset(map(canonical, self._labels))


def _listed(near: list[str]) -> str:
    return f" (near it: {', '.join(near)})" if near else ""


def _text_of(path: Path) -> str:
    if not path.exists():
        raise UsageError(f"there is no file {path}", hint="--kitchen names a file of things at hand.")
    try:
        return read_text(path)
    except UnicodeDecodeError as error:
        raise ReadError(f"{path}: not UTF-8 text (byte {error.start})", hint="Save it as UTF-8.") from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="--kitchen names a file that can be read.") from error


def _lines(path: Path, text: str) -> Iterator[Entry]:
    for number, line in enumerate(text.splitlines(), 1):
        thing = _BULLET.sub("", line.partition("#")[0].strip())
        if thing:
            yield Entry(f"{path}:{number}", _named(thing, f"{path}:{number}"))


def _json_entries(path: Path, text: str) -> Iterator[Entry]:
    try:
        value = json_value(text)
    except json.JSONDecodeError as error:
        raise ReadError(f"{path}:{error.lineno}: not JSON: {error.msg}", hint="Correct this line.") from error
    if isinstance(value, list):
        for place, item in enumerate(value):
            yield _json_entry(item, f"{path}: [{place}]")
        return
    fields = Fields(value, str(path))
    unknown = next((name for name in fields.names if name not in _FIELDS), None)
    if unknown is not None:
        raise ReadError(f"{path}: nobody asks for the field “{unknown}”", hint=_HINT)
    for kind in fields.names:
        for place, item in enumerate(fields.items(kind)):
            yield _json_entry(item, f"{path}: {kind}[{place}]", kind)


def _json_entry(item: object, where: str, kind: str = "") -> Entry:
    return Entry(where, _json_thing(item, where), kind, _json_number(item, where))


def _json_number(item: object, where: str) -> int | None:
    """Return how many things a node is: as its ``count`` says, or the numbers of things that a plan gives it.

    Raises ReadError for a ``count`` below 1.
    """
    if not isinstance(item, dict):
        return None
    fields = Fields(item, where)
    if "count" in fields:
        count = fields.whole_number("count")
        if count < 1:
            raise ReadError(f"{where}: “count” should be at least 1, found {count}", hint="Leave it out.")
        return count
    if "things" in fields:
        return len(fields.items("things")) or None
    return 1 if "thing" in fields and item["thing"] is not None else None


def _json_thing(item: object, where: str) -> str | ObjectNode:
    if isinstance(item, str):
        return _named(item.strip(), where)
    fields = Fields(item, where)
    label = _named(fields.text("object" if "label" not in fields and "object" in fields else "label").strip(), where)
    state = fields.optional_text("state")
    return ObjectNode(
        label,
        fields.texts("states") if "states" in fields else (state,) if state else (),
        fields.texts("ingredients") if "ingredients" in fields else (),
        fields.optional_text("relation"),
        fields.optional_text("container"),
    )


def _named(text: str, where: str) -> str:
    if not text.strip(" ,"):
        raise ReadError(f"{where}: a thing without a name", hint=_HINT)
    if len(text) > LONGEST_THING:
        raise ReadError(f"{where}: a thing of {len(text)} characters; {LONGEST_THING} are the most", hint=_HINT)
    return text
