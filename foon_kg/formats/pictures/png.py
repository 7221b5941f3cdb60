"""Pictures in pixels, by the renderer of ``vl_convert`` (resvg), which brings its own fonts."""

from __future__ import annotations

import re
from xml.etree import ElementTree as ET

import vl_convert

_STYLE = re.compile(r"<style>.*?</style>", re.DOTALL)
_MOST_PIXELS = 60_000_000
"""Larger pictures are made at a smaller scale, rather than taking gigabytes."""


def png_of(svg: str, scale: float = 2.0) -> bytes:
    """Return ``svg`` as a PNG, on white, ``scale`` times as large where that is not too large."""
    root = ET.fromstring(svg)  # noqa: S314 - a picture that this program has just drawn
    pixels = float(root.get("width", "1")) * float(root.get("height", "1"))
    fitting = (_MOST_PIXELS / pixels) ** 0.5
    return bytes(vl_convert.svg_to_png(_STYLE.sub("", svg), scale=min(scale, fitting)))
