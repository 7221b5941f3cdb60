"""Weights of motions on the motion nodes of the graph."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import neo4j

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.rows import VerbCostRow
from foon_kg.store.graph.schema import check_readable
from foon_kg.store.graph.statements import LOAD_COSTS, WRITING_TURN, ask


@dataclass(frozen=True)
class WeightsReport:
    """What a load of weights did: how many ``units`` have one now, and which motions are known to one side only.

    ``not_in_graph`` are motions of the file that no unit has, ``without_weight`` those of the graph that the file
    lacks.
    """

    motions: int
    units: int
    not_in_graph: tuple[str, ...]
    without_weight: tuple[str, ...]


def load_weights(connection: Connection, costs: MotionCosts, kitchen: Kitchen | None = None) -> WeightsReport:
    """Make ``costs`` the weights of the graph of ``connection``, in one transaction; those from before are forgotten.

    Units that are loaded later get theirs from the same table. Loading it again changes nothing. ``kitchen`` is the
    usual one for ``None``. Raises GraphError where there is no FOON or the database fails, SchemaError for a FOON of
    another version; nothing is changed then.
    """
    with connection.session(writing=True) as session:
        rows = session.execute_write(_write, costs, kitchen or Kitchen.default())
    in_graph = {row.verb for row in rows}
    return WeightsReport(
        motions=len(costs.costs),
        units=sum(row.units for row in rows if row.has_cost),
        not_in_graph=tuple(sorted(costs.costs.keys() - in_graph)),
        without_weight=costs.unknown(in_graph),
    )


def _write(transaction: neo4j.ManagedTransaction, costs: MotionCosts, kitchen: Kitchen) -> Sequence[VerbCostRow]:
    check_readable(next(iter(ask(transaction, WRITING_TURN)), None), kitchen)
    table = [{"motion": motion, "cost": costs.costs[motion]} for motion in sorted(costs.costs)]
    return ask(transaction, LOAD_COSTS, costs=table)
