"""MUHAI's recipes: networks of kitchen primitives, played from the first to the last so that each becomes a unit.

A network names the results of its primitives by variables. Here a variable stands for a vessel and what is in it, or
for a tool; a variable that nothing made is a fresh vessel or the tool that the primitive needs. Kitchen states, which
only chain the primitives, are passed over, and so is fetching a tool, which changes nothing.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

from foon_kg.loaders.lisp import Form, Symbol, read_lisp
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, ReadResult, Remark, Severity, UnreadableFile
from foon_kg.model import UNMEASURED, Annotation, FunctionalUnit, Measures, ObjectNode, Participant
from foon_kg.model.dish_classes import dish_classes
from foon_kg.model.errors import ReadError
from foon_kg.model.regular_files import read_bytes

_ENDING = ".lisp"
_DEFINITIONS = ("defparameter", "defvar", "setf")
_VESSELS = {
    "large-bowl": "mixing bowl",
    "medium-bowl": "mixing bowl",
    "small-bowl": "bowl",
    "cookie-sheet": "baking tray",
    "baking-tray": "baking tray",
    "muffin-tins": "muffin tray",
    "pan": "baking pan",
    "jar": "jar",
}
_TOOLS = {
    "beating-tool": "whisk",
    "mixing-tool": "spoon",
    "table-spoon": "spoon",
    "cutting-tool": "knife",
    "sifting-tool": "sieve",
    "scraper": "spatula",
    "grinding-tool": "food processor",
}
_STATES_IN_NAMES = frozenset({"cooked", "dried", "frozen", "canned", "ground", "shredded", "grated", "crushed"})
_FOODS = {"white-sugar": "sugar", "all-purpose-flour": "flour", "red-onion": "onion"}
"""Names of kinds that a FOON knows by a plainer one; a second name would draw recipes away from what is known."""

_SECONDS = {"second": 1, "minute": 60, "hour": 3600}
_NUMBER = r"\d+(\.\d+)?"
_TAKEN = "fetch-and-proportion"
_AMOUNTS = frozenset({_TAKEN, "portion-and-arrange"})

_KIND_OF_MIXTURE = ("dough", "batter", "salad", "dressing", "icing", "sauce", "filling", "glaze")
_CUTS = {"slice": "sliced", "square": "cut", "cube": "cubed", "sliver": "sliced", "dice": "diced", "half": "halved"}
_DISHES_BY_WORD = {"tuile": "cookie", "snap": "cookie", "slice": "salad"}
"""Dish types of titles in which no general word of a dish stands: MUHAI calls these cookies and salads."""


@dataclass(frozen=True)
class _Held:
    """A vessel (or a place, or a tool) with the foods in it."""

    vessel: str
    foods: tuple[ObjectNode, ...] = ()
    states: tuple[str, ...] = ()

    def node(self) -> ObjectNode:
        return ObjectNode(self.vessel, self.states or (() if self.foods else ("empty",)), self._names())

    def _names(self) -> tuple[str, ...]:
        return tuple(food.label for food in self.foods)

    def of(self, foods: Iterable[ObjectNode]) -> _Held:
        """Return this vessel with ``foods`` in it, one node for each label and state."""
        placed = (ObjectNode(food.label, food.states, food.ingredients, "in", self.vessel) for food in foods)
        return replace(self, foods=tuple(dict.fromkeys(placed)))


def read_muhai(paths: Iterable[Path]) -> Iterator[ReadResult]:
    """Yield one result for every MUHAI recipe (``*.lisp``) that ``paths`` name or hold, by name.

    A primitive that cannot be understood is left out, and told with its line. Raises ``ReadError`` for a path that
    does not exist or holds no such file.
    """
    found: set[Path] = set()
    for path in paths:
        if not path.exists():
            raise ReadError(f"there is no file or folder {path}", hint="Check the path.")
        files = [file for file in path.rglob(f"*{_ENDING}") if file.is_file()] if path.is_dir() else [path]
        if not files or (not path.is_dir() and path.suffix.lower() != _ENDING):
            raise ReadError(f"{path}: no MUHAI recipe there", hint=f"Name a *{_ENDING} file, or a folder of them.")
        found.update(files)
    return (read_muhai_file(file) for file in sorted(found, key=lambda file: (file.stem, str(file))))


def read_muhai_file(path: Path) -> ReadResult:
    """Return the units of the recipe in the file ``path``. Never raises."""
    try:
        data = read_bytes(path)
    except OSError as error:
        return Journal(str(path)).reject_unread(error)
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        text = data.decode("latin-1")  # MUHAI writes its degree signs so, in comments
    return read_muhai_text(text, path.stem, str(path))


def read_muhai_text(text: str, name: str, file: str = "") -> ReadResult:
    """Return the units of the longest network in ``text``, as the video ``name``. Never raises."""
    journal = Journal(file or name)
    try:
        document = read_lisp(text)
    except UnreadableFile as error:
        return journal.reject_file(error.line, error.problem)
    for line in document.unclosed:
        what = "the list that begins here is not closed before the next definition"
        journal.remark(line, Remark(NoticeKind.BAD_BRACKETS, what, "taken to end there"))
    networks = [network for form in document.forms if form.head in _DEFINITIONS for network in _networks(form)]
    if not networks:
        return journal.reject_file(None, Problem(NoticeKind.NO_UNITS, "no network that begins with (get-kitchen …)"))
    scene = _Scene(journal)
    for primitive in max(networks, key=lambda network: len(network.items)).forms():
        scene.play(primitive)
    if any(notice.severity is Severity.REJECTED for notice in journal.notices()):
        what = "steps are missing, so what the last one makes is hardly the dish"
        journal.remark(None, Remark(NoticeKind.ODD_CLASS, what, "no goal marked"))
        units = scene.units
    else:
        units = _with_goal(scene.units, name)
    notes = (Annotation(unit, measures=measures) for unit, measures in zip(units, scene.measures, strict=True))
    return journal.result(name, list(notes), (), scene.lines)


def _networks(definition: Form) -> Iterator[Form]:
    return (form for form in definition.forms() if any(inner.head == "get-kitchen" for inner in form.forms()))


def _with_goal(units: Sequence[FunctionalUnit], name: str) -> list[FunctionalUnit]:
    """Mark the dish: the last food that the recipe makes is called by the title and gets its dish type."""
    title = re.sub(r"\s*\d+$", "", name.replace("-", " "))
    dish = next(iter(sorted(set(_DISHES_BY_WORD) & {word.rstrip("s") for word in title.split()})), "")
    sure = [one.name for one in dish_classes(title) if one.sure]
    kind = sure[0] if sure else _DISHES_BY_WORD.get(dish)
    listed = list(units)
    if kind == "bread" and "biscuits" in title and "shortcake" not in title:
        kind = "cookie"  # what is sweet and baked in spoonfuls
    if kind and listed:
        last = listed[-1]
        foods = [place for place, one in enumerate(last.outputs) if one.node.container]
        if foods:
            goal = max(foods, key=lambda place: len(last.outputs[place].node.ingredients))
            old = last.outputs[goal].node.label
            outputs = tuple(_named(one, old, title, kind if i == goal else None) for i, one in enumerate(last.outputs))
            listed[-1] = replace(last, outputs=outputs)
    return listed


def _named(one: Participant, old: str, title: str, dish: str | None) -> Participant:
    node = one.node
    if node.label == old:
        node = replace(node, label=title)
    names = tuple(title if name == old else name for name in node.ingredients)
    return Participant(replace(node, ingredients=names), one.moving, dish)


class _Scene:
    """What each variable stands for while a network is played, and the units so far."""

    def __init__(self, journal: Journal) -> None:
        self.units: list[FunctionalUnit] = []
        self.measures: list[Measures] = []
        self.lines: list[int] = []
        self._oven: float | None = None
        self._journal = journal
        self._held: dict[str, _Held] = {}
        self._became: dict[str, str] = {}
        self._used: list[str] = []
        self._line = 0

    def play(self, primitive: Form) -> None:
        """Add the unit of one primitive; what cannot be understood is told with its line."""
        words = [item.text for item in primitive.items if isinstance(item, Symbol)][1:]
        rule = _RULES.get(primitive.head)
        if primitive.head in _WITHOUT_UNIT:
            return
        if rule is None or len(words) < rule.least or len(words) != len(primitive.items) - 1:
            what = "is no primitive that foon-kg knows" if rule is None else f"takes {rule.least} words at least"
            problem = Problem(NoticeKind.UNKNOWN_LINE, f"“{primitive.head}” {what}")
            self._journal.reject(primitive.line, problem)
            return
        before = len(self.units)
        self._used, self._line = [], primitive.line
        try:
            rule.act(self, words)
            if len(self.units) > before:
                self._measure(primitive.head, words, len(self.units) - before)
        except _NotThere as error:
            message = f"“{primitive.head}” needs {error}, which no primitive before it made"
            self._journal.reject(primitive.line, Problem(NoticeKind.UNIT_WITHOUT_INPUTS, message))

    def _measure(self, primitive: str, words: Sequence[str], added: int) -> None:
        """Note what ``words`` say of the units that were ``added``: how much, how long and how hot."""
        pairs = [(float(n), unit) for n, unit in pairwise(words) if re.fullmatch(_NUMBER, n)]
        seconds = next((number * _SECONDS[unit] for number, unit in pairs if unit in _SECONDS), None)
        celsius = next((number for number, unit in pairs if unit == "degrees-celsius"), None)
        if primitive == "preheat-oven":
            self._oven = celsius
        if primitive == "bake":
            celsius = self._oven if celsius is None else celsius
        amounts: tuple[str, ...] = ()
        if primitive in _AMOUNTS:
            food = next(
                (one.node.label for one in self.units[-1].inputs if one.node.container or primitive == _TAKEN), ""
            )
            amounts = tuple(f"{number:g} {unit} {food}" for number, unit in pairs[:1] if food)
        self.measures[-added:] = [Measures(celsius=celsius)] * (added - 1)  # the oven is lit for what is baked
        self.measures.append(Measures(amounts, seconds, celsius))

    def bind(self, variable: str, held: _Held) -> None:
        """Let ``variable`` stand for ``held``; what was used for it is that by now."""
        self._held[variable] = held
        self._became.pop(variable, None)
        self._became.update((used, variable) for used in self._used if used != variable)

    def vessel(self, variable: str, otherwise: str) -> _Held:
        """Return what ``variable`` stands for; a fresh vessel where nothing made it."""
        return self._held.get(self._now(variable)) or _Held(otherwise)

    def filled(self, variable: str) -> _Held:
        """Return a vessel with food in it. Raises ``_NotThere`` where there is none."""
        held = self._held.get(self._now(variable))
        if held is None or not held.foods:
            raise _NotThere(variable)
        return held

    def beside(self, variable: str) -> _Held:
        """Return a vessel with food in it, of which only some is used. Raises ``_NotThere`` where there is none."""
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
            self._journal.remark(self._line, Remark(NoticeKind.NOT_PLAYED, what, action))
        return now

    def tool(self, words: Sequence[str], place: int, otherwise: str) -> ObjectNode:
        """Return the tool at ``place``: what was fetched for it, what its name says, or the usual one."""
        word = words[place] if len(words) > place else ""
        held = self._held.get(word)
        name = re.sub(r"-\d+$", "", word.lstrip("?"))
        return ObjectNode(held.vessel if held else _TOOLS.get(name) or name.replace("-", " ") or otherwise)

    def add(
        self, motion: str, inputs: Iterable[ObjectNode], outputs: Iterable[ObjectNode], *, star: bool = False
    ) -> None:
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
        """Add a unit in which each food of the vessel at ``place`` becomes what ``change`` makes of it."""
        before = self.filled(words[place])
        after = before.of(map(change, before.foods))
        self.add(motion, (before.node(), *before.foods, *with_), (after.node(), *after.foods))
        self.bind(words[0], after)

    def move(self, out: str, source: _Held, target: _Held, motion: str, *, with_: tuple[ObjectNode, ...] = ()) -> None:
        """Add a unit in which all that is in ``source`` comes to what is in ``target``."""
        after = target.of((*target.foods, *source.foods))
        moved = after.foods[-len(source.foods) :]
        self.add(
            motion,
            (source.node(), *source.foods, target.node(), *with_),
            (after.node(), *moved, replace(source, foods=()).node()),
        )
        self.bind(out, after)


class _NotThere(Exception):  # noqa: N818  # a signal inside of this module
    """No food is where a primitive takes it."""


@dataclass(frozen=True)
class _Rule:
    """How a primitive is played, and how many words it needs."""

    least: int
    act: Callable[[_Scene, Sequence[str]], None]


def _state(*states: str) -> Callable[[ObjectNode], ObjectNode]:
    """Return a change to ``states``; the states that food had before are over, but for those of its surface."""
    return lambda food: replace(food, states=(*states, *(s for s in food.states if s in {"peeled", "cored", "washed"})))


def _proportion(scene: _Scene, words: Sequence[str]) -> None:
    out, food, unit = words[0], words[4], words[6]
    parts = [part for part in _FOODS.get(food, food).split("-") if part != "fresh"]
    state = parts[0] if len(parts) > 1 and parts[0] in _STATES_IN_NAMES else ""
    label = " ".join(parts[1:] if state else parts)
    own = (state,) if state else ("whole",) if unit in {"piece", "stalk", "clove"} else ()
    bowl = scene.vessel(words[3], "bowl")
    after = bowl.of([ObjectNode(label, own)])
    motion = "pick-and-place" if "whole" in own else "pour"
    scene.add(motion, (ObjectNode(label, own), bowl.node()), (after.node(), *after.foods))
    scene.bind(out, after)


def _fetch(scene: _Scene, words: Sequence[str]) -> None:
    name = words[3]
    scene.bind(words[0], _Held(_VESSELS.get(name) or _TOOLS.get(name) or name.replace("-", " ")))


def _transfer(scene: _Scene, words: Sequence[str]) -> None:
    target = scene.vessel(words[4], "mixing bowl")
    scene.move(words[0], scene.filled(words[5]), target, "pour")


def _transfer_items(scene: _Scene, words: Sequence[str]) -> None:
    scene.move(words[0], scene.filled(words[3]), scene.vessel(words[5], "baking tray"), "pick-and-place")


def _spread(scene: _Scene, words: Sequence[str]) -> None:
    target, source = scene.vessel(words[3], "baking pan"), scene.filled(words[4])
    scene.move(words[0], source, target, "spread", with_=(scene.tool(words, 5, "spatula"),))


def _sprinkle(scene: _Scene, words: Sequence[str]) -> None:
    scene.move(words[0], scene.filled(words[4]), scene.filled(words[3]), "sprinkle")


def _dip(scene: _Scene, words: Sequence[str]) -> None:
    coat, body = scene.beside(words[4]), scene.filled(words[3])
    names = tuple(food.label for food in coat.foods)
    after = body.of(replace(f, states=(*f.states, "coated"), ingredients=(*f.ingredients, *names)) for f in body.foods)
    scene.add("dip", (body.node(), *body.foods, coat.node(), *coat.foods), (after.node(), *after.foods, coat.node()))
    scene.bind(words[0], after)


def _crack(scene: _Scene, words: Sequence[str]) -> None:
    eggs, bowl = scene.filled(words[3]), scene.vessel(words[4], "bowl")
    after = bowl.of((*bowl.foods, *(replace(egg, states=("cracked",)) for egg in eggs.foods)))
    emptied = replace(eggs, foods=())
    scene.add("crack", (eggs.node(), *eggs.foods, bowl.node()), (after.node(), after.foods[-1], emptied.node()))
    scene.bind(words[0], after)


def _sift(scene: _Scene, words: Sequence[str]) -> None:
    target, source = scene.vessel(words[3], "bowl"), scene.filled(words[4])
    sifted = replace(source, foods=tuple(replace(food, states=("sifted",)) for food in source.foods))
    after = target.of((*target.foods, *sifted.foods))
    inputs = (source.node(), *source.foods, target.node(), scene.tool(words, 5, "sieve"))
    outputs = (after.node(), *after.foods[-len(source.foods) :], replace(source, foods=()).node())
    scene.add("sift", inputs, outputs)
    scene.bind(words[0], after)


def _mix(motion: str, state: str, tool: str) -> Callable[[_Scene, Sequence[str]], None]:
    def act(scene: _Scene, words: Sequence[str]) -> None:
        before = scene.filled(words[3])
        members = [name for food in before.foods for name in (food.ingredients or (food.label,))]
        if len(before.foods) == 1 and not before.foods[0].ingredients:
            scene.change(words, 3, motion, _state(state), (scene.tool(words, 4, tool),))
            return
        after = before.of([ObjectNode(_mixture(words[0]), (state,), tuple(members))])
        inputs = (before.node(), *before.foods, scene.tool(words, 4, tool))
        scene.add(motion, inputs, (after.node(), *after.foods), star=True)
        scene.bind(words[0], after)

    return act


def _mixture(variable: str) -> str:
    words = variable.lstrip("?").split("-")
    return next((kind for kind in _KIND_OF_MIXTURE if kind in words), "mixture")


def _simple(motion: str, place: int, *states: str, tools: tuple[str, ...] = ()) -> Callable[..., None]:
    """Return how to play a primitive that gives food the ``states``, with ``tools`` that it does not name."""
    nodes = tuple(ObjectNode(tool) for tool in tools)
    return lambda scene, words: scene.change(words, place, motion, _state(*states), nodes)


def _cut(scene: _Scene, words: Sequence[str]) -> None:
    pattern = words[4].removeprefix("finely-").removeprefix("coarsely-").removeprefix("roughly-")
    stem = pattern.rpartition("-")[2].removesuffix("s")
    state = pattern.replace("-", " ") if pattern.endswith("ed") else _CUTS.get(stem, "chopped")
    verb = {"sliced": "slice", "diced": "dice", "cubed": "dice", "halved": "cut", "cut": "cut"}.get(state, "chop")
    scene.change(words, 3, verb, _state(state), (scene.tool(words, 5, "knife"), ObjectNode("cutting board")))


def _take_off(motion: str, state: str) -> Callable[[_Scene, Sequence[str]], None]:
    def act(scene: _Scene, words: Sequence[str]) -> None:
        scene.change(words, 4, motion, _state(state), (scene.tool(words, 5, "knife"),))

    return act


def _bake(scene: _Scene, words: Sequence[str]) -> None:
    scene.filled(words[3])
    if not any(ObjectNode("oven", ("on",)) in unit.output_nodes for unit in scene.units):
        _preheat(scene, words)
    scene.change(words, 3, "bake", _state("baked"), (ObjectNode("oven", ("on",)),))


def _preheat(scene: _Scene, _: Sequence[str]) -> None:
    scene.add("turn on", (ObjectNode("oven", ("off",)),), (ObjectNode("oven", ("on",)),))


def _on_stove(motion: str, state: str) -> Callable[[_Scene, Sequence[str]], None]:
    return lambda scene, words: scene.change(words, 3, motion, _state(state), (ObjectNode("stove", ("on",)),))


def _prepare(motion: str, state: str, stuff: str) -> Callable[[_Scene, Sequence[str]], None]:
    """Return how to play what is done to an empty tray or pan."""

    def act(scene: _Scene, words: Sequence[str]) -> None:
        before = scene.vessel(words[3], "baking tray")
        after = replace(before, states=(*before.states, state))
        scene.add(motion, (before.node(), ObjectNode(stuff)), (after.node(),))
        scene.bind(words[0], after)

    return act


_COLD = 15
_HOT = frozenset({"baked", "cooked", "boiled", "melted", "fried"})


def _temperature(scene: _Scene, words: Sequence[str]) -> None:
    """Play cooling where the food is hot or the aim is cold; else what comes from the fridge is left to soften."""
    states = {state for food in scene.filled(words[3]).foods for state in food.states}
    cold = re.fullmatch(r"\d+(\.\d+)?", words[4]) is not None and float(words[4]) < _COLD
    motion, state = ("cool", "cooled") if cold or states & _HOT else ("leave", "softened")
    scene.change(words, 3, motion, lambda old: replace(old, states=(*old.states, state)))


def _cover(scene: _Scene, words: Sequence[str]) -> None:
    before = scene.filled(words[3])
    after = replace(before, states=("covered",))
    lid = scene.tool(words, 4, "lid")
    scene.add("cover", (before.node(), *before.foods, lid), (after.node(), *after.foods))
    scene.bind(words[0], after)


def _uncover(scene: _Scene, words: Sequence[str]) -> None:
    before = scene.filled(words[4])
    after = replace(before, states=())
    scene.add("uncover", (before.node(), *before.foods), (after.node(), *after.foods))
    scene.bind(words[0], after)


def _separate(scene: _Scene, words: Sequence[str]) -> None:
    eggs = scene.filled(words[4])
    parts = [
        scene.vessel(vessel, "bowl").of([ObjectNode(f"egg {part}", ("raw",))])
        for part, vessel in (("yolk", words[5]), ("white", words[6]))
    ]
    bowls = (scene.vessel(vessel, "bowl").node() for vessel in words[5:7])
    outputs = [node for part in parts for node in (part.node(), *part.foods)]
    scene.add("separate", (eggs.node(), *eggs.foods, *bowls), (*outputs, replace(eggs, foods=()).node()))
    for variable, part in zip(words, parts, strict=False):
        scene.bind(variable, part)


def _leave(scene: _Scene, words: Sequence[str]) -> None:
    scene.change(words, 3, "leave", lambda old: replace(old, states=(*old.states, "rested")))


_WITHOUT_UNIT = frozenset({"get-kitchen", "bind"})
_RULES: Mapping[str, _Rule] = {
    "fetch": _Rule(4, _fetch),
    "fetch-and-proportion": _Rule(7, _proportion),
    "transfer-contents": _Rule(8, _transfer),
    "transfer-items": _Rule(6, _transfer_items),
    "spread": _Rule(6, _spread),
    "sprinkle": _Rule(5, _sprinkle),
    "dip": _Rule(5, _dip),
    "crack": _Rule(5, _crack),
    "sift": _Rule(6, _sift),
    "beat": _Rule(5, _mix("beat", "beaten", "whisk")),
    "mix": _Rule(5, _mix("mix", "mixed", "spoon")),
    "mingle": _Rule(5, _mix("mix", "mixed", "spoon")),
    "shake": _Rule(4, _mix("shake", "mixed", "jar")),
    "cut": _Rule(6, _cut),
    "peel": _Rule(6, _take_off("peel", "peeled")),
    "seed": _Rule(6, _take_off("remove seeds", "seeded")),
    "mash": _Rule(5, _simple("mash", 3, "mashed", tools=("fork",))),
    "grind": _Rule(5, _simple("grind", 3, "ground", tools=("food processor",))),
    "melt": _Rule(5, _simple("melt", 3, "melted", tools=("microwave",))),
    "wash": _Rule(4, _simple("wash", 3, "washed", tools=("water",))),
    "drain": _Rule(6, _simple("drain", 4, "drained", tools=("colander",))),
    "flatten": _Rule(5, _simple("flatten", 3, "flattened", tools=("rolling pin",))),
    "shape": _Rule(5, _simple("shape", 3, "shaped")),
    "portion-and-arrange": _Rule(8, _simple("divide", 3, "divided")),
    "refrigerate": _Rule(7, _simple("refrigerate", 3, "chilled", tools=("fridge",))),
    "bring-to-temperature": _Rule(6, _temperature),
    "leave-for-time": _Rule(6, _leave),
    "cover": _Rule(5, _cover),
    "uncover": _Rule(5, _uncover),
    "separate-eggs": _Rule(8, _separate),
    "bake": _Rule(9, _bake),
    "preheat-oven": _Rule(6, _preheat),
    "boil": _Rule(6, _on_stove("boil", "boiled")),
    "fry": _Rule(8, _on_stove("fry", "fried")),
    "cook": _Rule(6, _on_stove("cook", "cooked")),
    "grease": _Rule(5, _prepare("grease", "greased", "butter")),
    "flour": _Rule(5, _prepare("sprinkle", "floured", "flour")),
    "line": _Rule(5, _prepare("line", "lined", "baking paper")),
}
