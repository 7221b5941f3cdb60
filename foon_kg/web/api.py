"""The API and the page as one ASGI application."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Collection, Sequence
from contextlib import asynccontextmanager
from importlib import resources
from pathlib import Path
from typing import Annotated, Any

from fastapi import APIRouter, FastAPI, Query, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse, Response
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.routing import BaseRoute, Route
from starlette.staticfiles import StaticFiles

from foon_kg import __version__
from foon_kg.foon import Substitute
from foon_kg.formats.pictures.svg import dark_colours
from foon_kg.model.errors import FoonError
from foon_kg.web import asking, telling, telling_plans
from foon_kg.web.api_page import api_page
from foon_kg.web.asked_before import AskedBefore, edition_headers, http_response
from foon_kg.web.callers import Callers
from foon_kg.web.explore.cypher import CypherDesk
from foon_kg.web.explore.routes import router as explore_router
from foon_kg.web.limits import BodyLimit, CrowdLimit, Limits, RateLimit
from foon_kg.web.metrics import Metered, Metrics
from foon_kg.web.pages import explore_page, plan_page, teach_page
from foon_kg.web.questions import (
    BusyError,
    ExamplesQuestion,
    InternalError,
    PlanQuestion,
    Question,
    Reply,
    SuggestQuestion,
    TooLongError,
)
from foon_kg.web.security import HEADERS, KnownHosts, SecurityHeaders, TokenRequired
from foon_kg.web.service import FoonService
from foon_kg.web.teach.routes import router as teach_router
from foon_kg.web.watching import router as watching
from foon_kg.web.words import Kind, Words

_REFUSALS: dict[int | str, dict[str, Any]] = {
    400: {"description": "The body cannot be read."},
    401: {"description": "The token is missing or wrong."},
    403: {"description": "Another site's page asks."},
    404: {"description": "There is no tree, no such object."},
    408: {"description": "The body came too slowly."},
    413: {"description": "The body is too large."},
    415: {"description": "The body is not JSON."},
    421: {"description": "The service has another name."},
    422: {"description": "The question cannot be read as asked."},
    429: {"description": "This caller asks too often; see Retry-After."},
    503: {"description": "Too much is asked at once (see Retry-After), or no FOON answers."},
    504: {"description": "The answer takes too long."},
}
REFUSALS = {status: told | {"model": telling.Refusal} for status, told in _REFUSALS.items()}

_NAMES = Query(alias="name", min_length=1, max_length=20, description="Foods, known or not.", examples=[["caper"]])
_LABEL = Query(min_length=1, max_length=asking.MOST_LETTERS, description="An object's name.", examples=["onion"])
_BEGINNING = Query(max_length=asking.MOST_LETTERS, description="What is typed so far.", examples=["chopped on"])
_LIMIT = Query(ge=1, le=50)
_SHOWN_LETTERS = 40  # of a text that is too long
_ROLE = Query(
    alias="as", max_length=40, description="What it does in a dish: liquid, protein, fat …", examples=["liquid"]
)
_INGREDIENTS = Query(
    alias="ingredient",
    min_length=1,
    max_length=asking.MOST_INGREDIENTS,
    description="State first: “chopped onion”.",
    examples=[["diced tomato", "sliced cucumber", "olive oil"]],
)
_AVOIDED = Query(max_length=20, description="Foods or kinds of food (nuts).")
_AT_HAND = Query(max_length=asking.MOST_THINGS, description=asking.AT_HAND)
_UNCHANGED: dict[int | str, dict[str, Any]] = {304: {"description": "The answer is the one of the ETag that was sent."}}

router = APIRouter(prefix="/api", responses=REFUSALS)


def web_app(
    service: FoonService,
    *,
    names: Collection[str],
    public: Collection[str] = (),
    token: str | None = None,
    limits: Limits | None = None,
    callers: Callers | None = None,
    cypher: CypherDesk | None = None,
) -> FastAPI:
    """Return the application that serves ``service`` under the host ``names``; it closes the service at its end.

    Sizes, times and rates are within ``limits``. Under the ``public`` names a proxy serves it; ``callers`` knows which
    proxies are believed to say who asks. With a ``token`` everything below ``/api`` asks for it. With a ``cypher`` desk
    the explorer takes questions in Cypher.
    """
    limits = limits or Limits()
    metrics = Metrics(())
    middleware = [
        Middleware(Metered, metrics=metrics),
        Middleware(SecurityHeaders),
        Middleware(CrowdLimit, limits=limits),
        Middleware(KnownHosts, names=names, public=public),
        Middleware(RateLimit, limits=limits, callers=callers or Callers()),
        *([Middleware(TokenRequired, token=token)] if token else []),
        Middleware(BodyLimit, limits=limits),
        Middleware(AskedBefore, service=service),
    ]
    app = FastAPI(
        title="foon-kg",
        version=__version__,
        description="Task trees for cooking, planned from a functional object-oriented network.",
        openapi_url="/api/openapi.json",
        docs_url=None,  # those pages fetch their program from elsewhere: see _api_described
        redoc_url=None,
        middleware=middleware,
        lifespan=_closing(service),
    )
    app.state.service, app.state.limits, app.state.cypher, app.state.metrics = service, limits, cypher, metrics
    app.include_router(router)
    app.include_router(explore_router, prefix="/api", responses=REFUSALS)
    app.include_router(watching)
    app.add_api_route("/api/docs", _api_described, include_in_schema=False)
    app.include_router(teach_router, prefix="/api", responses=REFUSALS)
    app.add_api_route("/picture.css", _picture_colours, include_in_schema=False)
    app.add_api_route("/stage.js", _stage, include_in_schema=False)
    app.add_api_route("/explore", explore_page, include_in_schema=False)
    app.mount("/explore", StaticFiles(directory=_folder("foon_kg.web.explore")))
    app.add_api_route("/teach", teach_page, include_in_schema=False)
    app.mount("/teach", StaticFiles(directory=_folder("foon_kg.web.teach")))
    app.add_api_route("/", plan_page, methods=["GET", "HEAD"], include_in_schema=False)
    app.mount("/", StaticFiles(directory=_folder("foon_kg.web")))
    metrics.paths = _paths(app.routes, ("", router), ("", watching), ("/api", explore_router), ("/api", teach_router))
    app.add_exception_handler(FoonError, _error_response)
    app.add_exception_handler(RequestValidationError, _invalid)
    app.add_exception_handler(HTTPException, _refused)
    app.add_exception_handler(Exception, _crashed)
    return app


@router.get("/summary")
def summary(request: Request, response: Response) -> telling.Summary:
    """Return how large the FOON is, and its dish types."""
    return telling.Summary.model_validate(_words(request, response).summary())


@router.get("/examples", response_model=telling.Examples)
async def examples(request: Request) -> Response:
    """Return up to six dishes to begin with: what videos of this FOON make, each of which can be planned."""
    return await _reply_to(request, ExamplesQuestion())


@router.get("/complete")
def complete(
    request: Request,
    response: Response,
    text: Annotated[str, _BEGINNING],
    kind: Kind = "ingredient",
    limit: Annotated[int, _LIMIT] = 10,
) -> list[str]:
    """Return the words that ``text`` may become; an ingredient is a state and a food."""
    return _words(request, response).complete(kind, text, limit)


@router.get("/similar")
def similar(
    request: Request,
    response: Response,
    names: Annotated[list[asking.Words], _NAMES],
    limit: Annotated[int, _LIMIT] = 5,
    role: Annotated[str | None, _ROLE] = None,
) -> list[telling.SimilarTold]:
    """Return for each name the known foods that can stand for it, best first; with ``as``, where it plays a role."""
    found = _words(request, response).similar(names, limit, role)
    return [telling.SimilarTold.model_validate(told) for told in found]


@router.get("/object", response_model_exclude_unset=True)
def around(request: Request, response: Response, label: Annotated[str, _LABEL]) -> telling.ObjectTold:
    """Return an object's nodes, the units that make and take it, and the videos it is in."""
    return telling.ObjectTold.model_validate(_words(request, response).around(label))


