r"""Trees that people read: drawn from plan results, then the readers' sheets counted and set beside the judge.

Two readers who know neither the program nor which version of it made a tree read the same trees, each alone. A reader
is given the page and nothing else; the key stays with whoever drew it.

    python benchmarks/reading.py draw plans.jsonl --seed 7 --each 5 --out trees.txt --key key.json
    python benchmarks/reading.py draw plans.jsonl --seed 8 --each 5 --videos 10 --not-in key.json \
        --out more.txt --key more-key.json
    python benchmarks/reading.py compare key.json --sheet one.txt --sheet two.txt --judge

Each subcommand says more with --help.
"""

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from foon_kg.evaluation.reading import ReadingTree, draw, key_to_json, names_in, planned_trees, read_key, video_trees
from foon_kg.evaluation.reading_figures import OVERALL, Differing, Reading, Shares, compare, judged
from foon_kg.evaluation.reading_page import page, words_in
from foon_kg.evaluation.reading_sheet import Sheet, read_sheet
from foon_kg.evaluation.resampling import Interval
from foon_kg.loaders import read_paths
from foon_kg.model import Subgraph
from foon_kg.model.errors import FoonError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.validation import KnownFoon, check

SHARED = Path(__file__).parents[1].parent / "shared"
VIDEOS = SHARED / "data" / "foon-111" / "TXT"
WORDS = SHARED / "reading.md"

DRAW = """Draw trees for a reading: as many of each dish type, by a seed, shuffled.

Plan results without a tree are left out, and told how many. --out is the page for the readers: what they are told (the
lines that reading.md quotes), then the trees. --key says which tree has which number, and keeps the plans for
`compare`. What was read before is not drawn again: --not-in takes the key of an earlier draw or a JSON list of names,
and may be given many times.

    python benchmarks/reading.py draw plans.jsonl --seed 7 --each 5 --out trees.txt --key key.json
    python benchmarks/reading.py draw plans.jsonl --seed 8 --each 5 --videos 10 --not-in key.json \\
        --out more.txt --key more-key.json
"""

COMPARE = """Count the sheets of readers, and set the judge beside them.

A sheet has one line a tree, `number | yes/no | yes/yes, but/no | faults`, in any order; behind a line of
dashes, or behind the last tree, anything may follow. Shares and agreement carry 95 % intervals (Wilson); kappa is
Cohen's. Recorded videos are counted apart.

    python benchmarks/reading.py compare key.json --sheet one.txt --sheet two.txt
    python benchmarks/reading.py compare key.json --sheet one.txt --sheet two.txt --judge --json
"""


def main() -> int:
    options = parser().parse_args()
    try:
        options.run(options)
    except FoonError as error:
        print(f"{error.message}\n{error.hint}", file=sys.stderr)
        return error.exit_code
    return 0


def parser() -> argparse.ArgumentParser:
    plainly = argparse.RawDescriptionHelpFormatter
    every = argparse.ArgumentParser(description=__doc__, formatter_class=plainly)
    commands = every.add_subparsers(required=True, metavar="draw | compare")
    one = commands.add_parser("draw", description=DRAW, formatter_class=plainly)
    one.add_argument("plans", nargs="+", type=Path, metavar="PLANS.jsonl", help="plan results of `foon plan --json`")
    one.add_argument("--seed", type=int, required=True, help="a new one for each reading")
    one.add_argument("--each", type=int, required=True, metavar="N", help="trees of each dish type")
    one.add_argument("--videos", type=int, default=0, metavar="M", help="recorded videos among them (default: none)")
    one.add_argument("--foon", type=Path, default=VIDEOS, metavar="DIR", help="where these are")
    one.add_argument("--out", type=Path, required=True, metavar="FILE", help="the page for the readers")
    one.add_argument("--key", type=Path, required=True, help="which tree has which number (JSON)")
    one.add_argument(
        "--not-in", type=Path, action="append", default=[], metavar="KEY", help="the key of an earlier draw, or a list"
    )
    one.add_argument("--words", type=Path, default=WORDS, metavar="FILE", help="quotes what readers are told")
    one.set_defaults(run=draw_trees)
    two = commands.add_parser("compare", description=COMPARE, formatter_class=plainly)
    two.add_argument("key", type=Path, metavar="KEY", help="what `draw` wrote")
    two.add_argument("--sheet", type=Path, action="append", required=True, help="what a reader wrote; once a reader")
    two.add_argument("--judge", action="store_true", help="ask the judge about the trees, too")
    two.add_argument("--files", type=Path, default=VIDEOS, metavar="DIR", help="the FOON that it asks, with the videos")
    two.add_argument("--json", action="store_true", help="the figures as JSON")
    two.set_defaults(run=compare_sheets)
    return every


