"""All that is in a graph, as a value that two graphs of the same content share."""

from __future__ import annotations

CHANGES = {"edition", "writes"}
"""What the record of a FOON tells of its writes, whatever they did."""


def whole_graph(connection, *, without="none"):
    """Return every node and relationship with its properties, in an order that does not depend on who wrote them.

    Nodes with the label ``without`` and what leads to them are left out.
    """
    with connection.session() as session:
        nodes = session.run(
            "MATCH (n) WHERE NOT $without IN labels(n) "
            "RETURN elementId(n) AS id, labels(n) AS labels, properties(n) AS values",
            without=without,
        )
        of = {row["id"]: (tuple(sorted(row["labels"])), _values(row["values"])) for row in nodes}
        edges = session.run(
            "MATCH (a)-[r]->(b) RETURN elementId(a) AS a, type(r) AS type, properties(r) AS values, elementId(b) AS b"
        )
        lines = [
            repr((of[row["a"]], row["type"], _values(row["values"]), of[row["b"]]))
            for row in edges
            if row["a"] in of and row["b"] in of
        ]
    return sorted(map(repr, of.values())), sorted(lines)


def _values(found):
    return tuple(sorted((name, repr(value)) for name, value in found.items() if name not in CHANGES))
