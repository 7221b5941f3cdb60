"""A command on a disk that does harm once: ``python writing_process.py FOLDER NUMBER HARM WORDS…``.

Tells as JSON how often files were changed, the exit code, what was printed and the error that nobody caught; a process
that is ended tells nothing.
"""

from __future__ import annotations

import json
import sys

from campaign.harmed_disk import Harm, HarmedDisk
from typer.testing import CliRunner

from foon_kg.cli import app


def on_a_harmed_disk(folder: str, number: str, harm: str, *words: str) -> dict[str, object]:
    """Return what the command did, in this process."""
    with HarmedDisk(folder, int(number), Harm(harm)).used() as disk:
        done = CliRunner().invoke(app, list(words))
    failed = done.exception if not isinstance(done.exception, SystemExit) else None
    return {"done": disk.done, "code": done.exit_code, "output": done.output, "failed": repr(failed) if failed else ""}


def main(*given: str) -> None:
    print(json.dumps(on_a_harmed_disk(*given)))


if __name__ == "__main__":
    main(*sys.argv[1:])
