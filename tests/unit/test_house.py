"""``make check`` refuses a change after which the house is worse: ``benchmarks/house.py --hold``."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

HOUSE = Path(__file__).parents[2] / "benchmarks" / "house.py"
FUNCTIONS = 60
"""More complex ones than any limit allows."""

CIRCLE = {"one.py": "from foon_kg import two\n", "two.py": "from foon_kg import one\n"}
TANGLE = "def tangle{number}(a, b):\n" + "    if a and b:\n        return [c for c in a if c]\n" * 6 + "    return b\n"


def checkout(folder: Path, files: dict[str, str]) -> Path:
    (folder / "README.md").write_text("# A house\n", encoding="utf-8")
    package = folder / "foon_kg"
    package.mkdir()
    (folder / "tests").mkdir()
    plain = "\n\n".join(f"def plain{number}():\n    return {number}\n" for number in range(FUNCTIONS))
    for name, text in {"__init__.py": "", "plain.py": plain, **files}.items():
        (package / name).write_text(text, encoding="utf-8")
    return folder


def held(folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, str(HOUSE), str(folder), "--hold"], capture_output=True, text=True, check=False
    )


def test_a_plain_house_passes(tmp_path):
    done = held(checkout(tmp_path, {}))
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize(
    ("files", "told"),
    [
        (CIRCLE, "circles between modules: 1, and at most 0"),
        (
            {"tangled.py": "\n\n".join(TANGLE.replace("{number}", str(number)) for number in range(FUNCTIONS))},
            f"functions more complex than 20: {FUNCTIONS}, and at most ",
        ),
        ({"../tests/test_long.py": "number = 0\n" * 401}, "files over 400 lines: 1, and at most 0"),
    ],
    ids=["circle", "tangle", "long test"],
)
def test_what_got_worse_is_told_with_its_limit(tmp_path, files, told):
    done = held(checkout(tmp_path, files))
    assert done.returncode == 1
    assert any(line.startswith(told) for line in done.stdout.splitlines()), done.stdout + done.stderr
