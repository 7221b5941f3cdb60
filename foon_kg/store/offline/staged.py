"""What is staged for an offline import: the tables of a FOON in one SQLite file, filled by the writer of the graph.

:class:`Staged` answers the statements with which :class:`~foon_kg.store.graph.writing.Writer` adds videos to a graph
that has none: each of its methods does on tables what the file of its name in ``cypher`` does in Neo4j. So an import
and a load write the same graph, by the same code. Nothing is ever taken away here.
"""

from __future__ import annotations

import json
import sqlite3
import uuid
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Self

from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.disk import explain_os_error
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.rows import AttestedRow, ContentRow, EvidenceRow, KeyRow, NameRow, SchemaState
from foon_kg.store.graph.schema import kitchen_key
from foon_kg.store.graph.statements import Row, Statement
from foon_kg.store.offline.tables import EDGES, END, LIST_DELIMITER, NODES, START, Edges, Nodes, kind_of, named

CACHE_KIB = 64_000
"""Bounds the memory that SQLite takes."""

Rows = Sequence[Mapping[str, Any]]

_TABLES = {table.name: table for table in (*NODES, *EDGES)}


class Staged:
    """The tables of a FOON in the file ``path``, which is made where it is not there. Close it, or use ``with``."""

    def __init__(self, path: Path, kitchen: Kitchen) -> None:
        self._kitchen = kitchen
        with explain_os_error(f"cannot write {path}"):
            path.touch()
        self.database = sqlite3.connect(path, isolation_level=None)
        for pragma in ("journal_mode = OFF", "synchronous = OFF", f"cache_size = -{CACHE_KIB}"):
            self.database.execute(f"PRAGMA {pragma}")
        for table in _TABLES.values():
            self.database.executescript(_made(table))
        self.database.execute("BEGIN")

    def ask(self, statement: Statement[Row], **parameters: object) -> list[Row]:
        """Do what ``statement`` does, and return its rows."""
        return getattr(self, statement.name)(**parameters) or []

    def commit(self) -> None:
        """Write down what was staged."""
        self.database.execute("COMMIT")
        self.database.execute("BEGIN")

    def close(self) -> None:
        """Let the file go."""
        self.database.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # the statements of the writer

    def writing_turn(self) -> list[SchemaState]:
        """Return the state of a graph that this program writes."""
        return [SchemaState(0, kitchen_key(self._kitchen), word_lists_key(), str(uuid.uuid4()), methods_key())]

    def video_contents(self, names: Sequence[str]) -> list[ContentRow]:
        """Return the content of those of the named videos that are there."""
        return [ContentRow(*row) for row in self._found("Video", "content", names)]

    def load_videos(self, videos: Rows) -> None:
        """Make videos."""
        self._insert("Video", ((row["name"], row["content"], _joined(row["sources"])) for row in videos))

    def load_objects(self, objects: Rows) -> None:
        """Make object nodes that are not there yet."""
        columns = [named(column) for column in _nodes("Object").columns]
        new = self._new("Object", (tuple(_cell(row[name]) for name in columns) for row in objects))
        labels = {row["key"]: row["label"] for row in objects}
        ids = self._merged("Label", labels.values())
        self._insert("Object_CALLED_Label", ((number, ids[labels[key]]) for key, number in new))

    def load_units(self, units: Rows) -> list[KeyRow]:
        """Make units that are not there yet, and return their keys."""
        cells = ((row["key"], row["verb"], _cell(row["accepts_any"])) for row in units)
        new = dict(self._new("Motion", cells))
        fresh = [row for row in units if row["key"] in new]
        objects = self._ids("Object", {key for row in fresh for key in (*row["inputs"], *row["outputs"])})
        ins = ((objects[key], new[row["key"]], None) for row in fresh for key in row["inputs"])
        outs = ((new[row["key"]], objects[key], None) for row in fresh for key in row["outputs"])
        self._insert("Object_INPUT_OF_Motion", ins)
        self._insert("Motion_OUTPUTS_Object", outs)
        return [KeyRow(key) for key in new]

    def load_sightings(self, sightings: Rows) -> None:
        """Write down where units were seen."""
        motions = self._ids("Motion", {row["unit"] for row in sightings})
        videos = self._ids("Video", {row["video"] for row in sightings})
        columns = [named(column) for column in _edges("Motion_SEEN_IN_Video").columns]
        cells = (
            (motions[row["unit"]], videos[row["video"]], *(_cell(row["properties"][name]) for name in columns))
            for row in sightings
        )
        self._insert("Motion_SEEN_IN_Video", cells)

    def load_next(self, videos: Rows) -> None:
        """Tie each unit of a video to the one that follows it."""
        motions = self._ids("Motion", {key for row in videos for key in row["units"]})
        pairs = (
            (motions[one], motions[other], row["name"], place)
            for row in videos
            for place, (one, other) in enumerate(zip(row["units"], row["units"][1:], strict=False))
        )
        self._insert("Motion_NEXT_Motion", pairs)

    def load_movements(self, rows: Rows) -> None:
        """Count sightings that show the objects of units moving."""
        motions = self._ids("Motion", {row["unit"] for row in rows})
        objects = self._ids("Object", {one["key"] for row in rows for one in (*row["inputs"], *row["outputs"])})
        for side, table, motion, other in (
            ("inputs", "Object_INPUT_OF_Motion", END, START),
            ("outputs", "Motion_OUTPUTS_Object", START, END),
        ):
            self.database.executemany(
                f"UPDATE {table} SET moving = coalesce(moving, 0) + ? WHERE {motion} = ? AND {other} = ?",
                [(one["count"], motions[row["unit"]], objects[one["key"]]) for row in rows for one in row[side]],
            )

    def load_goals(self, goals: Rows) -> None:
        """Mark goal nodes with their dish types and the foods they are made of."""
        dishes = self._merged("DishType", {row["dish_type"] for row in goals})
        objects = self._ids("Object", {row["key"] for row in goals})
        edges = ((objects[row["key"]], dishes[row["dish_type"]], row["video"]) for row in goals)
        self._insert("Object_IS_A_DishType", edges)
        made_of = {key: _split(foods) for key, foods in self._found("Object", "ingredients", objects)}
        foods = self._merged("Ingredient", {food for names in made_of.values() for food in names})
        pairs = ((objects[key], foods[name]) for key, names in made_of.items() for name in names)
        self._insert("Object_MADE_OF_Ingredient", pairs)

    def forget_plans(self, keys: Sequence[str]) -> None:
        """Do nothing: no reference trees are kept."""

    def count_foods(self, rows: Rows) -> None:
        """Add to the counts of foods in states."""
        foods = self._merged("Ingredient", {row["label"] for row in rows})
        states = self._merged("State", {row["state"] for row in rows})
        counts = ((foods[row["label"]], states[row["state"]], row["made"], row["used"]) for row in rows)
        self._add("Ingredient_SEEN_AS_State", counts, "made", "used")

    def count_motions(self, rows: Rows) -> None:
        """Add to the counts of states by verb."""
        states = self._merged("State", {row["state"] for row in rows})
        verbs = self._merged("Verb", {row["motion"] for row in rows})
        counts = ((states[row["state"]], verbs[row["motion"]], row["count"]) for row in rows)
        self._add("State_MADE_BY_Verb", counts, "count")

    def count_verbs(self, rows: Rows) -> None:
        """Add to the counts of units by verb."""
        self._merged("Verb", {row["motion"] for row in rows})
        self.database.executemany(
            "UPDATE Verb SET units = coalesce(units, 0) + ?, several = coalesce(several, 0) + ? WHERE name = ?",
            [(row["units"], row["several"], row["motion"]) for row in rows],
        )

    def load_matters(
        self, foods: Rows, kinds: Sequence[str], forms: Sequence[str], anything: Sequence[str]
    ) -> None:
        """Make what operators are done to, where it is not there yet."""
        rows = [(row["name"], row["kind"], "Food") for row in foods]
        rows += [(name, None, "Kind") for name in kinds]
        rows += [(name, None, "Form") for name in forms]
        rows += [(name, None, None) for name in anything]
        self.database.executemany(
            'INSERT OR IGNORE INTO Matter (name, kind, "_label") VALUES (?, ?, ?)', rows
        )

    def load_operators(self, operators: Rows) -> None:
        """Make operators that are not there yet, and tie new units to them."""
        self._insert("Operator", ((row["key"], row["motion"], _joined(row["tools"]), 0, None, None) for row in operators))
        ids = self._ids("Operator", [row["key"] for row in operators])
        motions = self._ids("Motion", {unit["key"] for row in operators for unit in row["units"]})
        ties = (
            (ids[row["key"]], motions[unit["key"]], _joined(unit["done_to"]), _joined(unit["changes"]))
            for row in operators
            for unit in row["units"]
        )
        self._insert("Operator_ATTESTED_BY_Motion", ties)

    def attested(self, keys: Sequence[str]) -> list[AttestedRow]:
        """Return what units attest."""
        rows = self.database.execute(
            "SELECT m.key, o.key, a.done_to, a.changes FROM json_each(?) k JOIN Motion m ON m.key = k.value "
            f'JOIN Operator_ATTESTED_BY_Motion a ON a."{END}" = m.id JOIN Operator o ON o.id = a."{START}"',
            (json.dumps(keys),),
        )
        return [AttestedRow([(unit, way, _split(done), _split(changes)) for unit, way, done, changes in rows])]

    def evidence(self, pairs: Rows) -> list[EvidenceRow]:
        """Return the evidence that is kept for operators and matters."""
        asked = [(row["operator"], name) for row in pairs for name in row["matters"]]
        rows = self.database.execute(
            "SELECT o.key, m.name, d.seen, d.changes FROM json_each(?) p "
            "JOIN Operator o ON o.key = json_extract(p.value, '$[0]') "
            "JOIN Matter m ON m.name = json_extract(p.value, '$[1]') "
            f'JOIN Operator_DONE_TO_Matter d ON d."{START}" = o.id AND d."{END}" = m.id',
            (json.dumps(asked),),
        )
        return [EvidenceRow([(way, matter, _split(seen), _split(changes)) for way, matter, seen, changes in rows])]

    def load_evidence(self, rows: Rows) -> None:
        """Add to the counts of what operators are done to, and write down where that was first seen."""
        operators = self._ids("Operator", {row["operator"] for row in rows})
        matters = self._ids("Matter", {row["matter"] for row in rows})
        self.database.executemany(
            "INSERT INTO Operator_DONE_TO_Matter VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET "
            "units = units + excluded.units, changed = changed + excluded.changed, "
            "seen = excluded.seen, changes = excluded.changes",
            [
                (operators[row["operator"]], matters[row["matter"]], row["units"], row["changed"],
                 _joined(row["seen"]), _joined(row["changes"]))
                for row in rows
            ],
        )  # fmt: skip

    def usual_foods(self, rows: Rows) -> None:
        """Leave it to :meth:`finish`: what is most often done to what is known at the end."""

    def count_operators(self, operators: Rows, gives: Rows, brings: Rows, places: Rows, appliances: Rows,
                        states: Rows) -> None:  # fmt: skip
        """Add to the counts of operators, and of the states in which matters are."""
        self.database.executemany(
            "UPDATE Operator SET count = count + ? WHERE key = ?",
            [(row["count"], row["operator"]) for row in operators],
        )
        self._count("Operator_GIVES_State", gives, "operator", "state")
        self._count("Operator_BRINGS_Matter", brings, "operator", "matter", "role")
        self._count("Operator_DONE_IN_Utensil", places, "operator", "utensil")
        self._count("Operator_WORKS_WITH_Utensil", appliances, "operator", "utensil")
        self._count("Matter_FOUND_AS_State", states, "matter", "state")

    def count_joins(self, posts: Rows, beside: Rows, cooked: Rows) -> None:
        """Add to the counts of where foods of a kind join, beside what, and how they are cooked before."""
        made = {row["post"]: row["properties"] for row in posts}
        rows = ((name, post["work"], post["heated"], _cell(post["joins"])) for name, post in made.items())
        self._insert("Post", rows)
        self._count("Matter_JOINS_AT_Post", posts, "kind", "post", "dish_type")
        self._count("Matter_JOINS_BESIDE_Matter", beside, "kind", "other")
        verbs = {name for name, _ in self._found("Verb", "name", {row["motion"] for row in cooked})}
        self._count("Matter_COOKED_BY_Verb", [row for row in cooked if row["motion"] in verbs], "kind", "motion")

    def load_frames(self, frames: Rows) -> None:
        """Make frames with their stages, lines and slots."""
        objects = self._ids("Object", {row["goal"] for row in frames})
        videos = self._ids("Video", {row["video"] for row in frames})
        matters = self._ids("Matter", {slot["properties"]["food"] for row in frames for slot in row["slots"]})
        for row in frames:
            frame = self._one("Frame", {"key": row["key"], **row["properties"]})
            self._insert("Frame_OF_Object", [(frame, objects[row["goal"]])])
            self._insert("Frame_DERIVED_FROM_Video", [(frame, videos[row["video"]])])
            stages = [self._one("Stage", stage) for stage in row["stages"]]
            self._insert("Frame_HAS_STAGE_Stage", _placed(frame, stages, row["main"]))
            for line in row["lines"]:
                number = self._one("Line", {})
                self._insert("Stage_JOINED_BY_Line", [(stages[line["stage"]], number, line["place"])])
                self._insert("Line_HAS_STAGE_Stage", _placed(number, stages, line["stages"]))
            for slot in row["slots"]:
                number = self._one("Slot", slot["properties"])
                self._insert("Stage_HAS_SLOT_Slot", [(stages[slot["stage"]], number, slot["place"])])
                self._insert("Slot_TAKES_Matter", [(number, matters[slot["properties"]["food"]])])

    def foods_new(self, names: Sequence[str]) -> list[NameRow]:
        """Return which of ``names`` are foods without a point."""
        ingredients = self._found("Ingredient", "singular", names)
        matters = self.database.execute(
            'SELECT m.name, m.canonical FROM json_each(?) asked JOIN Matter m ON m.name = asked.value '
            'WHERE m."_label" = ?',
            (json.dumps(list(names)), "Food"),
        )
        return [NameRow(name) for name in {name for name, known in (*ingredients, *matters) if known is None}]

    def load_vectors(self, rows: Rows) -> None:
        """Give foods their points and the names that they are compared by."""
        cells = [(row["canonical"], row["singular"], _cell(row["vector"]), row["name"]) for row in rows]
        self.database.executemany(
            "UPDATE Ingredient SET canonical = ?, singular = ?, vector = ? WHERE name = ?", cells
        )
        self.database.executemany(
            "UPDATE Matter SET canonical = ?, vector = ? WHERE name = ?",
            [(canonical, vector, name) for canonical, _, vector, name in cells],
        )

    def finish(self) -> None:
        """Bring up to date what is found out once, at the end."""
        for column, count in (("most_done", "units"), ("most_changed", "changed")):
            self.database.execute(
                f"UPDATE Operator SET {column} = (SELECT m.name FROM Operator_DONE_TO_Matter d "
                f'JOIN Matter m ON m.id = d."{END}" WHERE d."{START}" = Operator.id AND m."_label" = \'Food\' '
                f"AND d.{count} > 0 ORDER BY d.{count} DESC, m.name LIMIT 1)"
            )
        self.commit()

    # the tables

    def _one(self, table: str, properties: Mapping[str, Any]) -> int:
        """Make one node, and return its number."""
        columns = [named(column) for column in _nodes(table).columns]
        cells = [_cell(properties.get(name)) for name in columns]
        marks = ", ".join("?" * (1 + len(cells)))
        number = self.database.execute(f"INSERT INTO {table} VALUES ({marks})", (None, *cells)).lastrowid
        return number or 0

    def _insert(self, table: str, rows: Iterable[Sequence[Any]]) -> None:
        """Make nodes or edges that are not there yet."""
        made = _TABLES[table]
        columns = (*_keys(made), *(named(column) for column in made.columns))
        marks = ", ".join("?" * len(columns))
        names = ", ".join(f'"{column}"' for column in columns)
        self.database.executemany(f"INSERT OR IGNORE INTO {table} ({names}) VALUES ({marks})", rows)

    def _new(self, table: str, rows: Iterable[Sequence[Any]]) -> Iterator[tuple[str, int]]:
        """Make nodes that are not there yet, and yield the key and number of each that was not."""
        columns = [named(column) for column in _nodes(table).columns]
        marks, names = ", ".join("?" * len(columns)), ", ".join(f'"{column}"' for column in columns)
        cursor, text = self.database.cursor(), f"INSERT OR IGNORE INTO {table} ({names}) VALUES ({marks})"
        for row in rows:
            if cursor.execute(text, row).rowcount:
                yield row[0], cursor.lastrowid or 0

    def _merged(self, table: str, names: Iterable[str]) -> dict[str, int]:
        """Return the numbers of words, which are made where they are not there yet."""
        wanted = sorted(set(names))
        self.database.executemany(f"INSERT OR IGNORE INTO {table} (name) VALUES (?)", ((name,) for name in wanted))
        return self._ids(table, wanted)

    def _ids(self, table: str, keys: Iterable[str]) -> dict[str, int]:
        return dict(self._found(table, "id", keys))

    def _found(self, table: str, column: str, keys: Iterable[str]) -> list[tuple[str, Any]]:
        """Return the key and one column of those nodes that are there."""
        key = named(_nodes(table).columns[0])
        text = f'SELECT t."{key}", t."{column}" FROM json_each(?) asked JOIN {table} t ON t."{key}" = asked.value'
        return self.database.execute(text, (json.dumps(list(keys)),)).fetchall()

    def _count(self, table: str, rows: Rows, start: str, end: str, more: str = "") -> None:
        """Add to counts between the nodes that the columns ``start`` and ``end`` name."""
        edges = _edges(table)
        starts = self._ends(edges.start, {row[start] for row in rows})
        ends = self._ends(edges.end, {row[end] for row in rows})
        cells = (
            (starts[row[start]], ends[row[end]], *((row[more],) if more else ()), row["count"]) for row in rows
        )
        self._add(table, cells, "count")

    def _ends(self, label: str, names: Iterable[str]) -> dict[str, int]:
        """Return the numbers of nodes; states and utensils are made where they are not there yet."""
        return self._merged(label, names) if label in {"State", "Utensil"} else self._ids(label, names)

    def _add(self, table: str, rows: Iterable[Sequence[Any]], *counts: str) -> None:
        marks = ", ".join("?" * (2 + len(_edges(table).columns)))
        sums = ", ".join(f'"{name}" = "{name}" + excluded."{name}"' for name in counts)
        self.database.executemany(f"INSERT INTO {table} VALUES ({marks}) ON CONFLICT DO UPDATE SET {sums}", rows)


