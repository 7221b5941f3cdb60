"""What an offline load costs: a FOON of any size (see big_foon.py) through neo4j-admin into the local server.

    FOON_KG_HOME=FOLDER python benchmarks/offline.py --units 20000

Needs the public subgraphs beside the checkout; takes the place of all that the server of FOON_KG_HOME holds. Printed:
seconds of reading into tables, of writing files, of neo4j-admin alone and of lists, constraints and indexes; how many
times the time of neo4j-admin the import took with the last of them; CPU seconds and the most memory of this program.
"""

from __future__ import annotations

import argparse
import resource
import time

from big_foon import big_foon, real_subgraphs

from foon_kg.store.offline.importing import load_offline


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--units", type=int, default=20_000)
    options = parser.parse_args()
    made, before = big_foon(real_subgraphs(), options.units), time.process_time()
    report = load_offline(made, replace=True, say=print)
    print(f"{report.videos:,} videos, seconds: {report.seconds}")
    imported = report.seconds["import"]
    print(f"import and indexes: {(imported + report.seconds['indexes']) / imported:.2f} times the import alone")
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"this program: {time.process_time() - before:.1f} s of CPU, {most:,.0f} MB at most")


if __name__ == "__main__":
    main()
