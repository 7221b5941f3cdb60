from hypothesis import given, settings
from kitchen_stories import CHOP_ONION, SALAD, script, unit
from planner.dishes import KITCHEN, foons

from foon_kg.model import KnownUnit, Sighting
from foon_kg.restoration import restored

GRIDDLE = (
    "packet{bacon}; bacon(raw)@packet; griddle(on) > pick-and-place > griddle(on){bacon}; bacon(raw)@on griddle",
    "griddle(on){bacon} > close > griddle(closed,on){bacon}",
    "griddle(closed,on){bacon}; bacon(raw)@on griddle > cook > bacon(fried)@on griddle",
    "griddle(on){bacon} > turn off > griddle(off){bacon}",
)
OPEN = KnownUnit(unit("griddle(closed,on){bacon} > open > griddle(on){bacon}"), (Sighting("other", 8),))


def makers(*known):
    return lambda node: [maker for maker in known if node in maker.unit.output_nodes]


def motions(units):
    return [known.unit.motion for known in units]


def test_what_was_closed_is_opened_before_it_is_taken_as_open():
    units = script(*GRIDDLE)
    found = restored(units, makers(*units, OPEN), KITCHEN)
    assert motions(found) == ["pick-and-place", "close", "cook", "open", "turn off"]
    assert [known for known in found if known is not OPEN] == list(units)


def test_without_a_unit_that_makes_it_anew_the_script_stays_as_it_is():
    units = script(*GRIDDLE)
    assert restored(units, makers(*units), KITCHEN) == units


def test_a_unit_that_needs_more_than_what_stands_there_is_not_put_in():
    needy = KnownUnit(unit("griddle(closed,on){bacon}; turner > open > griddle(on){bacon}"), (Sighting("other", 8),))
    units = script(*GRIDDLE)
    assert restored(units, makers(*units, needy), KITCHEN) == units


def test_a_tool_that_only_stood_by_is_still_there_to_make_it_anew():
    lift = KnownUnit(unit("griddle(closed,on){bacon}; turner > open > griddle(on){bacon}"), (Sighting("other", 8),))
    cook = "griddle(closed,on){bacon}; bacon(raw)@on griddle; turner > cook > bacon(fried)@on griddle"
    units = script(*GRIDDLE[:2], cook, GRIDDLE[3])
    assert motions(restored(units, makers(*units, lift), KITCHEN)) == [*motions(units[:3]), "open", "turn off"]


def test_what_a_later_unit_takes_is_not_changed_back():
    units = script(*GRIDDLE[:2], GRIDDLE[3], GRIDDLE[2])
    assert restored(units, makers(*units, OPEN), KITCHEN) == units


def test_a_script_in_which_nothing_is_taken_as_it_was_stays_as_it_is():
    for units in (script(*SALAD), script(*CHOP_ONION)):
        assert restored(units, makers(*units, OPEN), KITCHEN) == units


@settings(max_examples=60, deadline=None)
@given(foons(most=1))
def test_a_video_is_complete_as_it_is(subgraphs):
    (video,) = subgraphs
    units = tuple(KnownUnit(a.unit, (Sighting(video.name, n),)) for n, a in enumerate(video.annotations))
    assert restored(units, makers(*units), KITCHEN) == units
