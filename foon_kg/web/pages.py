"""The pages of the service: each its own file, into which comes what they have in common, the links and the token.

All that they name is relative, as a proxy may serve them below a path.
"""

from __future__ import annotations

from importlib import resources

from fastapi.responses import Response

_PAGES = {"plan": ("", "Plan a dish"), "explore": ("explore", "Explore"), "teach": ("teach", "Teach")}
"""Where each page is, seen from the first, and what it is called."""


def navigation(here: str = "", up: str = "") -> str:
    """Return the links to all pages, of which ``here`` is the one that is shown; ``up`` leads to where they are.

    >>> print(navigation("teach").splitlines()[3].strip())
    <a href="teach" aria-current="page">Teach</a>
    """
    links = "".join(f"    {_link(name, here, up)}\n" for name in _PAGES)
    return f'<nav aria-label="Pages">\n{links}  </nav>'


def _link(name: str, here: str, up: str) -> str:
    address, said = _PAGES[name]
    if name != here:
        return f'<a href="{up + address or "./"}">{said}</a>'
    # the first page keeps what is asked behind the #: its own link begins anew without fetching it again
    return f'<a href="{"#" if name == "plan" else address}" aria-current="page">{said}</a>'


def _page(package: str, file: str, here: str) -> Response:
    """Return a page of a ``package``, which says by comments where the links and the question for the token belong."""
    text = resources.files(package).joinpath(file).read_text(encoding="utf-8")
    token = resources.files(__package__).joinpath("token.html").read_text(encoding="utf-8")
    text = text.replace("<!-- navigation -->", navigation(here)).replace("  <!-- token -->\n", token)
    return Response(text, media_type="text/html")


def plan_page() -> Response:
    """Return the page that plans."""
    return _page("foon_kg.web", "plan.html", "plan")


def explore_page() -> Response:
    """Return the page of the explorer."""
    return _page("foon_kg.web.explore", "explore.html", "explore")


def teach_page() -> Response:
    """Return the page that teaches."""
    return _page("foon_kg.web.teach", "teach.html", "teach")
