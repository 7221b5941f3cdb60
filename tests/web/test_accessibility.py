"""Every state of the page, judged by axe-core (tests/vendor): at a desk and in a hand, light and dark."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import quote

import pytest
from chromium import SCREENS, as_wide_as_the_screen, on_screen
from web.driving import until

AXE = Path(__file__).parents[1] / "vendor" / "axe.min.js"
SOUP = "dish=soup&with=cube+bouillon&with=200+g+sliced+mushroom&with=chopped+leek&with=boiling+water"
STATES = {
    "opening": "",
    **{name: f"{SOUP}&view={name}" for name in ("steps", "cook", "when", "why", "compare")},
    "cooking": f"{SOUP}&view=cook&step=10",
    "tree": f"{SOUP}&view=tree&step=7",
    "compared": f"{SOUP}&view=compare&other={quote(SOUP + '&without=leek')}",
    "not compared": f"{SOUP}&view=compare&other={quote(SOUP + '&have=spoon')}",
    "suggestions": "with=egg&with=chopped+onion&view=make",
    "refused": "with=egg&dish=soup&have=spoon",
}
THERE = """
    return !!document.body.dataset.page
        && ![...document.querySelectorAll('[aria-busy=true]')].some(one => one.checkVisibility())"""
FOUND = """
    axe.run(document, {resultTypes: ['violations']}).then(told => arguments[0](told.violations.map(
        one => `${one.id}: ${one.nodes.map(node => node.html).join(' ')}`)))"""


@pytest.mark.parametrize(("width", "scheme"), SCREENS)
def test_axe_finds_nothing_and_nothing_is_beyond_the_side(page, address, width, scheme):
    page.execute_cdp_cmd(
        "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    )
    on_screen(page, width, 720, touch=width < 500)
    found = {}
    for name, asked in STATES.items():
        page.get("about:blank")
        page.get(f"{address}/#{asked}")
        until(page, THERE)
        page.execute_script(AXE.read_text(encoding="utf-8"))
        found[name] = page.execute_async_script(FOUND)
        assert as_wide_as_the_screen(page, width), name
    assert found == {name: [] for name in STATES}
