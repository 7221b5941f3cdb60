"""Every query of the catalogue tied to the Python type that receives its rows, and the one way to run them."""

from __future__ import annotations

import logging
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from neo4j import ManagedTransaction, Transaction

from foon_kg.cypher import named_query
from foon_kg.store.graph import method_rows, recipe_rows, rows

_log = logging.getLogger(__name__)

R = TypeVar("R", bound=rows.Row)
"""A kind of rows."""


@dataclass(frozen=True)
class Statement(Generic[R]):
    """A query by name; its columns are the fields of ``row``, in order."""

    name: str
    row: type[R]


SCHEMA_STATE = Statement("schema_state", rows.SchemaState)
AWAIT_INDEXES = Statement("await_indexes", rows.Nothing)
SCHEMA_RECORD = Statement("schema_record", rows.Nothing)
WRITING_TURN = Statement("writing_turn", rows.SchemaState)

COMPLETE_LISTS = Statement("complete_lists", rows.Nothing)
HOLDS_SOMETHING = Statement("holds_something", rows.SomethingRow)

UNITS_COUNT = Statement("units_count", rows.UnitsCountRow)
SIZE = Statement("size", rows.SizeRow)
NAMES_LIKE = Statement("names_like", rows.NamesLikeRow)
AROUND_LABEL = Statement("around_label", rows.AroundLabelRow)
VIDEO_NAMES = Statement("video_names", rows.NameRow)
SOME_VIDEOS = Statement("some_videos", rows.NameRow)
VIDEO_CONTENTS = Statement("video_contents", rows.ContentRow)
SUBGRAPHS = Statement("subgraphs", rows.SubgraphRow)
VOCABULARY = Statement("vocabulary", rows.VocabularyRow)
GOALS = Statement("goals", rows.GoalsRow)
FOOD_ROWS = Statement("food_rows", rows.FoodRowsRow)
WORDS_FOR = Statement("words_for", rows.WordsForRow)
LIKELY_GOALS = Statement("likely_goals", rows.LikelyGoalsRow)
BEHIND = Statement("behind", rows.BehindRow)
BEHIND_ONE = Statement("behind_one", rows.BehindRow)
REMEMBERED = Statement("remembered", rows.PlanRow)
REMEMBER = Statement("remember", rows.Nothing)
KNOWN_UNITS = Statement("known_units", rows.KnownUnitsRow)
EQUIVALENTS = Statement("equivalents", rows.EquivalentsRow)
NODES_CALLED = Statement("nodes_called", rows.NodesRow)
STATISTICS = Statement("statistics", rows.StatisticsRow)
MOTION_COSTS = Statement("motion_costs", rows.MotionCostsRow)

LOAD_VIDEOS = Statement("load_videos", rows.Nothing)
LOAD_OBJECTS = Statement("load_objects", rows.KeysRow)
LOAD_UNITS = Statement("load_units", rows.KeysRow)
LOAD_MOVEMENTS = Statement("load_movements", rows.Nothing)
LOAD_SIGHTINGS = Statement("load_sightings", rows.Nothing)
LOAD_GOALS = Statement("load_goals", rows.Nothing)
COUNT_FOODS = Statement("count_foods", rows.Nothing)
COUNT_MOTIONS = Statement("count_motions", rows.Nothing)
COUNT_VERBS = Statement("count_verbs", rows.Nothing)
COUNT_STATES = Statement("count_states", rows.Nothing)
RECOUNT_WORDS = Statement("recount_words", rows.Nothing)
LOAD_COSTS = Statement("load_costs", rows.VerbCostRow)
FOODS_WITHOUT_VECTOR = Statement("foods_without_vector", rows.NameRow)
FOODS_NEW = Statement("foods_new", rows.NameRow)
LOAD_VECTORS = Statement("load_vectors", rows.Nothing)

