"""Many recipes planned from one FOON, on several cores, answered one by one in the order in which they were asked."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path

from foon_kg.integration.methods import TeachingView
from foon_kg.model import KnownUnit, Recipe
from foon_kg.model.errors import FoonError, GraphError, NoTreeError, ReadError, UsageError
from foon_kg.model.knowledge import Vocabulary
from foon_kg.model.names import canonical
from foon_kg.model.nodes import name_of_file
from foon_kg.planning.avoidance import without_avoided
from foon_kg.planning.considered import Considered
from foon_kg.planning.explanation import Explanation
from foon_kg.planning.planner import Planner
from foon_kg.planning.recipes import (
    IngredientWords,
    ReadRecipe,
    foods_named,
    of_known_type,
    read_recipe,
    recipe_of,
    with_states,
)
from foon_kg.planning.settings import PlanSettings, Substitute
from foon_kg.planning.several_asked import names_in
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanFailure, PlanResult

MOST_WRITES = 20
"""So often a question is asked anew because somebody wrote meanwhile."""

MANY = 4
"""From so many recipes on it is looked whether a whole FOON is better kept ready."""

SHARE = 64
"""With so many recipes for each, processes are worth the second or two that each takes to start and to learn."""


@dataclass(frozen=True)
class Question:
    """A recipe still to be read: its file, ``given`` without all states, or a dish type and ingredients in words.

    ``title`` is what a recipe in words is called.

    >>> Question(dish_type="soup", texts=("sliced leek", "water"), title="Cream of leek soup").stand_in.dish_type
    'soup'
    """

    path: Path | None = None
    dish_type: str = ""
    texts: tuple[str, ...] = ()
    given: Recipe | None = None
    title: str | None = None

    def read(self, words: IngredientWords, avoided: Sequence[str] = ()) -> ReadRecipe:
        """Return the recipe as ``words`` read its foods, without what is ``avoided`` (foods, kinds, allergens).

        Its notes say what had to be decided. Raises ReadError where the file cannot be read, and UsageError where the
        words ask for nothing, or nothing is left of them.

        >>> words = IngredientWords(Vocabulary((), (), ()), Kitchen.default())
        >>> read = Question(dish_type="risotto", texts=("boiled rice", "butter")).read(words, avoided=["milk"])
        >>> read.recipe.dish_type, read.recipe.title, [wanted.object for wanted in read.recipe.ingredients]
        ('rice', 'risotto', ['boiled rice'])
        >>> read.notes[-1]
        '“butter” is left out: “milk” may be in it'
        """
        if self.given is not None:
            read = with_states(self.given, words)
        elif self.path is not None:
            read = read_recipe(self.path, words)
        else:
            read = recipe_of(self.dish_type, self.texts, words, self.title)
        read = of_known_type(read)
        recipe, notes = without_avoided(read.recipe, avoided)
        return ReadRecipe(recipe, (*read.notes, *notes))

    def names(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """For the planner alone: return the foods that are named, and of what is in words all that may name foods.

        >>> Question(dish_type="salad", texts=("chopped onion",)).names()
        ((), ('chopped onion', 'onion'))
        """
        if self.given is not None:
            return tuple(wanted.object for wanted in self.given.ingredients), ()
        if self.path is not None:
            named, lines = foods_named(self.path)
            return named, names_in(lines)
        return (), names_in(self.texts)

    def as_planned(self, words: IngredientWords, avoided: Sequence[str] = ()) -> Recipe:
        """Return the recipe that an answer to this question names, and :attr:`stand_in` where it cannot be read.

        ``words`` and ``avoided`` are those of :meth:`read`; this raises neither ReadError nor UsageError.

        >>> words = IngredientWords(Vocabulary((), (), ()), Kitchen.default())
        >>> Question(dish_type="salad", texts=("",)).as_planned(words)
        Recipe(dish_type='salad', ingredients=(), id=None, title=None)
        """
        try:
            return self.read(words, avoided).recipe
        except (ReadError, UsageError):
            return self.stand_in

    @property
    def stand_in(self) -> Recipe:
        """What is known of the recipe before it is read, or where it cannot be: its name, and no food where it is read.

        >>> Question(Path("recipes/leek-soup.json")).stand_in
        Recipe(dish_type='', ingredients=(), id='leek-soup', title=None)
        """
        if self.given is not None:
            return self.given
        return Recipe(self.dish_type, (), id=None if self.path is None else name_of_file(self.path))


@dataclass(frozen=True)
class Answer:
    """What comes of one question: a tree or why there is none (``error``), and what had to be decided to read it.

    Where reasons are asked it has ``explanations`` and the other dishes that were ``considered``.

    >>> from foon_kg import Foon
    >>> from foon_kg.foon.demo import demo_folder
    >>> foon = Foon.from_files(demo_folder())
    >>> answer = foon.answer(Question(dish_type="bread", texts=("chopped onion",)), PlanSettings())
    >>> answer.error.message
    'this FOON has no bread'
    """

    outcome: PlanResult | PlanFailure
    notes: tuple[str, ...] = ()
    explanations: tuple[Explanation, ...] = ()
    considered: tuple[Considered, ...] = ()
    error: FoonError | None = None


class Cook:
    """Plans what is asked of one view, one question after the other; ``units`` are all of the FOON, where many come."""

    def __init__(self, view: TeachingView, settings: PlanSettings, units: Sequence[KnownUnit] | None = None) -> None:
        self.view = view
        self.settings = settings
        self.units = units
        self.asks_for_parts = units is None
        self.planner = Planner(view, settings, units)

    def answer(self, question: Question, *, explain: bool = False) -> Answer:
        """Return the answer to one ``question``, and why, where that, the settings or ``explain`` ask it.

        Where somebody writes to the FOON meanwhile it is answered anew, from what is there then; raises GraphError
        where that goes on. What is raised is not about this recipe, and ends the batch.
        """
        for _ in range(MOST_WRITES):
            answer = self._answer(question, explain=explain)
            if not self.view.moved():
                return answer
            self.planner = Planner(self.view, self.settings)
        raise GraphError("the FOON is written to all the time", hint="Ask again when it has been loaded.")

    def _answer(self, question: Question, *, explain: bool) -> Answer:
        read = ReadRecipe(question.stand_in, ())
        explanations: tuple[Explanation, ...] = ()
        considered: tuple[Considered, ...] = ()
        try:
            read = question.read(self.words_for(question), self.settings.avoided)
            if self.settings.method == "paper":
                from foon_kg.planning.paper import plan_by_the_paper  # noqa: PLC0415 - only comparisons need it

                result = plan_by_the_paper(self.view, read.recipe)
            elif explain or self.settings.explain:
                result, explanations, considered = self.planner.reasons(read.recipe)
            else:
                result = self.planner.plan(read.recipe)
            own = (*_chosen_dish(read, result), *_after_a_draft(result))
            notes = (*read.notes, *own, *_without_effect(self.settings.substitutes, result))
            return Answer(result, notes, explanations, considered)
        except (NoTreeError, ReadError, UsageError) as error:
            return Answer(PlanFailure.of(read.recipe, error), read.notes, error=error)

    def get_ready(self) -> None:
        """Work out what all questions need and the first would wait for: words, operators and frames of the FOON.

        Of a view that is asked for parts it is what no other question asks again: the outlines of its dishes.
        """
        if not self.asks_for_parts:
            _ = self._all_words
        self.planner.teaching_for((), "")

    def words_for(self, question: Question) -> IngredientWords:
        """Return the words in which ``question`` is read."""
        if not self.asks_for_parts:
            return self._all_words
        foods, called = question.names()
        return self._words_of(self.view.words_for(foods, called))

    @cached_property
    def _all_words(self) -> IngredientWords:
        return self._words_of(self.view.vocabulary())

    def _words_of(self, vocabulary: Vocabulary) -> IngredientWords:
        return IngredientWords(vocabulary, Kitchen.default(), self.settings.kitchen)


def _chosen_dish(read: ReadRecipe, result: PlanResult) -> tuple[str, ...]:
    """Return a note where no dish type was asked."""
    if read.recipe.dish_type:
        return ()
    return (f"no dish type was asked: {result.recipe.dish_type} is most like these (suggest names others)",)


def _after_a_draft(result: PlanResult) -> tuple[str, ...]:
    """Return a note where a tree is made after a draft."""
    sure = result.reference.draft_confidence
    if sure is None:
        return ()
    return (f"made after {', '.join(result.reference.videos)}, a draft that nobody has reviewed ({sure:.2f} sure)",)


def _without_effect(substitutes: Sequence[Substitute], result: PlanResult) -> Iterator[str]:
    """Yield a note for each choice of an equivalent of which the tree shows nothing, though its food was asked for."""
    asked = {canonical(wanted.object) for wanted in result.recipe.ingredients}
    shown = {(canonical(s.required), canonical(s.equivalent)) for s in result.substitutions if s.kind == "object"}
    for chosen in substitutes:
        pair = canonical(chosen.food), canonical(chosen.like)
        if pair[0] in asked and pair not in shown:
            yield f"no step of this tree handles “{chosen.food}” like {chosen.like}, as was chosen"


def answering(
    questions: Iterable[Question], view: TeachingView, settings: PlanSettings, units: Sequence[KnownUnit], jobs: int
) -> AbstractContextManager[Iterator[Answer]]:
    """Open ``jobs`` processes that answer ``questions``, in their order; how many they are changes no answer.

    Every process gets ``view``, ``settings`` and ``units``, all that the view knows, once. The answers raise
    :class:`~foon_kg.model.errors.FoonError` where one of them was ended from outside.
    """
    from foon_kg.planning.processes import spread  # noqa: PLC0415 - only batches need it

    return spread(partial(_answers_of, view, settings, units), questions, jobs)


def answering_on(
    address: str, questions: Iterable[Question], view: TeachingView, settings: PlanSettings, units: Sequence[KnownUnit]
) -> AbstractContextManager[Iterator[Answer]]:
    """Open the Dask cluster of the scheduler at ``address``, which answers ``questions`` as :func:`answering` does.

    ``view``, ``settings`` and ``units`` are sent to each of its workers once.
    """
    from foon_kg.planning.cluster import spread_over  # noqa: PLC0415 - only a cluster needs it

    return spread_over(partial(_answers_of, view, settings, units), questions, address)


def _answers_of(view: TeachingView, settings: PlanSettings, units: Sequence[KnownUnit]) -> Callable[[Question], Answer]:
    return Cook(view, settings, units).answer


def processes_for(recipes: int) -> int:
    """Return in how many processes so many ``recipes`` are planned soonest."""
    return max(1, min(cores(), recipes // SHARE))


def cores() -> int:
    """Return how many cores this program may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
