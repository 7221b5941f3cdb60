"""``foon serve``: the page and the API."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    import socket

    from foon_kg.web.service import FoonSource

EXAMPLES = examples(
    "foon serve",
    "foon serve --files subgraphs/ --port 8080",
    "foon serve --cypher",
    "foon serve --host 0.0.0.0 --token-file ~/.foon-token",
    "foon serve --name foon.example.org --proxy 127.0.0.1 --token-file token",
)


def serve(  # noqa: PLR0917 - each parameter is an option of its own
    host: Annotated[
        str, typer.Option(metavar="ADDRESS", help="The address to bind to; another than loopback asks for a token.")
    ] = ("127.0.0.1"),
    port: Annotated[int, typer.Option(metavar="N", min=0, max=65535, help="The port; 0 takes a free one.")] = 8000,
    token_file: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Ask who calls the API for the token in this file (made if missing)."),
    ] = None,
    names: Annotated[
        list[str] | None,
        typer.Option("--name", metavar="NAME", help="Also answer under this name: a proxy serves it so. Repeatable."),
    ] = None,
    proxies: Annotated[
        list[str] | None,
        typer.Option(
            "--proxy",
            metavar="ADDRESS",
            help="Believe this proxy (an address or a network) who asks through it. Repeatable.",
        ),
    ] = None,
    cypher: Annotated[
        bool, typer.Option("--cypher", help="Let who may ask also ask the graph in Cypher, on the page /explore.")
    ] = False,
    files: Files = None,
    jobs: Annotated[
        int | None, typer.Option("--jobs", "-j", metavar="N", min=1, help="Plan in N processes; as a rule all cores.")
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Serve a page to plan dishes, and the same as JSON.

    /explore is a picture of the FOON to wander through; with --cypher it takes questions in Cypher that only look. The
    JSON is under /api; /api/docs describes it.

    Only programs on this machine can reach it, unless --host says otherwise; then it asks for the token. The page asks
    for it too, or takes it from the address that is printed. Sizes, times and rates are limited. A graph that somebody
    changes is read anew; it may be empty at first. A proxy that serves it under a name of its own is told with --name,
    and has to bring TLS. All who come through it share one rate, unless --proxy says that what it writes into
    X-Forwarded-For is to be believed.
    """
    from foon_kg.foon import Foon
    from foon_kg.planning.batch import cores
    from foon_kg.planning.processes import collect_often
    from foon_kg.web.api import web_app
    from foon_kg.web.callers import Callers, proxy_network
    from foon_kg.web.connections import server_of
    from foon_kg.web.explore.cypher import CypherDesk
    from foon_kg.web.limits import Limits
    from foon_kg.web.security import own_names, public_name
    from foon_kg.web.service import FoonService

    say = sayer(quiet=quiet)
    public = [public_name(name) for name in names or ()]
    callers = Callers(tuple(map(proxy_network, proxies or ())))
    if cypher and files:
        raise UsageError("files cannot be asked in Cypher", hint="Leave out --cypher, or load them into Neo4j.")
    token = _token(token_file, host, public)
    foon = served_foon(files, say)
    collect_often()
    listener = _listening(host, port)
    address = _address(host, listener) + (f"#token={token}" if token else "")
    print_json({"address": address}) if as_json else say(address)
    limits = Limits()
    service = FoonService(foon, processes=jobs or cores(), most=limits.waiting, seconds=limits.seconds)
    service.summary()  # the processes begin now
    desk = CypherDesk(lambda: Foon.connect(say=say)) if cypher else None
    app = web_app(
        service, names=own_names(host), public=public, token=token, limits=limits, callers=callers, cypher=desk
    )
    server_of(app, limits, callers).run(sockets=[listener])


def _token(file: Path | None, host: str, public: Sequence[str]) -> str | None:
    """Return the token in a file, which is made where it is missing; raises UsageError where there has to be one."""
    from foon_kg.web.security import is_loopback, token_from

    if file is not None:
        return token_from(file.expanduser())
    if public or not is_loopback(host):
        raise UsageError(
            f"anybody could reach {public[0] if public else host}, and there is no token",
            hint="Add --token-file FILE (it is made), or stay with 127.0.0.1 and no --name.",
        )
    return None


def served_foon(files: Sequence[Path] | None, say: Say) -> FoonSource:
    """Return the FOON to serve: of ``files``, else of the environment's Neo4j or the local one, and ``say`` which."""
    from foon_kg.cli.knowledge import front_door
    from foon_kg.foon import Foon
    from foon_kg.web.foon import EMPTY, FixedFoon, LiveFoon

    if files:
        with front_door(files, say) as read:
            return FixedFoon(read.snapshot(), read.lessons())
    foon = LiveFoon(lambda: Foon.connect(say=say))
    if foon.edition() == EMPTY:  # what is wrong is said now, and not to the first who asks
        say("The database holds no FOON yet. Load one: foon load foon PATH…; what is loaded is served at once.")
    return foon


def _address(host: str, listener: socket.socket) -> str:
    name = f"[{host}]" if ":" in host else host
    return f"http://{name}:{listener.getsockname()[1]}/"


def _listening(host: str, port: int) -> socket.socket:
    """Return a socket that listens; raises UsageError where it cannot."""
    import socket

    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family)
    except OSError as error:
        raise UsageError(
            f"{host}:{port} cannot be served: {error.strerror}", hint="Choose another with --port or --host."
        ) from error
