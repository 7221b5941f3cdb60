"""How good the answers of a FOON are: plans of recipes scored, trees judged, videos left out and asked for."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Literal

from foon_kg.foon.answering import Answering
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.evaluation.figures import RecipeEvaluation
    from foon_kg.evaluation.left_out_video import LeftOutVideo
    from foon_kg.evaluation.sampling import LeftOut
    from foon_kg.evaluation.trees import TreeFigures, TreesEvaluation
    from foon_kg.evaluation.video_figures import LeaveOneOut, VideoFigures
    from foon_kg.model import Recipe
    from foon_kg.model.tree import TaskTree
    from foon_kg.plans.result import PlanFailure, PlanResult
    from foon_kg.store.snapshot import Snapshot

    Planned = Callable[[Sequence[Recipe]], Iterable[PlanResult | PlanFailure]]
    Compared = Callable[[Sequence[LeftOutVideo], Sequence[str]], Iterable[VideoFigures]]
    Shown = Callable[[Iterator[TreeFigures]], Iterable[TreeFigures]]


class Evaluating(Answering):
    """A FOON that says how good its answers are, and the trees of others."""

    def content_key(self) -> str:
        """Return a name for what the FOON knows: equal for equal units, whatever their videos are called.

        >>> foon.content_key() == Foon.from_files(demo_folder()).content_key()
        True
        """
        return _key(self.snapshot())

    def evaluate_recipes(
        self,
        recipes: Iterable[Recipe],
        *,
        seed: int = 0,
        method: Literal["frames", "paper"] = "frames",
        planned: Planned | None = None,
    ) -> RecipeEvaluation:
        """Return how well ``recipes`` are planned: each required ingredient is scored 0, 1 or 2.

        Their order decides nothing. Those of dish types with fewer than three goals in the FOON are left out and
        named; ``seed`` is that of the bootstrap. ``method`` is ``paper`` for its four algorithms to the letter.
        ``planned`` returns the outcomes of recipes in their order, where they are not to be planned here and now.
        The experiment of Sakib et al. with a rule that can be executed.

        Raises ``UsageError`` where none is of a dish type that the FOON knows enough of.

        >>> asked = foon.plan("salad", ["chopped onion", "olive oil"]).result.recipe
        >>> [line.score for line in foon.evaluate_recipes([asked]).recipes[0].scores]
        [2, 2]
        """
        from foon_kg.evaluation.examination import Examiner
        from foon_kg.evaluation.figures import RecipeEvaluation
        from foon_kg.evaluation.sampling import known_enough, left_out

        whole = self.snapshot()
        goals = whole.goals()
        asked = sorted(recipes, key=lambda recipe: (recipe.dish_type, recipe.id or ""))
        enough, out = known_enough(goals), left_out((recipe.dish_type for recipe in asked), goals)
        kept = [recipe for recipe in asked if recipe.dish_type in enough]
        if not kept:
            raise _too_little_known(out, enough)
        outcomes = self._planned(kept, method) if planned is None else planned(kept)
        examiner = Examiner(whole.units, goals, whole.vocabulary(), whole.kitchen)
        return RecipeEvaluation(_key(whole), seed, tuple(map(examiner.examine, outcomes)), out)

    def _planned(self, recipes: Sequence[Recipe], method: Literal["frames", "paper"]) -> list[PlanResult | PlanFailure]:
        from foon_kg.planning.batch import Question
        from foon_kg.planning.settings import PlanSettings

        questions = [Question(given=recipe) for recipe in recipes]
        with self.answers(questions, PlanSettings(method=method)) as answers:
            return [answer.outcome for answer in answers]

    def evaluate_trees(
        self, trees: Iterable[tuple[str, str, TaskTree]], *, shown: Shown | None = None
    ) -> TreesEvaluation:
        """Return how many of anybody's ``trees`` robot and cook accept, each given with where it is and its dish type.

        Their evidence is compared with this FOON. ``shown`` passes on the figures of trees one by one, as a progress
        bar does.

        >>> plan = foon.plan("salad", ["chopped onion", "olive oil"])
        >>> judged = foon.evaluate_trees([("here", "salad", plan.result.tree)])
        >>> judged.trees[0].report.accepted
        True
        """
        from foon_kg.evaluation.trees import TreesEvaluation, examined
        from foon_kg.validation import KnownFoon

        whole = self.snapshot()  # once: the key and what the judge knows are of one FOON
        figures = examined(trees, KnownFoon.of(whole.units, whole.goals()), whole.kitchen.free_foods)
        return TreesEvaluation(_key(whole), tuple(figures if shown is None else shown(figures)))

    def leave_one_out(
        self,
        dish_types: Collection[str] = (),
        *,
        sample: int | None = None,
        seed: int = 0,
        compared: Compared | None = None,
    ) -> LeaveOneOut:
        """Return what plans have in common with each video that is left out and asked for, beside three baselines.

        Of ``dish_types`` (none: all), ``sample`` videos of each, drawn by ``seed``, where that is a number. Dish types
        with fewer than three goals are left out and named. ``compared`` returns the figures of videos in their order
        by each of the methods that are named, where they are not to be planned here and now: that takes a second a
        video.

        Raises ``UsageError`` where there is no such video.

        >>> left = foon.leave_one_out(["salad"], sample=1)
        >>> [video.recipe.dish_type for video in left.videos]
        ['salad']
        """
        from foon_kg.evaluation.left_out_video import left_out_video
        from foon_kg.evaluation.methods import METHODS
        from foon_kg.evaluation.sampling import known_enough, left_out
        from foon_kg.evaluation.video_figures import LeaveOneOut

        whole = self.snapshot()
        found = [(subgraph.name, left_out_video(subgraph, whole.kitchen)) for subgraph in whole.subgraphs]
        videos = _of_types((video for _, video in found), dish_types)
        goals = whole.goals()
        enough, out = known_enough(goals), left_out((video.recipe.dish_type for video in videos), goals)
        asked = _drawn([video for video in videos if video.recipe.dish_type in enough], sample, seed)
        methods = tuple(METHODS)
        figures = _compared(asked, methods, whole) if compared is None else compared(asked, methods)
        nothing = tuple(name for name, video in found if video is None)
        return LeaveOneOut(_key(whole), seed, tuple(figures), methods, out, nothing)


def _compared(asked: Sequence[LeftOutVideo], methods: Sequence[str], whole: Snapshot) -> Iterable[VideoFigures]:
    from foon_kg.evaluation.leave_one_out import asking_without

    return map(asking_without(whole.subgraphs, whole.kitchen, methods), asked)


def _too_little_known(out: Sequence[LeftOut], enough: Iterable[str]) -> UsageError:
    names = ", ".join(dish.dish_type or "none" for dish in out)
    return UsageError(
        f"the FOON knows too little of these dish types: {names}",
        hint=f"It knows enough of: {', '.join(enough) or 'none'}.",
    )


def _key(whole: Snapshot) -> str:
    from foon_kg.model import content_key

    return content_key([known.unit.key for known in whole.units])


def _of_types(videos: Iterable[LeftOutVideo | None], dish_types: Collection[str]) -> list[LeftOutVideo]:
    """Return the videos that make one of ``dish_types``, of which none means all."""
    return [one for one in videos if one is not None and (not dish_types or one.recipe.dish_type in dish_types)]


def _drawn(videos: Sequence[LeftOutVideo], sample: int | None, seed: int) -> list[LeftOutVideo]:
    """Return the videos to leave out, ``sample`` of each dish type where that is a number; raises where none is."""
    from foon_kg.evaluation.sampling import sampled

    recipes = [video.recipe for video in videos]
    names = {recipe.id for recipe in (recipes if sample is None else sampled(recipes, sample, seed))}
    asked = [video for video in videos if video.name in names]
    if not asked:
        raise UsageError(
            "there is no video to leave out", hint="It needs a dish type with three goals in the FOON: see foon stats."
        )
    return asked
