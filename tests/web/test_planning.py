"""What a planning process does before it is asked changes no answer."""

from __future__ import annotations

from multiprocessing import Pipe

from pictures.demo_plans import demo_foon

from foon_kg.model.errors import GraphError
from foon_kg.web.foon import Served
from foon_kg.web.planning import PlanningDesk
from foon_kg.web.planning_process import _until_asked
from foon_kg.web.questions import PlanQuestion

QUESTIONS = [
    PlanQuestion("salad", ("sliced kohlrabi", "chopped onion")),
    PlanQuestion("", ("whole egg", "milk")),
    PlanQuestion("drinks", ("orange juice",), explain=True),
]


def test_practice_changes_no_answer():
    fresh, practised = PlanningDesk(Served("one", demo_foon())), PlanningDesk(Served("one", demo_foon()))
    practised.get_ready()
    dishes = list(practised.practise())
    assert len(dishes) > 5
    assert len({dish.dish_type for dish in dishes[:5]}) > 1  # what was begun serves questions of all types
    assert [practised.answer(question) for question in QUESTIONS] == [fresh.answer(question) for question in QUESTIONS]


def test_practice_can_be_left_at_any_dish():
    desk = PlanningDesk(Served("one", demo_foon()))
    practice = desk.practise()
    first, answer, second = next(practice), desk.answer(QUESTIONS[0]), next(practice)
    assert first != second
    assert answer == PlanningDesk(Served("one", demo_foon())).answer(QUESTIONS[0])


def test_practice_ends_where_the_foon_cannot_be_asked_any_more():
    class GoneDesk(PlanningDesk):
        def _planned(self, question):
            raise GraphError("the database went away")

    assert list(GoneDesk(Served("one", demo_foon())).practise()) == []


def test_a_process_practises_until_it_is_asked_and_goes_on_later():
    asking, asked = Pipe()
    practice = iter(range(5))
    asking.send("a question")
    _until_asked(asked, practice)
    assert asked.recv() == "a question"
    assert next(practice) == 1  # one was under way
    _until_asked(asked, practice)
    assert list(practice) == []
