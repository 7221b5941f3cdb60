"""Makes ready what every process that plans needs, whatever its FOON: modules, tables of cooking, what foods are like.

It is imported by the one process of which all that plan are copies (:mod:`foon_kg.web.planning_process`). A dish of the
demo is planned for it. No answer becomes another by what is kept of that.
"""

from __future__ import annotations

from contextlib import closing, suppress
from itertools import islice

from foon_kg.foon import Foon
from foon_kg.foon.demo import demo_folder
from foon_kg.planning.processes import keep_for_good
from foon_kg.web.foon import Served
from foon_kg.web.planning import PlanningDesk

_DISHES = 8
"""So many dishes of the demo are planned: they load the modules and tables that plans need."""


def _plan_some() -> None:
    with (
        Foon.from_files(demo_folder()) as foon,
        closing(PlanningDesk(Served("demo", foon.snapshot()))) as desk,
    ):
        desk.get_ready()
        for _ in islice(desk.practise(), _DISHES):
            pass


# Whatever is wrong is told where it is needed. Here it would end the process of which all that plan are copies.
with suppress(Exception):
    _plan_some()
keep_for_good()
