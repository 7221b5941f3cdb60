"""Classic retrieval, for robots: from a goal and a kitchen to the task tree with the fewest units or greatest success.

:func:`retrieve_tree` answers it, exactly, at any of the three levels of a FOON (:mod:`foon_kg.model.levels`). After
Paulius et al., Functional object-oriented network for manipulation learning (IROS 2016), whose program enumerates paths
instead.
"""

from foon_kg.search.classic.goal import Criterion, GoalSought, RetrievalView
from foon_kg.search.classic.result import RetrievalResult, RetrievedUnit
from foon_kg.search.classic.retrieval import retrieve_tree

__all__ = ["Criterion", "GoalSought", "RetrievalResult", "RetrievalView", "RetrievedUnit", "retrieve_tree"]
