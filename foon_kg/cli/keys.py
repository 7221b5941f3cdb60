"""Single keys from a terminal: none is lost that is pressed before it is asked for, none is taken for another."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import typer

_AT_ONCE = 64
"""Bytes that are read at a time: a key may be a sequence of several, and some may have been pressed before."""
_SEQUENCE = re.compile(r"\x1b(?:\[[0-9;?]*[@-~]|O.|.)?")
"""What arrows and other keys without a letter send."""


@dataclass
class Keys:
    """Reads keys while it is :meth:`open`; inside of :meth:`closed` the terminal takes lines, as it did before."""

    waiting: list[str] = field(default_factory=list)
    modes: tuple[list[Any], list[Any]] | None = None
    """How the terminal takes lines, and how it takes keys."""

    @contextmanager
    def open(self) -> Iterator[None]:
        """Have the terminal hand over each key at once, without showing it."""
        try:
            import termios
            import tty
        except ImportError:  # no such terminals: keys are read one by one
            yield
            return
        handle = sys.stdin.fileno()
        before = termios.tcgetattr(handle)
        tty.setcbreak(handle, termios.TCSADRAIN)
        self.modes = (before, termios.tcgetattr(handle))
        try:
            yield
        finally:
            termios.tcsetattr(handle, termios.TCSADRAIN, before)

    @contextmanager
    def closed(self) -> Iterator[None]:
        """Have the terminal take lines."""
        if self.modes is None:
            yield
            return
        import termios

        lines, keys = self.modes
        termios.tcsetattr(sys.stdin.fileno(), termios.TCSADRAIN, lines)
        try:
            yield
        finally:
            termios.tcsetattr(sys.stdin.fileno(), termios.TCSADRAIN, keys)

    def next(self) -> str:
        """Return the next key; what arrows and the like send is none. Raises EOFError where nobody is there."""
        if self.modes is None:
            return typer.getchar()
        while not self.waiting:
            data = os.read(sys.stdin.fileno(), _AT_ONCE)
            if not data:
                raise EOFError
            self.waiting += _SEQUENCE.sub("", data.decode(errors="ignore"))
        return self.waiting.pop(0)
