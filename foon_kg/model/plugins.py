"""Plug-ins: what other installed packages add, found by their entry points, and imported only when it is asked for.

=====================  ===================  =================================================================
group                  the name is          the object is
=====================  ===================  =================================================================
``foon_kg.loaders``    a file's ending      ``(text, name of the video, path) -> foon_kg.loaders.ReadResult``
``foon_kg.exports``    a format             ``(foon_kg.formats.exports.tree.ExportedTree) -> str``
``foon_kg.similarity``  for ``--vectors``   ``(names) -> array of unit vectors, a row a name``
=====================  ===================  =================================================================
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import EntryPoint, entry_points
from typing import Any

from foon_kg.model.errors import UsageError

LOADERS, EXPORTS, SIMILARITY = "foon_kg.loaders", "foon_kg.exports", "foon_kg.similarity"

Plugin = Callable[..., Any]


def names(group: str) -> tuple[str, ...]:
    """Return what the plug-ins of a group are called, in their order."""
    return tuple(sorted({point.name for point in entry_points(group=group)}))


def plugin(group: str, name: str) -> Plugin | None:
    """Return the plug-in of an entry-point ``group`` that has this ``name``, imported; ``None`` where there is none.

    Raises UsageError where two packages bring it, or where it cannot be imported or called.
    """
    found = tuple(entry_points(group=group, name=name))
    if not found:
        return None
    if len(found) > 1:
        packages = " and ".join(sorted(map(_package, found)))
        raise UsageError(f"{packages} both bring “{name}” ({group})", hint="Uninstall one of them.", code="plugin")
    try:
        loaded = found[0].load()
    except Exception as error:  # it is another package's code, and may raise anything
        raise _unusable(found[0], f"it cannot be imported: {error!r}") from error
    if not callable(loaded):
        raise _unusable(found[0], f"{found[0].value} cannot be called")
    return _told_errors(found[0], loaded)


def _told_errors(point: EntryPoint, call: Plugin) -> Plugin:
    """Return ``call``, whose errors say which package's they are."""

    def called(*arguments: Any) -> Any:  # noqa: ANN401 - whatever the group says
        try:
            return call(*arguments)
        except Exception as error:  # as above
            raise _unusable(point, f"it failed: {error!r}") from error

    return called


def _unusable(point: EntryPoint, why: str) -> UsageError:
    hint = "Ask those who make it, or uninstall it."
    return UsageError(f"the plug-in “{point.name}” of {_package(point)}: {why}", hint=hint, code="plugin")


def _package(point: EntryPoint) -> str:
    return point.value.partition(":")[0] if point.dist is None else point.dist.name
