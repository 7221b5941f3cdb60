"""Names that are programs to somebody: no browser runs them, and every other reader gets them back as they were."""

from __future__ import annotations

import json
from urllib.parse import quote, unquote
from xml.etree import ElementTree as ET

import pytest
from pictures.demo_plans import demo_foon, demo_plan
from typer.testing import CliRunner
from web.serving import app, served

from foon_kg.cli import app as commands
from foon_kg.loaders import read_json, write_json
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.foon import FixedFoon

pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
pytestmark = pytest.mark.slow

HOSTILE = (
    "<img src=x onerror=tripped()>",
    "</script><script>tripped()</script>",
    "<svg onload=tripped()>",
    '" onmouseover="tripped()" autofocus onfocus="tripped()',
    "' onclick='tripped()",
    "javascript:tripped()",
    "]]><script>tripped()</script>",
    "--><script>tripped()</script><!--",
    "{{constructor.constructor('tripped()')()}}",
    "</style></title><script>tripped()</script>",
)
TRIPWIRE = "window.tripped = () => document.documentElement.setAttribute('data-tripped', 'yes')"
DONE = "return document.documentElement.getAttribute('data-tripped')"


@pytest.fixture
def wired(browser):
    """A browser in which each page has what the names call."""
    added = browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": TRIPWIRE})
    yield browser
    browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)


def named(text, name):
    """JSON in which the food that the demo asks for has another name."""
    return json.loads(json.dumps(json.loads(text)).replace("kohlrabi", json.dumps(name)[1:-1]))


@pytest.fixture(params=HOSTILE)
def plan(request, tmp_path):
    """The file of a plan in which a food has a hostile name, and that name."""
    path = tmp_path / "plan.json"
    path.write_text(
        json.dumps(named(json.dumps(demo_plan("kohlrabi_salad").to_json()), request.param)), encoding="utf-8"
    )
    return path, request.param


def written(path, *words):
    done = CliRunner().invoke(commands, [*map(str, words), "--output", str(path)])
    assert done.exit_code == 0, done.output
    return path


def test_the_tripwire_is_there(wired, tmp_path):
    """Without this every test below could pass for nothing."""
    page = tmp_path / "page.html"
    page.write_text(f"<!doctype html><body>{HOSTILE[0]}")
    wired.get(page.as_uri())
    wired.execute_async_script("setTimeout(arguments[0])")
    assert wired.execute_script(DONE) == "yes"


def test_no_page_and_no_picture_runs_a_name(wired, plan, tmp_path):
    path, name = plan
    page = written(tmp_path / "page.html", "show", path, "--html")
    picture = written(tmp_path / "tree.svg", "show", path, "--svg")
    wired.get(page.as_uri())
    touch_all(wired)
    assert name in wired.execute_script("return document.documentElement.textContent")
    wired.get(picture.as_uri())
    touch_all(wired)
    words = ET.parse(picture).getroot().itertext()
    assert name in " ".join(" ".join(words).split())


def test_xml_gives_every_name_back(plan, tmp_path):
    path, name = plan
    for form in ("graphml", "behaviour-tree"):
        root = ET.parse(written(tmp_path / f"tree.{form}", "export", path, "--format", form)).getroot()
        texts = " ".join([*root.itertext(), *(value for one in root.iter() for value in one.attrib.values())])
        assert name in unquote(texts)
        assert not [one for one in root.iter() if str(one.tag).rpartition("}")[2] in {"script", "img", "svg"}]


def test_the_live_page_shows_hostile_names_as_words(wired):
    """A FOON of hostile names is planned from and looked at in the page that foon serve brings."""
    from selenium.webdriver.support.ui import WebDriverWait

    def until(script):
        return WebDriverWait(wired, 120, poll_frequency=0.05).until(lambda one: one.execute_script(script))

    name = HOSTILE[0]
    subgraphs = [
        read_json(json.dumps(renamed(write_json(one), name)), one.name).subgraph for one in demo_foon().subgraphs
    ]
    with served(app(foon=FixedFoon(Snapshot.of(subgraphs, Kitchen.default())))) as address:
        wired.get(f"{address}/explore#at={quote(name)}")
        until("return about.textContent.length > 40")
        assert name in wired.execute_script("return about.textContent")
        touch_all(wired)
        wired.get(f"{address}/")
        until("return ingredient.offsetParent !== null")
        box = wired.find_element("id", "ingredient")
        wired.execute_script("dish.value = 'salad'")
        for food in (f"sliced {name}", "chopped onion"):
            box.send_keys(food, "\ue007")
        box.send_keys("\ue009" + "\ue007")
        until("return result.getAttribute('aria-busy') === 'false' && document.activeElement === result")
        assert name in wired.execute_script("return document.body.textContent")
        touch_all(wired)


def renamed(text, name):
    return json.loads(json.dumps(json.loads(text)).replace("tomato", json.dumps(name)[1:-1]))


def touch_all(browser):
    """Have everything on a page happen that a name may wait for; then nothing was called."""
    browser.execute_async_script("""
        for (const one of document.querySelectorAll('*'))
            for (const what of ['mouseover', 'focus', 'load', 'error', 'click'])
                if (what !== 'click' || one.closest('.stage, text, p, li') && !one.closest('a, button'))
                    one.dispatchEvent(new Event(what));
        requestAnimationFrame(() => requestAnimationFrame(arguments[0]))
    """)
    assert browser.execute_script(DONE) is None
