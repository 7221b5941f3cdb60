"""Hostile names in exports, read by the programs that the exports are for: they see the name, and nothing runs.

Graphviz (compiled for node) and Mermaid (in Chromium) are fetched by ``make campaign``, pinned by
``consumers/package-lock.json``; without them those tests are left out.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from campaign.test_hostile_names import HOSTILE, named, renamed, touch_all, wired, written  # noqa: F401 - a fixture
from pictures.demo_plans import demo_foon, demo_plan

from foon_kg.formats.exports.neo4j_csv import AFTER, ARGUMENTS, write_neo4j_csv
from foon_kg.loaders import read_json, write_json
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, load
from foon_kg.store.snapshot import Snapshot

pytestmark = pytest.mark.slow

WHOLE_CAMPAIGN = os.environ.get("FOON_KG_CAMPAIGN") == "yes"
CONSUMERS = Path(__file__).parents[2] / "build" / "consumers"
HERE = Path(__file__).with_name("consumers")
NAMES = (
    *HOSTILE,
    "\\N \\G \\l",
    "a\\",
    "&lt;b&gt; &amp;amp; &#106;",
    "<b>bold</b>",
    "%%{init: {'securityLevel': 'loose'}}%%",
    'end; click n1 call tripped() "x"',
    "#35;#quot;",
    "`**bold**` $$x^2$$",
    "a|b{c}[d](e)",
    "=cmd|' /C calc'!A0",
    "'; DROP DATABASE neo4j; //",
    "a,b;c\"d''e",
    "(:goal (and)) ; x",
)
fetched = pytest.mark.skipif(not (CONSUMERS / "node_modules").is_dir(), reason="make campaign fetches them")


@pytest.fixture(params=NAMES)
def plan(request, tmp_path):
    """The file of a plan in which a food has a hostile name, and that name."""
    path = tmp_path / "plan.json"
    value = named(json.dumps(demo_plan("kohlrabi_salad").to_json()), request.param)
    path.write_text(json.dumps(value), encoding="utf-8")
    return path, request.param


def bare(text):
    """A text without its spaces: who draws breaks lines where they are too long."""
    return "".join(text.replace("\xa0", " ").split())


@fetched
def test_graphviz_draws_each_name(plan, tmp_path):
    path, name = plan
    script = CONSUMERS / "drawn.mjs"
    shutil.copy(HERE / "drawn.mjs", script)
    dot = written(tmp_path / "tree.dot", "export", path, "--format", "dot").read_bytes()
    drawn = subprocess.run(["node", str(script)], input=dot, capture_output=True, check=False)
    assert drawn.returncode == 0, drawn.stderr
    root = ET.fromstring(drawn.stdout)
    assert bare(name) in bare("".join(root.itertext()))
    assert not [one for one in root.iter() if one.tag.rpartition("}")[2] in {"script", "img", "image", "b"}]
    assert not [value for one in root.iter() for key, value in one.attrib.items() if key.startswith("on")]


@fetched
def test_mermaid_draws_each_name_and_runs_none(wired, plan, tmp_path):  # noqa: F811 - the fixture
    path, name = plan
    text = written(tmp_path / "tree.mmd", "export", path, "--format", "mermaid").read_text(encoding="utf-8")
    page = tmp_path / "page.html"
    library = (CONSUMERS / "node_modules" / "mermaid" / "dist" / "mermaid.min.js").as_uri()
    page.write_text(f'<!doctype html><meta charset="utf-8"><body><script src="{library}"></script>', encoding="utf-8")
    wired.get(page.as_uri())
    failed = wired.execute_async_script(
        """
        const [text, done] = arguments;
        mermaid.initialize({startOnLoad: false, securityLevel: "loose"});
        mermaid.render("drawn", text).then(
            ({svg}) => { document.body.innerHTML = svg; done(""); }, error => done(String(error)));
        """,
        text,
    )
    assert failed == ""
    assert bare(name) in bare(wired.execute_script("return document.body.textContent"))
    touch_all(wired)


@pytest.mark.parametrize("name", NAMES if WHOLE_CAMPAIGN else NAMES[:3])
def test_fast_downward_solves_what_is_called_so(tmp_path, monkeypatch, name):
    pytest.importorskip("up_fast_downward", reason="the extra [planners] is not installed")
    from unified_planning.io import PDDLReader
    from unified_planning.shortcuts import OneshotPlanner, get_environment

    monkeypatch.chdir(tmp_path)  # Fast Downward writes where it stands
    get_environment().credits_stream = None
    value = named(json.dumps(demo_plan("kohlrabi_salad").to_json()), name)
    (tmp_path / "plan.json").write_text(json.dumps(value), encoding="utf-8")
    folder = written(tmp_path / "pddl", "export", tmp_path / "plan.json", "--format", "pddl")
    domain, problem = (next(folder.glob(f"*{kind}*.pddl")) for kind in ("domain", "problem"))
    with OneshotPlanner(name="fast-downward") as planner:
        found = planner.solve(PDDLReader().parse_problem(str(domain), str(problem))).plan
    assert len(found.actions) == len(value["units"])


@pytest.mark.neo4j
@pytest.mark.skipif(not WHOLE_CAMPAIGN, reason="make campaign has the time for it")
def test_neo4j_admin_imports_each_name(empty_graph, tmp_path, monkeypatch):
    """What the real import makes of a FOON of hostile names is what a load of it makes."""
    from server.live_server import up

    from foon_kg.store.server import stop
    from foon_kg.store.server.home import Home
    from foon_kg.store.server.java import run_admin
    from foon_kg.store.server.startup_cache import the_startup_cache

    subgraphs = [
        read_json(json.dumps(renamed(write_json(one), name)), f"{one.name}-{number}").subgraph
        for one in demo_foon().subgraphs[:2]
        for number, name in enumerate(NAMES)
    ]
    with Connection(empty_graph) as connection:
        load(connection, subgraphs)
        loaded = names(connection)
    (tmp_path / "import").mkdir()
    for file in write_neo4j_csv(Snapshot.of(subgraphs, Kitchen.default())):
        (tmp_path / "import" / file.name).write_text(file.text, encoding="utf-8")
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "home"))
    up()
    stop()
    place = Home((tmp_path / "home").resolve())
    shutil.copytree(tmp_path / "import", place.root, dirs_exist_ok=True)  # the command runs there
    monkeypatch.chdir(place.root)
    monkeypatch.setenv("JDK_JAVA_OPTIONS", "--add-opens=java.base/java.nio=ALL-UNNAMED")
    words = ["database", "import", "full", "neo4j", "--overwrite-destination"]
    words += [line for line in Path(ARGUMENTS).read_text(encoding="utf-8").splitlines() if line.startswith("--")]
    cache = the_startup_cache()
    run_admin(place.root / "admin.args", cache.jar_set.class_path(cache.folder), place.root, words)
    with Connection(up()) as imported:
        with imported.session(writing=True) as session:
            session.run((tmp_path / "import" / AFTER).read_text(encoding="utf-8")).consume()
        assert names(imported) == loaded
    stop()


def names(connection):
    """Return all that objects, foods and motions are called, and where they are."""
    with connection.session() as session:
        rows = session.run("MATCH (n:Object|Ingredient|Motion) RETURN labels(n), n.label, n.name, n.verb, n.container")
        return sorted(map(repr, rows.values()))