@router.post("/plan", response_model=telling_plans.PlanTold)
async def plan(request: Request, asked: asking.PlanAsked) -> Response:
    """Plan a dish: the answer is the task tree, with its substitutions and assumptions, and what else is asked."""
    chosen = tuple(Substitute(one.food, one.like) for one in asked.substitutes)
    question = PlanQuestion(
        asked.dish_type,
        tuple(asked.ingredients),
        chosen,
        tuple(asked.avoid),
        tuple(asked.kitchen),
        asked.after,
        with_drafts=asked.with_drafts,
        title=asked.title,
        export=asked.export,
        explain=asked.explain,
        hands=tuple(asked.hands),
        picture_width=asked.picture_width if asked.pictures else None,
    )
    return await _reply_to(request, question)


@router.get("/plan", response_model=telling_plans.PlanTold, responses=_UNCHANGED)
async def plan_again(
    request: Request,
    ingredients: Annotated[list[asking.Words], _INGREDIENTS],
    dish_type: asking.DishType = "",
    avoid: Annotated[list[asking.Words], _AVOIDED] = [],  # noqa: B006 - FastAPI copies it
    kitchen: Annotated[list[asking.Words], _AT_HAND] = [],  # noqa: B006 - the same
    *,
    after: asking.After = "",
    title: asking.Title = "",
    with_drafts: Annotated[bool, Query(description=asking.DRAFTS)] = False,
    explain: bool = False,
) -> Response:
    """Plan a dish as POST does. The answer has an ETag: whoever sends it as If-None-Match is told if it still is so."""
    wanted = tuple(ingredients), (), tuple(avoid), tuple(kitchen)
    question = PlanQuestion(dish_type, *wanted, after, with_drafts=with_drafts, title=title, explain=explain)
    return await _reply_to(request, question)


