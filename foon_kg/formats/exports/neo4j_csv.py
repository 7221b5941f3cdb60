"""CSV files for ``neo4j-admin database import``: the graph that ``foon load foon`` writes, for a database offline.

One file for each label and each type of relationship, as :mod:`foon_kg.store.offline.tables` describes them. Texts are
quoted, what is missing is an empty field without quotes, and lists are joined by a character that no name can hold. An
import makes neither empty lists nor constraints. So the imported graph is no FOON yet: the one statement of
:data:`AFTER` makes the lists and writes the record that says so; and as that record names no schema, ``foon load foon``
with any of the files applies it, and finds all else in place.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from foon_kg.food.motion_costs import NO_COSTS, MotionCosts
from foon_kg.formats.exports.files import ExportFile
from foon_kg.formats.exports.neo4j_tables import Cell, Row, edge_tables, node_tables
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.schema import kitchen_key
from foon_kg.store.offline.tables import FOON_EDGES, FORMAT, LIST_DELIMITER, NODES, RECIPES
from foon_kg.store.snapshot import Snapshot

ARGUMENTS = "import.txt"
AFTER = "after.cypher"

_EXPORTED = ("Video", "Label", "Object", "Motion", "DishType", "Ingredient", "State", "Verb")
"""What an export has. Operators, frames and what is known of foods besides are learnt by the next load."""

_NODES = {
    table.label: tuple(column for column in table.columns if column != RECIPES)
    for table in NODES
    if table.label in _EXPORTED
}
_NODES["Motion"] += ("cost:double",)
_EDGES = {edges.type: edges for edges in FOON_EDGES if {edges.start, edges.end} <= set(_EXPORTED)}

_AFTER = """\
// Makes of the imported nodes a FOON that foon-kg can read: with the lists that an import leaves out where they are
// empty or hold one empty text, and with the record of the whole. Once: foon cypher --write - < after.cypher
MATCH (o:Object) SET o.states = coalesce(o.states, []), o.ingredients = coalesce(o.ingredients, [])
WITH count(*) AS objects
MATCH (v:Video) SET v.sources = coalesce(v.sources, [])
WITH count(*) AS videos
MATCH (:Motion)-[s:SEEN_IN]->(:Video)
SET s.span_starts = coalesce(s.span_starts, []), s.span_ends = coalesce(s.span_ends, []),
  s.inputs_dish = coalesce(s.inputs_dish, ['']), s.outputs_dish = coalesce(s.outputs_dish, [''])
WITH count(*) AS sightings
MERGE (f:Foon {{name: 'foon-kg'}})
SET f.version = 0, f.kitchen = '{kitchen}', f.words = '{words}', f.writes = 0{costs}
WITH f
MATCH (l:Label)
MERGE (l)-[:LABEL_OF]->(f)
"""


def write_neo4j_csv(foon: Snapshot, costs: MotionCosts = NO_COSTS) -> tuple[ExportFile, ...]:
    """Return the CSV files of a whole ``foon`` with the ``costs`` of its motions, and the arguments for the import."""
    nodes, edges = node_tables(foon), edge_tables(foon)
    nodes["Motion"] = [(*row, costs.costs.get(str(row[1]))) for row in nodes["Motion"]]
    places = {label: {row[0]: place for place, row in enumerate(rows)} for label, rows in nodes.items()}
    files = []
    for label, columns in _NODES.items():
        rows = ((place, *row) for place, row in enumerate(nodes[label]))
        files.append(_file(label, (f":ID({label})", *columns), rows))
    for kind, told in _EDGES.items():
        rows = ((places[told.start][row[0]], places[told.end][row[1]], *row[2:]) for row in edges[kind])
        files.append(_file(kind, (*told.ids, *told.columns), rows))
    after = _AFTER.format(kitchen=kitchen_key(foon.kitchen), words=word_lists_key(), costs=_table(costs))
    return (*files, ExportFile(ARGUMENTS, _arguments()), ExportFile(AFTER, after))


def _table(costs: MotionCosts) -> str:
    """Return the part of a SET clause that keeps ``costs`` for motion nodes that come later."""
    if not costs:
        return ""
    motions = sorted(costs.costs)
    names = ", ".join("'" + motion.replace("\\", "\\\\").replace("'", "\\'") + "'" for motion in motions)
    numbers = ", ".join(str(costs.costs[motion]) for motion in motions)
    return f",\n  f.cost_motions = [{names}],\n  f.costs = [{numbers}]"


def _arguments() -> str:
    lines = [f"--nodes={label}=./{label}.csv" for label in _NODES]
    lines += [f"--relationships={kind}=./{kind}.csv" for kind in _EDGES]
    lines += FORMAT
    return "\n".join(lines) + "\n"


def _file(name: str, header: Sequence[str], rows: Iterable[Row]) -> ExportFile:
    lines = (",".join(header), *(",".join(map(_cell, row)) for row in rows))
    return ExportFile(f"{name}.csv", "\n".join(lines) + "\n")


def _cell(value: Cell) -> str:
    if value is None:
        return ""
    if isinstance(value, str):
        return '"' + value.replace('"', '""') + '"'
    if isinstance(value, Sequence):
        return _cell(LIST_DELIMITER.join(map(_plain, value)))
    return _plain(value)


def _plain(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)
