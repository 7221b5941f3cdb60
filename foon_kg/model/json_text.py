"""JSON of which nobody knows what is in it: what cannot be read is a JSONDecodeError, whatever Python says of it.

Python reads no number of more than some thousand digits and no lists nested deeper than its stack, and raises other
errors for them than for what is no JSON.
"""

from __future__ import annotations

import json
from typing import Any

_DECODER = json.JSONDecoder()

compact_json = json.JSONEncoder(ensure_ascii=False, separators=(",", ":")).encode
"""Returns a value as JSON without spaces, the same on every machine: what hashes and texts in the graph are made of.

Made once: ``json.dumps`` makes an encoder at each call, and a FOON has a hash for each node and unit.
"""


def json_value(text: str) -> Any:  # noqa: ANN401 - any value of JSON
    """Return the value that ``text`` is in JSON; raises JSONDecodeError where it is none.

    >>> json_value('{"label": "egg"}')
    {'label': 'egg'}
    """
    try:
        return json.loads(text)
    except json.JSONDecodeError:
        raise
    except (ValueError, RecursionError) as error:
        raise _unreadable(text, 0) from error


def json_value_at(text: str, place: int) -> tuple[Any, int]:
    """Return the JSON value that begins at ``place`` (in characters) of a ``text``, and where it ends.

    Raises JSONDecodeError where there is none.

    >>> json_value_at("[1] and more", 0)
    ([1], 3)
    """
    try:
        return _DECODER.raw_decode(text, place)
    except json.JSONDecodeError:
        raise
    except (ValueError, RecursionError) as error:
        raise _unreadable(text, place) from error


def _unreadable(text: str, place: int) -> json.JSONDecodeError:
    return json.JSONDecodeError("a number of too many digits, or lists nested too deeply", text, place)
