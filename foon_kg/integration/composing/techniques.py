"""Techniques carried out: the foods of a recipe at the stages of a row of ``food/techniques.toml``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial

from foon_kg.food import Level, Tables, singular, tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Dish
from foon_kg.food.techniques import Around, Foods, Part, Technique, preparations, techniques_called, ways, works
from foon_kg.integration.composing.coated import is_portion
from foon_kg.integration.joining.course import HEATS
from foon_kg.integration.joining.spots import NATURAL, Join, spots_of
from foon_kg.integration.preparing.preparation import BY_HAND, JUICE, SECOND, Want, owed
from foon_kg.integration.teaching.frames import BATH, Line, Phase, Slot, Stage
from foon_kg.integration.teaching.operators import form_of

_MAIN = "dish"
"""The line of a technique that makes the dish."""


def technique_for(
    dish_type: str, told: Sequence[str], wants: Sequence[Want], recorded: Iterable[tuple[str, Collection[str]]] = ()
) -> Technique | None:
    """Return the first technique of the table that a dish is called by, and for which its foods are there.

    ``told`` are the words of its title, ``recorded`` what the videos of its type make, each with its foods: where one
    of them makes what the title says, of the foods that the technique needs, it teaches that, and no table, unless the
    recipe says which food is for which line of it.
    """
    around = Around([want.facts for want in wants], told)
    own = set(told)
    taught = [(words(label), foods) for label, foods in recorded if own.issuperset(words(label))]
    parts = {want.part for want in wants} - {""}
    for one in techniques_called(dish_type, told):
        if not one.is_called(dish_type, told):
            continue
        told_apart = "by table" in one.plan or not parts.isdisjoint(one.lines)
        if not told_apart and any(_teaches(label, foods, one) for label, foods in taught):
            continue
        if has_its_foods(one, wants, around):
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
    told: Sequence[str],
    known: Tables,
    *,
    when: str = "ways",
    baked: bool = False,
) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish is made by the first way of the table that a word of its name asks for; else as it is.

    ``dishes`` are those that it is called; ``told`` are the words of its type and title, ``baked``: they say that it
    comes out of an oven. ``when`` names one of the tables of ways.
    """
    wants = [join.want for join in joins]
    around = Around([want.facts for want in wants], told)
    dishes, shown = tuple(dishes), _shown(line) | ({"baked"} if baked else set())
    for one in ways(when):
        fits = all(any(getattr(dish, name) for dish in dishes) is holds for name, holds in map(_asked, one.dishes))
        fits = fits and all((name in shown) is holds for name, holds in map(_asked, one.video))
        if fits and one.is_called("", told) and has_its_foods(one, wants, around):
            return carried_out(one, joins, told, known)
    return line, tuple(joins)


def _asked(text: str) -> tuple[str, bool]:
    """Return what a row asks for, and whether it is to hold."""
    return text.removeprefix("!"), not text.startswith("!")


def _shown(line: Line) -> set[str]:
    """Return what a video does, as ways ask for it: what its stages do, and what it is heated on or in."""
    found = {stage.appliance for stage in line.all_stages() if not stage.does.isdisjoint(HEATS)}
    return found.union(*(stage.does for stage in line.all_stages()))


def has_its_foods(one: Technique, wants: Sequence[Want], around: Around) -> bool:
    """Whether the foods of a recipe are those that a row needs."""
    if not all(any(means(some, want, around) for some in need for want in wants) for need in one.needs):
        return False
    if any(means(some, want, around) for some in one.without for want in wants):
        return False
    return all(sum(means(some, want, around) for want in wants) == 1 for some in one.one)


def carried_out(
    technique: Technique, joins: Sequence[Join], told: Sequence[str], known: Tables
) -> tuple[Line, tuple[Join, ...]]:
    """Return the line of a technique with every food at the stage that is for it; ``told`` are the title's words."""
    placed = _Placed(technique, joins, Around([join.want.facts for join in joins], told), known)
    line = placed.line(_MAIN)
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
        work.states, -1,
    )  # fmt: skip


