"""Many reports counted: what robot and cook accept of all that was asked, and which rules are broken how often."""

from __future__ import annotations

from foon_kg.evaluation.verdicts import Verdicts, verdict_json
from foon_kg.validation import RULES, Finding, Report


def report(*findings, not_asked=()):
    return Report("one", tuple(findings), tuple((rule, why) for rule, why in not_asked))


HOT = Finding("W3", "the stove is off", 3)
RAW = Finding("K1", "egg is in the dish and was not cooked at all")
ODD = Finding("K3", "milk comes after the last cooking", minor=True)
LATE = Finding("C3", "the stove is still on at the end")


def test_a_share_is_of_all_that_was_asked_whether_it_has_a_tree_or_not():
    found = Verdicts((report(), report(HOT), report(RAW), report(LATE), None))
    assert found.named == {"robot": 3, "cook": 3, "accepted": 2, "form": 3}
    assert found.share(found.accepted) == 2 / 5
    assert Verdicts(()).share(0) == 0


def test_every_rule_counts_trees_and_a_fatal_finding_outweighs_minor_ones():
    found = Verdicts((report(ODD, ODD), report(ODD, Finding("K3", "peeled hot")), report())).rules
    assert list(found) == list(RULES)
    assert found["K3"].to_json() == {"kept": 1, "asked": 3, "fatal": 1, "minor": 1}
    assert found["K3"].broken == 2
    assert found["W1"].to_json() == {"kept": 3, "asked": 3, "fatal": 0, "minor": 0}


def test_a_rule_that_was_asked_in_part_counts_as_asked_and_one_that_was_left_out_does_not():
    left = [("C4", "no recipe is known"), ("C2", "in part: no FOON is known")]
    found = Verdicts((report(not_asked=left), report())).rules
    assert (found["C4"].asked, found["C2"].asked) == (1, 2)


def test_what_has_no_tree_is_asked_nothing_and_accepted_by_nobody():
    assert all(count.asked == 0 for count in Verdicts((None,)).rules.values())
    nothing = {"robot": False, "cook": False, "accepted": False, "form": False, "broken": [], "fatal": []}
    assert verdict_json(None) == nothing
    assert verdict_json(report(ODD, HOT)) == nothing | {
        "cook": True,
        "form": True,
        "broken": ["W3", "K3"],
        "fatal": ["W3"],
    }
