"""The pinned jars of the local Neo4j: what they are, where they come from and where they are kept."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

CHUNK = 1 << 20


@dataclass(frozen=True, slots=True)
class Jar:
    """One file of the pinned set: Maven coordinates ``group:artifact:version[:classifier]``, size in bytes, SHA-256."""

    coordinates: str
    size: int
    sha256: str

    @property
    def name(self) -> str:
        """The file's name; unique within the set."""
        return self.path.rpartition("/")[2]

    @property
    def path(self) -> str:
        """The file's path below the root of any Maven repository (Maven's standard repository layout)."""
        group, artifact, version, *classifier = self.coordinates.split(":")
        name = "-".join([artifact, version, *classifier])
        return f"{group.replace('.', '/')}/{artifact}/{version}/{name}.jar"


@dataclass(frozen=True, slots=True)
class JarSet:
    """Every jar of one Neo4j version, in class path order."""

    version: str
    jars: tuple[Jar, ...]

    @property
    def size(self) -> int:
        """Bytes of all jars together."""
        return sum(jar.size for jar in self.jars)

    @property
    def fingerprint(self) -> str:
        """A short hash that changes with any jar or with their order."""
        return hashlib.sha256("".join(jar.sha256 for jar in self.jars).encode()).hexdigest()[:12]

    def missing(self, folder: Path) -> tuple[Jar, ...]:
        """Return the jars that are not in ``folder`` with their full size."""
        return tuple(jar for jar in self.jars if not _has_size(folder / jar.name, jar.size))

    def damaged(self, folder: Path) -> tuple[Jar, ...]:
        """Return the jars in ``folder`` whose content is not the pinned one: slower than ``missing``, and certain."""
        present = (jar for jar in self.jars if (folder / jar.name).exists())
        return tuple(jar for jar in present if sha256_of(folder / jar.name) != jar.sha256)

    def hashes(self) -> dict[str, str]:
        """Return the SHA-256 that each file has to have, by its name."""
        return {jar.name: jar.sha256 for jar in self.jars}

    def class_path(self, folder: Path) -> tuple[Path, ...]:
        """Return the files in ``folder`` in the order in which Java must see them."""
        return tuple(folder / jar.name for jar in self.jars)


@cache
def pinned() -> JarSet:
    """Return the set that this version of foon-kg runs (``jars.json``, written by ``pin.py``)."""
    return from_json(json.loads(resources.files(__package__).joinpath("jars.json").read_text(encoding="utf-8")))


def from_json(record: dict[str, Any]) -> JarSet:
    """Return the content of a ``jars.json``, read as ``record``."""
    return JarSet(record["version"], tuple(Jar(**jar) for jar in record["jars"]))


def sha256_of(file: Path) -> str:
    """Return the SHA-256 of a file's content in hexadecimal."""
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _has_size(file: Path, size: int) -> bool:
    try:
        return file.stat().st_size == size
    except FileNotFoundError:
        return False
