"""FOONs for property tests: a small world, so that units, nodes and goals of different videos often coincide."""

from __future__ import annotations

from hypothesis import strategies as st

from foon_kg.model import (
    UNMEASURED,
    Annotation,
    FunctionalUnit,
    Measures,
    ObjectNode,
    Participant,
    Subgraph,
    Timing,
)

LABELS = ("onion", "salad", "egg", "bowl", "knife", "oil bottle", "crème")
STATES = ("whole", "chopped", "mixed", "clean", "dirty")
FOODS = ("onion", "egg", "salt")
DISHES = ("salad", "omelette", "drinks")

nodes = st.builds(
    ObjectNode,
    st.sampled_from(LABELS),
    st.lists(st.sampled_from(STATES), max_size=2).map(tuple),
    st.lists(st.sampled_from(FOODS), max_size=2).map(tuple),
    st.sampled_from((None, "in", "on")),
    st.sampled_from((None, "bowl", "oil bottle")),
)

participants = st.builds(Participant, nodes, st.booleans(), st.sampled_from((None, None, *DISHES)))

units = st.builds(
    FunctionalUnit,
    st.lists(participants, min_size=1, max_size=3).map(tuple),
    st.sampled_from(("chop", "mix", "pour")),
    st.lists(participants, min_size=1, max_size=2).map(tuple),
    st.booleans(),
)

spans = st.tuples(st.integers(0, 99).map(float), st.integers(100, 200).map(float))

timings = st.builds(Timing, st.lists(spans, max_size=2).map(tuple), st.booleans())

measures = st.just(UNMEASURED) | st.builds(
    Measures,
    st.lists(st.sampled_from(("200 g onion", "3 piece egg", "0.5 teaspoon salt")), max_size=2).map(tuple),
    st.none() | st.sampled_from((0.0, 30.0, 3600.0)),
    st.none() | st.sampled_from((-18.0, 0.0, 165.5)),
)

sources = st.lists(st.sampled_from(("video one", "video two")), max_size=2, unique=True).map(tuple)


def subgraphs_named(name: str) -> st.SearchStrategy[Subgraph]:
    """Subgraphs of one video, down to one without any unit."""
    annotations = st.lists(st.builds(Annotation, units, timings, measures), max_size=3).map(tuple)
    return st.builds(Subgraph, st.just(name), annotations, sources)


@st.composite
def foons(draw: st.DrawFn, names: tuple[str, ...] = ("a", "b", "c")) -> list[Subgraph]:
    """Some of the named videos, sharing units now and then."""
    chosen = draw(st.lists(st.sampled_from(names), min_size=1, unique=True))
    subgraphs = [draw(subgraphs_named(name)) for name in chosen]
    shared = [draw(st.sampled_from(s.annotations)) for s in subgraphs if s.annotations][:2]
    return [Subgraph(s.name, s.annotations + draw(st.sampled_from(((), tuple(shared)))), s.sources) for s in subgraphs]
