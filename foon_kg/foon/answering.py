"""How a FOON answers questions: one at once, many in processes, on a cluster, or in parts of a very large graph."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from foon_kg.foon.changing import Changing
from foon_kg.foon.opened import Paths

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.planning.batch import Answer, Cook, Question
    from foon_kg.planning.recipes import IngredientWords, ReadRecipe
    from foon_kg.planning.settings import PlanSettings
    from foon_kg.store.settings import ConnectionSettings
    from foon_kg.validation import KnownFoon

WHOLE = 50_000
"""A FOON of more units is held by no process: each asks the graph for the parts that a recipe needs."""

UNITS_A_RECIPE = 100
"""To read and to learn so many units takes as long as to ask for what one recipe more needs."""

UNCOUNTED = sys.maxsize
"""So many questions are taken for granted where nobody says how many there are."""

_MOST_KEPT = 8
"""For so many different settings what plans is kept ready: each holds what it has learnt of the whole FOON."""


class Answering(Changing):
    """A FOON that answers questions of recipes with settings."""

    @cached_property
    def _cooks(self) -> dict[PlanSettings, Cook]:
        """What plans from files, kept ready by settings."""
        return {}

    def close(self) -> None:
        """Forget what is kept ready, and give connections back. Another question opens them again.

        >>> foon.close()
        """
        self._cooks.clear()
        super().close()

    def known_with(self, settings: PlanSettings) -> KnownFoon:
        """Return what the judge compares a tree's evidence with that was planned with such ``settings``.

        >>> from foon_kg.planning.settings import PlanSettings
        >>> foon.known_with(PlanSettings()) is foon.known
        True
        """
        if not settings.with_drafts:
            return self.known
        from foon_kg.validation import KnownFoon

        with self._cook(settings) as cook:
            return KnownFoon.of(cook.units or (), cook.view.goals())

    def read_recipes(self, *files: Paths) -> Iterator[ReadRecipe]:
        """Yield the recipe in each of ``files`` (JSON) as :meth:`answer` reads it, in the words of this FOON.

        The ``notes`` of each say what had to be decided to read it. Raises :class:`~foon_kg.model.errors.ReadError`
        where one is no recipe.

        >>> from foon_kg.foon.demo import demo_recipes
        >>> [one.recipe.dish_type for one in foon.read_recipes(*demo_recipes()[:2])]
        ['drinks', 'salad']
        """
        from foon_kg.planning.recipes import read_recipe

        words = self.words()  # once: they are sorted out of the whole vocabulary
        for file in files:
            yield read_recipe(Path(file), words)

    def words(self) -> IngredientWords:
        """Return the words in which ingredients and kitchens are read.

        >>> foon.words().vocabulary.dish_types[:2]
        ('drinks', 'omelette')
        """
        from foon_kg.planning.recipes import IngredientWords
        from foon_kg.plans.kitchen import Kitchen

        with self.reading() as view:
            return IngredientWords(view.vocabulary(), Kitchen.default())

    def answer(self, question: Question, settings: PlanSettings, *, explain: bool = False) -> Answer:
        """Return the answer to a ``question`` asked with such ``settings``; its ``error`` is what stands in the way.

        :meth:`plan` raises that error instead, and takes plain words. With ``explain`` it has ``explanations`` too.

        >>> from foon_kg.planning.batch import Question
        >>> from foon_kg.planning.settings import PlanSettings
        >>> asked = Question(dish_type="salad", texts=("chopped onion", "olive oil"))
        >>> len(foon.answer(asked, PlanSettings()).outcome.units)
        6
        """
        with self._cook(settings) as cook:
            return cook.answer(question, explain=explain)

    def get_ready(self, settings: PlanSettings) -> None:
        """Make ready what answers questions with such ``settings``, so that the first waits no longer than others.

        >>> from foon_kg.planning.settings import PlanSettings
        >>> foon.get_ready(PlanSettings())
        """
        with self._cook(settings) as cook:
            cook.get_ready()

    @contextmanager
    def answers(
        self,
        questions: Iterable[Question],
        settings: PlanSettings,
        *,
        count: int | None = None,
        jobs: int | None = None,
        dask: str | None = None,
    ) -> Iterator[Iterable[Answer]]:
        """Open what answers ``questions`` with such ``settings``, in their order, each as :meth:`answer` does.

        Many are answered from the whole FOON as it stands now, where that is cheaper than to ask for what each needs,
        in ``jobs`` processes (as a rule as many cores as it is worth to start one on), or on the cluster of the Dask
        scheduler at ``dask``, whose workers ask the graph themselves where it is too large to be read; none of it
        changes an answer. Questions that are not a sequence are taken one by one;
        ``count`` says how many they are, and without it they are taken for many: the whole FOON is read, on all cores.
        Raises :class:`~foon_kg.model.errors.FoonError` where a process is ended from outside.

        >>> from foon_kg.planning.batch import Question
        >>> from foon_kg.planning.settings import PlanSettings
        >>> asked = [Question(dish_type="salad", texts=("chopped onion", oil)) for oil in ("olive oil", "walnut oil")]
        >>> with foon.answers(asked, PlanSettings()) as answers:
        ...     [len(answer.outcome.units) for answer in answers]
        [6, 6]
        """
        from foon_kg.planning.batch import MANY, processes_for

        if count is None:
            count = len(questions) if isinstance(questions, Sequence) else UNCOUNTED
        if not count:
            yield ()
            return
        jobs = processes_for(count) if jobs is None else jobs
        if dask is not None:
            opened = self._on_cluster(questions, settings, dask)
        elif count < MANY:
            opened = self._of_view(questions, settings, alone=count == 1)
        elif self._is_cheaper_in_parts(settings, max(1, count // jobs)):
            opened = self._in_parts(questions, settings, jobs)
        else:
            opened = self._of_whole(questions, settings, jobs)
        with opened as answers:
            yield answers

    def _is_cheaper_in_parts(self, settings: PlanSettings, recipes: int) -> bool:
        """Whether the FOON is in a graph, and too large for a process to read it whole for so many ``recipes``.

        What drafts teach is read with the whole. So is what another program learnt, as long as that can be.
        """
        if self._snapshot is not None or settings.with_drafts:
            return False
        units = self.unit_count()
        if units > WHOLE:
            return True
        with self._graph.reading() as view:
            return units > UNITS_A_RECIPE * recipes and view.is_learnt_by_this_program

    @contextmanager
    def _on_cluster(
        self, questions: Iterable[Question], settings: PlanSettings, dask: str
    ) -> Iterator[Iterable[Answer]]:
        """Open what answers questions on the cluster of the scheduler at ``dask``: from the whole FOON, sent to all.

        Where no process may read it whole each worker asks the graph, with the address and the password of this one.
        """
        from foon_kg.planning.batch import answering_on
        from foon_kg.planning.cluster import spread_over

        if not settings.with_drafts and self.is_larger_than(WHOLE):
            with spread_over(partial(_asking, self._needs_server("to ask"), settings), questions, dask) as answers:
                yield answers
            return
        with (
            self._viewed(settings, whole=True) as view,
            answering_on(dask, questions, view, settings, view.units) as answers,
        ):
            yield answers

    @contextmanager
    def _of_whole(self, questions: Iterable[Question], settings: PlanSettings, jobs: int) -> Iterator[Iterable[Answer]]:
        """Open what answers questions from the whole FOON in ``jobs`` processes."""
        from foon_kg.planning.batch import Cook, answering

        with self._viewed(settings, whole=True) as view:
            if jobs > 1:
                with answering(questions, view, settings, view.units, jobs) as answers:
                    yield answers
            else:
                yield map(Cook(view, settings, view.units).answer, questions)

    @contextmanager
    def _of_view(
        self, questions: Iterable[Question], settings: PlanSettings, *, alone: bool
    ) -> Iterator[Iterable[Answer]]:
        """Open what answers a few questions here, or one ``alone``; a graph is asked for the parts that each needs."""
        from foon_kg.planning.batch import Cook

        with self._viewed(settings) as view:
            units = None if alone else getattr(view, "units", None)
            yield map(Cook(view, settings, units).answer, questions)

    @contextmanager
    def _in_parts(self, questions: Iterable[Question], settings: PlanSettings, jobs: int) -> Iterator[Iterable[Answer]]:
        """Open what answers questions in ``jobs`` processes, each of which asks the graph for what a recipe needs."""
        from foon_kg.planning.processes import spread

        if jobs > 1:
            with spread(partial(_asking, self._needs_server("to ask"), settings), questions, jobs) as answers:
                yield answers
        else:
            yield (self.answer(question, settings) for question in questions)

    @contextmanager
    def _cook(self, settings: PlanSettings) -> Iterator[Cook]:
        """Open what answers questions with such settings; of files it is kept."""
        from foon_kg.planning.batch import Cook

        if self._snapshot is None:
            with self._viewed(settings) as view:
                yield Cook(view, settings, view.units if settings.with_drafts else None)
            return
        if settings not in self._cooks:
            if len(self._cooks) >= _MOST_KEPT:
                self._cooks.clear()
            known = self.with_drafts() if settings.with_drafts else self._snapshot
            self._cooks[settings] = Cook(known, settings, known.units)
        yield self._cooks[settings]

    @contextmanager
    def _viewed(self, settings: PlanSettings, *, whole: bool = False) -> Iterator[Any]:
        """Open what plans with such settings are made from: the ``whole`` in memory, or what answers in parts."""
        if settings.with_drafts:
            yield self.with_drafts()
        elif whole:
            yield self.snapshot()
        else:
            with self.reading() as view:
                yield view


def _asking(server: ConnectionSettings, settings: PlanSettings) -> Callable[[Question], Answer]:
    """Return what answers questions from the graph, for a process of its own."""
    foon = Answering(server=server)
    return lambda question: foon.answer(question, settings)