FORGET_SIGHTINGS = Statement("forget_sightings", rows.KeyRow)
FORGET_GOALS = Statement("forget_goals", rows.Nothing)
FORGET_VIDEOS = Statement("forget_videos", rows.Nothing)
FORGET_VECTORS = Statement("forget_vectors", rows.Nothing)
UNSUPPORTED_UNITS = Statement("unsupported_units", rows.UnitRow)
SWEEP_UNITS = Statement("sweep_units", rows.StatesRow)
SWEEP_WORDS = Statement("sweep_words", rows.Nothing)
CLEAR = Statement("clear", rows.Nothing)

METHODS = Statement("methods", method_rows.MethodsRow)
METHODS_COMMON = Statement("methods_common", method_rows.MethodsCommonRow)
METHODS_ASKED = Statement("methods_asked", method_rows.MethodsAskedRow)
FRAMES = Statement("frames", method_rows.FramesRow)
FRAMES_READ = Statement("frames_read", method_rows.FramesReadRow)
LOAD_MATTERS = Statement("load_matters", rows.Nothing)
LOAD_OPERATORS = Statement("load_operators", rows.Nothing)
ATTESTED = Statement("attested", method_rows.AttestedRow)
EVIDENCE = Statement("evidence", method_rows.EvidenceRow)
FIRST_SIGHTINGS = Statement("first_sightings", method_rows.FirstSightingsRow)
LOAD_EVIDENCE = Statement("load_evidence", rows.Nothing)
USUAL_FOODS = Statement("usual_foods", rows.Nothing)
COUNT_OPERATORS = Statement("count_operators", rows.Nothing)
SWEEP_OPERATORS = Statement("sweep_operators", rows.Nothing)
LOAD_FRAMES = Statement("load_frames", rows.Nothing)
FORGET_FRAMES = Statement("forget_frames", method_rows.TextRow)
COUNT_JOINS = Statement("count_joins", rows.Nothing)
FORGET_METHODS = Statement("forget_methods", rows.GoneRow)

UNITS_SHOWN = Statement("units_shown", rows.ShownRow)
LABELS_THERE = Statement("labels_there", rows.NameRow)

LOAD_DRAFTS = Statement("load_drafts", rows.Nothing)
DRAFT_CONTENTS = Statement("draft_contents", rows.ContentRow)
SURE_DRAFTS = Statement("surest_drafts", rows.DraftRow)
FORGET_DRAFTS = Statement("forget_drafts", rows.KeyRow)

LOAD_RECIPE_WORDS = Statement("load_recipe_words", rows.Nothing)
LOAD_RECIPES = Statement("load_recipes", rows.Nothing)
RECIPES_TURN = Statement("recipes_turn", recipe_rows.RecipesTurnRow)
RECIPES_HELD = Statement("recipes_held", recipe_rows.RecipeHeldRow)
ADD_RECIPE_COUNTS = Statement("add_recipe_counts", rows.Nothing)
RECIPE_CONTENTS = Statement("recipe_contents", recipe_rows.RecipeContentRow)
RECIPE = Statement("recipe", recipe_rows.RecipeRow)
RECIPE_PAGE = Statement("recipe_page", recipe_rows.RecipePageRow)
RECIPES_UNTIL = Statement("recipes_until", recipe_rows.RecipesUntilRow)
RECIPE_CLASSES = Statement("recipe_classes", recipe_rows.RecipeClassRow)
RECIPE_IDS = Statement("recipe_ids", recipe_rows.RecipeIdRow)
COUNT_RECIPES = Statement("count_recipes", recipe_rows.RecipeCountRow)
WANTED_FOODS = Statement("wanted_foods", recipe_rows.WantedFoodRow)


class Ask(Protocol):
    """Runs a statement in a transaction, or on what is staged for an import (:mod:`foon_kg.store.offline`)."""

    def __call__(self, statement: Statement[R], **parameters: object) -> list[R]:
        """Return its rows."""
        ...


def ask(transaction: Transaction | ManagedTransaction, statement: Statement[R], **parameters: object) -> list[R]:
    """Run ``statement`` in ``transaction``, in one round trip, and return its rows."""
    _log.debug("%s", statement.name)
    result = transaction.run(named_query(statement.name).text, parameters)
    return [statement.row(*record.values()) for record in result]
