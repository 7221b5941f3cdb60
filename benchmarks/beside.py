"""What two commands cost beside each other: they take turns, so that what else the machine does meets both.

    python benchmarks/beside.py [--times N] "COMMAND" "OTHER COMMAND"

Each is run in a shell, in pairs, and who goes first takes turns as well; a first pair is not counted. Printed: of each
the median of CPU seconds (user and system, of the command and of what it started and waited for) and of memory (the
most that one of its processes had), and the median of the ratios of the pairs: the second command in units of the
first. What a server does for them is not in it. The exit code is 1 where a command failed.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
from dataclasses import dataclass


@dataclass(frozen=True)
class Cost:
    """CPU seconds, and megabytes at most."""

    cpu: float
    memory: float


def cost_of(command: str) -> Cost:
    """Run a command and return what it cost; raises CalledProcessError where it fails."""
    process = subprocess.Popen(command, shell=True, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)  # it has been waited for
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command)
    return Cost(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)


def pairs(first: str, second: str, times: int) -> list[tuple[Cost, Cost]]:
    """Run both ``times`` times, and once before."""
    found = []
    for turn in range(times + 1):
        if turn % 2:
            one, other = cost_of(first), cost_of(second)
        else:
            other, one = cost_of(second), cost_of(first)
        found.append((one, other))
    return found[1:]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commands", nargs=2)
    parser.add_argument("--times", type=int, default=9)
    options = parser.parse_args()
    try:
        found = pairs(*options.commands, options.times)
    except subprocess.CalledProcessError as error:
        sys.exit(f"{error.cmd}: exit code {error.returncode}")
    for place, command in enumerate(options.commands):
        cpu = statistics.median(pair[place].cpu for pair in found)
        memory = statistics.median(pair[place].memory for pair in found)
        print(f"{cpu:8.2f} s of CPU, {memory:6.0f} MB: {command}")
    ratio = statistics.median(other.cpu / one.cpu for one, other in found)
    print(f"the second takes {ratio:.2f} times the CPU of the first, the median of {len(found)} pairs")


if __name__ == "__main__":
    main()
