"""Skips what needs the extra “web” where it is not installed."""

from __future__ import annotations

import importlib.util

collect_ignore_glob = [] if importlib.util.find_spec("fastapi") and importlib.util.find_spec("mcp") else ["test_*.py"]
