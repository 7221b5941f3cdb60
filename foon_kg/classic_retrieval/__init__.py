"""Classic retrieval, for robots: from a goal and a kitchen to the task tree with the fewest units or greatest success.

:func:`retrieve_tree` answers it, exactly, at any of the three levels of a FOON (:mod:`foon_kg.levels`). After Paulius
et al., Functional object-oriented network for manipulation learning (IROS 2016), whose program enumerates paths
instead.
"""

from foon_kg.classic_retrieval.goal import Criterion, GoalSought, RetrievalView
from foon_kg.classic_retrieval.result import RetrievalResult, RetrievedUnit
from foon_kg.classic_retrieval.retrieval import retrieve_tree

__all__ = ["Criterion", "GoalSought", "RetrievalResult", "RetrievalView", "RetrievedUnit", "retrieve_tree"]
