"""Tests of what an extra brings are skipped where that is not installed.

A module that is asked for here is not imported: each worker would import it, to collect tests that another one runs.
"""

from __future__ import annotations

from importlib.util import find_spec

import pytest


def needs(module: str) -> pytest.MarkDecorator:
    """Return the mark of a test that imports ``module``, the name of one at the top."""
    return pytest.mark.skipif(find_spec(module) is None, reason=f"{module} is not installed")


reads_lines_fully = pytest.mark.xdist_group("ingredient parser")
"""What reads lines of recipes with the parser goes to one worker: to load that takes two seconds of CPU."""

reads_sentences = pytest.mark.xdist_group("spacy")
"""What reads sentences with spaCy's pipeline goes to one worker, for the same reason."""
