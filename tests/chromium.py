"""A real Chromium for the tests of pages, driven by selenium; what is not installed skips, and says so."""

from __future__ import annotations

import contextlib
import shutil

import pytest

CHROMIUM = shutil.which("chromium")
DRIVER = shutil.which("chromedriver")
PATIENCE = 120
"""Seconds for a script to come back, on a machine that is busy with other tests."""

FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--window-size=1200,900",
)


@contextlib.contextmanager
def chromium(profile):
    """A browser with an empty ``profile`` (a folder) that keeps the messages of its console."""
    webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed")
    if not (CHROMIUM and DRIVER):
        pytest.skip("no chromium and chromedriver here (Debian: apt-get install chromium chromium-driver)")
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    for flag in (*FLAGS, f"--user-data-dir={profile}"):
        options.add_argument(flag)
    driver = webdriver.Chrome(options, webdriver.ChromeService(DRIVER))
    driver.set_script_timeout(PATIENCE)
    try:
        yield driver
    finally:
        driver.quit()


def on_screen(browser, width, height=700, *, touch=False):
    """Show the page as on a screen of so many pixels, which fingers touch or not."""
    from selenium.webdriver.support.ui import WebDriverWait

    screen = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": touch}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
    browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": touch})
    shown = "screen.width" if touch else "innerWidth"  # a page may be laid out wider than what is in a hand
    WebDriverWait(browser, PATIENCE, 0.05).until(lambda it: it.execute_script(f"return {shown}") == width)


def as_usual(browser):
    """Show the page on the screen that the browser was begun with."""
    browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


def papers(browser, scheme, picture):
    """The colours of the page and of the ``picture`` (a CSS selector) on it, in a light or a dark ``scheme``."""
    media = {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", media)
    script = """
        return [getComputedStyle(document.body).backgroundColor,
                getComputedStyle(document.querySelector(arguments[0] + ' .paper')).fill]"""
    return browser.execute_script(script, picture)


SCREENS = [
    (375, "dark"),
    (1200, "light"),
    *(pytest.param(*one, marks=pytest.mark.campaign) for one in ((375, "light"), (1200, "dark"))),
]
"""A hand's and a desk's, in pixels, and the scheme of colours; two show all widths and all colours."""

PAPERS = {"light": "rgb(255, 255, 255)", "dark": "rgb(22, 24, 29)"}


def as_wide_as_the_screen(browser, width):
    """Whether nothing of the page is beyond the side of a screen of ``width`` pixels."""
    return browser.execute_script("return document.documentElement.scrollWidth") <= width


def fingers(browser, *touches):
    """Touch the screen: each is a kind of event, and where the fingers are then."""
    for kind, places in touches:
        points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
        browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
