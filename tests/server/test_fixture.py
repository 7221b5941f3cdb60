import neo4j
import pytest

pytestmark = pytest.mark.neo4j


def _count(settings):
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        return driver.execute_query("MATCH (n) RETURN count(n) AS n", database_=settings.database).records[0]["n"]


@pytest.mark.parametrize("round_", [1, 2])
def test_an_empty_graph_is_empty_whatever_the_test_before_wrote(empty_graph, round_):
    assert _count(empty_graph) == 0
    with neo4j.GraphDatabase.driver(empty_graph.uri, auth=(empty_graph.user, empty_graph.password)) as driver:
        driver.execute_query("CREATE CONSTRAINT c FOR (n:Left) REQUIRE n.key IS UNIQUE")
        driver.execute_query("CREATE (:Left {key: $round})", round=round_)
    assert _count(empty_graph) == 1
