"""What an offline load costs: a FOON of any size (see big_foon.py) through neo4j-admin into the local server.

    FOON_KG_HOME=FOLDER python benchmarks/offline.py --units 20000

Needs the public subgraphs beside the checkout; takes the place of all that the server of FOON_KG_HOME holds. The FOON
is made while it is read, a part at a time. Printed: seconds and CPU seconds of every 2,000 videos that were staged, so
that what grows is seen; seconds of reading into tables, of writing files, of neo4j-admin alone and of lists,
constraints and indexes; how many times the time of neo4j-admin the import took with the last of them; CPU seconds and
the most memory of this program.
"""

from __future__ import annotations

import argparse
import gc
import resource
import time

from big_foon import cuisines, real_subgraphs

from foon_kg.store.offline.importing import load_offline

EVERY = 2_000


class Rates:
    """Prints what each ``EVERY`` videos cost that were staged."""

    def __init__(self) -> None:
        self._videos = 0
        self._last = (time.perf_counter(), time.process_time())

    def add(self, videos: int) -> None:
        """Take down that so many videos more are staged."""
        before, self._videos = self._videos, self._videos + videos
        if before // EVERY != self._videos // EVERY:
            now = (time.perf_counter(), time.process_time())
            wall, cpu = (b - a for a, b in zip(self._last, now, strict=True))
            most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
            print(f"{self._videos:,} videos: {wall:.1f} s, {cpu:.1f} s of CPU, {most:,.0f} MB at most", flush=True)
            self._last = now


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--units", type=int, default=20_000)
    options = parser.parse_args()
    gc.set_threshold(1_000_000, 50, 100)  # as every command of foon has it
    before = time.process_time()
    report = load_offline(cuisines(real_subgraphs(), options.units), replace=True, say=print, told=Rates().add)
    print(f"{report.videos:,} videos, seconds: {report.seconds}")
    imported = report.seconds["import"]
    print(f"import and indexes: {(imported + report.seconds['indexes']) / imported:.2f} times the import alone")
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"this program: {time.process_time() - before:.1f} s of CPU, {most:,.0f} MB at most")


if __name__ == "__main__":
    main()
