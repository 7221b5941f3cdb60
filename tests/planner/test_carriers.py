"""Foods that join a tree by a step of their own (foon_kg.carriers)."""

from __future__ import annotations

import pytest
from kitchen_stories import node, script

from foon_kg.carriers import Carrier, Carriers
from foon_kg.kitchen import Kitchen

KITCHEN = Kitchen.default()
SPRINKLE = "shaker{salt}; salt(granulated)@in shaker; bowl{egg} > sprinkle > bowl{egg,salt}; shaker{salt}"
POUR = "cup{salt}; salt(granulated)@in cup; bowl{egg} > pour > bowl{egg,salt}; cup(empty)"


def unlike(_one, _other):
    return 0.0


def carrier(text):
    return Carrier.of(script(text)[0], KITCHEN)


class TestWhatIsACarrier:
    def test_one_food_that_comes_into_a_vessel(self):
        found = carrier(SPRINKLE)
        assert (found.food, found.vessel, found.tools) == (node("salt(granulated)@in shaker"), node("bowl{egg}"), ())

    def test_a_spoon_that_stays_as_it_is(self):
        assert carrier("sugar; spoon; bowl > scoop and pour > bowl{sugar}; spoon").tools == (node("spoon"),)

    @pytest.mark.parametrize(
        "text",
        [
            "salt; pepper; bowl > pour > bowl{pepper,salt}",  # two foods
            "salt; bowl{egg} > mix > bowl{egg,salt}",  # that does more than bring it
            "salt; pan{egg} > cook > pan{egg,salt}",
            "salt; bowl{egg,salt} > pour > bowl{egg,salt}",  # it was there
            "salt; bowl > pour > bowl(dirty){salt}",  # the vessel is another
            "salt; bowl; fork > pour > bowl{salt}; fork(bent)",  # so is the fork
            "salt; bowl > pour > bowl{salt}; sauce@in bowl",  # and something else is made
        ],
    )
    def test_what_does_more_or_less_than_that(self, text):
        assert carrier(text) is None


class TestWhichIsBest:
    def best(self, food, vessel, *lines, like=unlike):
        found = Carriers.of(script(*lines), KITCHEN).best(node(food), node(vessel), like)
        return found and found.known.unit.motion

    def test_the_motion_most_usual_for_the_food(self):
        more = SPRINKLE.replace("egg", "leek")
        assert self.best("salt(granulated)", "bowl{tomato}", SPRINKLE, POUR, more) == "sprinkle"
        assert (
            self.best(
                "salt(granulated)",
                "bowl{tomato}",
                SPRINKLE,
                POUR,
                POUR.replace("egg", "leek"),
                POUR.replace("egg", "oat"),
            )
            == "pour"
        )

    def test_only_into_the_same_vessel_in_the_same_state_and_place(self):
        assert self.best("salt(granulated)", "bowl(empty)", SPRINKLE) == "sprinkle"
        assert self.best("salt(granulated)", "pan{egg}", SPRINKLE) is None
        assert self.best("salt(granulated)", "bowl(hot){egg}", SPRINKLE) is None
        assert self.best("salt(granulated)", "bowl{egg}@on stove", SPRINKLE) is None

    def test_a_food_that_is_like_it_or_in_the_same_state_shows_how(self):
        assert self.best("pepper(ground)", "bowl{egg}", SPRINKLE) is None
        assert self.best("pepper(granulated)", "bowl{egg}", SPRINKLE) == "sprinkle"
        assert self.best("pepper(ground)", "bowl{egg}", SPRINKLE, like=lambda *_: 0.8) == "sprinkle"

    def test_where_no_more_may_enter_nothing_is_carried(self):
        assert self.best("salt(granulated)", "bowl{egg}", SPRINKLE.replace("sprinkle", "scrape")) is None

    def test_from_the_same_place_it_would_need_the_same_vessel(self):
        assert self.best("salt(granulated)@in shaker", "bowl{egg}", SPRINKLE) is None
