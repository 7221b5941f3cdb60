"""The address under which a browser opens the second of a video that somebody named as the source of a FOON."""

from __future__ import annotations

from urllib.parse import urlsplit, urlunsplit


def is_web_address(source: str) -> bool:
    """Return whether a link to ``source`` opens a page; ``javascript:`` and the like would do something else.

    >>> is_web_address("https://example.org/salad"), is_web_address("javascript:alert(1)")
    (True, False)
    """
    try:
        return urlsplit(source).scheme in {"http", "https"}
    except ValueError:  # brackets that do not close
        return False


def video_address(source: str, start: float | None) -> str:
    """Return the address of the video ``source`` from the second ``start`` on; of no start, its beginning."""
    if start is None:
        return source
    parts = urlsplit(source)
    if parts.hostname and (parts.hostname.endswith("youtube.com") or parts.hostname == "youtu.be"):
        second = f"t={int(start)}s"
        return urlunsplit(parts._replace(query=f"{parts.query}&{second}" if parts.query else second))
    # a media fragment (W3C, 2012): any other player that knows none plays from the beginning
    return source if parts.fragment else f"{source}#t={start:g}"
