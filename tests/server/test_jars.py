import pytest

from foon_kg.store.server.jars import Jar, JarSet, pinned, sha256_of


def test_the_pinned_set_is_whole_neo4j_with_no_name_twice():
    jar_set = pinned()
    names = [jar.name for jar in jar_set.jars]
    assert len(names) == len(set(names))
    assert names[0] == f"neo4j-{jar_set.version}.jar"
    for artifact in ("neo4j-bolt", "neo4j-kernel", "neo4j-cypher"):
        assert f"{artifact}-{jar_set.version}.jar" in names
    assert all(jar.size > 0 and len(bytes.fromhex(jar.sha256)) == 32 for jar in jar_set.jars)


@pytest.mark.parametrize(
    ("coordinates", "path"),
    [
        ("org.neo4j:neo4j:2026.09.0", "org/neo4j/neo4j/2026.09.0/neo4j-2026.09.0.jar"),
        ("io.netty:epoll:4.2:linux-x86_64", "io/netty/epoll/4.2/epoll-4.2-linux-x86_64.jar"),
    ],
)
def test_a_jar_lies_where_the_maven_layout_puts_it(coordinates, path):
    assert Jar(coordinates, 1, "").path == path


def test_the_fingerprint_knows_content_and_order():
    one, two = Jar("g:a:1", 1, "aa"), Jar("g:b:1", 1, "bb")
    assert JarSet("1", (one, two)).fingerprint != JarSet("1", (two, one)).fingerprint
    assert JarSet("1", (one, two)).fingerprint != JarSet("1", (one, Jar("g:b:1", 1, "bc"))).fingerprint


def test_a_jar_of_the_right_size_and_other_content_is_damaged(tmp_path):
    (tmp_path / "a-1.jar").write_bytes(b"right")
    jar = Jar("g:a:1", 5, sha256_of(tmp_path / "a-1.jar"))
    jar_set = JarSet("1", (jar, Jar("g:b:1", 5, "")))
    assert jar_set.damaged(tmp_path) == ()
    (tmp_path / "a-1.jar").write_bytes(b"wrong")
    assert jar_set.damaged(tmp_path) == (jar,)
    assert jar_set.missing(tmp_path) == jar_set.jars[1:]