def draw_trees(options: argparse.Namespace) -> None:
    planned = [tree for path in options.plans for tree in planned_trees(path)]
    videos = video_trees(subgraphs_in(options.foon), Kitchen.default()) if options.videos else {}
    read = frozenset[str]().union(*map(names_in, options.not_in))
    chosen = draw(planned, videos, seed=options.seed, each=options.each, recorded=options.videos, without=read)
    words = words_in(options.words)
    options.out.write_text(page(words, [tree.tree(videos) for tree in chosen]), encoding="utf-8")
    options.key.write_text(json.dumps(key_to_json(options.seed, chosen), ensure_ascii=False) + "\n", encoding="utf-8")
    for line in told_of_draw(planned, chosen, options.each):
        print(line, file=sys.stderr)


def told_of_draw(planned: Sequence[ReadingTree], chosen: Sequence[ReadingTree], each: int) -> Iterator[str]:
    counts = Counter(tree.dish_type for tree in chosen if not tree.recorded)
    yield f"{counts.total()} trees of {len(counts)} dish types, {len(chosen) - counts.total()} videos"
    for dish_type in sorted({tree.dish_type for tree in planned}):
        if counts[dish_type] < each:
            yield f"{dish_type}: only {counts[dish_type]}"
    without = sum(not tree.has_steps for tree in planned)
    if without:
        yield f"{without} of {len(planned)} plan results have no tree"


def compare_sheets(options: argparse.Namespace) -> None:
    trees = read_key(options.key)
    sheets = [read_sheet(path, len(trees)) for path in options.sheet]
    reading = compare(trees, sheets, judge(trees, options.files) if options.judge else None)
    if options.json:
        print(json.dumps(reading.to_json(), ensure_ascii=False))
    else:
        show(reading)


def judge(trees: Sequence[ReadingTree], files: Path) -> Sheet:
    subgraphs = subgraphs_in(files)
    kitchen = Kitchen.default()
    snapshot, videos = Snapshot.of(subgraphs, kitchen), video_trees(subgraphs, kitchen)
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    return tuple(judged(check(tree.tree(videos), foon)) for tree in trees)


def subgraphs_in(folder: Path) -> list[Subgraph]:
    return [result.subgraph for result in read_paths([folder]) if result.subgraph is not None]


def show(reading: Reading) -> None:
    print("Accepted, per cent [95 %]; both: as robot and as cook")
    print(f"{'':34}{'trees':>6}{'robot':>15}{'cook':>15}{'plain yes':>15}{'both':>15}")
    for shares in reading.shares:
        print(row(shares))
    print("\nAgreement, per cent [95 %] and kappa")
    for one in reading.agreements:
        kappa = "-" if one.kappa is None else f"{one.kappa:.2f}"
        raters = " and ".join(one.raters)
        print(f"{one.kind:10}{raters:24}{one.aspect:10}{one.trees:>4}{shown(one.same):>15}{kappa:>8}")
    if reading.differing:
        print(f"\nJudge and a reader differ on {len(reading.differing)} trees (robot | cook | words)")
    for tree in reading.differing:
        print(paragraph(tree))


def row(shares: Shares) -> str:
    figures = (shares.robot, shares.cook, shares.plain, shares.accepted)
    cells = "".join(f"{'-' if figure is None else shown(figure):>15}" for figure in figures)
    indent = "" if shares.dish_type == OVERALL else "  "
    return f"{shares.kind:10}{indent + shares.dish_type:12}{shares.rater:12}{shares.trees:>6}{cells}"


def shown(interval: Interval) -> str:
    return f"{100 * interval.mean:.0f} [{100 * interval.low:.0f}, {100 * interval.high:.0f}]"


def paragraph(tree: Differing) -> str:
    kind = "recorded " if tree.recorded else ""
    said = (f"    {rater}: {verdict}" for rater, verdict in tree.verdicts.items())
    return "\n".join([f"{tree.number} {tree.name} ({kind}{tree.dish_type}): {', '.join(tree.aspects)}", *said])


if __name__ == "__main__":
    sys.exit(main())
