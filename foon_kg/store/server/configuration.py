"""The configuration of the local Neo4j: loopback only, bounded, closed to the outside."""

from __future__ import annotations

import secrets

from foon_kg.model.kept import write_private
from foon_kg.store.disk import explain_os_error
from foon_kg.store.server.home import Home
from foon_kg.store.server.reach import HOST

PAGE_CACHE = "512m"


def neo4j_conf(port: int) -> str:
    """Return the text of ``neo4j.conf`` for a server that answers Bolt on ``port`` of the loopback interface."""
    settings = {
        "server.default_listen_address": HOST,
        "server.default_advertised_address": HOST,
        "server.bolt.enabled": "true",
        "server.bolt.listen_address": f"{HOST}:{port}",
        "server.bolt.advertised_address": f"{HOST}:{port}",
        "server.http.enabled": "false",
        "server.https.enabled": "false",
        "dbms.security.auth_enabled": "true",
        "server.memory.pagecache.size": PAGE_CACHE,
        # What a question could reach outside the graph although it only reads.
        "dbms.security.allow_csv_import_from_file_urls": "false",
        "internal.dbms.cypher_ip_blocklist": "0.0.0.0/0,::/0",
        "dbms.usage_report.enabled": "false",
        # Else a statement is planned once more for each size of its lists, in tens, hundreds, thousands: loads of one
        # video and of thousands would share no plan.
        "internal.cypher.use_parameter_size": "false",
        # A question is ended so soon after its time limit.
        "db.transaction.monitor.check.interval": "200ms",
        "server.config.strict_validation.enabled": "true",
        # Without it every stop waits ten seconds for idle Bolt threads.
        "internal.server.bolt.thread_pool_shutdown_wait_time": "200ms",
        # One machine, one user: a few recent transaction logs are enough to recover from a crash.
        "db.tx_log.rotation.retention_policy": "64M size",
        "db.tx_log.rotation.size": "32m",
    }
    head = "# Written by foon-kg at every start: changes made here are lost.\n"
    return head + "".join(f"{name}={value}\n" for name, value in settings.items())


def write_configuration(home: Home, port: int) -> None:
    """Put the neo4j.conf of a server on ``port`` where the server of ``home`` looks for it."""
    with explain_os_error(f"cannot write {home.configuration}"):
        write_private(home.configuration / "neo4j.conf", neo4j_conf(port))


def new_password() -> str:
    """Return a random password of 192 bits."""
    return secrets.token_hex(24)  # one that begins with "-" would be an option to the admin command
