"""Does harm to one write, fsync, rename or other change of a file in a folder, chosen by its number."""

from __future__ import annotations

import builtins
import errno
import io
import os
from contextlib import ExitStack, contextmanager
from enum import StrEnum
from pathlib import Path
from unittest import mock

KILLED = 86
"""The exit code of a process that is ended at an operation."""


class Harm(StrEnum):
    """What happens at an operation."""

    FAILS = "fails"
    """It raises an OSError; of a write half is there."""
    ENDS = "ends"
    """The process ends as with kill -9; of a write half is there."""


class HarmedDisk:
    """While it is used, counts what changes files below ``folder``; ``number`` is harmed. ``done`` names them all."""

    def __init__(self, folder, number=0, harm=Harm.FAILS):
        self.folder, self.number, self.harm = os.path.realpath(folder), number, harm
        self.done = []

    @contextmanager
    def used(self):
        """Put the counting operations in the place of those of the system."""
        with ExitStack() as stack:
            for name in ("fsync", "replace", "rename", "truncate", "ftruncate"):
                stack.enter_context(mock.patch.object(os, name, self._counting(name, getattr(os, name))))
            opened = self._opened(io.open)
            stack.enter_context(mock.patch.object(io, "open", opened))
            stack.enter_context(mock.patch.object(builtins, "open", opened))
            yield self

    def reach(self, name):
        """Count an operation; return whether it is to be harmed."""
        self.done.append(name)
        return len(self.done) == self.number

    def strike(self):
        """Do the harm."""
        if self.harm is Harm.ENDS:
            os._exit(KILLED)
        raise OSError(errno.EIO, os.strerror(errno.EIO))

    def is_here(self, file):
        """Whether a path, or the file of a descriptor, is below the folder."""
        place = f"/proc/self/fd/{file}" if isinstance(file, int) else file
        return os.path.realpath(os.fsdecode(place)).startswith(self.folder + os.sep)

    def _counting(self, name, real):
        def operation(file, *others, **options):
            if self.is_here(file) and self.reach(name):
                self.strike()
            return real(file, *others, **options)

        return operation

    def _opened(self, real):
        def opened(file, mode="r", buffering=-1, *others, **options):
            if not set(mode) & set("wxa+") or not self.is_here(file):
                return real(file, mode, buffering, *others, **options)
            raw = _Harmed(self, file, mode.replace("b", "").replace("t", ""), closefd=options.pop("closefd", True))
            if buffering == 0:
                return raw
            stream = io.BufferedRandom(raw) if "+" in mode else io.BufferedWriter(raw)
            return stream if "b" in mode else io.TextIOWrapper(stream, *others, **options)

        return opened


class _Harmed(io.FileIO):
    def __init__(self, disk, file, mode, **options):
        self._disk = disk
        super().__init__(os.fspath(file) if isinstance(file, Path) else file, mode, **options)

    def write(self, data):
        if self._disk.reach("write"):
            super().write(memoryview(data).cast("B")[: len(data) // 2])
            self._disk.strike()
        return super().write(data)

    def truncate(self, size=None):
        if self._disk.reach("truncate"):
            self._disk.strike()
        return super().truncate(size)
