import neo4j
import pytest

from foon_kg.cypher import schema_parts

pytestmark = pytest.mark.neo4j


def _count(settings):
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        return driver.execute_query("MATCH (n) RETURN count(n) AS n", database_=settings.database).records[0]["n"]


def _schema(settings):
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        rows = [*driver.execute_query("SHOW CONSTRAINTS YIELD name").records, *driver.execute_query(INDEXES).records]
    return {row["name"] for row in rows}


INDEXES = "SHOW INDEXES YIELD name, type, owningConstraint WHERE type <> 'LOOKUP' AND owningConstraint IS NULL"


def _disturb(settings):
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        driver.execute_query("CREATE CONSTRAINT c FOR (n:Left) REQUIRE n.key IS UNIQUE")
        driver.execute_query("CREATE INDEX i FOR (n:Left) ON (n.name)")
        driver.execute_query("DROP INDEX object_label IF EXISTS")
        driver.execute_query("CREATE (:Left {key: 1})-[:AND]->(:Right)")


@pytest.mark.parametrize("round_", [1, 2])
def test_an_empty_graph_has_the_schema_alone_whatever_the_test_before_wrote(empty_graph, round_):
    assert _count(empty_graph) == 0
    assert _schema(empty_graph) == schema_parts().keys()
    _disturb(empty_graph)
    assert _count(empty_graph) == 2


@pytest.mark.parametrize("round_", [1, 2])
def test_a_bare_graph_has_nothing_whatever_the_test_before_wrote(bare_graph, round_):
    assert _count(bare_graph) == 0
    assert _schema(bare_graph) == set()
    _disturb(bare_graph)
    assert _count(bare_graph) == 2
