"""Every command that reads or writes a file, given a special one: what each told and how it ended, as lines of JSON.

``python reading_commands.py FOLDER``: the folder has the special file under each ending that a command asks for.
"""

from __future__ import annotations

import json
import resource
import sys
from pathlib import Path

from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes

MEMORY = 6_000_000_000
FILES = ("--files", str(demo_folder()))
RECIPE = str(demo_recipes()[0])
SUBGRAPH = str(min(demo_folder().glob("*.txt")))

READS = {
    ("check", "trees"): ("check", "@.json", *FILES),
    ("check", "--recipe"): ("check", "PLAN", "--recipe", "@.json", *FILES),
    ("check", "--kitchen"): ("check", "PLAN", "--kitchen", "@.txt", *FILES),
    ("check", "--files"): ("check", "PLAN", "--files", "@.txt"),
    ("diff", "paths"): ("diff", "@.txt", *FILES),
    ("diff", "--files"): ("diff", SUBGRAPH, "--files", "@.json"),
    ("draft accept", "paths"): ("draft", "accept", "@.csv"),
    ("draft review", "paths"): ("draft", "review", "@.csv", *FILES),
    ("draft review", "--files"): ("draft", "review", "DRAFT", "--files", "@.txt"),
    ("draft recipes", "paths"): ("draft", "recipes", "@.json", *FILES, "--output", "DRAFTED"),
    ("draft recipes", "--files"): ("draft", "recipes", "COLLECTION", "--files", "@.txt", "--output", "DRAFTED"),
    ("draft review", "paths: recipes"): ("draft", "review", "@.jsonl", "--recipe", "r1"),
    ("draft text", "paths"): ("draft", "text", "@.txt", *FILES, "--output", "OUT"),
    ("draft text", "--files"): ("draft", "text", "TEXT", "--files", "@.txt", "--output", "OUT"),
    ("draft videos", "paths"): ("draft", "videos", "@.csv", *FILES, "--output", "OUT"),
    ("draft videos", "--files"): ("draft", "videos", "NARRATED", "--files", "@.txt", "--output", "OUT"),
    ("evaluate leave-one-out", "-o"): ("evaluate", "leave-one-out", *FILES, "--sample", "1", "-o", "@.jsonl"),
    ("evaluate leave-one-out", "--compare"): ("evaluate", "leave-one-out", *FILES, "--compare", "@.json"),
    ("evaluate leave-one-out", "--files"): ("evaluate", "leave-one-out", "--files", "@.txt"),
    ("evaluate recipes", "paths"): ("evaluate", "recipes", "@.json", *FILES),
    ("evaluate recipes", "-o"): ("evaluate", "recipes", RECIPE, *FILES, "-o", "@.jsonl"),
    ("evaluate recipes", "--scores"): ("evaluate", "recipes", RECIPE, *FILES, "--scores", "@.csv"),
    ("evaluate recipes", "--compare"): ("evaluate", "recipes", RECIPE, *FILES, "--compare", "@.json"),
    ("evaluate recipes", "--files"): ("evaluate", "recipes", RECIPE, "--files", "@.txt"),
    ("evaluate trees", "paths"): ("evaluate", "trees", "@.json", *FILES),
    ("evaluate trees", "--files"): ("evaluate", "trees", "PLAN", "--files", "@.txt"),
    ("export", "tree"): ("export", "@.json", "--format", "dot"),
    ("export", "--kitchen"): ("export", "--format", "pddl", "--goal", "salad", "--kitchen", "@.txt", *FILES),
    ("export", "--recipe"): ("export", "PLAN", "--format", "markdown", "--recipe", "@.json"),
    ("export", "--weights"): ("export", "PLAN", "--format", "graphml", "--weights", "@.json"),
    ("export", "--files"): ("export", "--format", "dot", "--files", "@.txt"),
    ("load drafts", "paths"): ("load", "drafts", "@.jsonl", "--dry-run"),
    ("load drafts", "paths: gzip"): ("load", "drafts", "@.jsonl.gz", "--dry-run"),
    ("load foon", "paths"): ("load", "foon", "@.txt", "--dry-run"),
    ("load foon", "--recipes"): ("load", "foon", SUBGRAPH, "--offline", "--recipes", "@.jsonl"),
    ("load muhai", "paths"): ("load", "muhai", "@.lisp", "--dry-run"),
    ("load recipes", "paths"): ("load", "recipes", "@.jsonl", "--dry-run"),
    ("load recipes", "paths: a list"): ("load", "recipes", "@.json", "--dry-run"),
    ("load recipes", "paths: a table"): ("load", "recipes", "@.csv", "--dry-run"),
    ("load recipes", "paths: Parquet"): ("load", "recipes", "@.parquet", "--dry-run"),
    ("load foon", "paths: JSON"): ("load", "foon", "@.json", "--dry-run"),
    ("draft videos", "paths: JSON"): ("draft", "videos", "@.json", *FILES, "--output", "OUT"),
    ("load videos", "paths"): ("load", "videos", "@.csv", "--dry-run"),
    ("load weights", "file"): ("load", "weights", "@.json"),
    ("mcp", "--files"): ("mcp", "--files", "@.txt"),
    ("plan", "wanted: a file"): ("plan", "@.json", *FILES),
    ("plan", "--kitchen"): ("plan", RECIPE, "--kitchen", "@.txt", *FILES),
    ("plan", "-o"): ("plan", RECIPE, *FILES, "-o", "@.jsonl"),
    ("plan", "--files"): ("plan", RECIPE, "--files", "@.txt"),
    ("retrieve", "--weights"): ("retrieve", "salad", "--weights", "@.json", *FILES),
    ("retrieve", "--kitchen"): ("retrieve", "salad", "--kitchen", "@.txt", *FILES),
    ("retrieve", "--files"): ("retrieve", "salad", "--files", "@.txt"),
    ("serve", "--token-file"): ("serve", *FILES, "--token-file", "@.txt", "--port", "0"),
    ("serve", "--files"): ("serve", "--files", "@.txt", "--port", "0"),
    ("show", "result"): ("show", "@.json"),
    ("show", "--files"): ("show", "PLAN", "--schedule", "--files", "@.txt"),
    ("similar", "--files"): ("similar", "caper", "--files", "@.txt"),
    ("stats", "--files"): ("stats", "--files", "@.txt"),
    ("suggest", "--kitchen"): ("suggest", "onion", "--kitchen", "@.txt", *FILES),
    ("suggest", "--files"): ("suggest", "onion", "--files", "@.txt"),
    ("draft recipes", "-o"): ("draft", "recipes", "COLLECTION", *FILES, "--output", "@.jsonl"),
}
"""By command and option: ``@.txt`` is the special file; words in capitals are good ones beside it (:data:`GOOD`).

What would begin a file anew comes last.
"""

