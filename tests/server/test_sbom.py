"""The bill of materials names every jar of the local Neo4j with the hash by which it is fetched."""

from __future__ import annotations

import json

from foon_kg.store.server.jars import Jar, pinned
from foon_kg.store.server.sbom import main, with_jars

BOM = {
    "bomFormat": "CycloneDX",
    "specVersion": "1.6",
    "metadata": {"component": {"bom-ref": "root-component", "name": "foon-kg", "type": "application"}},
    "components": [{"bom-ref": "requirements-L1", "name": "neo4j", "type": "library"}],
    "dependencies": [{"ref": "requirements-L1"}, {"ref": "root-component"}],
}


def test_every_pinned_jar_is_a_component_with_its_hash(tmp_path):
    file = tmp_path / "bom.json"
    file.write_text(json.dumps(BOM))
    main(file)
    told = json.loads(file.read_text())
    packages, *jars = told["components"]
    assert packages == BOM["components"][0]
    assert [one["hashes"] for one in jars] == [[{"alg": "SHA-256", "content": jar.sha256}] for jar in pinned().jars]
    assert len({one["bom-ref"] for one in told["components"]}) == len(told["components"])


def test_what_it_is_of_depends_on_all_and_each_part_is_told_once():
    told = with_jars(BOM, [Jar("io.netty:netty:4.2+x:linux", 1, "0" * 64)])
    netty = "pkg:maven/io.netty/netty@4.2%2Bx?classifier=linux&type=jar"
    assert told["dependencies"] == [
        {"ref": "root-component", "dependsOn": ["requirements-L1", netty]},
        {"ref": "requirements-L1"},
        {"ref": netty},
    ]
    assert told["components"][1]["purl"] == netty
