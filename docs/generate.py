"""Write docs/reference/commands.md from the commands themselves, so that it says what they say.

python docs/generate.py          # writes the file
python docs/generate.py --check  # exits with 1 where the file says something else
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import typer

from foon_kg.cli import app

TARGET = Path(__file__).parent / "reference" / "commands.md"
HEAD = """# Commands

Every command as it describes itself; `foon COMMAND --help` says the same. Exit codes: 0 done, 1 failed, 2 wrong usage,
3 no tree. This page is written by `python docs/generate.py`.
"""


def described(command: Any, path: tuple[str, ...]) -> Iterator[str]:  # noqa: ANN401 - typer has a click of its own
    """Yield the lines of a command and of those below it."""
    below = getattr(command, "commands", None)
    if below is not None:
        for name, one in below.items():
            yield from described(one, (*path, name))
        return
    context = command.context_class(command, info_name=" ".join(path))
    yield from ("", f"## {' '.join(path)}", "")
    yield from ("```text", command.get_usage(context).removeprefix("Usage: "), "```", "")
    yield " ".join(line.strip() for line in (command.help or "").split("\n\n")[0].split("\n"))
    for paragraph in (command.help or "").split("\n\n")[1:]:
        yield from ("", " ".join(line.strip() for line in paragraph.replace("\b", "").split("\n")))
    rows = [row for option in command.params if (row := option.get_help_record(context)) is not None]
    if rows:
        yield from ("", "| option | what it does |", "|---|---|")
        for names, text in rows:
            yield f"| `{names.replace('|', chr(92) + '|')}` | {' '.join(text.split()).replace('|', chr(92) + '|')} |"
    examples = [line.strip() for line in (command.epilog or "").replace("\b", "").splitlines() if "foon " in line]
    if examples:
        yield from ("", "```sh", *examples, "```")


def document() -> str:
    """Return the whole page."""
    return HEAD + "\n".join(described(typer.main.get_command(app), ("foon",))) + "\n"


def main() -> int:
    """Write the page, or compare it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    if parser.parse_args().check:
        same = TARGET.read_text(encoding="utf-8") == document()
        print("docs/reference/commands.md is " + ("as it should be" if same else "old: run python docs/generate.py"))
        return 0 if same else 1
    TARGET.write_text(document(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
