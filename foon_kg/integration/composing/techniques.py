"""Techniques carried out: the foods of a recipe at the stages of a row of ``food/techniques.toml``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from foon_kg.food import Level, Tables, tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Dish, Food, State
from foon_kg.food.techniques import (
    Around,
    Foods,
    Part,
    Technique,
    Work,
    is_so,
    preparations,
    techniques_called,
    ways,
    works,
)
from foon_kg.integration.bench import is_flat
from foon_kg.integration.composing.assigning import MAIN, assigned, has_its_foods, line_told
from foon_kg.integration.joining.spots import NATURAL, Join, spots_of
from foon_kg.integration.preparing.preparation import BY_HAND, JUICE, SECOND, Want, is_left_whole
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import (
    ADDED,
    BATH,
    THINNED,
    Asked,
    LiftedOut,
    Line,
    Phase,
    Rejoined,
    Slot,
    Stage,
    Steamed,
)


def technique_for(
    dish_type: str,
    title_words: Sequence[str],
    wants: Sequence[Want],
    recorded: Iterable[tuple[str, Collection[str]]] = (),
) -> Technique | None:
    """Return the first technique of the table that a dish is called by, and for which its foods, ``wants``, are there.

    ``title_words`` are the words of its title, ``recorded`` what the videos of its type make, each with its foods:
    where one of them makes what the title says, of the foods that the technique needs, it teaches that, and no table,
    unless the recipe says which food is for which line of it.
    """
    around = Around([want.facts for want in wants], title_words)
    own = set(title_words)
    taught = [(words(label), foods) for label, foods in recorded if own.issuperset(words(label))]
    parts = {want.part for want in wants} - {""}

    def is_taught(one: Technique) -> bool:
        told_apart = any(line_told(part, one.lines) for part in parts)
        return (
            "by table" not in one.plan
            and not told_apart
            and any(_teaches(label, foods, one) for label, foods in taught)
        )

    for one in techniques_called(dish_type, title_words):
        if one.is_called(dish_type, title_words) and not is_taught(one) and has_its_foods(one, wants, around):
            return one
    return None


def _teaches(label: tuple[str, ...], foods: Collection[str], one: Technique) -> bool:
    """Whether a video that makes what is called ``label``, of these foods, shows what a technique says."""
    if not any(label[-len(name) :] == name for name in one.called):
        return False
    facts = {name: tables().foods.food(name) for name in foods}
    around = Around(list(facts.values()), label)

    def has(some: Foods) -> bool:
        return any(some.mean(name, food, {some.state}, around) for name, food in facts.items())

    return all(any(map(has, need)) for need in one.needs) and not any(map(has, one.without))


def as_a_way_says(
    line: Line,
    joins: Sequence[Join],
    dishes: Iterable[Dish],
    name_words: Sequence[str],
    known: Tables,
    *,
    when: str = "ways",
    baked: bool = False,
) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` by the first way of the table that a word of the name asks for; or as they are.

    ``dishes`` are those that it is called; ``name_words`` are the words of its type and title, ``baked``: they say that
    it comes out of an oven. ``when`` names one of the tables of ways; ``known`` are those of foods and motions.
    """
    wants = [join.want for join in joins]
    around = Around([want.facts for want in wants], name_words)
    dishes, shown = tuple(dishes), _shown(line) | ({"baked"} if baked else set())
    for one in ways(when):
        fits = _is_for(one, dishes) and all(is_so(name, shown) for name in one.video)
        if fits and one.is_called("", name_words) and has_its_foods(one, wants, around):
            return carried_out(one, joins, name_words, known)
    return line, tuple(joins)


def _is_for(one: Technique, dishes: Sequence[Dish]) -> bool:
    """Whether a way is one for dishes that are called so."""
    fields = [name.removeprefix("!") for name in one.dishes]
    held = {name for name in fields if any(getattr(dish, name) for dish in dishes)}
    return all(is_so(name, held) for name in one.dishes)


