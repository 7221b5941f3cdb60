"""The API of the explorer: search, what is around a thing, the shortest way of a food, questions in Cypher."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated

from fastapi import APIRouter, Query, Request

from foon_kg.cypher import explore_queries
from foon_kg.web.asking import MOST_LETTERS
from foon_kg.web.explore.about import places_of
from foon_kg.web.explore.answers import drawn
from foon_kg.web.explore.asking import AroundAsked, CypherAsked, WayAsked
from foon_kg.web.explore.cypher import CypherDesk, NoCypherError
from foon_kg.web.explore.explorer import Explorer
from foon_kg.web.explore.network import Thing, ThingKind
from foon_kg.web.explore.telling import (
    AnswerTold,
    BeginTold,
    NeighbourhoodTold,
    QuestionsTold,
    QuestionTold,
    StepTold,
    StopTold,
    WayTold,
)

_TEXT = Query(max_length=MOST_LETTERS, description="What is typed so far.", examples=["chopped on"])
_KINDS = Query(alias="kind", max_length=7, description="Only things of these kinds.")
_LIMIT = Query(ge=1, le=50)
_BEGIN: dict[ThingKind, int] = {"food": 4, "utensil": 1, "motion": 2, "dish": 2, "video": 1}
"""Of which kinds how many things are told to begin with."""

router = APIRouter(prefix="/explore")


@router.get("/search")
def search(
    request: Request,
    text: Annotated[str, _TEXT],
    kinds: Annotated[list[ThingKind] | None, _KINDS] = None,
    limit: Annotated[int, _LIMIT] = 12,
) -> list[Thing]:
    """Return the foods, utensils, motions, videos, dish types and objects that ``text`` may become, best first."""
    explorer = _explorer(request)
    return _told(explorer, explorer.search.find(text, kinds or (), limit))


@router.get("/begin")
def begin(request: Request) -> BeginTold:
    """Return the videos, motions and dish types to filter by, and some things that take part in much to begin with."""
    network = _explorer(request).network
    return BeginTold(
        videos=list(network.names("video")),
        motions=list(network.names("motion")),
        dish_types=list(network.names("dish")),
        begin=_told(_explorer(request), network.largest(_BEGIN)),
    )


@router.post("/around")
def around(request: Request, asked: AroundAsked) -> NeighbourhoodTold:
    """Return what is around a thing, never more than asked, and what the thing is."""
    explorer = _explorer(request)
    found = explorer.neighbours.around(asked.id, asked.filters(), depth=asked.depth, most=asked.most, shown=asked.shown)
    return NeighbourhoodTold(
        things=_told(explorer, found.things),
        edges=list(found.edges),
        more=found.more,
        about=explorer.telling.about(found.things[0]),
    )


@router.post("/way")
def way(request: Request, asked: WayAsked) -> WayTold:
    """Return the shortest way of a food from one state to another: over the food, not over knives and bowls."""
    explorer = _explorer(request)
    network, found = explorer.network, explorer.ways.shortest(asked.start, asked.end, asked.filters())
    stops = [network.thing(f"object:{stop.node.key}") for stop in found.stops]
    steps = [network.thing(f"step:{known.unit.key}") for known in found.steps]
    return WayTold(
        stops=[
            StopTold(thing=thing, name=stop.name)
            for thing, stop in zip(_told(explorer, stops), found.stops, strict=True)
        ],
        steps=[
            StepTold(thing=thing, places=list(places_of(known.seen_in)))
            for thing, known in zip(_told(explorer, steps), found.steps, strict=True)
        ],
        edges=list(explorer.neighbours.edges({t.id for t in (*stops, *steps)})),
    )


@router.get("/questions")
def questions(request: Request) -> QuestionsTold:
    """Return the questions in Cypher that come with foon-kg, and whether this service takes any."""
    ours = (
        QuestionTold(
            name=query.name,
            answers=query.answers,
            text=query.statement,
            parameters=query.parameters,
            examples=query.defaults | query.examples,
        )
        for query in explore_queries()
    )
    return QuestionsTold(allowed=request.app.state.cypher is not None, questions=list(ours))


@router.post("/cypher")
def cypher(request: Request, asked: CypherAsked) -> AnswerTold:
    """Return the answer to a question in Cypher: a table, and what of it can be drawn. Refused is all but a look."""
    desk: CypherDesk | None = request.app.state.cypher
    if desk is None:
        raise NoCypherError
    answer = desk.ask(asked.text, asked.parameters, asked.limit)
    if request.app.state.service.current().explorer is None:  # a table is told, and nothing is drawn
        return AnswerTold(columns=list(answer.columns), rows=answer.plain_rows(), cut=answer.cut, things=[], edges=[])
    explorer = _explorer(request)
    found = drawn(answer, explorer.network)
    known = explorer.neighbours.edges({thing.id for thing in found.things if thing.kind != "other"})
    return AnswerTold(
        columns=list(answer.columns),
        rows=answer.plain_rows(),
        cut=answer.cut,
        things=_told(explorer, found.things),
        edges=list(dict.fromkeys((*found.edges, *known))),
    )


def _told(explorer: Explorer, things: Iterable[Thing]) -> list[Thing]:
    return [explorer.telling.in_words(thing) for thing in things]


def _explorer(request: Request) -> Explorer:
    explorer: Explorer = request.app.state.service.explorer()
    return explorer
