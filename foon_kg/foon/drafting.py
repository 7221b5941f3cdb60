"""What a FOON makes of words: drafts of subgraphs, by how its own units do such actions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from foon_kg.foon.opened import Opened, Paths, Say, silent
from foon_kg.model.nodes import one_spelling

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.language.drafting.review import Missing
    from foon_kg.language.recipe_drafts import RecipeDrafter
    from foon_kg.model.collected import CollectedRecipe
    from foon_kg.model.drafted import DraftedRecipe
    from foon_kg.model.drafts import Draft, DraftFile
    from foon_kg.model.narration import Narration
    from foon_kg.store.graph.drafts import DraftsStored


class Drafting:
    """Drafts of subgraphs, of videos and recipes that are told in words, by what a FOON knows (``foon.drafting``)."""

    def __init__(self, foon: Opened) -> None:
        self._foon = foon

    @staticmethod
    def narration(path: Paths, *, say: Say = silent) -> Narration:
        """Return the recipe in the text file at ``path``, for :meth:`draft`: a step a line, or running text.

        Ingredients are those below a heading, or at the top, each with its amount. ``say`` hears where the extra that
        reads those is not installed; then the recipe lists none. Raises :class:`~foon_kg.model.errors.ReadError` where
        nothing in the file says what to do, and :class:`~foon_kg.model.errors.UsageError` where no draft could be named
        after it.

        >>> from pathlib import Path
        >>> from tempfile import TemporaryDirectory
        >>> with TemporaryDirectory() as folder:
        ...     written = Path(folder, "salad.txt").write_text("Peel the onion. Slice it.")
        ...     [sentence.text for sentence in Drafting.narration(Path(folder, "salad.txt")).sentences]
        ['Peel the onion. Slice it.']
        """
        from foon_kg.language.recipe_text import read_narration

        return read_narration(Path(path), say)

    @staticmethod
    def missing(draft: DraftFile) -> Sequence[Missing]:
        """Return the inputs of a reviewed ``draft`` that no earlier row makes and no kitchen has (contract, C1 and C6).

        As long as there is one, the units cannot be executed in their order.

        >>> from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant
        >>> from foon_kg.model.drafts import DraftFile, DraftRow
        >>> unit = FunctionalUnit((Participant(ObjectNode("onion", ("chopped",))),), "serve", ())
        >>> row = DraftRow(2, Annotation(unit), 1.0, (), "serve the onion")
        >>> [str(one.node) for one in Drafting.missing(DraftFile("salad.csv", (row,), None, ()))]
        ['onion (chopped)']
        """
        from foon_kg.language.drafting.review import missing as missing_in
        from foon_kg.plans.kitchen import Kitchen

        return missing_in(draft, Kitchen.default())

    def draft(self, narration: Narration, dish_type: str | None = None) -> Draft:
        """Return the draft of a ``narration``: units with a confidence (0 to 1) and doubts, and what was left out.

        Its sentences, if it has any, are read by spaCy's parser; ``dish_type`` is that of the last thing made. Raises
        :class:`~foon_kg.model.errors.UsageError` where the parser is not installed.

        >>> from foon_kg.model.narration import Mention, NarratedAction, Narration
        >>> told = Narration("salad", (NarratedAction("chop", (Mention("onion"),)),))
        >>> foon.drafting.draft(told).units[0].annotation.unit.motion
        'chop'
        """
        return next(self.drafts([narration], dish_type))

    def drafts(
        self,
        narrations: Iterable[Narration],
        dish_type: str | None = None,
        *,
        tell_odd: Callable[[Narration, Exception], None] | None = None,
    ) -> Iterator[Draft]:
        """Yield the :meth:`draft` of each of ``narrations``, all with this ``dish_type``; the FOON is read once.

        One that cannot be drafted is told to ``tell_odd`` and passed over; without that its error is raised.

        >>> from foon_kg.model.narration import Mention, NarratedAction, Narration
        >>> told = [Narration(name, (NarratedAction("wash", (Mention(name),)),)) for name in ("tomato", "lettuce")]
        >>> [len(one.units) for one in foon.drafting.drafts(told)]
        [1, 1]
        """
        from foon_kg.language.drafting import draft
        from foon_kg.language.drafting.precedents import FoonPrecedents
        from foon_kg.language.instructions import with_actions
        from foon_kg.model.errors import FoonError

        whole = self._foon.snapshot()
        precedents = FoonPrecedents(whole.units, whole.kitchen)
        for narration in narrations:
            try:
                told = with_actions(narration, precedents.verbs, precedents.names) if narration.sentences else narration
                made = draft(told, precedents, dish_type=dish_type)
            except (FoonError, LookupError, ValueError) as error:  # one odd narration ends no batch
                if tell_odd is None:
                    raise
                tell_odd(narration, error)
            else:
                yield made

    @contextmanager
    def of_recipes(
        self, recipes: Iterable[CollectedRecipe], *, jobs: int | None = None
    ) -> Iterator[Iterable[DraftedRecipe]]:
        """Open what drafts ``recipes`` of a collection by their instructions, in their order, in ``jobs`` processes.

        As a rule those are all cores; how many they are changes no draft. A recipe that cannot be drafted is one that
        says why. Raises :class:`~foon_kg.model.errors.FoonError` where a process is ended from outside, or what reads
        sentences is not installed.

        >>> from foon_kg.model.collected import CollectedRecipe
        >>> with foon.drafting.of_recipes([CollectedRecipe("r1", "Toast", (), "toast.json:1")], jobs=1) as drafted:
        ...     [one.problem for one in drafted]
        ['it has no instructions']
        """
        from foon_kg.language.recipe_drafts import RecipeDrafter
        from foon_kg.planning.batch import cores
        from foon_kg.planning.processes import spread

        whole = self._foon.snapshot()
        drafter = RecipeDrafter(whole.units, whole.kitchen)
        processes = cores() if jobs is None else jobs
        if processes == 1:
            yield map(drafter.draft, recipes)
            return
        with spread(partial(_drafter, drafter), recipes, processes) as drafted:
            yield drafted

    def store(self, drafts: Iterable[DraftedRecipe], stored: Callable[[DraftsStored], None] = silent) -> DraftsStored:
        """Bring ``drafts`` of recipes into the graph, apart from its videos; ``stored`` is told of each transaction.

        >>> foon.drafting.store([])
        Traceback (most recent call last):
        foon_kg.model.errors.UsageError: a FOON in files has no Neo4j for drafts
        """
        from foon_kg.store.graph.drafts import load_drafts

        return load_drafts(self._foon.connection_for("for drafts"), drafts, stored=stored)

    def remove(self, names: Sequence[str], *, dry_run: bool = False) -> None:
        """Take drafts of recipes out of the graph, all or none: those of these ``names`` (``draft:ID``).

        With ``dry_run`` nothing goes. Raises :class:`~foon_kg.model.errors.UsageError` for a FOON in files, and where
        the graph has no such draft.

        >>> foon.drafting.remove(["draft:nobody"], dry_run=True)
        Traceback (most recent call last):
        foon_kg.model.errors.UsageError: a FOON in files has no Neo4j to take drafts out of
        """
        from foon_kg.store.graph.drafts import check_drafts, remove_drafts

        connection = self._foon.connection_for("to take drafts out of")
        drafts = list(map(one_spelling, names))
        check_drafts(connection, drafts)
        if not dry_run:
            remove_drafts(connection, drafts)


def _drafter(drafter: RecipeDrafter) -> Callable[[CollectedRecipe], DraftedRecipe]:
    return drafter.draft
