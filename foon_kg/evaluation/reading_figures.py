"""What a reading gives: which shares readers and judge accept, how far they agree, and where they differ.

Recorded videos are counted apart from planned trees throughout: people made them, no program did. Intervals are
Wilson's at 95 % (1927), kappas Cohen's (1960).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from foon_kg.evaluation.agreement import agreement
from foon_kg.evaluation.reading import ReadingTree
from foon_kg.evaluation.reading_sheet import Sheet, Verdict
from foon_kg.evaluation.resampling import Interval, share
from foon_kg.model.json_fields import JsonObject
from foon_kg.validation import Report

JUDGE = "judge"
ALL_READERS = "all readers"
"""Accepts in a role what every reader accepts in it, and accepts a tree that every reader accepts in both."""

PLANNED, RECORDED = "planned", "recorded"
"""The kinds of trees."""

OVERALL = "all"
"""Stands for all dish types together."""

ASPECTS = ("robot", "cook", "accepted")
"""What is compared of two verdicts."""


@dataclass(frozen=True)
class Shares:
    """Which shares (0 to 1, with their intervals) of so many ``trees`` of a ``kind`` and ``dish_type`` a rater accepts.

    ``dish_type`` is :data:`OVERALL` for all of them; ``rater`` is ``reader 1`` and so on, :data:`ALL_READERS` or
    :data:`JUDGE`. ``plain`` is a cook's yes without a but, ``None`` for the judge.
    """

    kind: str
    dish_type: str
    rater: str
    trees: int
    robot: Interval
    cook: Interval
    plain: Interval | None
    accepted: Interval

    def to_json(self) -> JsonObject:
        """Return the shares as JSON."""
        figures = {"robot": self.robot, "cook": self.cook, "plain": self.plain, "accepted": self.accepted}
        said = {name: figure and figure.to_json() for name, figure in figures.items()}
        return {"kind": self.kind, "dish_type": self.dish_type, "rater": self.rater, "trees": self.trees, **said}


@dataclass(frozen=True)
class Agreed:
    """How far two ``raters`` agree on one of :data:`ASPECTS`, over the ``trees`` of a ``kind``.

    ``same`` is the share (0 to 1) of trees of which both say the same; ``kappa`` is Cohen's, ``None`` where one of them
    says the same of all.
    """

    kind: str
    aspect: str
    raters: tuple[str, str]
    trees: int
    same: Interval
    kappa: float | None

    def to_json(self) -> JsonObject:
        """Return the agreement as JSON."""
        kappa = None if self.kappa is None else round(self.kappa, 6)
        raters = list(self.raters)
        return {
            "kind": self.kind,
            "aspect": self.aspect,
            "raters": raters,
            "trees": self.trees,
            "same": self.same.to_json(),
            "kappa": kappa,
        }


@dataclass(frozen=True)
class Differing:
    """A tree on which the judge and a reader differ, in which ``aspects``, and what each rater says of it.

    ``number`` is that on the readers' sheets, from 1, and ``name`` the tree's ``id`` in JSON.
    """

    number: int
    name: str
    dish_type: str
    recorded: bool
    aspects: tuple[str, ...]
    verdicts: Mapping[str, Verdict]

    def to_json(self) -> JsonObject:
        """Return the tree as JSON."""
        said = {
            rater: {aspect: getattr(verdict, aspect) for aspect in ASPECTS} | {"words": verdict.words}
            for rater, verdict in self.verdicts.items()
        }
        named = {"number": self.number, "id": self.name, "dish_type": self.dish_type, "recorded": self.recorded}
        return {**named, "aspects": list(self.aspects), "verdicts": said}


@dataclass(frozen=True)
class Reading:
    """All figures of one reading; ``differing`` has no tree where no judge was asked."""

    shares: tuple[Shares, ...]
    agreements: tuple[Agreed, ...]
    differing: tuple[Differing, ...]

    def to_json(self) -> JsonObject:
        """Return the figures as JSON."""
        return {
            "shares": [one.to_json() for one in self.shares],
            "agreements": [one.to_json() for one in self.agreements],
            "differing": [one.to_json() for one in self.differing],
        }


def judged(report: Report) -> Verdict:
    """Return what the judge says in its ``report``, in a reader's form.

    Its words are the rules that are broken fatally, then how many minor findings there are, and of which rules.
    """
    minor = [finding.rule for finding in report.findings if finding.minor]
    rules = dict.fromkeys(minor)
    told = [", ".join(report.fatal)] if report.fatal else []
    told += [f"{len(minor)} minor ({', '.join(rules)})"] if minor else []
    return Verdict(report.robot, report.cook, None, "; ".join(told))


def compare(trees: Sequence[ReadingTree], readers: Sequence[Sheet], judge: Sheet | None = None) -> Reading:
    """Return the figures of a reading; each sheet, the judge's too, has the verdicts of ``trees`` in their order.

    Raises ValueError where there is no reader or a sheet has not as many verdicts as there are trees.
    """
    if not readers:
        raise ValueError("nobody read the trees")
    said = {f"reader {number}": sheet for number, sheet in enumerate(readers, start=1)}
    raters = said if judge is None else {**said, JUDGE: judge}
    rows = [
        _Row(number, tree, dict(zip(raters, verdicts, strict=True)), _all(verdicts[: len(said)]))  # readers come first
        for number, (tree, *verdicts) in enumerate(zip(trees, *raters.values(), strict=True), start=1)
    ]
    return Reading(tuple(_shares(rows)), tuple(_agreements(rows)), tuple(_differing(rows)))


@dataclass(frozen=True)
class _Row:
    """A tree with what every rater says of it, and what all readers together accept."""

    number: int
    tree: ReadingTree
    verdicts: Mapping[str, Verdict]
    together: Verdict

    @property
    def kind(self) -> str:
        return RECORDED if self.tree.recorded else PLANNED


def _all(verdicts: Sequence[Verdict]) -> Verdict:
    return Verdict(
        all(one.robot for one in verdicts), all(one.cook for one in verdicts), all(one.plain for one in verdicts)
    )


def _kinds(rows: Iterable[_Row]) -> Iterator[tuple[str, list[_Row]]]:
    found = list(rows)
    for kind in (PLANNED, RECORDED):
        of_kind = [row for row in found if row.kind == kind]
        if of_kind:
            yield kind, of_kind


def _shares(rows: Sequence[_Row]) -> Iterator[Shares]:
    for kind, of_kind in _kinds(rows):
        for dish_type in (OVERALL, *sorted({row.tree.dish_type for row in of_kind})):
            here = [row for row in of_kind if dish_type in {OVERALL, row.tree.dish_type}]
            for rater in here[0].verdicts:
                yield _accepts(kind, dish_type, rater, [row.verdicts[rater] for row in here])
            yield _accepts(kind, dish_type, ALL_READERS, [row.together for row in here])


def _accepts(kind: str, dish_type: str, rater: str, verdicts: Sequence[Verdict]) -> Shares:
    robot, cook, accepted = (_share(getattr(one, aspect) for one in verdicts) for aspect in ASPECTS)
    plain = None if rater == JUDGE else _share(bool(one.plain) for one in verdicts)
    return Shares(kind, dish_type, rater, len(verdicts), robot, cook, plain, accepted)


def _agreements(rows: Sequence[_Row]) -> Iterator[Agreed]:
    for kind, of_kind in _kinds(rows):
        for one, other in combinations(of_kind[0].verdicts, 2):
            for aspect in ASPECTS:
                first, second = _said(of_kind, one, aspect), _said(of_kind, other, aspect)
                same = _share(his == hers for his, hers in zip(first, second, strict=True))
                yield Agreed(kind, aspect, (one, other), len(of_kind), same, agreement(first, second).kappa)


def _said(rows: Iterable[_Row], rater: str, aspect: str) -> list[int]:
    """Return 1 for each of ``rows`` whose tree the ``rater`` accepts in this ``aspect``, 0 for the others."""
    return [int(getattr(row.verdicts[rater], aspect)) for row in rows]


def _differing(rows: Sequence[_Row]) -> Iterator[Differing]:
    for row in rows:
        judge = row.verdicts.get(JUDGE)
        if judge is None:
            return
        aspects = tuple(
            aspect
            for aspect in ASPECTS
            if any(getattr(one, aspect) != getattr(judge, aspect) for one in row.verdicts.values())
        )
        if aspects:
            yield Differing(row.number, row.tree.name, row.tree.dish_type, row.tree.recorded, aspects, row.verdicts)


def _share(truths: Iterable[bool]) -> Interval:
    found = list(truths)
    return share(sum(found), len(found))
