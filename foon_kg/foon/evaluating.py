"""How good the answers of a FOON are: plans of recipes scored, trees judged, videos left out and asked for."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from foon_kg.foon.opened import Paths, Say, silent
from foon_kg.model.errors import ReadError, UsageError

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.evaluation.comparison import Earlier
    from foon_kg.evaluation.figures import RecipeEvaluation
    from foon_kg.evaluation.left_out_video import LeftOutVideo
    from foon_kg.evaluation.sampling import LeftOut
    from foon_kg.evaluation.sheet import FilledSheet
    from foon_kg.evaluation.trees import TreeFigures, TreesEvaluation
    from foon_kg.evaluation.video_figures import LeaveOneOut, VideoFigures
    from foon_kg.foon.answering import Answering
    from foon_kg.foon.collected import Recipes
    from foon_kg.model import Recipe
    from foon_kg.model.tree import TaskTree
    from foon_kg.plans.result import PlanFailure, PlanResult
    from foon_kg.store.snapshot import Snapshot

    Planned = Callable[[Sequence[Recipe]], Iterable[PlanResult | PlanFailure]]
    Compared = Callable[[Sequence[LeftOutVideo], Sequence[str]], Iterable[VideoFigures]]
    Shown = Callable[[Iterator[TreeFigures]], Iterable[TreeFigures]]


class Evaluation:
    """How good the answers of a FOON are, and the trees of others (``foon.evaluation``)."""

    def __init__(self, foon: Answering) -> None:
        self._foon = foon

    def recipes_of(
        self,
        *paths: Paths,
        dish_types: Collection[str] = (),
        sample: int | None = None,
        seed: int = 0,
        noted: Say = silent,
    ) -> list[Recipe]:
        """Return the recipes of files and folders (``paths``) that are of ``dish_types`` (none: all), as they are read.

        At most ``sample`` of each type are drawn by ``seed`` (any whole number; the same draws the same), all where
        ``sample`` is ``None``; ``noted`` hears what had to be decided to read them. Raises
        :class:`~foon_kg.model.errors.ReadError` for what is no recipe, and where two of one type have one id.

        >>> from foon_kg.foon.demo import demo_recipes
        >>> [one.id for one in foon.evaluation.recipes_of(*demo_recipes(), dish_types=["salad"], sample=1)]
        ['courgette_salad']
        """
        from foon_kg.evaluation.sampling import sampled
        from foon_kg.planning.recipes import recipe_files

        found = []
        for read in self._foon.read_recipes(*recipe_files(map(Path, paths))):
            found.append(read.recipe)
            for note in read.notes:
                noted(note)
        _check_distinct(found)
        asked = [one for one in found if not dish_types or one.dish_type in dish_types]
        return asked if sample is None else sampled(asked, sample, seed)

    def loaded_recipes(
        self, collection: Recipes, dish_types: Collection[str], *, sample: int | None = None, seed: int = 0
    ) -> list[Recipe]:
        """Return the recipes of a ``collection`` in a Neo4j that surely are of ``dish_types``, in words of this FOON.

        At most ``sample`` of each type are drawn by ``seed``, all where ``sample`` is ``None``. Raises ``UsageError``
        for a ``collection`` in files.

        >>> foon.evaluation.loaded_recipes(foon.recipes, ["salad"])
        Traceback (most recent call last):
        foon_kg.model.errors.UsageError: a FOON in files has no Neo4j for recipes
        """
        from foon_kg.evaluation.sampling import drawn
        from foon_kg.planning.recipes import with_states

        words = self._foon.words()
        found: list[Recipe] = []
        for dish_type in sorted(set(dish_types)):
            ids = collection.ids(dish_type)
            names = ids if sample is None else drawn(ids, sample, seed, dish_type)
            found += [with_states(collection.get(name).asked(dish_type), words).recipe for name in names]
        return found

    @staticmethod
    def earlier(path: Paths, kind: Literal["recipes", "leave-one-out"]) -> Earlier:
        """Return an evaluation of this ``kind`` that was printed as JSON into the file at ``path``, to compare with.

        Raises :class:`~foon_kg.model.errors.ReadError` for what is none, and
        :class:`~foon_kg.model.errors.UsageError` for one of another kind.

        >>> Evaluation.earlier("not there", "recipes")
        Traceback (most recent call last):
        foon_kg.model.errors.ReadError: not there: No such file or directory
        """
        from foon_kg.evaluation.comparison import earlier_evaluation

        return earlier_evaluation(Path(path), kind)

    @staticmethod
    def sheet(evaluation: RecipeEvaluation) -> str:
        """Return a sheet (CSV) on which people can score each line of an ``evaluation``, its scores left open.

        >>> asked = foon.plan("salad", ["chopped onion", "olive oil"]).result.recipe
        >>> Evaluation.sheet(foon.evaluation.recipes([asked])).splitlines()[0]
        'recipe,dish_type,ingredient,state,progress_line,score'
        """
        from foon_kg.evaluation.sheet import write_sheet

        return write_sheet(evaluation.recipes)

    @staticmethod
    def filled_sheet(path: Paths) -> FilledSheet:
        """Return the scores that people wrote on the sheet at ``path``: it says how well they agree with the rule.

        Raises :class:`~foon_kg.model.errors.ReadError` with the line that is none of such a sheet.

        >>> Evaluation.filled_sheet("not there")
        Traceback (most recent call last):
        foon_kg.model.errors.ReadError: not there: No such file or directory
        """
        from foon_kg.evaluation.sheet import read_sheet

        return read_sheet(Path(path))

    def recipes(
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
        >>> [line.score for line in foon.evaluation.recipes([asked]).recipes[0].scores]
        [2, 2]
        """
        from foon_kg.evaluation.examination import Examiner
        from foon_kg.evaluation.figures import RecipeEvaluation
        from foon_kg.evaluation.sampling import known_enough, left_out

        whole = self._foon.snapshot()
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
        with self._foon.answers(questions, PlanSettings(method=method)) as answers:
            return [answer.outcome for answer in answers]

    def trees(self, trees: Iterable[tuple[str, str, TaskTree]], *, shown: Shown | None = None) -> TreesEvaluation:
        """Return how many of anybody's ``trees`` robot and cook accept, each given with where it is and its dish type.

        Their evidence is compared with this FOON. ``shown`` passes on the figures of trees one by one, as a progress
        bar does.

        >>> plan = foon.plan("salad", ["chopped onion", "olive oil"])
        >>> judged = foon.evaluation.trees([("here", "salad", plan.result.tree)])
        >>> judged.trees[0].report.accepted
        True
        """
        from foon_kg.evaluation.trees import TreesEvaluation, examined
        from foon_kg.validation import KnownFoon

        whole = self._foon.snapshot()  # once: the key and what the judge knows are of one FOON
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

        >>> left = foon.evaluation.leave_one_out(["salad"], sample=1)
        >>> [video.recipe.dish_type for video in left.videos]
        ['salad']
        """
        from foon_kg.evaluation.left_out_video import left_out_video
        from foon_kg.evaluation.methods import METHODS
        from foon_kg.evaluation.sampling import known_enough, left_out
        from foon_kg.evaluation.video_figures import LeaveOneOut

        whole = self._foon.snapshot()
        found = [(subgraph.name, left_out_video(subgraph, whole.kitchen)) for subgraph in whole.subgraphs]
        videos = _of_types((video for _, video in found), dish_types)
        goals = whole.goals()
        enough, out = known_enough(goals), left_out((video.recipe.dish_type for video in videos), goals)
        asked = _drawn([video for video in videos if video.recipe.dish_type in enough], sample, seed)
        methods = tuple(METHODS)
        figures = _compared(asked, methods, whole) if compared is None else compared(asked, methods)
        nothing = tuple(name for name, video in found if video is None)
        return LeaveOneOut(_key(whole), seed, tuple(figures), methods, out, nothing)

    @contextmanager
    def leaving_out(
        self,
        videos: Sequence[LeftOutVideo],
        methods: Sequence[str],
        *,
        jobs: int | None = None,
        dask: str | None = None,
    ) -> Iterator[Iterator[VideoFigures]]:
        """Open what asks ``methods`` for each of ``videos`` of the FOON without it, and yields the figures in order.

        That is done in ``jobs`` processes (as a rule all cores), on the cluster of the Dask scheduler at ``dask``, or
        for few videos in this process; none of it changes a figure.

        >>> with foon.evaluation.leaving_out([], ["foon-kg"]) as figures:
        ...     list(figures)
        []
        """
        from foon_kg.evaluation.leave_one_out import asking_without
        from foon_kg.planning.batch import MANY, cores
        from foon_kg.planning.cluster import spread_over
        from foon_kg.planning.processes import spread

        whole = self._foon.snapshot()
        make = partial(asking_without, whole.subgraphs, whole.kitchen, methods)
        processes = cores() if jobs is None else jobs
        opened: AbstractContextManager[Iterator[VideoFigures]]
        if dask is not None:
            opened = spread_over(make, videos, dask)
        elif processes > 1 and len(videos) >= MANY:
            opened = spread(make, videos, processes)
        else:
            opened = nullcontext(map(make(), videos) if videos else iter(()))
        with opened as figures:
            yield figures

    def plan_of_left_out(self, video: VideoFigures) -> PlanResult:
        """Return the tree that foon-kg makes for a ``video`` of all the others.

        Raises :class:`~foon_kg.model.errors.NoTreeError` where there is none.

        >>> left = foon.evaluation.leave_one_out(["salad"], sample=1)
        >>> len(foon.evaluation.plan_of_left_out(left.videos[0]).units) > 1
        True
        """
        from foon_kg.evaluation.leave_one_out import planned_without

        whole = self._foon.snapshot()
        return planned_without(whole.subgraphs, whole.kitchen, video)


def _check_distinct(recipes: Iterable[Recipe]) -> None:
    """Raise ReadError where two recipes of one dish type have one id."""
    counts = Counter((recipe.dish_type, recipe.id) for recipe in recipes)
    twice = next((name for (_, name), count in counts.items() if count > 1), None)
    if twice is not None:
        raise ReadError(f"two recipes are called “{twice}”", hint="Name each file once; give each recipe its own id.")


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
