"""What is asked of the API, typed and bounded: the OpenAPI document is made from this."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from foon_kg.model import DISH_TYPES

# far more than recipes and kitchens have: what is larger was not written by a cook, and would only take time
MOST_INGREDIENTS = 60
MOST_THINGS = 200
MOST_LETTERS = 100

DishType = Literal[(*DISH_TYPES, "")]  # type: ignore[valid-type] # the 30 names, and "" for any
_WORDS = r"^[^\x00-\x1f\x7f]*[^\s\x00-\x1f\x7f,][^\x00-\x1f\x7f]*$"
Words = Annotated[str, Field(min_length=1, max_length=MOST_LETTERS, pattern=_WORDS)]

AT_HAND = (
    "What is at hand: “knife”, “oven, preheated”, “chopped onion”, “egg in carton”. Naming utensils says that there "
    "are no others, and so with foods; of a kind that is not named everything is there."
)
After = Annotated[
    str,
    Field(
        max_length=MOST_LETTERS,
        pattern=r"^[^\x00-\x1f\x7f]*$",
        description="The recorded dish, or the video, to make it after; empty for the one that suits best.",
    ),
]
Title = Annotated[
    str,
    Field(
        max_length=MOST_LETTERS,
        pattern=r"^[^\x00-\x1f\x7f]*$",
        description="What the dish is called, which is read: a creamy soup is blended, a lasagna laid in layers.",
    ),
]
EXPORT = (
    "Also answer the plan as files of this format: foon, json, dot, mermaid, graphml, markdown, behaviour-tree, pddl."
)
AVOIDED = (
    "Foods or kinds of food (nuts) to leave out; of the usual allergens (egg, gluten) what is as a rule made with them."
)
DRAFTS = "Plan after dishes, too, that were only drafted from the words of recipes."
Pairs = Annotated[int, Field(ge=1, le=4)]
Kitchen = Annotated[list[Words], Field(max_length=MOST_THINGS, description=AT_HAND, examples=[[]])]


class Asked(BaseModel):
    """A body that is sent: a field that it does not have is an error."""

    model_config = ConfigDict(extra="forbid", strict=True)


class SubstituteAsked(Asked):
    """Handle this food like one that the FOON knows."""

    food: Words = Field(examples=["kohlrabi"])
    like: Words = Field(examples=["carrot"])


class PlanAsked(Asked):
    """A dish to be planned."""

    dish_type: DishType = Field("", description="Empty for the one most like these ingredients.", examples=["salad"])
    ingredients: list[Words] = Field(
        min_length=1,
        max_length=MOST_INGREDIENTS,
        description="State first: “chopped onion”.",
        examples=[["diced tomato", "sliced cucumber", "olive oil"]],
    )
    substitutes: list[SubstituteAsked] = Field([], max_length=MOST_INGREDIENTS, examples=[[]])
    avoid: list[Words] = Field([], max_length=20, description=AVOIDED, examples=[[]])
    kitchen: Kitchen = []
    after: After = ""
    title: Title = ""
    with_drafts: bool = Field(default=False, description=DRAFTS)
    export: str = Field("", max_length=40, description=EXPORT, examples=["markdown"])
    explain: bool = Field(default=False, description="Also answer why each ingredient is made as it is.")
    hands: list[Pairs] = Field(
        [], max_length=4, description="Also answer a schedule for each of these pairs of hands.", examples=[[1, 2]]
    )
    pictures: bool = Field(default=False, description="Also answer tree, progress lines and schedules as SVG.")
    picture_width: int = Field(1180, ge=280, le=4000, description="How wide all but the tree are, in pixels.")


class SuggestAsked(Asked):
    """Foods at hand; ``kitchen`` names what else is there."""

    foods: list[Words] = Field(min_length=1, max_length=MOST_INGREDIENTS, examples=[["egg", "chopped onion"]])
    most: int = Field(5, ge=1, le=20)
    kitchen: Kitchen = []
