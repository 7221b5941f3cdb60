"""What videos teach, worked out beside the writer: one batch ahead and no more, and nothing of it is left."""

from __future__ import annotations

import sys
import threading

import pytest
from kitchen_stories import SALAD, subgraph

from foon_kg.model import Subgraph
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.taught import SWITCH_SECONDS, Ahead, taught_by

KITCHEN = Kitchen.default()
BATCHES = [[subgraph(f"{number}{part}", "salad", *SALAD[number:]) for part in "ab"] for number in range(4)]
BROKEN = Subgraph("broken", (None,))
"""From which nothing can be learnt."""


def test_one_batch_is_begun_ahead_and_what_was_written_is_forgotten():
    taken: list[str] = []

    def source():
        for batch in BATCHES:
            taken.append(batch[0].name)
            yield batch

    with Ahead(KITCHEN) as ahead:
        for number, batch in enumerate(ahead.through(source())):
            assert len(taken) == min(number + 2, len(BATCHES))
            assert [ahead.taught_by(one) for one in batch] == [taught_by(one, KITCHEN) for one in batch]
            for written in BATCHES[:number]:
                with pytest.raises(KeyError):
                    ahead.taught_by(written[0])
        assert number == len(BATCHES) - 1
        with pytest.raises(KeyError):
            ahead.taught_by(BATCHES[-1][0])


def load_until_it_fails(ahead, batches):
    done = []
    for batch in ahead.through(batches):
        for one in batch:
            ahead.taught_by(one)
        done.append(batch)
    return done


def source_that_fails():
    yield from BATCHES[:2]
    raise OSError("the disk went away")


@pytest.mark.parametrize(("batches", "error"), [([*BATCHES, [BROKEN]], AttributeError), (source_that_fails(), OSError)])
def test_what_fails_reaches_the_writer_and_its_thread_ends(batches, error):
    before = set(threading.enumerate())
    with pytest.raises(error), Ahead(KITCHEN) as ahead:
        load_until_it_fails(ahead, batches)
    assert set(threading.enumerate()) == before


def be_interrupted(ahead):
    ahead.begin(one for batch in BATCHES for one in batch)
    raise KeyboardInterrupt


def test_an_interrupted_writer_leaves_no_thread():
    before = set(threading.enumerate())
    with pytest.raises(KeyboardInterrupt), Ahead(KITCHEN) as ahead:
        be_interrupted(ahead)
    assert set(threading.enumerate()) == before


def test_threads_take_short_turns_until_the_last_load_ends_whichever_that_is():
    before = sys.getswitchinterval()
    first, second = Ahead(KITCHEN), Ahead(KITCHEN)
    first.__enter__()
    second.__enter__()
    first.__exit__()
    assert sys.getswitchinterval() == pytest.approx(min(before, SWITCH_SECONDS))
    second.__exit__()
    assert sys.getswitchinterval() == pytest.approx(before)


def test_threads_take_turns_as_before_after_a_load_that_failed():
    before = sys.getswitchinterval()
    with pytest.raises(KeyboardInterrupt), Ahead(KITCHEN) as ahead:
        be_interrupted(ahead)
    assert sys.getswitchinterval() == pytest.approx(before)
