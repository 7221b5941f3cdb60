"""The graph that ``foon load foon`` writes, as tables: one for each label and each type of relationship.

This is what is staged for an offline import (:mod:`foon_kg.store.offline.staged`), and what the CSV files are made of,
its own and those of ``foon export --format csv``.
``docs/reference/schema.md`` says what each of them means.
"""

from __future__ import annotations

from dataclasses import dataclass

LIST_DELIMITER = "\x1f"
"""Joins lists; no name holds it."""

NUMBER, START, END = "_id", "_start", "_end"

RECIPES = "recipes:long"
"""The column of how many recipes there are of a dish type, or with a food."""

FORMAT = (f"--array-delimiter=U+{ord(LIST_DELIMITER):04X}", "--multiline-fields=true")
"""The arguments by which the import reads files that are written so."""


@dataclass(frozen=True)
class Nodes:
    """The nodes of one label. The first of ``columns`` (``name:kind``, as the import has them) tells them apart.

    Where ``labelled``, a column says which label each has besides. ``unique`` is ``False`` where nothing tells two
    apart.
    """

    label: str
    columns: tuple[str, ...]
    labelled: bool = False
    unique: bool = True

    @property
    def name(self) -> str:
        """What its table and file are called."""
        return self.label

    @property
    def ids(self) -> tuple[str, ...]:
        """The header of the column by which its nodes are named."""
        return (f":ID({self.label})",)


@dataclass(frozen=True)
class Edges:
    """The relationships of one type between two labels; ``unique`` are the columns that tell them apart, if any do."""

    type: str
    start: str
    end: str
    columns: tuple[str, ...] = ()
    unique: tuple[str, ...] = (START, END)

    @property
    def name(self) -> str:
        """What its table and file are called."""
        return f"{self.start}_{self.type}_{self.end}"

    @property
    def ids(self) -> tuple[str, ...]:
        """The headers of the columns that name the two ends."""
        return (f":START_ID({self.start})", f":END_ID({self.end})")


_SIDE = ("{}:long[]", "{}_moving:boolean[]", "{}_dish:string[]")
_EVIDENCE = ("units:long", "changed:long", "seen:string[]", "changes:string[]")

NODES = (
    Nodes("Video", ("name:string", "content:string", "sources:string[]")),
    Nodes("Label", ("name:string",)),
    Nodes(
        "Object",
        ("key:string", "label:string", "states:string[]", "ingredients:string[]", "relation:string",
         "container:string", "start:boolean", "utensil:boolean"),
    ),
    Nodes("Motion", ("key:string", "verb:string", "accepts_any:boolean")),
    Nodes("DishType", ("name:string", RECIPES)),
    Nodes("Ingredient", ("name:string", "canonical:string", "singular:string", "vector:double[]", RECIPES)),
    Nodes("State", ("name:string",)),
    Nodes("Verb", ("name:string", "units:long", "several:long")),
    Nodes("Operator", ("key:string", "motion:string", "tools:string[]", "count:long", "most_done:string",
                       "most_changed:string")),
    Nodes("Matter", ("name:string", "kind:string", "canonical:string", "vector:double[]"), labelled=True),
    Nodes("Utensil", ("name:string",)),
    Nodes("StageType", ("name:string", "work:string", "heated:string", "joins:boolean")),
    Nodes(
        "Frame",
        ("key:string", "dish_type:string", "label:string", "foods:string[]", "kinds:string[]", "outline:string",
         "weak:string[]", "text:string"),
    ),
    Nodes(
        "Stage",
        ("motion:string", "does:string[]", "tools:string[]", "vessel:string", "relation:string", "appliance:string",
         "source:string", "label:string", "states:string[]", "step:long"),
        unique=False,
    ),
    Nodes("Line", (), unique=False),
    Nodes(
        "Slot",
        ("food:string", "kind:string", "states:string[]", "cooked:string[]", "motion:string", "tools:string[]",
         "source:string"),
        unique=False,
    ),
    Nodes("Recipe", ("id:string", "title:string", "content:string", "source:string", "partition:string", "url:string",
                     "left_over:string[]")),
)  # fmt: skip

FOON_EDGES = (
    Edges("CALLED", "Object", "Label"),
    Edges("INPUT_OF", "Object", "Motion", ("moving:long",), unique=(END, START)),
    Edges("OUTPUTS", "Motion", "Object", ("moving:long",)),
    Edges("NEXT", "Motion", "Motion", ("video:string", "position:long"), unique=()),
    Edges(
        "SEEN_IN",
        "Motion",
        "Video",
        (
            "position:long", "start:double", "end:double", "assumed:boolean",
            "span_starts:double[]", "span_ends:double[]",
            *(column.format(side) for side in ("inputs", "outputs") for column in _SIDE),
            "amounts:string[]", "seconds:double", "celsius:double",
        ),
        unique=(),
    ),
    Edges("IS_A", "Object", "DishType", ("video:string",), unique=(START, END, "video")),
    Edges("MADE_OF", "Object", "Ingredient"),
    Edges("SEEN_AS", "Ingredient", "State", ("made:long", "used:long")),
    Edges("MADE_BY", "State", "Verb", ("count:long",)),
    Edges("ATTESTED_BY", "Operator", "Motion", ("done_to:string[]", "changes:string[]"), unique=(END,)),
    Edges("DONE_TO", "Operator", "Matter", _EVIDENCE),
    Edges("GIVES", "Operator", "State", ("count:long",)),
    Edges("BRINGS", "Operator", "Matter", ("out_of:string", "count:long"), unique=(START, END, "out_of")),
    Edges("DONE_IN", "Operator", "Utensil", ("count:long",)),
    Edges("FOUND_AS", "Matter", "State", ("count:long",)),
    Edges("JOINS_AT", "Matter", "StageType", ("dish_type:string", "count:long"), unique=(START, END, "dish_type")),
    Edges("JOINS_BESIDE", "Matter", "Matter", ("count:long",)),
    Edges("COOKED_BY", "Matter", "Verb", ("count:long",)),
    Edges("OF", "Frame", "Object"),
    Edges("DERIVED_FROM", "Frame", "Video"),
    Edges("HAS_STAGE", "Frame", "Stage", ("place:long",), unique=()),
    Edges("HAS_STAGE", "Line", "Stage", ("place:long",), unique=()),
    Edges("JOINED_BY", "Stage", "Line", ("place:long",), unique=()),
    Edges("HAS_SLOT", "Stage", "Slot", ("place:long",), unique=()),
    Edges("TAKES", "Slot", "Matter", unique=()),
)  # fmt: skip
"""Without ``LABEL_OF``, which leads from every label to the record of the FOON."""

RECIPE_EDGES = (
    Edges("CALLS_FOR", "Recipe", "Ingredient", ("position:long", "state:string", "text:string", "quantity:string",
                                                "unit:string"), unique=()),
    Edges("KIND_OF", "Recipe", "DishType", ("sure:boolean",), unique=()),
    Edges("USED_IN", "Ingredient", "DishType", ("count:long",)),
    Edges("ASKED_AS", "Ingredient", "State", ("count:long",)),
)  # fmt: skip
"""Recipes, and what is counted of them (``foon_kg.store.graph.recipe_counts``)."""

EDGES = (*FOON_EDGES, *RECIPE_EDGES)


def named(column: str) -> str:
    """Return the name of a column."""
    return column.partition(":")[0]


def kind_of(column: str) -> str:
    """Return the type of a column, as the import calls it."""
    return column.partition(":")[2]
