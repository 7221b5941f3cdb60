"""Algorithm 3: the best reference task tree of a goal, proven.

:func:`retrieve` is the everyday search, :func:`enumerate_paths` the definition that it is measured against.
"""

from foon_kg.search.enumeration import Enumeration, enumerate_paths, with_gaps_of
from foon_kg.search.ground import Explored
from foon_kg.search.problem import Bound, NoWayError, ReferenceTree, SearchProblem
from foon_kg.search.recall import retrieve_once
from foon_kg.search.retrieve import retrieve
from foon_kg.search.schedule import schedule
from foon_kg.search.unit_index import UnitIndex

__all__ = [
    "Bound",
    "Enumeration",
    "Explored",
    "NoWayError",
    "ReferenceTree",
    "SearchProblem",
    "UnitIndex",
    "enumerate_paths",
    "retrieve",
    "retrieve_once",
    "schedule",
    "with_gaps_of",
]
