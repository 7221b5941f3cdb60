"""XML documents that can be read back to what was written."""

from __future__ import annotations

import re
from xml.etree import ElementTree as ET

from foon_kg.model.errors import FormatError

_NOT_KEPT = re.compile("[^\t\n\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def xml_text(text: str) -> str:
    """Return ``text`` where XML keeps it; raises :class:`~foon_kg.model.errors.FormatError` where it does not."""
    if found := _NOT_KEPT.search(text):
        raise FormatError(
            f"{text!a} has the character U+{ord(found[0]):04X}, which XML cannot hold",
            hint="Take it out of the name, or export JSON.",
        )
    return text


def xml_document(root: ET.Element) -> str:
    """Return the document of the element ``root`` as text, one element a line."""
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, encoding="unicode") + "\n"
