"""A small Maven repository on the loopback interface that can be told to misbehave."""

from __future__ import annotations

import hashlib
import threading
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

from foon_kg.store.server.jars import Jar, JarSet


@dataclass
class MavenRepository:
    """Serves jars; records the first byte of every request, and breaks off or lies as ``cut``, ``wrong`` etc. say."""

    contents: dict[str, bytes] = field(default_factory=dict)
    requests: list[tuple[str, int]] = field(default_factory=list)
    cut: dict[str, int] = field(default_factory=dict)  # path: bytes sent before the connection ends, once
    stall: threading.Event | None = None  # after half a file wait for this
    understands_ranges: bool = True
    address: str = ""

    def jar(self, artifact: str, content: bytes) -> Jar:
        """Add a jar and return what a pinned set says of it."""
        jar = Jar(f"org.example:{artifact}:1.0", len(content), hashlib.sha256(content).hexdigest())
        self.contents[f"/{jar.path}"] = content
        return jar

    def jar_set(self, count: int, size: int = 5_000) -> JarSet:
        """Add ``count`` jars of different content."""
        return JarSet("1.0", tuple(self.jar(f"part{n}", bytes([n]) * (size + n)) for n in range(count)))

    def first_bytes_asked(self, jar: Jar) -> list[int]:
        """Return where the requests for this jar began, in order."""
        return [start for path, start in self.requests if path == f"/{jar.path}"]


def serve(repository: MavenRepository) -> ThreadingHTTPServer:
    """Serve the repository from a thread; the caller shuts the server down."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_GET(self):
            content = repository.contents.get(self.path)
            if content is None:
                self.send_error(404)
                return
            asked = self.headers.get("Range")
            start = int(asked.removeprefix("bytes=").rstrip("-")) if asked and repository.understands_ranges else 0
            repository.requests.append((self.path, start))
            self.send_response(206 if start else 200)
            self.send_header("Content-Length", str(len(content) - start))
            self.end_headers()
            self._send(content[start:])

        def _send(self, body):
            limit = repository.cut.pop(self.path, None)
            if limit is not None:
                self.wfile.write(body[:limit])
                self.close_connection = True
            elif repository.stall:
                self.wfile.write(body[: len(body) // 2])
                self.wfile.flush()
                repository.stall.wait()
                self.close_connection = True
            else:
                self.wfile.write(body)

        def log_message(self, *_):
            """Keep the output of the tests readable."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    repository.address = f"http://127.0.0.1:{server.server_port}"
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server
