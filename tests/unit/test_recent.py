"""A mapping that keeps what was asked of late."""

from foon_kg.model.recent import Recent


def test_of_more_than_it_keeps_what_was_not_asked_the_longest_goes():
    kept = Recent(2)
    kept["egg"], kept["salt"] = 1, 2
    assert kept["egg"] == 1
    kept["milk"] = 3
    assert dict(kept) == {"egg": 1, "milk": 3}
    assert kept.get("salt") is None


def test_an_entry_that_is_written_anew_is_recent_and_takes_no_more_room():
    kept = Recent(2)
    kept["egg"], kept["salt"], kept["egg"], kept["milk"] = 1, 2, 4, 3
    assert dict(kept) == {"egg": 4, "milk": 3}
