"""A home for a real local server, apart from the one that the other tests share."""

from __future__ import annotations

import neo4j
import pytest

from foon_kg.store.server import stop
from foon_kg.store.server.home import Home


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    """A private home, named by the environment for this module; its server is not warmed up, and stopped at the end."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("foon_kg.store.server.lifecycle._warm", lambda _settings: None)
        root = tmp_path_factory.mktemp("home")
        patch.setenv("FOON_KG_HOME", str(root))
        yield Home(root.resolve())
        stop()


@pytest.fixture
def ask():
    """Run one query on the server of some settings and return its first value, or None."""

    def run(settings, query, **parameters):
        with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
            rows = driver.execute_query(query, parameters, database_=settings.database).records
        return rows[0][0] if rows else None

    return run
