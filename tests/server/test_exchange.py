"""Data put in the place of other data: wherever that fails, or the program is killed, one of both is there, whole."""

from __future__ import annotations

import os

import pytest
from campaign.harmed_disk import KILLED, Harm, HarmedDisk

from foon_kg.model.errors import ServerError
from foon_kg.store.server.exchange import exchange, settle
from foon_kg.store.server.home import Home

OLD, NEW = "what was stored", "what was imported"


def home_with(root, what, password):
    place = Home(root)
    place.create()
    place.databases.mkdir(parents=True)
    (place.databases / "store").write_text(what)
    place.password_file.write_text(password)
    return place


@pytest.fixture
def homes(tmp_path):
    place = home_with(tmp_path / "home", OLD, "secret")
    return place, home_with(place.root / "import" / "home", NEW, "secret")


def held(place):
    """Return what a server that is started now finds, and everything that lies beside it."""
    settle(place)
    return (place.databases / "store").read_text(), {one.name for one in place.root.iterdir()} - {"import"}


def test_the_new_data_takes_the_place_of_the_old(homes):
    place, made = homes
    beside = {one.name for one in place.root.iterdir()} - {"import"}
    exchange(place, made)
    assert held(place) == (NEW, beside)


def operations(place, made):
    with HarmedDisk(place.root).used() as disk:
        exchange(place, made)
    return len(disk.done)


@pytest.mark.parametrize("harm", Harm)
def test_an_exchange_that_breaks_off_loses_neither(tmp_path, harm):
    def begin(number):
        place = home_with(tmp_path / str(number), OLD, "secret")
        return place, home_with(place.root / "import" / "home", NEW, "secret")

    total = operations(*begin(0))
    assert total >= 2
    for number in range(1, total + 1):
        place, made = begin(number)
        beside = {one.name for one in place.root.iterdir()} - {"import"}
        if harm is Harm.FAILS:
            with HarmedDisk(place.root, number, harm).used(), pytest.raises(ServerError, match="cannot put the import"):
                exchange(place, made)
            assert held(place) == (OLD, beside)
        else:
            killed_at(place, made, number)
            assert held(place)[0] in {OLD, NEW}
            assert held(place)[1] == beside
        exchange(place, home_with(place.root / "import" / "again", NEW, "secret"))
        assert held(place) == (NEW, beside)


def killed_at(place, made, number):
    child = os.fork()
    if not child:
        with HarmedDisk(place.root, number, Harm.ENDS).used():
            exchange(place, made)
        os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == KILLED


def test_a_home_that_was_never_started_gets_data_and_the_password_that_opens_it(tmp_path):
    place = Home(tmp_path / "home")
    place.create()
    exchange(place, home_with(place.root / "import" / "home", NEW, "made"))
    assert (held(place)[0], place.password_file.read_text()) == (NEW, "made")