def _shown(line: Line) -> set[str]:
    """Return what a video does, as ways ask for it: what its stages do, what it is heated on or in, and if first."""
    found = {stage.appliance for stage in line.all_stages() if stage.heats}
    hot = word_list("was made hot")
    if any(slot.kind != "water" and not hot.isdisjoint(slot.states) for slot in line.all_slots()):
        found.add("warm")
    return found.union(*(stage.does for stage in line.all_stages()))


def carried_out(
    technique: Technique, joins: Sequence[Join], title_words: Sequence[str], known: Tables
) -> tuple[Line, tuple[Join, ...]]:
    """Return the line of a technique with every food of ``joins`` at the stage that is for it.

    ``title_words`` are the title's words, ``known`` the tables.
    """
    placed = _Placed(technique, joins, Around([join.want.facts for join in joins], title_words))
    line = placed.line(MAIN)
    spots = {id(spot.stage): spot for spot in spots_of(line)}
    found = []
    for number, (join, foods, part) in enumerate(placed.found):
        want, slot = _prepared(join.want, foods, known)
        want = replace(want, cooked=False) if works()[part.stage].bath and slot is None else want
        want = replace(want, number=placed.highest + number + 1) if foods.again else want
        spot = spots[id(placed.stages[id(part)])]
        found.append(Join(want, spot, min(join.fit, NATURAL), slot, on_top=works()[part.stage].on_top))
    return line, tuple(found)


def stage_of(name: str) -> Stage:
    """Return the stage of that name in the table, at which nothing joins yet."""
    work = works()[name]
    return Stage(
        (), work.motion, work.does, work.tools, work.vessel, work.relation, work.appliance, work.source, work.label,
        work.states, ADDED,
    )  # fmt: skip


def done_instead(name: str, stage: Stage) -> Stage:
    """Return a stage that does what the stage ``name`` of the table does in the stead of ``stage``, in the same tin.

    Where that has none, as what lies on a flat tray, it is done in the vessel of the table.
    """
    work, row = works()[name], tables().utensil(stage.vessel)
    tin = row is not None and "bake" in row.can and not is_flat(stage.vessel)
    vessel = stage.vessel if tin else work.vessel
    return _kind_of(work)(
        stage.adds, work.motion, work.does, work.tools, vessel, work.relation, work.appliance, work.source,
        stage.label, stage.states, stage.step,
    )  # fmt: skip


class _Placed:
    """Which food joins at which part of a technique, and the stages of these parts."""

    def __init__(self, technique: Technique, joins: Sequence[Join], around: Around) -> None:
        self.technique = technique
        self.highest = max([SECOND, *(join.want.number for join in joins)])
        self.stages: dict[int, Stage] = {}
        self.found = assigned(technique, joins, around)
        self.used = {id(one.part) for one in self.found}
        self.taken: set[str] = set()

    def line(self, name: str) -> Line:
        """Return one line of the technique, with those that join it: each where it is named first."""
        self.taken.add(name)
        return Line(tuple(self._stage(part) for part in self.technique.lines[name] if self._is_there(part)))

    def _is_there(self, part: Part) -> bool:
        """Whether a stage is not left out: foods join there, or a line that has no other place."""
        named = Counter(line for parts in self.technique.lines.values() for one in parts for line in one.lines)
        lines = (line for line in part.lines if named[line] == 1)
        return not part.optional or id(part) in self.used or any(map(self._is_used, lines))

    def _is_used(self, name: str) -> bool:
        """Whether any food joins a line, or one that joins it."""
        parts = self.technique.lines[name]
        return any(id(part) in self.used or any(map(self._is_used, part.lines)) for part in parts)

    def _stage(self, part: Part) -> Stage:
        work = works()[part.stage]
        adds, lone = self._adds(part)
        water = (BATH,) if work.bath else (THINNED,) if work.thins else ()
        stage = _kind_of(work)(
            (*water, *adds), work.motion, work.does, work.tools, part.vessel or work.vessel,
            work.relation, work.appliance, work.source, self._label(part, work.label), work.states, 0,
        )  # fmt: skip
        self.stages[id(part)] = stage
        self.stages |= {id(one): stage for one in lone}
        return stage

    def _adds(self, part: Part) -> tuple[tuple[Slot | Line, ...], list[Part]]:
        """Return the lines that join a stage, and where the lone foods stand that join it without theirs."""
        adds: list[Slot | Line] = []
        alone: list[Part] = []
        for name in part.lines:
            if name in self.taken or not self._is_used(name):
                continue
            lone = self._lone(name)
            if lone is None:
                adds.append(self.line(name))
            else:
                alone.append(lone)
        return tuple(adds), alone

    def _lone(self, name: str) -> Part | None:
        """Return where the one food joins of a line that would only mix it with nothing; ``None`` for any other."""
        parts = self.technique.lines[name]
        here = {id(part) for part in parts}
        found = [part for _, _, part in self.found if id(part) in here]
        does = frozenset().union(*(works()[part.stage].does for part in parts))
        mixes = does == {"mix"} and not any(self._is_used(line) for part in parts for line in part.lines)
        return found[0] if mixes and len(found) == 1 else None

    def _label(self, part: Part, usual: str) -> str:
        """Return what a stage makes: "~" is what its first food is called."""
        if part.label == "~":
            return next((join.want.label for join, _, at in self.found if at is part), usual)
        return part.label or usual