class _Placed:
    """Which food joins at which part of a technique, and the stages of these parts."""

    def __init__(self, technique: Technique, joins: Sequence[Join], around: Around, known: Tables) -> None:
        self.technique = technique
        self.around = around
        self.known = known
        self.highest = max(SECOND, *(join.want.number for join in joins))
        self.stages: dict[int, Stage] = {}
        self.found = list(self._found(joins))
        self.used = {id(part) for _, _, part in self.found}
        self.taken: set[str] = set()

    def _found(self, joins: Sequence[Join]) -> Iterator[tuple[Join, Foods, Part]]:
        lines = self.technique.lines
        wishes = [(foods, part, name) for name, parts in lines.items() for part in parts for foods in part.foods]
        wishes.sort(key=lambda wish: (wish[0].again, wish[0].is_rest))
        told = {join.want.part for join in joins} & (lines.keys() - {_MAIN})
        apart = told if any(foods.is_rest for foods, _, _ in wishes) else set()
        once: dict[int, tuple[Join, Foods, Part]] = {}
        taken: dict[int, str] = {}
        for line in sorted(told):  # what a recipe says of it itself comes before all
            meant = [(replace(foods, again=False), part) for foods, part, name in wishes if name == line]
            for join in (join for join in joins if join.want.part == line):
                wish = next((wish for wish in meant if means(wish[0], join.want, self.around)), meant[0])
                taken[join.want.number], once[join.want.number] = line, (join, *wish)
        more: list[tuple[Join, Foods, Part]] = []
        for foods, part, name in wishes:
            found = [join for join in joins if means(foods, join.want, self.around)]
            if foods.again:
                found = [join for join in found if taken.get(join.want.number) != name]
                beside = {one.want.part for one, _, at in once.values() if at in lines[name]} - {"", *told}
                said = [join for join in found if join.want.part in beside]
                once |= {join.want.number: (join, replace(foods, again=False), part) for join in said}
                found = [join for join in found if not join.want.part]
                more += self._again(found, foods, part, once) if not said else ()
            for join in found if name not in apart and not foods.again else ():
                if join.want.number not in once:
                    taken[join.want.number] = name if foods.is_rest else ""  # else two of it are meant: layers
                    once[join.want.number] = (join, foods, part)
        for join in joins:
            if join.want.number not in once and once:
                once[join.want.number] = self._beside(join, list(once.values()))
        yield from once.values()
        yield from more

    def _beside(self, join: Join, placed: Sequence[tuple[Join, Foods, Part]]) -> tuple[Join, Foods, Part]:
        """Return a food that no stage names where the one joins that is listed nearest, for the same part if any is."""
        number, told = join.want.number, join.want.part
        _, _, part = min(placed, key=lambda one: (one[0].want.part != told, abs(one[0].want.number - number)))
        return join, Foods(("*",)), part

    def _again(
        self, found: Sequence[Join], foods: Foods, part: Part, once: dict[int, tuple[Join, Foods, Part]]
    ) -> Iterator[tuple[Join, Foods, Part]]:
        """Yield the second portions that join a part; what a recipe names twice is two portions already.

        Of those the one joins that stands nearest, in the recipe, to the other foods of the part.
        """
        there = [join.want.number for join, _, at in once.values() if at is part]
        labels = Counter(singular(join.want.label) for join in found)
        for label in labels:
            alike = [join for join in found if singular(join.want.label) == label]
            if len(alike) > 1 and not any(join.want.number in there for join in alike):
                near = min(alike, key=lambda join: min((abs(join.want.number - n) for n in there), default=0))
                once[near.want.number] = (near, replace(foods, again=False), part)
            elif len(alike) == 1 and alike[0].want.number not in once:
                once[alike[0].want.number] = (alike[0], replace(foods, again=False), part)
            elif len(alike) == 1 and alike[0].want.number not in there:
                yield alike[0], foods, part

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
        over_heat = work.appliance and work.source == "heat" and "dry" not in work.does and not work.phased
        stage = (partial(Phase, bath=work.bath) if over_heat else Stage)(
            (BATH, *adds) if work.bath else adds, work.motion, work.does, work.tools, part.vessel or work.vessel,
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
        mixes = does == {"mix"} and not any(part.lines for part in parts)
        return found[0] if mixes and len(found) == 1 else None

    def _label(self, part: Part, usual: str) -> str:
        """Return what a stage makes: "~" is what its first food is called."""
        if part.label == "~":
            return next((join.want.label for join, _, at in self.found if at is part), usual)
        return part.label or usual


def means(foods: Foods, want: Want, around: Around) -> bool:
    """Whether a food of a recipe is one of those that a text of the table means."""
    return foods.mean(want.label, want.facts, _states(want) if foods.state else (), around)


def _states(want: Want) -> set[str]:
    """Return what is said of a food: its states, and what ways ask of how it is named and comes."""
    known, label = tables(), want.label
    fine = known.state(want.make).fine or 0 if want.make else 0
    due = {"cook", "boil"} & owed(want, known)
    mash = {want.make, want.then} & word_list("only what is soft is so")
    said = {
        "in one piece": not want.make,
        "in pieces": fine > 1,
        "portion": is_portion(want, known),
        "due": bool(due),
        "raw": "cook" in due and not (want.cooked and want.make),
        "runs": want.squeezed or want.asked in word_list("runs"),
        "several": label != singular(label) or not word_list("is asked twofold").isdisjoint(words(label)),
        "as mash": bool(mash) or "made" in want.facts.traits,
    }
    return {want.asked, want.make, want.then, *want.leaf, *(name for name, holds in said.items() if holds)}


def _prepared(want: Want, foods: Foods, known: Tables) -> tuple[Want, Slot | None]:
    """Return a food as a technique takes it, with the slot that says how it is cooked before."""
    if not foods.made:
        return want, None
    row = preparations()[foods.made]
    slot = Slot(want.label, want.facts.kind, cooked=(row["cooked"],)) if "cooked" in row else None
    cut = bool(want.make) and bool(known.state(want.make).fine)
    want = replace(want, cooked=row.get("said", want.cooked))
    by_hand = dict.fromkeys(sorted(known.state(want.make).earns & BY_HAND) if want.make else (), Level.MINOR)
    if "make" in row and (row.get("always") or not cut):
        squeezed = row["make"] == JUICE and form_of(known, want.label, want.leaf) == "whole"
        want = replace(want, make=row["make"], foamed=bool(row.get("foamed")), squeezed=squeezed)
    if "then" in row and not want.then and not cut:
        want = replace(want, then=row["then"], cooked=True)
    owes = by_hand | dict(want.facts.owes)  # what is asked peeled is peeled, and then halved
    kept = {name: level for name, level in owes.items() if name not in row.get("waives", ())}
    return replace(want, facts=replace(want.facts, owes=kept)), slot