def _nodes(name: str) -> Nodes:
    table = _TABLES[name]
    assert isinstance(table, Nodes)
    return table


def _edges(name: str) -> Edges:
    table = _TABLES[name]
    assert isinstance(table, Edges)
    return table


def _keys(table: Nodes | Edges) -> tuple[str, ...]:
    return () if isinstance(table, Nodes) else (START, END)


def _made(table: Nodes | Edges) -> str:
    """Return the statement that makes a table where it is not there; numbers are kept as numbers, all else as texts."""
    columns = [f'"{named(column)}" {"INTEGER" if kind_of(column) == "long" else "TEXT"}' for column in table.columns]
    if isinstance(table, Nodes):
        columns = ["id INTEGER PRIMARY KEY", *columns, *(['"_label" TEXT'] if table.labelled else [])]
        unique, rest = ((named(table.columns[0]),) if table.unique else ()), ""
    else:
        columns = [f'"{START}" INTEGER', f'"{END}" INTEGER', *columns]
        unique, rest = table.unique, " WITHOUT ROWID" if table.unique else ""
    if unique:
        names = ", ".join(f'"{name}"' for name in unique)
        columns.append(f"{'UNIQUE' if isinstance(table, Nodes) else 'PRIMARY KEY'} ({names})")
    return f"CREATE TABLE IF NOT EXISTS {table.name} ({', '.join(columns)}){rest};"


def _cell(value: object) -> str | int | None:
    """Return a value as it stands in the tables: the text that the CSV file has of it, but for whole numbers."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int):
        return value
    if isinstance(value, Iterable):
        return _joined(value)
    return repr(value)


def _joined(values: Iterable[object]) -> str | None:
    """Return a list as one text, an empty one as nothing."""
    return LIST_DELIMITER.join(str(_cell(value)) for value in values) or None


def _split(text: str | None) -> list[str]:
    return text.split(LIST_DELIMITER) if text else []


def _placed(owner: int, stages: Sequence[int], numbers: Iterable[int]) -> Iterator[tuple[int, int, int]]:
    return ((owner, stages[number], place) for place, number in enumerate(numbers))
