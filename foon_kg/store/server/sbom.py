"""Adds the jars of the local Neo4j to a bill of materials: ``python -m foon_kg.store.server.sbom BOM.json``.

``make sbom`` runs it on what cyclonedx-bom says of the pinned Python packages (CycloneDX, JSON), and checks the result.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from foon_kg.store.server.jars import Jar, pinned


def with_jars(bom: dict[str, Any], jars: Sequence[Jar]) -> dict[str, Any]:
    """Return ``bom`` with a component for each of ``jars``, on which what the bom is of depends."""
    root = bom["metadata"]["component"]["bom-ref"]
    components = [_component(jar) for jar in jars]
    refs = [component["bom-ref"] for component in (*bom["components"], *components)]
    others = [one for one in bom.get("dependencies", ()) if one["ref"] != root]
    return {
        **bom,
        "components": [*bom["components"], *components],
        "dependencies": [
            {"ref": root, "dependsOn": refs},
            *others,
            *({"ref": component["bom-ref"]} for component in components),
        ],
    }


def _component(jar: Jar) -> dict[str, Any]:
    group, name, version, *classifier = jar.coordinates.split(":")
    kind = f"?classifier={quote(classifier[0])}&type=jar" if classifier else "?type=jar"
    purl = f"pkg:maven/{quote(group)}/{quote(name)}@{quote(version)}{kind}"
    return {
        "type": "library",
        "bom-ref": purl,
        "group": group,
        "name": name,
        "version": version,
        "purl": purl,
        "hashes": [{"alg": "SHA-256", "content": jar.sha256}],
    }


def main(file: Path) -> None:
    """Add the pinned jars to ``file``."""
    bom = with_jars(json.loads(file.read_text(encoding="utf-8")), pinned().jars)
    file.write_text(json.dumps(bom, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
