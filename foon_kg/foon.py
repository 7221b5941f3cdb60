"""The front door: a FOON to ask, from Python.

>>> from foon_kg import Foon
>>> from foon_kg.demo import demo_folder
>>> foon = Foon.from_files(demo_folder())
>>> plan = foon.plan("salad", ["chopped onion", "diced tomato", "olive oil"])
>>> print(plan.steps[1].text)
Peel the onion with the knife.
>>> plan.check().accepted
True
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from foon_kg.formats.exports.formats import export_tree
from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient, Sighting
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.knowledge import Neighbour
from foon_kg.planning.batch import Cook, Question
from foon_kg.planning.explanation import Explanation
from foon_kg.planning.settings import PlanSettings, Substitute
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import Assumption, PlannedUnit, PlanResult, Substitution
from foon_kg.store.snapshot import Snapshot
from foon_kg.validation import KnownFoon, Report, TaskTree, check

if TYPE_CHECKING:  # what only some callers have installed
    import networkx as nx
    import pandas as pd

    from foon_kg.planning.suggestion import Suggestion
    from foon_kg.search.classic import RetrievalResult
    from foon_kg.store.graph import GraphView
    from foon_kg.store.graph.free_cypher import Answer
    from foon_kg.store.graph.loading import LoadReport
    from foon_kg.store.server import ConnectionSettings

Paths = str | os.PathLike[str]


@dataclass(frozen=True)
class Step:
    """One step of a plan: ``text`` is a sentence for a cook, ``motion`` the FOON's own word for what is done.

    ``inputs`` and ``outputs`` are the objects before and after it. ``seen_in`` are the places in videos that attest it,
    ``origin`` says how near they are (``exact``, ``food``, ``like``, ``kind``, ``motion``).
    """

    number: int
    text: str
    motion: str
    inputs: tuple[ObjectNode, ...]
    outputs: tuple[ObjectNode, ...]
    origin: str
    seen_in: tuple[Sighting, ...]

    def __str__(self) -> str:
        return f"{self.number}. {self.text}"


class Plan:
    """A task tree that makes a dish, in the order in which it is carried out. A notebook shows it as a table."""

    def __init__(self, result: PlanResult, foon: Foon, settings: PlanSettings, notes: Sequence[str] = ()) -> None:
        self.result = result
        """The answer as :meth:`~foon_kg.plans.result.PlanResult.to_json` writes it."""
        self.notes = tuple(notes)
        """What had to be decided to read the question, a sentence each."""
        self._foon = foon
        self._settings = settings

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The steps, numbered from 1.

        >>> print(plan.steps[1])
        2. Peel the onion with the knife.
        >>> plan.steps[1].motion
        'peel'
        """
        return tuple(self._step(number, unit) for number, unit in enumerate(self.result.units, start=1))

    def _step(self, number: int, unit: PlannedUnit) -> Step:
        text = sentence(unit.as_unit(), self._settings.kitchen)
        return Step(number, text, unit.motion_node, unit.input_nodes, unit.output_nodes, unit.origin, unit.seen_in)

    @property
    def goal(self) -> ObjectNode:
        """The dish.

        >>> print(plan.goal)
        salad (mixed; {olive oil, onion, tomato}; in salad bowl)
        """
        return self.result.goal

    @property
    def substitutions(self) -> tuple[Substitution, ...]:
        """What is handled like another food or read as another state, with a confidence from 0 to 1 each."""
        return self.result.substitutions

    @property
    def assumptions(self) -> tuple[Assumption, ...]:
        """What no step makes so and is taken to be so, and why."""
        return self.result.assumptions

    def check(self) -> Report:
        """Return what the judge says: whether a robot could carry it out and a cook would serve it, and every finding.

        The judge knows nothing of the planner (docs/contract.md).

        >>> plan.check().accepted
        True
        """
        tree = TaskTree.from_json(self.result.to_json())
        return check(tree, self._foon.known, free=self._settings.kitchen.free_foods)

    def explain(self) -> tuple[Explanation, ...]:
        """Return for each asked food why it is made as it is: after which dish, where it joins, on what evidence.

        >>> plan.explain()[0].videos
        ('bean_salad', 'farmhouse_omelette', 'garden_salad')
        """
        question = Question(given=self.result.recipe)
        return self._foon.answer(question, self._settings, explain=True)[1]

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
        return self.result.to_frame()

    def to_networkx(self) -> nx.DiGraph[str]:
        """Return the tree as a graph of networkx: objects and motions are nodes, what goes in and comes out edges.

        A node has ``kind`` (``object`` or ``motion``), ``label`` and, of a motion, ``step`` (from 1). Raises
        :class:`~foon_kg.model.errors.UsageError` where networkx is not installed.

        >>> plan.to_networkx().nodes["2 peel"]["kind"]
        'motion'
        """
        try:
            import networkx as nx  # noqa: PLC0415 - only this needs it, and it is not always there
        except ModuleNotFoundError as error:
            raise UsageError("to_networkx() needs networkx", hint="Install it with: pip install networkx") from error
        graph = nx.DiGraph()
        for step in self.steps:
            motion = f"{step.number} {step.motion}"
            graph.add_node(motion, kind="motion", label=step.motion, step=step.number)
            for node in (*step.inputs, *step.outputs):
                graph.add_node(str(node), kind="object", label=node.label)
            graph.add_edges_from((str(node), motion) for node in step.inputs)
            graph.add_edges_from((motion, str(node)) for node in step.outputs)
        return graph

    def to_svg(self) -> str:
        """Return a picture of the tree. Raises ``UsageError`` without the extra ``pictures``.

        >>> plan.to_svg()[:4]
        '<svg'
        """
        from foon_kg.formats.pictures.tree import tree_svg  # noqa: PLC0415 - what draws takes long to import
        from foon_kg.formats.views.shown_tree import ShownTree  # noqa: PLC0415
        from foon_kg.model.extras import missing  # noqa: PLC0415

        try:
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
        return self.result._repr_html_()


