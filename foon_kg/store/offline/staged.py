"""What is staged for an offline import: the tables of a FOON in one SQLite file, filled by the writer of the graph.

:class:`Staged` answers the statements with which :class:`~foon_kg.store.graph.writing.Writer` adds videos to a graph
that has none: each of its methods does on tables what the file of its name in ``cypher`` does in Neo4j. So an import
and a load write the same graph, by the same code. Nothing is ever taken away here.
"""

from __future__ import annotations

import json
import uuid
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path

from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.method_rows import AttestedRow, EvidenceRow
from foon_kg.store.graph.rows import ContentRow, KeysRow, NameRow, SchemaState
from foon_kg.store.graph.schema import kitchen_key
from foon_kg.store.graph.statements import R, Statement
from foon_kg.store.offline.database import Rows, cell, edges_of, joined, nodes_of, split
from foon_kg.store.offline.recipes import StagedRecipes
from foon_kg.store.offline.tables import END, NUMBER, START, named


class Staged(StagedRecipes):
    """The tables of a FOON in the file ``path``, which is made where it is not there. Close it, or use ``with``."""

    def __init__(self, path: Path, kitchen: Kitchen) -> None:
        super().__init__(path)
        self._kitchen = kitchen

    def ask(self, statement: Statement[R], **parameters: object) -> list[R]:
        """Do what ``statement`` does, and return its rows."""
        return getattr(self, statement.name)(**parameters) or []

    def seen_foods(self) -> list[str]:
        """Return the foods that units have in some state, sorted: those that a FOON's vocabulary tells."""
        rows = self.database.execute(
            f'SELECT DISTINCT i.name FROM Ingredient_SEEN_AS_State s JOIN Ingredient i ON i.{NUMBER} = s."{START}"'
        )
        return sorted(name for (name,) in rows)

    def writing_turn(self) -> list[SchemaState]:
        """Return the state of a graph that this program writes."""
        return [SchemaState(0, kitchen_key(self._kitchen), word_lists_key(), str(uuid.uuid4()), methods_key())]

    def video_contents(self, names: Sequence[str]) -> list[ContentRow]:
        """Return the content of those of the named videos that are there."""
        return [ContentRow(*row) for row in self.found("Video", "content", names)]

    def load_videos(self, videos: Rows) -> None:
        """Make videos."""
        self.insert("Video", ((row["name"], row["content"], joined(row["sources"])) for row in videos))

    def load_objects(self, objects: Rows) -> list[KeysRow]:
        """Make object nodes that are not there yet, and return their keys."""
        columns = [named(column) for column in nodes_of("Object").columns]
        new = list(self.new("Object", (tuple(cell(row[name]) for name in columns) for row in objects)))
        labels = {row["key"]: row["label"] for row in objects}
        ids = self.merged("Label", labels.values())
        self.insert("Object_CALLED_Label", ((number, ids[labels[key]]) for key, number in new))
        return [KeysRow([key for key, _ in new])]

    def load_units(self, units: Rows) -> list[KeysRow]:
        """Make units that are not there yet, and return their keys."""
        cells = ((row["key"], row["verb"], cell(row["accepts_any"])) for row in units)
        new = dict(self.new("Motion", cells))
        fresh = [row for row in units if row["key"] in new]
        ins, outs = list(_ends(fresh, "inputs")), list(_ends(fresh, "outputs"))
        objects = self.ids("Object", {key for _, key, _ in (*ins, *outs)})
        self.insert("Object_INPUT_OF_Motion", ((objects[key], new[unit], moving) for unit, key, moving in ins))
        self.insert("Motion_OUTPUTS_Object", ((new[unit], objects[key], moving) for unit, key, moving in outs))
        return [KeysRow(list(new))]

    def load_sightings(self, videos: Rows) -> None:
        """Write down where the units of ``videos`` were seen, and tie each to the one that follows it."""
        motions = self.ids("Motion", {one["unit"] for row in videos for one in row["sightings"]})
        numbers = self.ids("Video", {row["name"] for row in videos})
        columns = [named(column) for column in edges_of("Motion_SEEN_IN_Video").columns]
        cells = (
            (motions[one["unit"]], numbers[row["name"]], *(cell(one["properties"][name]) for name in columns))
            for row in videos
            for one in row["sightings"]
        )
        self.insert("Motion_SEEN_IN_Video", cells)
        pairs = (
            (motions[one["unit"]], motions[other["unit"]], row["name"], place)
            for row in videos
            for place, (one, other) in enumerate(pairwise(row["sightings"]))
        )
        self.insert("Motion_NEXT_Motion", pairs)

    def load_movements(self, rows: Rows) -> None:
        """Count sightings that show the objects of units moving, a row (``rows``) a unit."""
        motions = self.ids("Motion", {row["unit"] for row in rows})
        objects = self.ids("Object", {one["key"] for row in rows for one in (*row["inputs"], *row["outputs"])})
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
        dishes = self.merged("DishType", {row["dish_type"] for row in goals})
        objects = self.ids("Object", {row["key"] for row in goals})
        edges = ((objects[row["key"]], dishes[row["dish_type"]], row["video"]) for row in goals)
        self.insert("Object_IS_A_DishType", edges)
        made_of = {key: split(foods) for key, foods in self.found("Object", "ingredients", objects)}
        foods = self.merged("Ingredient", {food for names in made_of.values() for food in names})
        pairs = ((objects[key], foods[name]) for key, names in made_of.items() for name in names)
        self.insert("Object_MADE_OF_Ingredient", pairs)

    def count_foods(self, rows: Rows) -> None:
        """Add ``rows`` to the counts of foods in states."""
        foods = self.merged("Ingredient", {row["label"] for row in rows})
        states = self.merged("State", {row["state"] for row in rows})
        counts = ((foods[row["label"]], states[row["state"]], row["made"], row["used"]) for row in rows)
        self.add("Ingredient_SEEN_AS_State", counts, "made", "used")

    def count_motions(self, rows: Rows) -> None:
        """Add ``rows`` to the counts of states by verb."""
        states = self.merged("State", {row["state"] for row in rows})
        verbs = self.merged("Verb", {row["motion"] for row in rows})
        counts = ((states[row["state"]], verbs[row["motion"]], row["count"]) for row in rows)
        self.add("State_MADE_BY_Verb", counts, "count")

    def count_verbs(self, rows: Rows) -> None:
        """Add ``rows`` to the counts of units by verb."""
        self.merged("Verb", {row["motion"] for row in rows})
        self.database.executemany(
            "UPDATE Verb SET units = coalesce(units, 0) + ?, several = coalesce(several, 0) + ? WHERE name = ?",
            [(row["units"], row["several"], row["motion"]) for row in rows],
        )

    def load_matters(self, foods: Rows, kinds: Sequence[str], forms: Sequence[str], appliances: Sequence[str],
                     anything: Sequence[str]) -> None:  # fmt: skip
        """Make what operators are done to, where it is not there.

        That are ``foods``, ``kinds`` and ``forms`` of food, ``appliances``, and ``anything``.
        """
        rows: list[tuple[str, str | None, str | None]] = [(row["name"], row["kind"], "Food") for row in foods]
        rows += [(name, None, "Kind") for name in kinds]
        rows += [(name, None, "Form") for name in forms]
        rows += [(name, None, "Appliance") for name in appliances]
        rows += [(name, None, None) for name in anything]
        self.database.executemany('INSERT OR IGNORE INTO Matter (name, kind, "_label") VALUES (?, ?, ?)', rows)

    def load_operators(self, operators: Rows) -> None:
        """Make operators that are not there yet, and tie new units to them."""
        self.insert("Operator", ((row["key"], row["motion"], joined(row["tools"]), 0, None, None) for row in operators))
        ids = self.ids("Operator", [row["key"] for row in operators])
        motions = self.ids("Motion", {unit["key"] for row in operators for unit in row["units"]})
        ties = (
            (ids[row["key"]], motions[unit["key"]], joined(unit["done_to"]), joined(unit["changes"]))
            for row in operators
            for unit in row["units"]
        )
        self.insert("Operator_ATTESTED_BY_Motion", ties)

    def attested(self, keys: Sequence[str]) -> list[AttestedRow]:
        """Return what the units called ``keys`` attest."""
        rows = self.database.execute(
            "SELECT m.key, o.key, a.done_to, a.changes FROM json_each(?) k JOIN Motion m ON m.key = k.value "
            f'JOIN Operator_ATTESTED_BY_Motion a ON a."{END}" = m.{NUMBER} JOIN Operator o ON o.{NUMBER} = a."{START}"',
            (json.dumps(keys),),
        )
        return [AttestedRow([(unit, way, split(done), split(changes)) for unit, way, done, changes in rows])]

    def evidence(self, pairs: Rows) -> list[EvidenceRow]:
        """Return the evidence that is kept for ``pairs`` of an operator and a matter."""
        asked = [(row["operator"], name) for row in pairs for name in row["matters"]]
        rows = self.database.execute(
            "SELECT o.key, m.name, d.units, d.changed, d.seen, d.changes FROM json_each(?) p "
            "JOIN Operator o ON o.key = json_extract(p.value, '$[0]') "
            "JOIN Matter m ON m.name = json_extract(p.value, '$[1]') "
            f'JOIN Operator_DONE_TO_Matter d ON d."{START}" = o.{NUMBER} AND d."{END}" = m.{NUMBER}',
            (json.dumps(asked),),
        )
        return [
            EvidenceRow(
                [
                    (way, matter, units, changed, split(seen), split(changes))
                    for way, matter, units, changed, seen, changes in rows
                ]
            )
        ]

    def load_evidence(self, rows: Rows) -> None:
        """Add ``rows`` to the counts of what operators are done to, and write down where that was first seen."""
        pairs = [(row["operator"], one) for row in rows for one in (*row["known"], *row["new"])]
        operators = self.ids("Operator", {operator for operator, _ in pairs})
        matters = self.ids("Matter", {one["matter"] for _, one in pairs})
        self.database.executemany(
            "INSERT INTO Operator_DONE_TO_Matter VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET "
            "units = units + excluded.units, changed = changed + excluded.changed, "
            "seen = excluded.seen, changes = excluded.changes",
            [
                (operators[operator], matters[one["matter"]], one["units"], one["changed"],
                 joined(one["seen"]), joined(one["changes"]))
                for operator, one in pairs
            ],
        )  # fmt: skip

    def count_states(self, rows: Rows) -> None:
        """Leave ``rows`` uncounted: what was imported is counted at once."""

    def usual_foods(self, rows: Rows) -> None:
        """Leave ``rows`` to :meth:`finish`: what is most often done to what is known at the end."""

    def count_operators(self, *, operators: Rows, gives: Rows, brings: Rows, places: Rows, states: Rows) -> None:
        """Add to the counts of ``operators``, and of the ``states`` in which matters are.

        ``gives``, ``brings`` and ``places`` are rows with a count each: which state an operator gives, what it brings
        along, and where it is done.
        """
        self.database.executemany(
            "UPDATE Operator SET count = count + ? WHERE key = ?",
            [(row["count"], row["operator"]) for row in operators],
        )
        self.count("Operator_GIVES_State", gives, "operator", "state")
        self.count("Operator_BRINGS_Matter", brings, "operator", "matter", "role")
        self.count("Operator_DONE_IN_Utensil", places, "operator", "utensil")
        self.count("Matter_FOUND_AS_State", states, "matter", "state")

    def count_joins(self, stage_types: Rows, beside: Rows, cooked: Rows) -> None:
        """Add to the counts of at which ``stage_types`` kinds join, ``beside`` what, how ``cooked`` before."""
        made = {row["stage_type"]: row["properties"] for row in stage_types}
        rows = ((name, one["work"], one["heated"], cell(one["joins"])) for name, one in made.items())
        self.insert("StageType", rows)
        self.count("Matter_JOINS_AT_StageType", stage_types, "kind", "stage_type", "dish_type")
        self.count("Matter_JOINS_BESIDE_Matter", beside, "kind", "other")
        verbs = {name for name, _ in self.found("Verb", "name", {row["motion"] for row in cooked})}
        self.count("Matter_COOKED_BY_Verb", [row for row in cooked if row["motion"] in verbs], "kind", "motion")

    def load_frames(self, frames: Rows) -> None:
        """Make frames with their stages, lines and slots."""
        objects = self.ids("Object", {row["goal"] for row in frames})
        videos = self.ids("Video", {row["video"] for row in frames})
        matters = self.ids("Matter", {slot["properties"]["food"] for row in frames for slot in row["slots"]})
        for row in frames:
            frame = self.one("Frame", {"key": row["key"], **row["properties"]})
            self.insert("Frame_OF_Object", [(frame, objects[row["goal"]])])
            self.insert("Frame_DERIVED_FROM_Video", [(frame, videos[row["video"]])])
            stages = [self.one("Stage", stage) for stage in row["stages"]]
            self.insert("Frame_HAS_STAGE_Stage", _placed(frame, stages, row["main"]))
            for line in row["lines"]:
                number = self.one("Line", {})
                self.insert("Stage_JOINED_BY_Line", [(stages[line["stage"]], number, line["place"])])
                self.insert("Line_HAS_STAGE_Stage", _placed(number, stages, line["stages"]))
            for slot in row["slots"]:
                number = self.one("Slot", slot["properties"])
                self.insert("Stage_HAS_SLOT_Slot", [(stages[slot["stage"]], number, slot["place"])])
                self.insert("Slot_TAKES_Matter", [(number, matters[slot["properties"]["food"]])])

    def foods_new(self, names: Sequence[str]) -> list[NameRow]:
        """Return which of ``names`` are foods without a point."""
        ingredients = self.found("Ingredient", "singular", names)
        matters = self.database.execute(
            "SELECT m.name, m.canonical FROM json_each(?) asked JOIN Matter m ON m.name = asked.value "
            'WHERE m."_label" = ?',
            (json.dumps(list(names)), "Food"),
        )
        return [NameRow(name) for name in {name for name, known in (*ingredients, *matters) if known is None}]

    def load_vectors(self, rows: Rows) -> None:
        """Give foods their points and the names that they are compared by, a row (``rows``) a food."""
        cells = [(row["canonical"], row["singular"], cell(row["vector"]), row["name"]) for row in rows]
        self.database.executemany("UPDATE Ingredient SET canonical = ?, singular = ?, vector = ? WHERE name = ?", cells)
        self.database.executemany(
            "UPDATE Matter SET canonical = ?, vector = ? WHERE name = ?",
            [(canonical, vector, name) for canonical, _, vector, name in cells],
        )

    def finish(self) -> None:
        """Bring up to date what is found out once, at the end."""
        for column, count in (("most_done", "units"), ("most_changed", "changed")):
            self.database.execute(
                f"UPDATE Operator SET {column} = (SELECT m.name FROM Operator_DONE_TO_Matter d "
                f'JOIN Matter m ON m.{NUMBER} = d."{END}" WHERE d."{START}" = Operator.{NUMBER} '
                f"AND m.\"_label\" = 'Food' AND d.{count} > 0 ORDER BY d.{count} DESC, m.name LIMIT 1)"
            )
        self.commit()


def _placed(owner: int, stages: Sequence[int], numbers: Iterable[int]) -> Iterator[tuple[int, int, int]]:
    return ((owner, stages[number], place) for place, number in enumerate(numbers))


def _ends(units: Rows, side: str) -> Iterator[tuple[str, str, int | None]]:
    """Yield the key of each unit with those of its objects on one ``side``, and how often these move."""
    return ((row["key"], key, moving) for row in units for key, moving in row[side])
