"""Task trees whose names hold everything that some format takes for its own marks."""

from __future__ import annotations

from hypothesis import strategies as st

from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import FunctionalUnit, ObjectNode, Participant, Recipe, Sighting
from foon_kg.model.tree import Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult, ReferenceSummary

ODD = (
    "crème fraîche", "焼き豆腐", "a \"b\" 'c'", "<b>&amp;</b>", "x;y,z:(w)", "{in} [out]", "%25 \\n \\", "end", "n1",
    "a#b|c`d`", "$x", "{bowl}", "1. *", "]]>", "-- -->",
)  # fmt: skip
"""Names as a FOON may have them: without control characters."""

names = st.one_of(
    st.sampled_from(("onion", "bowl", "knife", "salt", *ODD)),
    st.text("aé焼 \"'<>&;:,(){}[]%#|`$\\*_-.!", min_size=1, max_size=4).filter(str.strip),
)

nodes = st.builds(
    ObjectNode,
    names,
    st.lists(names, max_size=2).map(tuple),
    st.lists(names, max_size=2).map(tuple),
    st.one_of(st.none(), names),
    st.one_of(st.none(), names),
)


@st.composite
def units(draw, pool=nodes):
    side = st.lists(st.builds(Participant, pool, st.booleans()), min_size=1, max_size=3).map(tuple)
    return FunctionalUnit(draw(side), draw(names), draw(side), draw(st.booleans()))


@st.composite
def plans(draw):
    """Plan results over few nodes, so that units often make what others take; some can be executed, most cannot."""
    pool = st.sampled_from(draw(st.lists(nodes, min_size=3, max_size=6, unique=True)))
    seen = Sighting(draw(names), 3, draw(st.one_of(st.none(), names)), draw(st.sampled_from((None, 0.0, 70.5))))
    planned = [Step.of_unit(unit, "foon", (seen,)) for unit in draw(st.lists(units(pool), min_size=1, max_size=4))]
    goal = draw(st.sampled_from(planned[-1].output_nodes))
    kitchen = tuple(draw(st.lists(pool, unique=True)))
    recipe = Recipe("salad", (), title=draw(st.one_of(st.none(), names)))
    return PlanResult(recipe, ReferenceSummary(goal, 1, 0, exact=True), goal, tuple(planned), kitchen)


trees = st.one_of(plans().map(ExportedTree.of_plan), plans().map(lambda plan: of_file(plan.to_subgraph())))
"""The same trees once as plan results, once as a FOON file tells them."""


def of_file(subgraph):
    """Return the tree of a FOON file."""
    return ExportedTree.of_subgraph(subgraph, Kitchen.default())