class Foon:
    """A FOON to plan with: files in memory (:meth:`from_files`) or a Neo4j (:meth:`connect`).

    It is a context manager; :meth:`close` gives connections back.
    """

    def __init__(self, snapshot: Snapshot | None = None, server: ConnectionSettings | None = None) -> None:
        if (snapshot is None) == (server is None):
            raise UsageError("a FOON is in files or in a Neo4j", hint="Call Foon.from_files or Foon.connect.")
        self._snapshot = snapshot
        self._server = server
        self._cooks: dict[PlanSettings, Cook] = {}

    @classmethod
    def from_files(cls, *paths: Paths) -> Self:
        """Read subgraph files and tables, and all in folders. What of them cannot be used is left out.

        Raises :class:`~foon_kg.model.errors.ReadError` where there is nothing to read.

        >>> Foon.from_files(demo_folder())
        <Foon of 23 videos in memory>
        """
        from foon_kg.loaders.video_tables import read_videos  # noqa: PLC0415 - who connects reads no files

        found = [result.subgraph for result in read_videos([Path(path) for path in paths])]
        subgraphs = [subgraph for subgraph in found if subgraph is not None]
        if not subgraphs:
            names = ", ".join(map(str, paths)) or "no path"
            raise ReadError(f"there is no FOON in {names}", hint="Name subgraph files or folders.")
        return cls(snapshot=Snapshot.of(subgraphs, Kitchen.default()))

    @classmethod
    def connect(cls, uri: str | None = None, user: str = "neo4j", password: str = "", database: str = "neo4j") -> Self:
        """Connect to the Neo4j at ``uri``; without one to that of NEO4J_URI, else to foon-kg's own, which is started.

        Raises :class:`~foon_kg.model.errors.ServerError` where the own one cannot be started; whether a Neo4j answers
        shows the first question (:class:`~foon_kg.model.errors.GraphError`).
        """
        from foon_kg.store.server import ConnectionSettings, connection_settings  # noqa: PLC0415

        if uri is None:
            return cls(server=connection_settings(lambda _: None))
        return cls(server=ConnectionSettings(uri, user, password, database))

    def close(self) -> None:
        """Forget what is kept ready."""
        self._cooks.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        if self._snapshot is not None:
            return f"<Foon of {len(self._snapshot.subgraphs)} videos in memory>"
        return f"<Foon at {self._server.uri if self._server else ''}>"

    @contextmanager
    def reading(self) -> Iterator[Snapshot | GraphView]:
        """Open the FOON for reading, for what this class has no method for.

        >>> with foon.reading() as view:
        ...     len(view.goals())
        23
        """
        if self._snapshot is not None:
            yield self._snapshot
            return
        from foon_kg.store.graph import Neo4jGraph  # noqa: PLC0415 - who reads files needs no driver

        with Neo4jGraph(self._needs_server("to read")) as graph, graph.reading() as view:
            yield view

    @cached_property
    def known(self) -> KnownFoon:
        """What the judge compares a tree's evidence with."""
        if self._snapshot is not None:
            return KnownFoon.of(self._snapshot.units, self._snapshot.goals())
        from foon_kg.store.graph import Neo4jGraph  # noqa: PLC0415

        with Neo4jGraph(self._needs_server("to judge")) as graph:
            whole = graph.snapshot()
        return KnownFoon.of(whole.units, whole.goals())

    # --- questions ---

    def plan(
        self,
        dish_type: str,
        ingredients: Iterable[str | tuple[str, str]],
        *,
        title: str | None = None,
        avoid: Sequence[str] = (),
        substitute: Mapping[str, str] | None = None,
        kitchen: Kitchen | None = None,
    ) -> Plan:
        """Return the task tree that makes a dish of ``dish_type`` (``""``: the one most like these foods).

        ``ingredients`` are in words (``"chopped onion"``) or pairs of food and state. ``title`` is read: a creamy soup
        is blended. ``avoid`` names foods or kinds of food that no step may have, ``substitute`` by which known food an
        asked one is handled, ``kitchen`` what is at hand. Algorithms 1 to 4 of the paper.

        Raises :class:`~foon_kg.model.errors.NoTreeError` where the FOON has no way to make it, and
        :class:`~foon_kg.model.errors.UsageError` for a dish type or foods that nobody knows.

        >>> plan = foon.plan("salad", [("onion", "chopped"), ("olive oil", "")], avoid=["nuts"])
        >>> len(plan)
        6
        """
        chosen = tuple(Substitute(food, like) for food, like in (substitute or {}).items())
        settings = PlanSettings(kitchen or Kitchen.default(), substitutes=chosen, avoided=tuple(avoid))
        asked = list(ingredients)
        pairs = [one for one in asked if not isinstance(one, str)]
        if pairs and len(pairs) < len(asked):
            raise UsageError("ingredients are words or pairs", hint="Give all of them in one way.")
        if pairs or title is not None:
            given = pairs or self._read(dish_type, [one for one in asked if isinstance(one, str)], settings)
            wanted = tuple(RequiredIngredient(food, state) for food, state in given)
            question = Question(given=Recipe(dish_type, wanted, title=title))
        else:
            question = Question(dish_type=dish_type, texts=tuple(one for one in asked if isinstance(one, str)))
        result, _, notes = self.answer(question, settings)
        return Plan(result, self, settings, notes)

    def _read(self, dish_type: str, texts: Sequence[str], settings: PlanSettings) -> list[tuple[str, str]]:
        question = Question(dish_type=dish_type, texts=tuple(texts))
        with self._cook(settings) as cook:
            read = question.read(cook.words_for(question))
        return [(wanted.object, wanted.state) for wanted in read.recipe.ingredients]

    def answer(
        self, question: Question, settings: PlanSettings, *, explain: bool = False
    ) -> tuple[PlanResult, tuple[Explanation, ...], tuple[str, ...]]:
        """Return the answer to a question with its explanations and notes; raises what stands in its way."""
        with self._cook(settings) as cook:
            answer = cook.answer(question, explain=explain)
        if answer.error is not None or not isinstance(answer.outcome, PlanResult):
            raise answer.error or UsageError("there is no answer", hint="Ask something.")
        return answer.outcome, answer.explanations, answer.notes

    @contextmanager
    def _cook(self, settings: PlanSettings) -> Iterator[Cook]:
        """Open what answers questions with such settings; of files it is kept."""
        if self._snapshot is None:
            with self.reading() as view:
                yield Cook(view, settings)
            return
        if settings not in self._cooks:
            if len(self._cooks) >= _MOST_KEPT:
                self._cooks.clear()
            self._cooks[settings] = Cook(self._snapshot, settings, self._snapshot.units)
        yield self._cooks[settings]

    def similar(self, food: str, limit: int = 5) -> tuple[Neighbour, ...]:
        """Return the known foods that can stand for ``food``, the best first, each with a confidence from 0 to 1.

        >>> foon.similar("caper", limit=1)[0].name
        'black olive'
        """
        with self.reading() as view:
            return view.equivalents([food], limit=limit)[0]

    def retrieve(
        self, goal: str, states: Iterable[str] = (), ingredients: Iterable[str] = (), *, kitchen: Kitchen | None = None
    ) -> RetrievalResult:
        """Return the shortest tree of a goal that the FOON has as it is, proven: classic retrieval (algorithm 3).

        Raises :class:`~foon_kg.model.errors.NoTreeError` where there is none.

        >>> len(foon.retrieve("omelette").units)
        10
        """
        from foon_kg.model.levels import Level  # noqa: PLC0415
        from foon_kg.search.classic import Criterion, GoalSought, retrieve_tree  # noqa: PLC0415

        sought = GoalSought(goal, tuple(states), tuple(ingredients), None, Level(2), Criterion("units"))
        with self.reading() as view:
            return retrieve_tree(view, sought, kitchen or Kitchen.default(), view.motion_costs())

    def suggest(self, foods: Iterable[str], most: int = 5) -> tuple[Suggestion, ...]:
        """Return what can be made of ``foods``, the best first; utensils among them are then the only ones.

        >>> foon.suggest(["egg", "butter", "salt"], most=1)[0].goal.node.label
        'omelette'
        """
        from foon_kg.planning.kitchen_file import Entry, ThingReader  # noqa: PLC0415
        from foon_kg.planning.recipes import IngredientWords  # noqa: PLC0415
        from foon_kg.planning.suggestion import suggest  # noqa: PLC0415
        from foon_kg.plans.stock import StockedKitchen  # noqa: PLC0415

        with self.reading() as view:
            reader = ThingReader(IngredientWords(view.vocabulary(), Kitchen.default()))
            things = [reader.read(Entry(f"“{text}”", text))[0] for text in foods]
            stocked = StockedKitchen.of(Kitchen.default(), ()).with_things(things)
            return tuple(suggest(view, stocked, most=most).found)

    # --- Neo4j alone ---

    def cypher(self, text: str, limit: int = 1_000, **parameters: Any) -> Answer:  # noqa: ANN401 - whatever Cypher takes
        """Return the rows of a question in Cypher, at most ``limit``; what is more than a look at the graph is refused.

        Raises :class:`~foon_kg.model.errors.GraphError`, and :class:`~foon_kg.model.errors.UsageError` for a FOON in
        files.
        """
        from foon_kg.store.graph import Connection  # noqa: PLC0415
        from foon_kg.store.graph.free_cypher import ask_freely  # noqa: PLC0415

        with Connection(self._needs_server("to be asked in Cypher")) as connection:
            return ask_freely(connection, text, parameters, limit=limit)

    def load(self, *paths: Paths) -> LoadReport:
        """Bring files and tables into the graph, all or none, and return which were new, replaced and unchanged.

        Raises :class:`~foon_kg.model.errors.ReadError` where one of them cannot be read whole, and
        :class:`~foon_kg.model.errors.UsageError` for a FOON in files.
        """
        from foon_kg.loaders import Severity  # noqa: PLC0415
        from foon_kg.loaders.video_tables import read_videos  # noqa: PLC0415
        from foon_kg.store.graph import Connection, load  # noqa: PLC0415

        settings = self._needs_server("to load files")
        results = list(read_videos([Path(path) for path in paths]))
        bad = [notice for result in results for notice in result.notices if notice.severity is Severity.REJECTED]
        if bad:
            raise ReadError(str(bad[0]), hint="Mend it, or load with “foon load foon --bad-tolerance”.")
        subgraphs = [result.subgraph for result in results if result.subgraph is not None]
        with Connection(settings) as connection:
            report = load(connection, subgraphs)
        self.__dict__.pop("known", None)
        return report

    def _needs_server(self, what: str) -> ConnectionSettings:
        if self._server is None:
            raise UsageError(f"a FOON in files has no Neo4j {what}", hint="Use Foon.connect().")
        return self._server


_MOST_KEPT = 8
"""For so many different settings what plans is kept ready."""
