"""What of a recorded dish recipes are compared with: worked out once for every question."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

from foon_kg.food import Food, Tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.goals.asked import CARRIES, SEASONS
from foon_kg.integration.joining.batters import is_thin
from foon_kg.integration.joining.layouts import Layout
from foon_kg.integration.joining.spots import Spot
from foon_kg.integration.teaching.frames import Frame

_MOST_KEPT = 2048
"""For how many dishes this is kept: all of an annotated FOON (111 videos have 106 goals), a bound for a drafted one."""

_MOSTLY = 0.6
"""A dish of whose foods this share is what dressings are made of is a dressing."""


@lru_cache(maxsize=_MOST_KEPT)
def recorded(layout: Layout, known: Tables) -> Recorded:
    """Return what recipes are compared with of the dish of ``layout``, read by the tables ``known``."""
    return Recorded(layout, known)


@dataclass(frozen=True, eq=False)
class Recorded:
    """A recorded dish: how it is called, what is in it, and what is done to it."""

    layout: Layout
    known: Tables

    @property
    def frame(self) -> Frame:
        """How the dish is made."""
        return self.layout.frame

    @property
    def label(self) -> str:
        """How the dish is called."""
        return self.layout.frame.goal.label

    @cached_property
    def words(self) -> tuple[str, ...]:
        """The words by which it is called."""
        return words(self.label)

    @cached_property
    def type_words(self) -> frozenset[str]:
        """The words of its dish type."""
        return frozenset(words(self.frame.dish_type))

    @cached_property
    def foods(self) -> tuple[Food, ...]:
        """What is known of the foods of its slots, in their states."""
        return tuple(self.known.foods.food(slot.food, slot.states) for slot in self.frame.line.all_slots())

    @cached_property
    def food_names(self) -> frozenset[str]:
        """The names of the foods of its slots."""
        return frozenset(slot.food for slot in self.frame.line.all_slots())

    @cached_property
    def built_on(self) -> tuple[int, ...]:
        """The slots of what it is built on, by identity."""
        slots = zip(self.frame.line.all_slots(), self.foods, strict=True)
        return tuple(id(slot) for slot, food in slots if food.is_any(CARRIES))

    @cached_property
    def beside(self) -> tuple[int, ...]:
        """The slots of its other foods but seasonings, by identity."""
        slots = zip(self.frame.line.all_slots(), self.foods, strict=True)
        return tuple(id(slot) for slot, food in slots if not food.is_any(CARRIES) and not food.is_any(SEASONS))

    @cached_property
    def work_done(self) -> frozenset[str]:
        """What is done to it; ``fat`` and ``liquid`` where it is heated with such."""
        found = set().union(*(spot.stage.does for spot in self.layout.spots))
        if self.layout.heats:
            found |= {"fat" for food in self.foods if food.is_a("fat")}
            found |= {"liquid" for food in self.foods if food.is_a("liquid", "water")}
        return frozenset(found)

    @cached_property
    def named_foods(self) -> tuple[tuple[str, str], ...]:
        """The words of its name that the tables list as foods, each with its kind: (tomato, vegetable)."""
        foods = self.known.foods
        return tuple((word, foods.food(word).kind) for word in self.words if foods.is_listed(word))

    @cached_property
    def promised(self) -> tuple[str, ...]:
        """The foods that its name promises, but those that its dish type or a dish in its name stands for (egg salad).

        What is made on the way (dough, a sauce) is no promise of a food.
        """
        met = {word for dish in self.known.dishes_named(self.label) for word in words(dish.name)} | self.type_words
        foods = self.known.foods
        named = (word for word in self.words if word not in met and foods.is_listed(word))
        return tuple(word for word in named if not foods.food(word).is_a("made", "dough"))

    @cached_property
    def damaged(self) -> bool:
        """Whether something stays raw, half of the goal was lost, or the video ends before the dish is done.

        Such a frame is still worth something (:mod:`~foon_kg.goals.score`): it may be the only one of its dish type.
        """
        goal = self.frame.goal
        ends_early = says(goal.states, "is not done")
        return self.layout.raw or ends_early or 2 * len(self.frame.weak) >= len(goal.ingredients) > 0

    @cached_property
    def heats(self) -> bool:
        """Whether anything of it is heated or warmed."""
        return any(spot.stage.heats for spot in self.layout.spots)

    @cached_property
    def bakes(self) -> bool:
        """Whether anything of it is heated with dry heat."""
        hot = [spot.stage for spot in self.layout.spots if "heat" in spot.stage.does]
        return any("dry" in stage.does or stage.appliance in {"oven", "microwave"} for stage in hot)

    @cached_property
    def in_oven(self) -> bool:
        """Whether anything of it is heated in an oven."""
        stages = (spot.stage for spot in self.layout.spots)
        return any(stage.appliance == "oven" and "heat" in stage.does for stage in stages)

    @cached_property
    def cooks_foods(self) -> bool:
        """Whether a food of it is cooked by itself before it joins."""
        return any(slot.cooked for slot in self.frame.line.all_slots())

    @cached_property
    def ends_raw(self) -> bool:
        """Whether it is kneaded or shaped, and never heated as a whole: its video ends with balls of raw dough."""
        main = [spot for spot in self.layout.spots if not spot.side]
        worked = any(spot.stage_type.work in {"knead", "shape"} for spot in main)
        return worked and not any("heat" in spot.stage.does for spot in main)

    @cached_property
    def worked_cold(self) -> tuple[Spot, ...]:
        """The stages at which it is kneaded or shaped, and not heated."""
        return tuple(
            spot
            for spot in self.layout.spots
            if spot.stage_type.work in {"knead", "shape"} and "heat" not in spot.stage.does
        )

    @cached_property
    def sets_cold(self) -> bool:
        """Whether it sets in the cold at last."""
        return self.layout.spots[-1].stage.motion in word_list("sets in the cold")

    @cached_property
    def blends_beside(self) -> bool:
        """Whether a machine makes a part of a hot dish, by which that is called: a pesto."""
        return self.layout.heats and any(spot.side and "blend" in spot.stage.does for spot in self.layout.spots)

    @cached_property
    def is_stacked(self) -> bool:
        """Whether its type or name says that it is put together on bread."""
        return any(dish.stacked for dish in self.known.dishes_named(self.frame.dish_type, self.label))

    @cached_property
    def makes_dough(self) -> bool:
        """Whether it bakes a dough that is mixed at once."""
        tin = any(dish.tin for dish in self.known.dishes_named(self.frame.dish_type))
        return tin and self.layout.batter is None and any(food.is_a("flour") for food in self.foods)

    @cached_property
    def mixed_in_bowl(self) -> bool:
        """Whether it makes its batter in a bowl."""
        return self.layout.batter is not None and self.layout.batter.fat.stage.vessel == "bowl"

    @cached_property
    def watered(self) -> bool:
        """Whether it makes a batter with water."""
        return self.layout.batter is not None and is_thin(self.layout.batter)

    @cached_property
    def cut_when_baked(self) -> bool:
        """Whether it is cut in what it is baked in."""
        cut = (spot for spot in self.layout.spots if "cut" in spot.stage.does and not spot.side)
        rows = [self.known.utensil(spot.stage.vessel) for spot in cut]
        return any(row is not None and "bake" in row.can for row in rows)

    @cached_property
    def only_poured(self) -> bool:
        """Whether it is a dressing and nothing else: of little but what dressings are made of, and called no salad."""
        if any(dish.dressed for dish in self.known.dishes_named(self.label)):
            return False
        parts = [food.is_a("herb", *word_list("is poured over")) for food in self.foods]
        return sum(parts) >= _MOSTLY * len(parts)

    @cached_property
    def heats_base_alone(self) -> bool:
        """Whether what a stacked dish is stacked on is heated before anything is laid on it."""
        there: list[Food] = []
        for spot in self.layout.spots:
            if spot.side:
                continue
            if spot.stage.lines:
                return False  # more than the base is there by now
            foods = (self.known.foods.food(slot.food) for slot in spot.stage.slots)
            there += [food for food in foods if not food.is_a("fat")]
            if there and spot.stage.heats:
                return all(food.is_any(word_list("carries what is stacked")) for food in there)
        return False
