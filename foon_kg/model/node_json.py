"""Object nodes, sightings and recipes as the JSON of a plan result has them."""

from __future__ import annotations

from foon_kg.model import UNMEASURED, AskedAmount, Measures, ObjectNode, Recipe, RequiredIngredient, Sighting
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.nodes import one_spelling


def node_to_json(node: ObjectNode) -> JsonObject:
    """Return the five fields of an object node.

    >>> node_to_json(ObjectNode("egg", ("raw",), (), "in", "bowl"))["container"]
    'bowl'
    """
    return {
        "label": node.label,
        "states": list(node.states),
        "ingredients": list(node.ingredients),
        "relation": node.relation,
        "container": node.container,
    }


def node_from_json(fields: Fields) -> ObjectNode:
    """Return the node of the ``fields`` that :func:`node_to_json` wrote.

    >>> egg = ObjectNode("egg", ("raw",), (), "in", "bowl")
    >>> node_from_json(Fields(node_to_json(egg), "node")) == egg
    True
    """
    return ObjectNode(
        fields.text("label"),
        fields.texts("states"),
        fields.texts("ingredients"),
        fields.optional_text("relation"),
        fields.optional_text("container"),
    )


def recipe_to_json(recipe: Recipe) -> JsonObject:
    """Return the ``recipe`` field of a plan result.

    >>> recipe_to_json(Recipe("salad", (RequiredIngredient("onion", "chopped"),)))["ingredients"]
    [{'object': 'onion', 'state': 'chopped'}]
    """
    ingredients = [wanted_to_json(wanted) for wanted in recipe.ingredients]
    return {"id": recipe.id, "title": recipe.title, "dish_type": recipe.dish_type, "ingredients": ingredients}


def wanted_to_json(wanted: RequiredIngredient) -> JsonObject:
    """Return an asked food (``wanted``) with its state; how much and what for only where it says so.

    >>> wanted_to_json(RequiredIngredient("onion", "chopped", "2"))
    {'object': 'onion', 'state': 'chopped', 'amount': '2'}
    """
    told: JsonObject = {"object": wanted.object, "state": wanted.state}
    more = {"amount": wanted.amount, "part": wanted.part}
    return told | {name: value for name, value in more.items() if value}


def recipe_from_json(fields: Fields) -> Recipe:
    """Return the recipe of the ``fields`` that :func:`recipe_to_json` wrote.

    >>> salad = Recipe("salad", (RequiredIngredient("onion", "chopped"),))
    >>> recipe_from_json(Fields(recipe_to_json(salad), "recipe")) == salad
    True
    """
    ingredients = tuple(
        RequiredIngredient(
            i.text("object"), i.text("state"), *(i.text(name) if name in i else "" for name in ("amount", "part"))
        )
        for i in fields.nested_list("ingredients")
    )
    return Recipe(fields.text("dish_type"), ingredients, fields.optional_text("id"), fields.optional_text("title"))


def measures_to_json(measures: Measures) -> JsonObject:
    """Return how much, how long (s) and how hot (°C) ``measures`` say it is; what nobody says is left out.

    >>> measures_to_json(Measures(("200 g flour",), celsius=180))
    {'amounts': ['200 g flour'], 'celsius': 180}
    """
    told: JsonObject = {"amounts": list(measures.amounts)} if measures.amounts else {}
    if measures.seconds is not None:
        told["seconds"] = measures.seconds
    if measures.celsius is not None:
        told["celsius"] = measures.celsius
    if measures.asked:
        told["asked"] = [{"amount": one.amount, "food": one.food} for one in measures.asked]
    return told


def measures_from_json(fields: Fields) -> Measures:
    """Read back what :func:`measures_to_json` wrote, from the field ``measures`` of a unit; none where it has none.

    >>> measures_from_json(Fields({"measures": {"seconds": 60}}, "unit")).seconds
    60.0
    """
    if "measures" not in fields:
        return UNMEASURED
    told = fields.nested("measures")
    return Measures(
        tuple(told.texts("amounts")) if "amounts" in told else (),
        told.optional_number("seconds"),
        told.optional_number("celsius"),
        tuple(AskedAmount(one.text("amount"), one.text("food")) for one in told.nested_list("asked"))
        if "asked" in told
        else (),
    )


def sighting_to_json(sighting: Sighting) -> JsonObject:
    """Return where a unit was seen, a ``sighting``; the place in the video is called ``unit``.

    >>> sighting_to_json(Sighting("greek_salad", 3))["unit"]
    3
    """
    return {
        "video": sighting.video,
        "unit": sighting.position,
        "source": sighting.source,
        "start": sighting.start,
        "end": sighting.end,
    } | ({"measures": measures_to_json(sighting.measures)} if sighting.measures else {})


def sighting_from_json(fields: Fields) -> Sighting:
    """Return the sighting of the ``fields`` that :func:`sighting_to_json` wrote.

    >>> seen = Sighting("greek_salad", 3, None, 5.0, 9.0)
    >>> sighting_from_json(Fields(sighting_to_json(seen), "sighting")) == seen
    True
    """
    return Sighting(
        one_spelling(fields.text("video")),
        fields.whole_number("unit"),
        fields.optional_text("source"),
        fields.optional_number("start"),
        fields.optional_number("end"),
        measures_from_json(fields),
    )
