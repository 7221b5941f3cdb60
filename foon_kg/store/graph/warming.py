"""The first plan after a start of the server must not wait for it to compile its queries."""

from __future__ import annotations

from foon_kg.model.errors import GraphError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.reading import GraphView
from foon_kg.store.graph.schema import check_readable
from foon_kg.store.graph.statements import SCHEMA_STATE, ask
from foon_kg.store.settings import ConnectionSettings

ROUNDS = 3
"""Compiling a query is one round; the code that runs it gets quicker for a few more."""

GOALS = 3

FOODS = ("onion", "egg", "olive oil")


def warm(settings: ConnectionSettings) -> None:
    """Ask the Neo4j of these ``settings`` every question of a plan a few times.

    An empty database warms up too; an unreachable one is left alone. So is one that holds something else, or a FOON
    that was imported and is not finished yet.
    """
    try:
        with (
            Connection(settings) as connection,
            connection.session() as session,
            session.begin_transaction() as transaction,
        ):
            if GraphView(transaction).video_names():
                check_readable(next(iter(ask(transaction, SCHEMA_STATE)), None), Kitchen.default())
            for _ in range(ROUNDS):
                _ask_everything(GraphView(transaction))  # a view of its own each, as a view asks nothing twice
    except GraphError:
        return  # warming is a favour: whoever asks next is told what is wrong


def _ask_everything(view: GraphView) -> None:
    words = view.vocabulary()
    view.words_for(FOODS)
    view.likely_goals(None, FOODS, GOALS)
    view.methods_for(FOODS, "")
    goals = [goal for dish_type in words.dish_types[:1] for goal in view.goals(dish_type)] or list(view.goals())
    foods = [(food.label, food.state) for food in words.foods[:GOALS]]
    view.remembered("")
    view.behind([goal.node for goal in goals[:GOALS]], foods)
    view.behind([goal.node for goal in goals[:1]])
