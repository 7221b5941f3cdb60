"""A task tree as lines of a terminal, at any width from 40 columns on."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rich.console import Console, ConsoleOptions, Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.substitution import done_like, handled
from foon_kg.formats.views.lives import lives
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.words import (
    ALARM,
    ASIDE,
    MOTION,
    STATE,
    UNSEEN,
    UNSEEN_SIGN,
    food_words,
    in_a_row,
    motion_words,
    node_words,
    section,
    shown_inputs,
    shown_outputs,
    stage_words,
)
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.claims import Substitution
from foon_kg.model.tree import Step, things_found
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.progress import ProgressLine
from foon_kg.plans.result import PlanResult

WIDE = 140
"""From so many columns on, what belongs to the steps stands beside them."""


def plan_view(result: PlanResult) -> RenderableType:
    """Return the whole plan of ``result``.

    That is what it makes, the steps, the kitchen, what was substituted or assumed, and the progress lines.
    """
    return tree_view(ShownTree.of_result(result))


def tree_view(tree: ShownTree, *, as_units: bool = False) -> RenderableType:
    """Return the same of any tree, as far as it is known; its steps as sentences, or ``as_units`` of the FOON."""
    unseen = frozenset(tree.unseen)
    rest = list(_beside_the_steps(tree, unseen))
    if unseen and not as_units:
        legend = f"{UNSEEN_SIGN} handled like another food: no video shows it so"
        rest.append(Padding(Text(legend, ASIDE), (1, 0, 0, 0)))
    header = _header(tree.result, unseen) if tree.result else _plain_header(tree)
    steps = _units(tree.units, unseen) if as_units else _sentences(tree.units, unseen)
    return Group(header, _Beside(section("Steps", steps), Group(*rest)))


def _beside_the_steps(tree: ShownTree, unseen: frozenset[str]) -> Iterator[RenderableType]:
    """Yield what there is to say of a tree besides its steps; foods that are ``unseen`` carry their sign."""
    found = things_found(tree.units)
    there = (_numbered(node_words(n, unseen), len(found.get(n, ()))) for n in _at_hand(tree.kitchen))
    yield section("Kitchen", in_a_row(there, " · "))
    if tree.substitutions:
        yield section("Substitutions", _substitutions(tree.substitutions))
    if tree.result and tree.result.assumptions:
        yield section("Assumptions", _assumptions(tree.result))
    if tree.result and tree.result.passed_over:
        yield section("Nearer by their foods, and passed over", _passed_over(tree.result))
    if tree.lines:
        yield section("Progress of each ingredient", _progress(lives(tree.lines), unseen))


def _numbered(words: Text, number: int) -> Text:
    """Return the ``words`` of a thing, and how many of them are needed where one is not enough."""
    return Text.assemble(f"{number} x ", words) if number > 1 else words


def _at_hand(kitchen: Sequence[ObjectNode]) -> Iterator[ObjectNode]:
    """Yield what has to be there; a packet is told by what is sold in it."""
    within = {(node.label, node.container) for node in kitchen}
    for node in kitchen:
        if not node.ingredients or not all((food, node.label) in within for food in node.ingredients):
            yield node


def progress_view(tree: ShownTree) -> RenderableType:
    """Return the progress line of every ingredient of ``tree``."""
    return _progress(tree.lines, frozenset(tree.unseen))


@dataclass(frozen=True)
class _Beside:
    """Two things side by side where there is room for it, else one under the other."""

    left: RenderableType
    right: RenderableType

    def __rich_console__(self, _console: Console, options: ConsoleOptions) -> Iterator[RenderableType]:
        if options.max_width < WIDE:
            yield from (self.left, self.right)
            return
        table = Table.grid(expand=True, padding=(0, 4, 0, 0))
        table.add_column(ratio=3)
        table.add_column(ratio=2)
        table.add_row(self.left, self.right)
        yield table


def _dish_name(recipe: Recipe) -> str:
    """Return what to call a recipe: its title, else its id, else its dish type."""
    return recipe.title or recipe.id or recipe.dish_type


def _header(result: PlanResult, unseen: frozenset[str]) -> RenderableType:
    table = Table.grid(padding=(0, 1))
    asked = Text(", ").join(_asked(wanted) for wanted in result.recipe.ingredients)
    name, dish_type = _dish_name(result.recipe), result.recipe.dish_type
    table.add_row(Text("dish", ASIDE), Text(name if name == dish_type else f"{name} ({dish_type})", "bold"))
    table.add_row(Text("asked", ASIDE), asked)
    table.add_row(Text("makes", ASIDE), node_words(result.goal, unseen))
    if result.reference.technique:
        told = f"{result.reference.technique}: by foon-kg's own tables, no video shows these steps in this order"
        table.add_row(Text("made as", ASIDE), Text(told))
        table.add_row(Text("nearest", ASIDE), _reference(result))
    else:
        table.add_row(Text("like", ASIDE), _reference(result))
    return table


def _asked(wanted: RequiredIngredient) -> Text:
    return Text.assemble(f"{wanted.amount} {wanted.object} (".lstrip(), (wanted.state, STATE), ")")


def _reference(result: PlanResult) -> Text:
    reference = result.reference
    proven = (
        "proven: no shorter way, and none that takes more of them" if reference.exact else "the best one found in time"
    )
    covered = f"{reference.units} steps, {reference.overlap} of the {len(result.recipe.ingredients)} ingredients"
    seen = f" (video {', '.join(reference.videos)})" if reference.videos else ""
    if reference.draft_confidence is None:
        return Text(f"{reference.goal.label}{seen}: {covered}, {proven}")
    names = ", ".join(reference.videos)
    told = f" ({names}: drafted from a recipe's words, not reviewed, {reference.draft_confidence:.2f} sure)"
    return Text.assemble(reference.goal.label, (told, "yellow"), f": {covered}, {proven}")


def _plain_header(tree: ShownTree) -> RenderableType:
    table = Table.grid(padding=(0, 1))
    table.add_row(Text("tree", ASIDE), Text(tree.title, "bold"))
    table.add_row(Text("makes", ASIDE), node_words(tree.goal))
    return table


def _sentences(units: Sequence[Step], unseen: frozenset[str]) -> Table:
    """Return each step as a sentence for a cook."""
    kitchen = Kitchen.default()
    table = Table.grid(padding=(0, 1))
    table.add_column(justify="right", style=ASIDE)
    for number, unit in enumerate(units, start=1):
        text = Text(_marked(sentence(unit, kitchen, unit.measures), unseen))
        text.highlight_words([f"{UNSEEN_SIGN}{name}" for name in unseen], UNSEEN, case_sensitive=False)
        table.add_row(str(number), _with_source(text, unit))
    return table


def _marked(told: str, unseen: frozenset[str]) -> str:
    """Return a sentence in which foods that the FOON has never seen carry their sign."""
    for name in sorted(unseen, key=len, reverse=True):
        told = re.sub(
            rf"(?<![\w{UNSEEN_SIGN}]){re.escape(name)}(?!\w)", rf"{UNSEEN_SIGN}\g<0>", told, flags=re.IGNORECASE
        )
    return told


def _with_source(text: Text, unit: Step) -> Text:
    if unit.origin == "foon" or not unit.seen_in:
        return text
    alone = unit.grounding == "motion" and any(map(Kitchen.default().is_food, unit.input_nodes))
    how = "only the motion, as in" if alone else "like"
    return text.append(f"  [{how} {unit.seen_in[0].video}]", ASIDE)


def _units(units: Sequence[Step], unseen: frozenset[str]) -> Table:
    table = Table.grid(padding=(0, 1))
    table.add_column(justify="right", style=ASIDE)
    told: set[tuple[str, tuple[str, ...]]] = set()
    for number, unit in enumerate(units, start=1):
        table.add_row(str(number), _step(unit, unseen, told))
    return table


def _step(unit: Step, unseen: frozenset[str], told: set[tuple[str, tuple[str, ...]]]) -> Text:
    """Return what goes in, what is done and what comes out; what something holds is told once (``told``)."""

    def words(node: ObjectNode) -> Text:
        contents = (node.label, node.ingredients)
        new = contents not in told
        told.add(contents)
        return node_words(node, unseen, contents=new)

    taken = in_a_row(map(words, shown_inputs(unit.input_nodes)), " + ")
    made = in_a_row(map(words, shown_outputs(unit.output_nodes)), " + ")
    return _with_source(Text.assemble(taken, " → ", motion_words(unit.motion), " → ", made), unit)


def _substitutions(substitutions: tuple[Substitution, ...]) -> Table:
    table = Table.grid(padding=(0, 1))
    table.add_column(justify="right", style=ASIDE)
    for one in substitutions:
        table.add_row(f"{one.confidence:.2f}", _substitution(one))
    return table


def _substitution(one: Substitution) -> Text:
    if one.for_want:
        return Text.assemble(("! ", ALARM), (UNSEEN_SIGN + one.required, UNSEEN), (f" {handled(one)}", ALARM))
    if one.kind == "object":
        text = Text.assemble((UNSEEN_SIGN + one.required, UNSEEN), f" {handled(one)}")
    else:
        text = Text(done_like(one))
    others = ", ".join(f"{other.name} {other.confidence:.2f}" for other in one.alternatives)
    return text.append(f"  or {others}", ASIDE) if others else text


def _assumptions(result: PlanResult) -> RenderableType:
    return Group(*(Text.assemble(node_words(one.node), f": {one.why}") for one in result.assumptions))


def _passed_over(result: PlanResult) -> RenderableType:
    return Group(*(Text(f"{one.similarity:.2f} {one.goal.label}: {one.why}") for one in result.passed_over))


def _progress(lines: tuple[ProgressLine, ...], unseen: frozenset[str]) -> Group:
    return Group(*(_line(line, unseen) for line in lines))


def _line(line: ProgressLine, unseen: frozenset[str]) -> RenderableType:
    if not line.steps:
        return Text.assemble(food_words(line.ingredient, unseen), (" does not reach the dish", ASIDE))
    return Group(food_words(line.ingredient, unseen), Padding(Text(" ").join(_stages(line)), (0, 0, 0, 2)))


def _stages(line: ProgressLine) -> Iterator[Text]:
    """Yield each stage and the motion that ends it; what the food has become part of is named where that changes."""
    name = line.ingredient
    for step in line.steps:
        stage = stage_words(step.states, step.relation, step.container)
        if step.object and step.object != name:
            name = step.object
            stage = Text.assemble(f"{name} ", stage)
        yield stage or Text("as it is")
        yield Text(f"→ {step.motion} →", MOTION)
    yield Text(line.end_product or "", "bold")
