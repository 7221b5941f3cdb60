"""One launch of Neo4j on one home: configuration, password, process, first answer."""

from __future__ import annotations

import signal
import subprocess
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from foon_kg.model.kept import write_private
from foon_kg.store.disk import explain_os_error
from foon_kg.store.server import process as processes
from foon_kg.store.server.configuration import new_password, write_configuration
from foon_kg.store.server.home import Home
from foon_kg.store.server.jars import JarSet
from foon_kg.store.server.java import MAIN_CLASS, run_admin, write_arguments
from foon_kg.store.server.reach import password_of, settings_of
from foon_kg.store.settings import ConnectionSettings


@contextmanager
def launched(
    place: Home, port: int, jar_set: JarSet, folder: Path, flags: Sequence[str]
) -> Iterator[tuple[subprocess.Popen[bytes], ConnectionSettings]]:
    """Configure the home ``place`` and start Neo4j on it from the jars in ``folder``; it does not answer yet.

    It listens on ``port``; ``jar_set`` says what its jars are, ``flags`` are Java's. The process is ended if the block
    raises, Ctrl-C included: no half-started server stays.
    """
    class_path = jar_set.class_path(folder)
    write_configuration(place, port)
    set_password(place, class_path)
    settings = settings_of(place, port)
    main = (MAIN_CLASS, f"--home-dir={place.root}", f"--config-dir={place.configuration}")
    with explain_os_error(f"cannot write {place.arguments}"):
        command = write_arguments(place.arguments, class_path, flags, main)
    with _interrupts_held() as let_go:
        child = processes.spawn(command, place.console_log, place.root)
        try:
            let_go()
            yield child, settings
        except BaseException:
            child.kill()
            child.wait()
            raise


@contextmanager
def _interrupts_held() -> Iterator[Callable[[], None]]:
    """Hold Ctrl-C back until the block lets go: one that came while a process starts would leave it to nobody."""
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or before is None:
        yield lambda: None  # Python raises nothing here
        return
    held: list[int] = []

    def let_go() -> None:
        signal.signal(signal.SIGINT, before)
        if held:
            signal.raise_signal(held.pop())

    signal.signal(signal.SIGINT, lambda number, _frame: held.append(number))
    try:
        yield let_go
    finally:
        signal.signal(signal.SIGINT, before)


def set_password(place: Home, class_path: Sequence[Path]) -> None:
    """Give the home ``place``, if it was never started, its random password; Neo4j accepts it only then.

    ``class_path`` are the jars of the program that sets it.
    """
    if place.databases.exists():
        return
    with explain_os_error(f"cannot write {place.password_file}"):
        if not place.password_file.exists():
            write_private(place.password_file, new_password())
    arguments = place.arguments.with_name("admin.args")
    run_admin(arguments, class_path, place.root, ("dbms", "set-initial-password", password_of(place)))
