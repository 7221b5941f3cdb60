"""From a recipe to a task tree: the four algorithms of the paper, one after the other.

The planner asks a :class:`~foon_kg.knowledge.KnowledgeView` four questions: the words of the FOON that matter to the
recipe, the likeliest goals of the dish type, the units behind the first of them and behind everything that may have to
be made apart, and, only where none of these goals leads to a tree, the units behind more of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from foon_kg.avoidance import kitchen_without
from foon_kg.carriers import MOST_UNITS, Read
from foon_kg.explanation import Explanation
from foon_kg.goals.ranking import RankedGoal
from foon_kg.kitchen import Kitchen, words
from foon_kg.knowledge import KnowledgeView, Vocabulary
from foon_kg.likeness import Likeness
from foon_kg.model import KnownUnit, ObjectNode, Recipe
from foon_kg.question import Question
from foon_kg.recent import Recent
from foon_kg.result import PlanResult
from foon_kg.search import SearchProblem
from foon_kg.settings import PlanSettings
from foon_kg.similarity import food_similarity
from foon_kg.substitution import Equivalents
from foon_kg.workshop import MOST_KITCHENS, Workshop


def plan(view: KnowledgeView, recipe: Recipe, settings: PlanSettings | None = None) -> PlanResult:
    """Answer the task tree that makes ``recipe``.

    A recipe without a dish type (``""``) may become a dish of any; the answer says which. Raises :class:`UsageError`
    for a recipe without ingredients or with an unknown dish type, and :class:`NoTreeError` where the FOON has no way to
    make it; the code is ``no-goal``, ``no-way``, ``left-out``, ``avoided`` or ``missing``.
    """
    return Planner(view, settings or PlanSettings()).plan(recipe)


class Planner:
    """Plans recipes from one view.

    For many recipes give ``units``, all of the FOON: they are numbered once, and what was derived for one recipe
    serves the next. Without them each plan asks the view for just the units behind its goals and foods.
    """

    def __init__(self, view: KnowledgeView, settings: PlanSettings, units: Sequence[KnownUnit] | None = None) -> None:
        self.view = view
        self.settings = settings
        usual = settings.similarity is food_similarity() and not settings.substitutes and not settings.avoided
        self.asks_for_parts = units is None and usual
        self.whole = None if units is None else Workshop(units, view.goals(), settings, self.vocabulary)
        self._equivalents: list[Equivalents] = []
        self.carriers: Read = Recent(MOST_UNITS)
        if not self.asks_for_parts:
            self.likeness.learn(())  # a substitute that nobody knows is refused before anything is planned

    @cached_property
    def vocabulary(self) -> Vocabulary:
        """Answer all words of the FOON."""
        return self.view.vocabulary()

    @cached_property
    def likeness(self) -> Likeness:
        """Answer how like the foods of the FOON are to others, with what a person chose."""
        return Likeness(self.settings.similarity, self.vocabulary, self.settings.substitutes)

    @cached_property
    def known_foods(self) -> frozenset[str]:
        """Answer the foods of the FOON, each word in the singular."""
        return frozenset(" ".join(words(label)) for label in self.vocabulary.rows_of)

    def kitchen_for(self, foods: Sequence[str]) -> Kitchen:
        """Answer the kitchen of a recipe that asks for ``foods``."""
        # water that is asked is taken once, for the dish, and not for washing beside it (sense, S4)
        return kitchen_without(self.settings.kitchen, (*self.settings.avoided, *foods)).with_foods(foods)

    def equivalents(self, vocabulary: Vocabulary, likeness: Likeness, kitchen: Kitchen) -> Equivalents:
        """Answer what the FOON's words stand for in ``kitchen``.

        Recipes with equal kitchens, and the same words, share it, and so what was worked out in it.
        """
        kept = self._equivalents
        same = (e for e in kept if e.vocabulary is vocabulary and e.name_confidence is likeness)
        known = next((e for e in same if _same_kitchen(e.kitchen, kitchen)), None)
        if known is None:
            like, motions = self.settings.state_similarity, self.settings.rules.motions
            known = Equivalents(vocabulary, kitchen, likeness, like, likeness.own, motions)
            self._equivalents = [known, *kept][:MOST_KITCHENS]
        return known

    def plan(self, recipe: Recipe) -> PlanResult:
        """Answer the task tree that makes ``recipe``; raises as :func:`plan` does."""
        return Question(self, recipe).answer()

    def reference_question(self, recipe: Recipe) -> tuple[RankedGoal, SearchProblem]:
        """Answer the goal that is most like ``recipe`` (algorithm 1), and what algorithm 3 is asked about it."""
        return Question(self, recipe).reference_question()

    def reference_tree(self, recipe: Recipe, goal: ObjectNode) -> tuple[KnownUnit, ...]:
        """Answer the reference tree of ``goal`` for ``recipe``, as it was recorded: what a plan begins with.

        Raises UsageError where ``goal`` is no goal for this recipe in this FOON.
        """
        return Question(self, recipe).reference_tree(goal)

    def explain(self, recipe: Recipe) -> tuple[PlanResult, tuple[Explanation, ...]]:
        """Answer the tree, and why every required food is made as it is; raises as :func:`plan` does."""
        return Question(self, recipe, all_words=True).explained()  # what is too unlike is named as well


def _same_kitchen(one: Kitchen, other: Kitchen) -> bool:
    """Whether two kitchens of one planner are the same: recipes may differ in no more than this."""
    return one.free_foods == other.free_foods and one.utensils == other.utensils
