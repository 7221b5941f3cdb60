"""A program that loads FOONs and tells every step on stdout, waiting after each line until it is told to go on.

Started by the tests with the connection and the subgraphs' folder on the command line; they end it with kill -9.
"""

from __future__ import annotations

import json
import logging
import sys
from pathlib import Path

from foon_kg.loaders import read_paths
from foon_kg.store.graph import Connection, load
from foon_kg.store.settings import ConnectionSettings


def tell(line: str) -> None:
    print(line, flush=True)
    sys.stdin.readline()


class Telling(logging.Handler):
    """Tells each query before it is sent."""

    def emit(self, record: logging.LogRecord) -> None:
        tell(f"sending {record.getMessage()}")


def main() -> None:
    settings = ConnectionSettings(**json.loads(sys.argv[1]))
    queries = logging.getLogger("foon_kg.store.graph.statements")
    queries.setLevel(logging.DEBUG)
    queries.addHandler(Telling())
    subgraphs = [result.subgraph for result in read_paths([Path(sys.argv[2])]) if result.subgraph]
    with Connection(settings) as connection:
        load(
            connection,
            subgraphs,
            stored=lambda report: tell("stored " + json.dumps(report.inserted + report.replaced + report.unchanged)),
            units_per_transaction=1,
        )


main()
