"""The questions that take a while, answered from one FOON in memory: plans and suggestions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict

from foon_kg.batch import Answer, Cook, Wishes
from foon_kg.batch import Question as CookQuestion
from foon_kg.errors import FoonError
from foon_kg.explanation import Explanation
from foon_kg.json_fields import JsonObject
from foon_kg.kitchen import Kitchen
from foon_kg.kitchen_file import Entry, ReadKitchen, kitchen_with
from foon_kg.model_json import node_to_json
from foon_kg.pictures.progress import progress_svg
from foon_kg.pictures.tree import tree_svg
from foon_kg.recipes import IngredientWords
from foon_kg.result import PlanResult
from foon_kg.shopping import shopping_list
from foon_kg.snapshot import Snapshot
from foon_kg.suggestion import suggest
from foon_kg.views.shown_tree import ShownTree
from foon_kg.web.questions import PlanQuestion, Question, Reply, SuggestQuestion
from foon_kg.web.words import seen_at

TIME_LIMIT = 3.0
"""Seconds for the search of one reference tree."""

MOST_PLANS = 300
"""So many questions share what was worked out for the ones before; then that is forgotten, or it would only grow."""


class PlanningDesk:
    """Answers plans and suggestions from one FOON, for one thread."""

    def __init__(self, snapshot: Snapshot) -> None:
        self.snapshot = snapshot
        self._cook = self._new_cook()
        self._plans = 0

    def answer(self, question: Question) -> Reply:
        """Answer ``question``; what is wrong with it is an answer too."""
        try:
            if isinstance(question, PlanQuestion):
                return self._plan(question)
            return Reply.of(self._suggest(question))
        except FoonError as error:
            return Reply.of_error(error)

    def close(self) -> None:
        """Nothing is held open."""

    def _plan(self, question: PlanQuestion) -> Reply:
        read = self._at_hand(question.kitchen) if question.kitchen else None
        answer = self._cook_for(question, read.kitchen if read else Kitchen.default()).answer(
            CookQuestion(dish_type=question.dish_type, texts=tuple(question.ingredients))
        )
        notes = [*(read.notes if read else ()), *answer.notes]
        if answer.error is not None:
            return Reply.of_error(answer.error, answer.outcome.to_json() | {"notes": notes})
        return Reply.of(plan_to_json(answer, question.picture_width) | {"notes": notes})

    def _cook_for(self, question: PlanQuestion, kitchen: Kitchen) -> Cook:
        if question.substitutes or question.avoided or question.kitchen:
            wishes = Wishes(
                question.substitutes, question.avoided, explain=True, kitchen=kitchen, time_limit=TIME_LIMIT
            )
            return Cook(self.snapshot, wishes)
        if self._plans >= MOST_PLANS:
            self._cook, self._plans = self._new_cook(), 0
        self._plans += 1
        return self._cook

    def _new_cook(self) -> Cook:
        return Cook(self.snapshot, Wishes(explain=True, time_limit=TIME_LIMIT), self.snapshot.units)

    def _suggest(self, question: SuggestQuestion) -> JsonObject:
        read = self._at_hand((*question.foods, *question.kitchen))
        found = suggest(self.snapshot, read.kitchen, most=question.most, time_limit=TIME_LIMIT)
        return {
            "suggestions": [one.to_json() for one in found.found],
            "considered": found.considered,
            "proven": found.proven,
            "notes": list(read.notes),
        }

    def _at_hand(self, things: Sequence[str]) -> ReadKitchen:
        words = IngredientWords(self.snapshot.vocabulary(), Kitchen.default())
        return kitchen_with([Entry(f"“{text}”", text) for text in things], words)


def plan_to_json(answer: Answer, picture_width: int | None = None) -> JsonObject:
    """Answer a plan as ``foon plan --json`` prints it, and what to buy, why, where to look, and pictures."""
    if not isinstance(answer.outcome, PlanResult):
        raise TypeError("only a plan has steps")
    told: JsonObject = answer.outcome.to_json() | {
        "notes": list(answer.notes),
        "explanations": list(map(explanation_to_json, answer.explanations)),
        "shopping": list(map(node_to_json, shopping_list(answer.outcome.kitchen, Kitchen.default()))),
        "videos": [seen_at(unit.seen_in) for unit in answer.outcome.units],
    }
    if picture_width is not None:
        shown = ShownTree.of_result(answer.outcome)
        told["pictures"] = {"tree": tree_svg(shown, Kitchen.default()), "progress": progress_svg(shown, picture_width)}
    return told


def explanation_to_json(one: Explanation) -> JsonObject:
    """Answer why one ingredient is made as it is, field by field."""
    fields: JsonObject = asdict(one)
    fields["renamed"] = [{"known": known, "now": now} for known, now in one.renamed]
    return fields