def _kind_of(work: Work) -> Callable[..., Stage]:
    """Return what makes a stage of the kind that does such ``work``; a plain stage for most."""
    if work.over:
        return partial(Steamed, over=work.over)
    if work.appliance and work.source == "heat" and "dry" not in work.does and not work.phased:
        return partial(Phase, bath=work.bath)
    if work.lifts:
        return LiftedOut
    if work.rejoins:
        return Rejoined
    return Asked if work.always else Stage


def _prepared(want: Want, foods: Foods, known: Tables) -> tuple[Want, Slot | None]:
    """Return a food as a technique takes it, with the slot that says how it is cooked before.

    What is asked cut already is cut no other way, unless the row says that it is always done.
    """
    if not foods.made:
        return want, None
    row = preparations()[foods.made]
    slot = Slot(want.label, want.facts.kind, cooked=(row["cooked"],)) if "cooked" in row else None
    asked = known.state(want.make)
    shaped = _is_shaped(want, row, asked)
    made = shaped and "make" in row
    facts = _still_owing(want.facts, asked if made else State(""), row.get("waives", ()))
    want = replace(want, cooked=row.get("said", want.cooked), then=row.get("later", want.then))
    if made:
        squeezed = _is_squeezed(want, row["make"], known)
        want = replace(want, make=row["make"], foamed=bool(row.get("foamed")), squeezed=squeezed)
    if shaped and not want.then:
        want = _cooked_to(want, row.get("then", ""))
    return replace(want, facts=facts), slot


def _cooked_to(want: Want, state: str) -> Want:
    """Return a food that is cooked and then brought to a state; as it is where none is said."""
    return replace(want, then=state, cooked=True) if state else want


def _is_shaped(want: Want, row: Mapping[str, Any], asked: State) -> bool:
    """Whether a food is cut as a row says.

    Not where it is asked cut or comes broken, nor pressed where its peel or juice is asked.
    """
    if row.get("make") == JUICE and (want.make in word_list("is off the outside") or JUICE in want.leaf):
        return False
    if want.facts.is_any(word_list("comes broken")):
        return False
    uncut = asked.fineness == 0 and not is_left_whole(want)
    return uncut or bool(row.get("always"))


def _is_squeezed(want: Want, make: str, known: Tables) -> bool:
    return make == JUICE and form_of(known, want.label, want.leaf) == "whole"


def _still_owing(facts: Food, asked: State, waives: Collection[str]) -> Food:
    """Return a food that owes no more what a technique ``waives``; what is asked peeled is peeled, and then halved."""
    owes = dict.fromkeys(sorted(asked.earns & BY_HAND), Level.MINOR) | dict(facts.owes)
    return replace(facts, owes={name: level for name, level in owes.items() if name not in waives})
