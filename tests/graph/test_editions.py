"""What was read of one edition of the FOON is not read again, and nothing older is ever answered."""

from __future__ import annotations

from contextlib import nullcontext

import pytest
from kitchen_stories import SALAD, subgraph

from foon_kg.model.errors import SchemaError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import load, remove
from foon_kg.store.graph.edition import MOST_UNITS, Edition
from foon_kg.store.snapshot import Snapshot

salad = subgraph("salad", "salad", *SALAD)
shorter = subgraph("salad", "salad", *SALAD[:3])
other = subgraph("other", "omelette", *SALAD[2:])


def questions_of_a_plan(view):
    goals = view.goals("salad")
    return view.vocabulary(), goals, view.behind([goal.node for goal in goals], [("onion", "chopped")])


@pytest.mark.neo4j
def test_a_question_is_one_round_trip_and_fetching_what_is_behind_a_goal_another(connection, graph):
    load(connection, [salad])
    with graph.reading() as view:
        questions_of_a_plan(view)
        assert view.round_trips == 5  # the first asks for the schema and the edition


@pytest.mark.neo4j
def test_what_was_read_of_an_edition_is_not_read_again(connection, graph):
    load(connection, [salad])
    with graph.reading() as view:
        answers = questions_of_a_plan(view)
    with graph.reading() as view:
        assert questions_of_a_plan(view) == answers
        assert view.round_trips == 2  # which edition it is, and what is behind the goals


@pytest.mark.neo4j
@pytest.mark.parametrize("now", [[salad, other], [shorter], [other]])
def test_whatever_changed_is_read_anew(connection, graph, now):
    load(connection, [salad])
    with graph.reading() as view:
        questions_of_a_plan(view)
    load(connection, now)
    if salad not in now and shorter not in now:
        remove(connection, ["salad"])
    with graph.reading() as view:
        assert questions_of_a_plan(view) == questions_of_a_plan(Snapshot.of(now, Kitchen.default()))


@pytest.mark.neo4j
def test_a_load_between_two_questions_shows_in_the_next_view(connection, graph):
    load(connection, [shorter])
    with graph.reading() as view:
        view.vocabulary()
        load(connection, [salad])
        view.goals("salad")
    with graph.reading() as view:
        assert questions_of_a_plan(view) == questions_of_a_plan(Snapshot.of([salad], Kitchen.default()))


@pytest.mark.neo4j
@pytest.mark.parametrize(("now", "error"), [("methods", None), ("kitchen", SchemaError)])
def test_who_wrote_meanwhile_is_looked_at_as_at_the_beginning(connection, graph, now, error):
    """Another foon-kg may have learnt what is there anew, or have written it with another kitchen."""
    load(connection, [salad])
    with graph.reading() as view:
        view.vocabulary()
        assert (view.moved(), view.is_learnt_by_this_program) == (False, True)
        with connection.session(writing=True) as session:
            session.run(f"MATCH (f:Foon) SET f.edition = 'another', f.{now} = 'another'").consume()
        with pytest.raises(error) if error else nullcontext():
            assert view.moved()
            assert not view.is_learnt_by_this_program


def test_an_edition_that_is_not_told_apart_is_never_kept():
    assert Edition().still(None).name is None
    edition = Edition(None, goals={"salad": ()})
    assert not edition.still(None).goals


def test_what_was_read_is_given_up_when_it_grows_too_large():
    kept = Edition("today", units=dict.fromkeys(map(str, range(MOST_UNITS))))
    assert kept.still("today") is kept
    kept.units["one more"] = None
    assert kept.still("today") == Edition("today")
