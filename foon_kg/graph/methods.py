"""Operators and frames out of the rows of the graph: they answer as those that are learnt in memory."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from itertools import chain

from foon_kg.food import tables
from foon_kg.graph.frame_rows import frame_of
from foon_kg.graph.lifting import ANYTHING, KIND
from foon_kg.graph.rows import EvidenceValue, MethodsRow
from foon_kg.integration.methods import Methods
from foon_kg.integration.operators import Evidence, Operators, Way
from foon_kg.integration.places import Post, Posts
from foon_kg.model import Goal, Sighting


def methods_of(row: MethodsRow, goals: Iterable[Goal]) -> Methods:
    """Answer what was learnt of a FOON."""
    frames = sorted(map(frame_of, row.frames), key=lambda frame: (frame.video, frame.goal.sort_key, frame.dish_type))
    methods = Methods(operators_of(row), tuple(frames), tuple(goals))
    vars(methods)["posts"] = posts_of(row)  # they were counted when the frames were learnt
    return methods


def operators_of(row: MethodsRow) -> Operators:
    """Answer the operators, with the evidence that ``row`` has."""
    found = Operators((), tables())
    sightings = _sightings_of(chain.from_iterable(row.evidence))
    ways: list[Way] = [(motion, tuple(tools)) for motion, tools in row.operators]
    for way, evidence, appliances in zip(ways, row.evidence, row.appliances, strict=True):
        for matter, units, changed, seen, changes in evidence:
            _attest(found.evidence[way], matter, units, [sightings[text] for text in seen])
            if changed:
                _attest(found.acts[way], matter, changed, [sightings[text] for text in changes])
        found.evidence[way].appliances.update(dict(appliances))
        found.foods |= found.evidence[way].foods.keys()
    for way, gives, brings, places in zip(ways, row.gives, row.brings, row.places, strict=True):
        for state, count in gives:
            found.giving[state][way] = count
        for matter, role, count in brings:
            found.bringing[matter, role][way] = count
        if places:
            found.onto[way].update(dict(places))
    for matter, states in row.states:
        found.states[matter].update(states)
    return found


def _sightings_of(evidence: Iterable[EvidenceValue]) -> dict[str, Sighting]:
    """Answer each sighting that is named by its text: many are named again and again."""
    texts = list(dict.fromkeys(text for _, _, _, seen, changes in evidence for text in (*seen, *changes)))
    values = json.loads(f"[{','.join(texts)}]")
    return {text: Sighting(*value) for text, value in zip(texts, values, strict=True)}


def _attest(evidence: Evidence, matter: str, units: int, seen: Sequence[Sighting]) -> None:
    if matter == ANYTHING:
        evidence.count = units
        evidence.all.extend(seen)
    elif matter.startswith(KIND):
        evidence.kinds[matter.removeprefix(KIND)].extend(seen)
    else:
        evidence.often[matter] = units
        evidence.foods[matter].extend(seen)


def posts_of(row: MethodsRow) -> Posts:
    """Answer where foods of each kind join, from the counts of the graph."""
    posts = Posts((), tables())
    for kind, dish_type, work, heated, joins, count in row.posts:
        post: Post = (work, heated, joins)
        for name in posts.names(kind.removeprefix(KIND)):
            for dish in (dish_type, ""):
                for counter, value in zip(posts.counts[name, dish], post, strict=True):
                    counter[value] += count
    for kind, other, count in row.beside:
        posts.beside[kind.removeprefix(KIND)][other.removeprefix(KIND)] += count
    for kind, motion, count in row.cooked:
        for name in posts.names(kind.removeprefix(KIND)):
            posts.cooked[name][motion] += count
    return posts
