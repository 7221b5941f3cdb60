"""The driver's waits between two tries of a transaction, cut short: harm is done a thousand times in a campaign."""

from __future__ import annotations

from functools import partial

import neo4j

BETWEEN_TRIES = 0.02
"""Seconds before the second try, and twice as many before each other; else a whole one."""

hasty_driver = partial(neo4j.GraphDatabase.driver, initial_retry_delay=BETWEEN_TRIES)
"""Stands for ``neo4j.GraphDatabase.driver``."""
