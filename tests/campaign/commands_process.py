"""Commands, one after another as they are asked for on stdin: lines of JSON, each with the words of one.

Told on stdout: that it is ready, then of each command its exit code, what it printed, and the error that nobody caught.
"""

from __future__ import annotations

import json
import sys

import neo4j
from campaign.hasty_driver import hasty_driver
from typer.testing import CliRunner

from foon_kg.cli import app


def main() -> None:
    neo4j.GraphDatabase.driver = hasty_driver
    out = sys.stdout
    for line in iter(sys.stdin.readline, ""):
        words = json.loads(line)
        done = CliRunner().invoke(app, words)
        failed = done.exception if not isinstance(done.exception, SystemExit) else None
        told = [done.exit_code, done.stdout, done.stderr, repr(failed) if failed else ""]
        print(json.dumps(told), file=out, flush=True)


main()
