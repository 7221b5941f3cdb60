"""How the service is reached: its address, its names, its token; and what runs behind its socket."""

from __future__ import annotations

import socket
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from foon_kg.foon import Foon
from foon_kg.model.errors import UsageError
from foon_kg.planning.batch import cores
from foon_kg.planning.processes import collect_often
from foon_kg.web.api import web_app
from foon_kg.web.callers import Callers, proxy_network
from foon_kg.web.connections import server_of
from foon_kg.web.explore.cypher import CypherDesk
from foon_kg.web.limits import Limits
from foon_kg.web.security import is_loopback, own_names, public_name, token_from
from foon_kg.web.service import FoonService, FoonSource


@dataclass(frozen=True)
class Reached:
    """Where the service listens (``host``), its ``public`` names, the ``token`` it asks for, and who is believed."""

    host: str
    public: Sequence[str]
    token: str | None
    callers: Callers

    @classmethod
    def at(cls, host: str, names: Sequence[str], proxies: Sequence[str], token_file: Path | None) -> Reached:
        """Return how a service is reached at ``host`` and under ``names``, through ``proxies``.

        The token is that of ``token_file``, which is made where it is missing. Raises UsageError for names and proxies
        that are none, and where others than this machine's programs could ask without a token.
        """
        public = [public_name(name) for name in names]
        callers = Callers(tuple(map(proxy_network, proxies)))
        if token_file is not None:
            return cls(host, public, token_from(token_file.expanduser()), callers)
        if public or not is_loopback(host):
            raise UsageError(
                f"anybody could reach {public[0] if public else host}, and there is no token",
                hint="Add --token-file FILE (it is made), or stay with 127.0.0.1 and no --name.",
            )
        return cls(host, public, None, callers)

    def listening(self, port: int) -> socket.socket:
        """Return a socket that listens at ``port`` (0: a free one); raises UsageError where it cannot."""
        family = socket.AF_INET6 if ":" in self.host else socket.AF_INET
        try:
            return socket.create_server((self.host, port), family=family)
        except OSError as error:
            raise UsageError(
                f"{self.host}:{port} cannot be served: {error.strerror}", hint="Choose another with --port or --host."
            ) from error

    def address(self, listener: socket.socket) -> str:
        """Return the address at which a browser reaches what answers on ``listener``, with the token."""
        name = f"[{self.host}]" if ":" in self.host else self.host
        return f"http://{name}:{listener.getsockname()[1]}/" + (f"#token={self.token}" if self.token else "")


def serve(
    foon: FoonSource,
    reached: Reached,
    port: int,
    announce: Callable[[str], object],
    *,
    jobs: int | None = None,
    asked_in_cypher: Callable[[], Foon] | None = None,
) -> None:
    """Answer questions about ``foon`` at ``port`` (0: a free one) until the program is ended.

    ``announce`` hears the address at which it is ``reached``. Plans are made in ``jobs`` processes, as a rule as many
    as there are cores; who may ask may also ask in Cypher what ``asked_in_cypher`` opens, if that is given. Raises
    UsageError where nothing can listen there.
    """
    collect_often()
    listener = reached.listening(port)
    announce(reached.address(listener))
    limits = Limits()
    service = FoonService(foon, processes=jobs or cores(), most=limits.waiting, seconds=limits.seconds)
    service.summary()  # the processes begin now
    app = web_app(
        service,
        names=own_names(reached.host),
        public=reached.public,
        token=reached.token,
        limits=limits,
        callers=reached.callers,
        cypher=None if asked_in_cypher is None else CypherDesk(asked_in_cypher),
    )
    server_of(app, limits, reached.callers).run(sockets=[listener])
