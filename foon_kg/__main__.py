"""``foon``, and ``python -m foon_kg``: the command line, which Ctrl-C ends at any moment with 130 and without a word.

The commands are imported where that is minded already: it is most of what a short command does.
"""

from __future__ import annotations

import signal
import sys

INTERRUPTED = 128 + signal.SIGINT
"""How a program ends that Ctrl-C stopped, by the custom of shells."""


def main() -> None:
    """Run ``foon`` (the entry point of the installed program)."""
    try:
        from foon_kg.cli import main as run  # noqa: PLC0415 - see above

        run()
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    finally:
        if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, signal.SIG_DFL)  # nothing is left to be put in order: Python only ends now


if __name__ == "__main__":
    main()
