"""How each primitive of a MUHAI network is played: the unit that it adds, and what its variables stand for then.

A rule is one row of ``_RULES``: how many words the primitive needs at least, and a function of the scene and these
words, the first of which is the variable of the result.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from foon_kg.loaders.lisp import Form, Symbol
from foon_kg.loaders.muhai_scene import TOOLS, Held, NotThere, Scene
from foon_kg.loaders.notices import NoticeKind, Problem
from foon_kg.model import Measures, ObjectNode

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
_STATES_IN_NAMES = frozenset({"cooked", "dried", "frozen", "canned", "ground", "shredded", "grated", "crushed"})
_FOODS = {"white-sugar": "sugar", "all-purpose-flour": "flour", "red-onion": "onion"}
"""Names of kinds that a FOON knows by a plainer one; a second name would draw recipes away from what is known."""

_SECONDS = {"second": 1, "minute": 60, "hour": 3600}
_NUMBER = r"\d+(\.\d+)?"
_TAKEN = "fetch-and-proportion"
_AMOUNTS = frozenset({_TAKEN, "portion-and-arrange"})

_KIND_OF_MIXTURE = ("dough", "batter", "salad", "dressing", "icing", "sauce", "filling", "glaze")
_CUTS = {"slice": "sliced", "square": "cut", "cube": "cubed", "sliver": "sliced", "dice": "diced", "half": "halved"}


def play(scene: Scene, primitive: Form) -> None:
    """Add the unit of ``primitive`` to ``scene``; what cannot be understood is told with its line."""
    words = [item.text for item in primitive.items if isinstance(item, Symbol)][1:]
    rule = _RULES.get(primitive.head)
    if primitive.head in _WITHOUT_UNIT:
        return
    if rule is None or len(words) < rule.least or len(words) != len(primitive.items) - 1:
        what = "is no primitive that foon-kg knows" if rule is None else f"takes words alone, {rule.least} at least"
        problem = Problem(NoticeKind.UNKNOWN_LINE, f"“{primitive.head}” {what}")
        scene.journal.reject(primitive.line, problem)
        return
    before = len(scene.units)
    scene.begin(primitive.line)
    try:
        rule.act(scene, words)
        if len(scene.units) > before:
            _measure(scene, primitive.head, words, len(scene.units) - before)
    except NotThere as error:
        message = f"“{primitive.head}” needs {error}, which no primitive before it made"
        scene.journal.reject(primitive.line, Problem(NoticeKind.UNIT_WITHOUT_INPUTS, message))


def _measure(scene: Scene, primitive: str, words: Sequence[str], added: int) -> None:
    """Note what ``words`` say of the units that were ``added``: how much, how long and how hot."""
    pairs = [(float(number), unit) for number, unit in pairwise(words) if re.fullmatch(_NUMBER, number)]
    seconds = next((number * _SECONDS[unit] for number, unit in pairs if unit in _SECONDS), None)
    celsius = next((number for number, unit in pairs if unit == "degrees-celsius"), None)
    if primitive == "preheat-oven":
        scene.oven = celsius
    if primitive == "bake" and celsius is None:
        celsius = scene.oven
    scene.measures[-added:] = [Measures(celsius=celsius)] * (added - 1)  # the oven is lit for what is baked
    scene.measures.append(Measures(tuple(_amounts(scene, primitive, pairs)), seconds, celsius))


def _amounts(scene: Scene, primitive: str, pairs: Sequence[tuple[float, str]]) -> Iterator[str]:
    """Yield how much of a food the last unit takes, where its primitive says so: "200 g flour"."""
    if primitive not in _AMOUNTS:
        return
    taken = (one.node for one in scene.units[-1].inputs if one.node.container or primitive == _TAKEN)
    food = next((node.label for node in taken), "")
    if food:
        yield from (f"{number:g} {unit} {food}" for number, unit in pairs[:1])


@dataclass(frozen=True)
class _Rule:
    """How a primitive is played, and how many words it needs."""

    least: int
    act: Callable[[Scene, Sequence[str]], None]


def _state(*states: str) -> Callable[[ObjectNode], ObjectNode]:
    """Return a change to ``states``; the states that food had before are over, but for those of its surface."""
    return lambda food: replace(food, states=(*states, *(s for s in food.states if s in {"peeled", "cored", "washed"})))


def _proportion(scene: Scene, words: Sequence[str]) -> None:
    out, food, unit = words[0], words[4], words[6]
    parts = [part for part in _FOODS.get(food, food).split("-") if part != "fresh"]
    state = parts[0] if len(parts) > 1 and parts[0] in _STATES_IN_NAMES else ""
    label = " ".join(parts[1:] if state else parts)
    own = (state,) if state else ("whole",) if unit in {"piece", "stalk", "clove"} else ()
    bowl = scene.vessel(words[3], "bowl")
    after, taken = bowl.put([ObjectNode(label, own)])
    motion = "pick-and-place" if "whole" in own else "pour"
    scene.add(motion, (ObjectNode(label, own), bowl.node()), (after.node(), *taken))
    scene.bind(out, after)


def _fetch(scene: Scene, words: Sequence[str]) -> None:
    name = words[3]
    scene.bind(words[0], Held(_VESSELS.get(name) or TOOLS.get(name) or name.replace("-", " ")))


def _transfer(scene: Scene, words: Sequence[str]) -> None:
    target = scene.vessel(words[4], "mixing bowl")
    scene.move(words[0], scene.filled(words[5]), target, "pour")


def _transfer_items(scene: Scene, words: Sequence[str]) -> None:
    scene.move(words[0], scene.filled(words[3]), scene.vessel(words[5], "baking tray"), "pick-and-place")


def _spread(scene: Scene, words: Sequence[str]) -> None:
    target, source = scene.vessel(words[3], "baking pan"), scene.filled(words[4])
    scene.move(words[0], source, target, "spread", with_=(scene.tool(words, 5, "spatula"),))


def _sprinkle(scene: Scene, words: Sequence[str]) -> None:
    scene.move(words[0], scene.filled(words[4]), scene.filled(words[3]), "sprinkle")


def _dip(scene: Scene, words: Sequence[str]) -> None:
    coat, body = scene.beside(words[4]), scene.filled(words[3])
    names = tuple(food.label for food in coat.foods)
    after = body.of(replace(f, states=(*f.states, "coated"), ingredients=(*f.ingredients, *names)) for f in body.foods)
    scene.add("dip", (body.node(), *body.foods, coat.node(), *coat.foods), (after.node(), *after.foods, coat.node()))
    scene.bind(words[0], after)


def _crack(scene: Scene, words: Sequence[str]) -> None:
    eggs, bowl = scene.filled(words[3]), scene.vessel(words[4], "bowl")
    after, cracked = bowl.put(replace(egg, states=("cracked",)) for egg in eggs.foods)
    emptied = replace(eggs, foods=())
    scene.add("crack", (eggs.node(), *eggs.foods, bowl.node()), (after.node(), *cracked, emptied.node()))
    scene.bind(words[0], after)


def _sift(scene: Scene, words: Sequence[str]) -> None:
    target, source = scene.vessel(words[3], "bowl"), scene.filled(words[4])
    after, sifted = target.put(replace(food, states=("sifted",)) for food in source.foods)
    inputs = (source.node(), *source.foods, target.node(), scene.tool(words, 5, "sieve"))
    scene.add("sift", inputs, (after.node(), *sifted, replace(source, foods=()).node()))
    scene.bind(words[0], after)


def _mix(motion: str, state: str, tool: str) -> Callable[[Scene, Sequence[str]], None]:
    def act(scene: Scene, words: Sequence[str]) -> None:
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


def _cut(scene: Scene, words: Sequence[str]) -> None:
    pattern = words[4].removeprefix("finely-").removeprefix("coarsely-").removeprefix("roughly-")
    stem = pattern.rpartition("-")[2].removesuffix("s")
    state = pattern.replace("-", " ") if pattern.endswith("ed") else _CUTS.get(stem, "chopped")
    verb = {"sliced": "slice", "diced": "dice", "cubed": "dice", "halved": "cut", "cut": "cut"}.get(state, "chop")
    scene.change(words, 3, verb, _state(state), (scene.tool(words, 5, "knife"), ObjectNode("cutting board")))


def _take_off(motion: str, state: str) -> Callable[[Scene, Sequence[str]], None]:
    def act(scene: Scene, words: Sequence[str]) -> None:
        scene.change(words, 4, motion, _state(state), (scene.tool(words, 5, "knife"),))

    return act


def _bake(scene: Scene, words: Sequence[str]) -> None:
    scene.filled(words[3])
    if not any(ObjectNode("oven", ("on",)) in unit.output_nodes for unit in scene.units):
        _preheat(scene, words)
    scene.change(words, 3, "bake", _state("baked"), (ObjectNode("oven", ("on",)),))


def _preheat(scene: Scene, _: Sequence[str]) -> None:
    scene.add("turn on", (ObjectNode("oven", ("off",)),), (ObjectNode("oven", ("on",)),))


def _on_stove(motion: str, state: str) -> Callable[[Scene, Sequence[str]], None]:
    return lambda scene, words: scene.change(words, 3, motion, _state(state), (ObjectNode("stove", ("on",)),))


def _prepare(motion: str, state: str, stuff: str) -> Callable[[Scene, Sequence[str]], None]:
    """Return how to play what is done to an empty tray or pan."""

    def act(scene: Scene, words: Sequence[str]) -> None:
        before = scene.vessel(words[3], "baking tray")
        after = replace(before, states=(*before.states, state))
        scene.add(motion, (before.node(), ObjectNode(stuff)), (after.node(),))
        scene.bind(words[0], after)

    return act


_COLD = 15
"""In °C: what is brought to less is cooled, whatever it was before."""

_HOT = frozenset({"baked", "cooked", "boiled", "melted", "fried"})


def _temperature(scene: Scene, words: Sequence[str]) -> None:
    """Play cooling where the food is hot or the aim is cold; else what comes from the fridge is left to soften."""
    states = {state for food in scene.filled(words[3]).foods for state in food.states}
    cold = re.fullmatch(_NUMBER, words[4]) is not None and float(words[4]) < _COLD
    motion, state = ("cool", "cooled") if cold or states & _HOT else ("leave", "softened")
    scene.change(words, 3, motion, lambda old: replace(old, states=(*old.states, state)))


def _cover(scene: Scene, words: Sequence[str]) -> None:
    before = scene.filled(words[3])
    after = replace(before, states=(*before.states, "covered"))
    lid = scene.tool(words, 4, "lid")
    scene.add("cover", (before.node(), *before.foods, lid), (after.node(), *after.foods))
    scene.bind(words[0], after)


def _uncover(scene: Scene, words: Sequence[str]) -> None:
    before = scene.filled(words[4])
    after = replace(before, states=tuple(state for state in before.states if state != "covered"))
    scene.add("uncover", (before.node(), *before.foods), (after.node(), *after.foods))
    scene.bind(words[0], after)


_EGG_PARTS = ("yolk", "white")
"""In the order in which MUHAI names their bowls."""


def _separate(scene: Scene, words: Sequence[str]) -> None:
    eggs = scene.filled(words[4])
    bowls = [scene.vessel(vessel, "bowl") for vessel in words[5:7]]
    parted = [bowl.put([ObjectNode(f"egg {part}", ("raw",))]) for bowl, part in zip(bowls, _EGG_PARTS, strict=True)]
    outputs = [node for after, part in parted for node in (after.node(), *part)]
    inputs = (eggs.node(), *eggs.foods, *(bowl.node() for bowl in bowls))
    scene.add("separate", inputs, (*outputs, replace(eggs, foods=()).node()))
    for variable, (after, _) in zip(words[:2], parted, strict=True):
        scene.bind(variable, after)


def _leave(scene: Scene, words: Sequence[str]) -> None:
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
