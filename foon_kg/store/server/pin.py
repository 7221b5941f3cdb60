"""Write ``jars.json`` anew: ``python -m foon_kg.store.server.pin 2026.09.0``.

Run by a maintainer when Neo4j's version changes. jgo's resolver walks the dependencies (minutes: one description after
another), every jar is fetched once, and coordinates, sizes and SHA-256 are written down in class path order.
"""

from __future__ import annotations

import json
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from foon_kg.store.server.fetch import THREADS, repositories
from foon_kg.store.server.jars import Jar, sha256_of

TARGET = Path(__file__).with_name("jars.json")


def resolve(version: str) -> list[str]:
    """Return the coordinates of Neo4j ``version`` and all it needs at run time, in class path order."""
    import jgo  # noqa: PLC0415 - part of the optional [server] extra

    artifacts = jgo.resolve(f"org.neo4j:neo4j:{version}")
    if strange := [str(artifact) for artifact in artifacts if artifact.packaging != "jar"]:
        sys.exit(f"not jars: {strange}")
    parts = [(item.groupId, item.artifactId, item.version, item.classifier) for item in artifacts]
    return [":".join(part for part in coordinates if part) for coordinates in parts]


def measure(coordinates: str, folder: Path) -> Jar:
    """Return the jar of these ``coordinates``, fetched into ``folder``, with its size and SHA-256."""
    import requests  # noqa: PLC0415 - part of the optional [server] extra

    unknown = Jar(coordinates, size=0, sha256="")
    answer = requests.get(f"{repositories()[0]}/{unknown.path}", timeout=60)
    answer.raise_for_status()
    file = folder / unknown.name
    file.write_bytes(answer.content)
    return Jar(coordinates, size=len(answer.content), sha256=sha256_of(file))


def main(version: str) -> None:
    """Resolve, measure and write the jars of Neo4j ``version``."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(THREADS) as pool:
        jars = list(pool.map(lambda coordinates: measure(coordinates, Path(folder)), resolve(version)))
    rows = [{"coordinates": jar.coordinates, "size": jar.size, "sha256": jar.sha256} for jar in jars]
    lines = ",\n".join(f"  {json.dumps(row)}" for row in rows)
    TARGET.write_text(f'{{"version": {json.dumps(version)}, "jars": [\n{lines}\n]}}\n', encoding="utf-8")
    print(f"{len(jars)} jars, {sum(jar.size for jar in jars) / 1e6:.0f} MB -> {TARGET.name}")


if __name__ == "__main__":
    main(sys.argv[1])
