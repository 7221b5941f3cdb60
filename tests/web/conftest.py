"""The page in a browser, begun anew for each test; what needs the extra “web” is skipped where it is not installed."""

from __future__ import annotations

import importlib.util

import pytest

collect_ignore_glob = [] if importlib.util.find_spec("fastapi") and importlib.util.find_spec("mcp") else ["test_*.py"]


@pytest.fixture(scope="module")
def address():
    from web.serving import app, served  # what the extra “web” brings

    with served(app()) as found:
        yield found


@pytest.fixture
def page(browser, address):
    """The page, begun anew."""
    from chromium import as_usual
    from web.driving import open_page

    browser.execute_cdp_cmd("Network.setBlockedURLs", {"urls": []})
    as_usual(browser)
    # a script that forgets what is kept would need the page, and an empty one between ends the process that draws:
    # either costs as much as to open the page
    browser.execute_cdp_cmd("Storage.clearDataForOrigin", {"origin": address, "storageTypes": "local_storage"})
    browser.get_log("browser")
    open_page(browser, address)
    return browser