WRITES = {
    ("draft text", "-o"): ("draft", "text", "TEXT", *FILES, "--output", "@"),
    ("draft videos", "-o"): ("draft", "videos", "NARRATED", *FILES, "--output", "@"),
    ("evaluate leave-one-out", "--html"): ("evaluate", "leave-one-out", *FILES, "--sample", "1", "--html", "@.html"),
    ("evaluate recipes", "--html"): ("evaluate", "recipes", RECIPE, *FILES, "--html", "@.html"),
    ("evaluate recipes", "--scores-to"): ("evaluate", "recipes", RECIPE, *FILES, "--scores-to", "@.csv"),
    ("export", "-o"): ("export", "PLAN", "--format", "dot", "-o", "@.dot"),
    ("load foon", "--report"): ("load", "foon", SUBGRAPH, "--dry-run", "--report", "@.jsonl"),
    ("load muhai", "--report"): (
        "load",
        "muhai",
        "NETWORK",
        "--dry-run",
        "--bad-tolerance",
        "1",
        "--report",
        "@.jsonl",
    ),
    ("load recipes", "--report"): ("load", "recipes", "COLLECTION", "--dry-run", "--report", "@.jsonl"),
    ("load videos", "--report"): ("load", "videos", "TABLE", "--dry-run", "--report", "@.jsonl"),
    ("show", "-o"): ("show", "PLAN", "--format", "json", "-o", "@.json"),
}
"""The same of what is only written."""

AT_A_TERMINAL = {("draft review", "-o")}
"""What is written after questions to a person, as all the rest is: by write_file."""


def main(folder: Path) -> None:
    """Run every command; a file that is read into memory without end ends in a MemoryError."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    beside = {name: str(folder / "good" / file) for name, file in GOOD.items()}
    for key, words in (*READS.items(), *WRITES.items()):
        special = str(folder / f"special{words[_place(words)].removeprefix('@')}")
        given = [special if word.startswith("@") else beside.get(word, word) for word in words]
        done = CliRunner().invoke(app, given)
        failed = done.exception if not isinstance(done.exception, SystemExit) else None
        told = {
            "what": key,
            "path": special,
            "code": done.exit_code,
            "output": done.output[-2000:],
            "failed": repr(failed),
            "writes": words in WRITES.values(),
        }
        print(json.dumps(told), flush=True)


GOOD = {
    "PLAN": "plan.json",
    "TEXT": "soup.txt",
    "DRAFT": "draft.csv",
    "NARRATED": "narrated.csv",
    "COLLECTION": "recipes.json",
    "DRAFTED": "drafted.jsonl",
    "OUT": "drafts",
    "NETWORK": "network.lisp",
    "TABLE": "table.csv",
}


def _place(words: tuple[str, ...]) -> int:
    return next(place for place, word in enumerate(words) if word.startswith("@"))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
