"""The questions that take a while, answered from one FOON: plans, suggestions and examples."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import islice

from foon_kg.foon import Answer, Foon, PlanSettings, ReadKitchen
from foon_kg.foon import Question as PlannerQuestion
from foon_kg.model.errors import FoonError
from foon_kg.model.json_fields import JsonObject
from foon_kg.plans.durations import Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.web.examples import example_dishes, question_of
from foon_kg.web.foon import Served
from foon_kg.web.plan_answer import plan_to_json
from foon_kg.web.questions import ExamplesQuestion, PlanQuestion, Question, Reply, SuggestQuestion
from foon_kg.web.sources import PartSources, Sources, WholeSources

TIME_LIMIT = 3.0
"""Seconds for the search of one reference tree, and for each dish that is suggested."""

_MOST_PRACTISED = 120
"""So many dishes are planned before anybody asks: of the public FOON all, of a larger one some of each type."""

_NO_WISHES = PlanSettings(time_limit=TIME_LIMIT)


class PlanningDesk:
    """Answers plans, suggestions and examples from the FOON that is ``served``, for one thread."""

    def __init__(self, served: Served) -> None:
        self._foon = served.foon()
        self._sources: Sources = WholeSources(self._foon) if served.snapshot else PartSources(self._foon)

    def get_ready(self) -> None:
        """Work out what every plan needs, so that no question waits for it and none of its time limit goes into it."""
        self._foon.get_ready(_NO_WISHES)
        self._sources.get_ready()
        _ = self._durations  # worked out now, and kept

    def practise(self) -> Iterator[PlannerQuestion]:
        """Plan recorded dishes to fill the caches (words, places of foods, reference trees); yield each after it.

        Answers stay the same; the first questions about like foods are answered sooner. It ends where the FOON cannot
        be asked any more, or changed meanwhile: whoever asks then is told so.
        """
        try:
            for dish in islice(Foon(self._sources.sample).recorded_dishes(), _MOST_PRACTISED):
                question = question_of(dish)
                self._planned(question)
                yield question
        except FoonError:
            return

    def answer(self, question: Question) -> Reply:
        """Return the reply to ``question``; what is wrong with it, or with the FOON, is one too."""
        try:
            if isinstance(question, PlanQuestion):
                return self._plan(question)
            if isinstance(question, ExamplesQuestion):
                return Reply.of({"examples": example_dishes(Foon(self._sources.sample), self._planned, question.most)})
            return Reply.of(self._suggest(question))
        except FoonError as error:
            return Reply.of_error(error)

    def close(self) -> None:
        """Give connections back."""
        self._foon.close()

    def _plan(self, question: PlanQuestion) -> Reply:
        self._sources.check(with_drafts=question.with_drafts)
        read = self._at_hand(question.kitchen) if question.kitchen else None
        answer = self._answered(question, read.kitchen if read else Kitchen.default())
        notes = [*(read.notes if read else ()), *answer.notes]
        if answer.error is not None:
            return Reply.of_error(answer.error, answer.outcome.to_json() | {"notes": notes})
        source = self._sources.of(answer, with_drafts=question.with_drafts)
        told = plan_to_json(answer, question, self._durations, source.known, source.places)
        return Reply.of(told | {"notes": notes})

    def _answered(self, question: PlanQuestion, kitchen: Kitchen) -> Answer:
        asked = PlannerQuestion(dish_type=question.dish_type, texts=question.ingredients, title=question.title or None)
        chosen, avoided = question.substitutes, question.avoided
        if not (chosen or avoided or question.kitchen or question.after):
            plain = replace(_NO_WISHES, with_drafts=question.with_drafts)
            return self._foon.answer(asked, plain, explain=question.explain)
        settings = PlanSettings(
            kitchen=kitchen, time_limit=TIME_LIMIT, substitutes=chosen, avoided=avoided, after=question.after,
            explain=question.explain, with_drafts=question.with_drafts,
        )  # fmt: skip
        with self._foon.answers([asked], settings) as answers:  # nothing is kept ready for what others do not wish
            return next(iter(answers))

    def _planned(self, question: PlannerQuestion) -> Answer:
        return self._foon.answer(question, _NO_WISHES)

    @cached_property
    def _durations(self) -> Durations:
        return Durations.of_units(self._sources.sample.units)

    def _suggest(self, question: SuggestQuestion) -> JsonObject:
        read = self._at_hand((*question.foods, *question.kitchen))
        found = self._foon.suggestions(read.kitchen, question.most, TIME_LIMIT)
        return {
            "suggestions": [one.to_json() for one in found.found],
            "considered": found.considered,
            "proven": found.proven,
            "notes": list(read.notes),
        }

    def _at_hand(self, things: Sequence[str]) -> ReadKitchen:
        return self._foon.kitchen(foods=things)
