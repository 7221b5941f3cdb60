"""Makes ready what every process that reads recipe lines needs: the parser with its model, and the tables of foods.

It is imported by the one process of which all that read lines are copies (:mod:`foon_kg.language.recipe_lines`).
"""

from __future__ import annotations

import gc
from contextlib import suppress

from foon_kg.language.recipe_lines import read_fully

# Whatever is wrong is told where it is needed. Here it would end the process of which all that read are copies.
with suppress(Exception):
    read_fully("2 x, y (z)")
gc.collect()
gc.freeze()  # all of it stays, and a look through it for unreachable cycles would have each copy keep its own
