"""A plan as Python has it: its steps as sentences, what it says of itself, and its other forms."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Protocol

from foon_kg.formats.exports.formats import export_tree
from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import ObjectNode
from foon_kg.model.claims import Assumption, Substitution
from foon_kg.model.errors import UsageError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.tree import Step
from foon_kg.planning.batch import Answer, Question
from foon_kg.planning.explanation import Explanations
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.result import PlanResult
from foon_kg.validation import KnownFoon, Report, check

if TYPE_CHECKING:  # what only some callers have installed
    import networkx as nx
    import pandas as pd


class AskedAgain(Protocol):
    """What a plan asks of the FOON that it comes from."""

    def known_with(self, settings: PlanSettings) -> KnownFoon:
        """Return what the judge compares evidence with where a plan is made with ``settings``."""
        ...

    def answer(self, question: Question, settings: PlanSettings, *, explain: bool = False) -> Answer:
        """Return the answer to a ``question`` by these ``settings``, with explanations where it shall ``explain``."""
        ...


class Plan:
    """A task tree that makes a dish, in the order in which it is carried out. A notebook shows it as a table."""

    def __init__(self, result: PlanResult, foon: AskedAgain, settings: PlanSettings, notes: Sequence[str] = ()) -> None:
        self.result = result
        """The answer as :meth:`~foon_kg.plans.result.PlanResult.to_json` writes it."""
        self.notes = tuple(notes)
        """What had to be decided to read the question, a sentence each."""
        self._foon = foon
        self._settings = settings

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The steps of :attr:`result`, with their numbers from 1 and a sentence for a cook (``text``) each.

        >>> print(plan.steps[1])
        2. Peel the onion with the knife.
        >>> plan.steps[1].motion, plan.steps[1].phase, plan.steps[1].seen_in[0].video
        ('peel', 'prepare', 'bean_salad')
        """
        kitchen = self._settings.kitchen
        return tuple(
            replace(unit, number=number, text=sentence(unit, kitchen, unit.measures))
            for number, unit in enumerate(self.result.units, start=1)
        )

    @property
    def goal(self) -> ObjectNode:
        """The dish.

        >>> print(plan.goal)
        salad (mixed; {olive oil, onion, tomato}; in salad bowl)
        """
        return self.result.goal

    @property
    def substitutions(self) -> tuple[Substitution, ...]:
        """What is handled like another food or read as another state, with a confidence from 0 to 1 each.

        >>> plan.substitutions
        ()
        """
        return self.result.substitutions

    @property
    def assumptions(self) -> tuple[Assumption, ...]:
        """What no step makes so and is taken to be so, and why.

        >>> plan.assumptions
        ()
        """
        return self.result.assumptions

    def check(self) -> Report:
        """Return what the judge says: whether a robot could carry it out and a cook would serve it, and every finding.

        The judge knows nothing of the planner (docs/contract.md). Printed it is what ``foon check`` prints.

        >>> plan.check().accepted
        True
        >>> print(plan.check())
        plan: accepted (robot yes, cook yes, form kept)
        """
        known, kitchen = self._foon.known_with(self._settings), self._settings.kitchen
        return check(self.result.tree, known, kitchen.free_foods, named_so=kitchen.names_so)

    def explain(self) -> Explanations:
        """Return for each asked food why it is made as it is: after which dish, where it joins, on what evidence.

        Printed it is sentences, each :class:`~foon_kg.foon.Explanation` of it has the same as fields.

        >>> plan.explain()[0].videos
        ('bean_salad', 'farmhouse_omelette', 'garden_salad')
        >>> print(plan.explain()[2])
        olive oil (liquid)
          has a place in the recorded dish, and is handled as FOON handles it in bean_salad, garden_salad
          joins the others in step 7 (pour), where olive oil joins in the recorded dish (1.00 like it)
        """
        question = Question(given=self.result.recipe)
        return Explanations(self._foon.answer(question, self._settings, explain=True).explanations)

    def to_json(self) -> JsonObject:
        """Return the plan as ``foon plan --json`` prints it.

        >>> plan.to_json()["reference"]["videos"]
        ['greek_salad']
        """
        return self.result.to_json()

    def to_frame(self) -> pd.DataFrame:
        """Return the steps as a table, a row each, with motion, inputs, outputs, video, start and end (seconds).

        Raises :class:`~foon_kg.model.errors.UsageError` where pandas is not installed.

        >>> plan.to_frame()["motion"][2]
        'peel'
        """
        from foon_kg.formats.views.notebook import steps_frame

        return steps_frame(self.to_json())

    def to_networkx(self) -> nx.DiGraph[str]:
        """Return the tree as a graph of networkx: objects and motions are nodes, what goes in and comes out edges.

        A node has ``kind`` (``object`` or ``motion``), ``label`` and, of a motion, ``step`` (from 1). Raises
        :class:`~foon_kg.model.errors.UsageError` where networkx is not installed.

        >>> plan.to_networkx().nodes["2 peel"]["kind"]
        'motion'
        """
        try:
            import networkx as nx
        except ModuleNotFoundError as error:
            raise UsageError("this needs networkx, which is not installed", hint="pip install networkx") from error
        graph = nx.DiGraph()
        for step in self.steps:
            motion = f"{step.number} {step.motion}"
            graph.add_node(motion, kind="motion", label=step.motion, step=step.number)
            for node in (*step.input_nodes, *step.output_nodes):
                graph.add_node(str(node), kind="object", label=node.label)
            graph.add_edges_from((str(node), motion) for node in step.input_nodes)
            graph.add_edges_from((motion, str(node)) for node in step.output_nodes)
        return graph

    def to_svg(self) -> str:
        """Return a picture of the tree. Raises ``UsageError`` without the extra ``pictures``.

        >>> plan.to_svg()[:4]
        '<svg'
        """
        from foon_kg.formats.views.shown_tree import ShownTree
        from foon_kg.model.extras import missing

        try:
            from foon_kg.formats.pictures.tree import tree_svg

            return tree_svg(ShownTree.of_result(self.result), self._settings.kitchen)
        except ModuleNotFoundError as error:
            raise missing(error) or error from error

    def export(self, form: str) -> str:
        """Return the plan in another program's form; where that is several files, one after the other with their names.

        ``form``: ``foon``, ``json``, ``dot``, ``mermaid``, ``graphml``, ``markdown``, ``behaviour-tree`` or ``pddl``.
        Raises :class:`~foon_kg.model.errors.UsageError` for another one.

        >>> print(plan.export("markdown").splitlines()[0])
        # Salad
        """
        files = export_tree(ExportedTree.of_plan(self.result), form)
        if len(files) == 1:
            return files[0].text
        return "\n".join(f"; {file.name}\n{file.text}" for file in files)

    def __str__(self) -> str:
        return "\n".join(map(str, self.steps))

    def __len__(self) -> int:
        return len(self.result.units)

    def __iter__(self) -> Iterator[Step]:
        return iter(self.steps)

    def __repr__(self) -> str:
        recipe = self.result.recipe
        return f"<Plan of {recipe.title or recipe.dish_type or self.goal.label}: {len(self)} steps>"

    def _repr_html_(self) -> str:
        from foon_kg.formats.views.notebook import plan_html

        return plan_html(self.to_json())
