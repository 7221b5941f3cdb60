"""For who keeps the service running: whether it can answer, and what was counted. No cook asks this."""

from __future__ import annotations

import asyncio

from fastapi import APIRouter, Request
from fastapi.responses import JSONResponse, Response

from foon_kg import __version__
from foon_kg.web.metrics import CONTENT_TYPE, Metrics

HEALTH, METRICS = "/health", "/metrics"

router = APIRouter(include_in_schema=False)


@router.get(HEALTH)
async def health(request: Request) -> Response:
    """Return ``ok`` where the service can plan; raises what every other question raises where it has no FOON."""
    await asyncio.to_thread(request.app.state.service.current)
    return JSONResponse({"status": "ok"})


@router.get(METRICS)
def metrics(request: Request) -> Response:
    """Return what was counted since the service began, in the text format of Prometheus."""
    counted: Metrics = request.app.state.metrics
    service = request.app.state.service
    edition, kept = service.standing()
    size = edition.words.size if edition else None
    beside = {
        "foon_ready": ("Whether a FOON is there to answer from.", float(edition is not None)),
        "foon_units": ("Units of the FOON.", float(size.units if size else 0)),
        "foon_videos": ("Videos of the FOON.", float(size.videos if size else 0)),
        "foon_answers_kept": ("Answers that are kept for who asks the same again.", float(kept)),
    }
    labels = {"version": __version__, "edition": edition.name if edition else ""}
    return Response(counted.text(beside, labels), media_type=CONTENT_TYPE)