@router.post("/suggest", response_model=telling.SuggestionsTold)
async def suggest(request: Request, asked: asking.SuggestAsked) -> Response:
    """Name the dishes that the foods at hand make best."""
    return await _reply_to(request, SuggestQuestion(tuple(asked.foods), asked.most, tuple(asked.kitchen)))


async def _reply_to(request: Request, question: Question) -> Response:
    service, limits = _service(request), request.app.state.limits
    try:
        edition, future = await asyncio.to_thread(service.asked, question)
        reply = await asyncio.wait_for(asyncio.shield(asyncio.wrap_future(future)), limits.seconds)
    except TimeoutError as error:
        raise TooLongError(limits.seconds) from error
    service.remember_words(request.scope["words"], question)
    status, headers, body = http_response(reply, edition, request.scope)
    return Response(body, status, headers)


def _words(request: Request, response: Response) -> Words:
    """Return what answers quick questions, and have ``response`` tell of which edition it is."""
    edition = _service(request).current()
    response.headers.update(edition_headers(edition))
    return edition.words


def _service(request: Request) -> FoonService:
    service: FoonService = request.app.state.service
    return service


def _error_response(_: Request, error: Exception) -> Response:
    if not isinstance(error, FoonError):
        raise error
    reply = Reply.of_error(error)
    if isinstance(error, BusyError):
        return Response(reply.body, 503, {"retry-after": "1"}, "application/json")
    return Response(reply.body, reply.status, media_type="application/json")


def _invalid(_: Request, error: Exception) -> Response:
    if not isinstance(error, RequestValidationError):
        raise error
    first = error.errors()[0]
    place, hint = ".".join(map(str, first["loc"])), "See /api/docs."
    message = f"{place}: {first['msg']}"
    if first["type"] == "string_too_long":  # a cook can be told that, too
        message = f"“{first['input'][:_SHOWN_LETTERS]}…” is longer than {first['ctx']['max_length']} characters"
        hint = f"Write it shorter ({place} in the API)."
    told = FoonError(message, hint=hint, code="request")
    return Response(Reply.of_error(told).body, 422, media_type="application/json")


def _refused(_: Request, error: Exception) -> Response:
    if not isinstance(error, HTTPException):
        raise error
    code = {400: "request", 404: "unknown", 405: "method"}.get(error.status_code, "http")
    told = {"code": code, "message": error.detail, "hint": "See /api/docs."}
    return JSONResponse({"error": told}, error.status_code, error.headers)


def _crashed(_: Request, __: Exception) -> Response:
    """Tell nothing of what went wrong inside: that goes to the log. This is sent outside of every middleware."""
    return Response(Reply.of_error(InternalError()).body, 500, HEADERS, "application/json")


def _picture_colours() -> Response:
    return Response(dark_colours(), media_type="text/css")


def _stage() -> Response:
    """Return the program that moves a picture: the page of ``foon show --html`` has the same."""
    program = resources.files("foon_kg.formats.pictures").joinpath("stage.js").read_text(encoding="utf-8")
    return Response(program, media_type="text/javascript")


def _api_described(request: Request) -> Response:
    """Return the page that describes the API: what a browser would have to run for it is against its policy."""
    return Response(api_page(request.app.openapi()), media_type="text/html")


def _folder(package: str) -> Path:
    return Path(str(resources.files(package).joinpath("page")))


def _paths(own: Sequence[BaseRoute], *included: tuple[str, APIRouter]) -> frozenset[str]:
    """Return the paths under which something is answered: by the application's ``own`` routes and what it ``included``.

    That is routers, each below a prefix, which FastAPI does not list among the routes of the application.
    """
    below = {f"{prefix}{one.path}" for prefix, some in included for one in some.routes if isinstance(one, Route)}
    return frozenset({"/", *below, *(one.path for one in own if isinstance(one, Route))})


def _closing(service: FoonService) -> Callable[[FastAPI], Any]:
    @asynccontextmanager
    async def lifespan(_: FastAPI) -> AsyncIterator[None]:
        yield
        await asyncio.to_thread(service.close)

    return lifespan
