"""Reference trees that were retrieved are kept in the graph, once the question is answered."""

from __future__ import annotations

import dataclasses
import logging
from collections.abc import Sequence

from foon_kg.model.errors import GraphError
from foon_kg.model.knowledge import RetrievedTree
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.statements import REMEMBER, ask

PATIENCE = 2.0
"""How long (seconds) to wait for a load that holds the goal; a tree that is not kept is searched for again."""

_log = logging.getLogger(__name__)


def keep_trees(connection: Connection, trees: Sequence[RetrievedTree]) -> bool:
    """Keep ``trees`` in one transaction of ``connection``, and return whether that could be done.

    Whoever may only read, or comes while a load holds the goal, keeps nothing: the question has been answered, and what
    is kept only spares the next one a search.
    """
    rows = [dataclasses.asdict(tree) for tree in sorted(trees, key=lambda tree: tree.question)]
    try:
        with connection.session(writing=True) as session, session.begin_transaction(timeout=PATIENCE) as transaction:
            ask(transaction, REMEMBER, trees=rows)
    except GraphError as error:
        _log.info("the reference trees are not kept: %s", error)
        return False
    return True
