"""The service behind a proxy as docs/how-to/serve.md sets it up: what that has nginx send is sent here."""

from __future__ import annotations

import re
import shlex
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import urljoin

import httpx
import pytest
from web.serving import SALAD, app, served

from foon_kg.web.callers import Callers, proxy_network
from foon_kg.web.limits import Limits

PAGE = (Path(__file__).parents[2] / "docs" / "how-to" / "serve.md").read_text(encoding="utf-8")
CONFIGURED = re.search(r"```nginx\n(.*?)```", PAGE, re.DOTALL)[1]
WORDS = shlex.split(re.search(r"^foon serve --port .*$", PAGE, re.MULTILINE)[0])
OPTIONS = dict(zip(WORDS[2::2], WORDS[3::2], strict=True))
NAME, SHOWN = re.search(r"the page is at `https://([^/`]+)(/[^`]*)`", PAGE).groups()
TOKEN = "a token that nobody guesses"
FEW = Limits(seconds=300.0, per_second=1e-6, burst=2)
ANN, BOB = "203.0.113.1", "203.0.113.2"


class Linked(HTMLParser):
    """The addresses that a page loads by itself."""

    def __init__(self, text):
        super().__init__()
        self.found = set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        told = dict(attrs)
        if tag in {"script", "img"} and told.get("src"):
            self.found.add(told["src"])
        if tag == "link" and told.get("href"):
            self.found.add(told["href"])


class Proxied:
    """What a browser gets for a path on the proxy: it sends on what its configuration says, as nginx reads that."""

    def __init__(self, address):
        self.place = re.search(r"location (\S+) {", CONFIGURED)[1]
        _, port, path = re.search(r"proxy_pass http://(\S+):(\d+)(\S*);", CONFIGURED).groups()
        assert port == OPTIONS["--port"]
        self.target, self.taken_away = address + path, self.place if path else ""
        self.headers = dict(re.findall(r"proxy_set_header (\S+) (\S+);", CONFIGURED))

    def __call__(self, path, *, method="GET", caller=ANN, headers=None, **asked):
        assert path.startswith(self.place)
        sent = {name.lower(): value for name, value in (headers or {}).items()}
        before = [sent["x-forwarded-for"]] if "x-forwarded-for" in sent else []
        values = {"$host": NAME, "$proxy_add_x_forwarded_for": ", ".join([*before, caller])}
        sent |= {name.lower(): values[value] for name, value in self.headers.items()}
        address = f"{self.target}{path.removeprefix(self.taken_away)}"
        return httpx.request(method, address, headers=sent, timeout=120, **asked)


def behind(**wishes):
    """The service as the command of the page starts it."""
    callers = Callers((proxy_network(OPTIONS["--proxy"]),))
    return served(app(token=TOKEN, public=[OPTIONS["--name"]], callers=callers, **wishes), callers)


@pytest.fixture(scope="module")
def proxied():
    with behind() as address:
        yield Proxied(address)


@pytest.mark.parametrize("path", ["", "explore", "teach", "api/docs"])
def test_pages_and_all_that_they_load_come_through_it(proxied, path):
    address = f"{SHOWN}{path}"
    page = proxied(address, headers={"authorization": f"Bearer {TOKEN}"})
    assert page.status_code == 200
    linked = {urljoin(address, one) for one in Linked(page.text).found}
    assert {one for one in linked if not one.startswith(SHOWN)} == set()
    assert {one: proxied(one).status_code for one in linked} == dict.fromkeys(linked, 200)


def test_its_page_may_ask_and_the_page_of_another_name_may_not(proxied):
    for origin, status in ((f"https://{NAME}", 200), ("https://evil.example", 403)):
        headers = {"origin": origin, "authorization": f"Bearer {TOKEN}"}
        answer = proxied(f"{SHOWN}api/plan", method="POST", headers=headers, json=SALAD)
        assert answer.status_code == status
    assert proxied(f"{SHOWN}api/summary").status_code == 401


def test_who_asks_too_often_keeps_nobody_else_out_whatever_is_made_up():
    with behind(limits=FEW) as address:
        proxied = Proxied(address)

        def asks(caller, told=None):
            headers = {"authorization": f"Bearer {TOKEN}"} | ({"x-forwarded-for": told} if told else {})
            return proxied(f"{SHOWN}api/summary", caller=caller, headers=headers).status_code

        assert [asks(ANN), asks(ANN), asks(ANN)] == [200, 200, 429]
        assert asks(ANN, told=BOB) == 429
        assert asks(BOB) == 200
