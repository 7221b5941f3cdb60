import pytest

from foon_kg.store.server import ConnectionSettings, connection_from_environment, connection_settings

VARIABLES = ("NEO4J_URI", "NEO4J_USER", "NEO4J_PASSWORD", "NEO4J_DATABASE")


@pytest.fixture(autouse=True)
def no_neo4j_named(monkeypatch):
    for name in VARIABLES:
        monkeypatch.delenv(name, raising=False)


def test_no_uri_names_no_database(monkeypatch):
    monkeypatch.setenv("NEO4J_PASSWORD", "left over")
    assert connection_from_environment() is None
    monkeypatch.setenv("NEO4J_URI", "")
    assert connection_from_environment() is None


def test_a_uri_alone_means_the_usual_user_and_database(monkeypatch):
    monkeypatch.setenv("NEO4J_URI", "neo4j://example:7687")
    assert connection_from_environment() == ConnectionSettings("neo4j://example:7687", "neo4j", "", "neo4j")


def test_everything_that_is_named_is_used_and_no_local_server_is_started(monkeypatch, tmp_path):
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "home"))
    for name, value in zip(VARIABLES, ("bolt://there:1", "cook", "pepper", "kitchen"), strict=True):
        monkeypatch.setenv(name, value)
    assert connection_settings() == ConnectionSettings("bolt://there:1", "cook", "pepper", "kitchen")
    assert not (tmp_path / "home").exists()


def test_a_password_is_not_in_what_is_printed_of_settings():
    assert "pepper" not in repr(ConnectionSettings("bolt://there:1", "cook", "pepper"))
