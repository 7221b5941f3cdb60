"""Who asks: the address of a caller, also behind proxies that are trusted to tell it."""

from __future__ import annotations

from dataclasses import dataclass
from ipaddress import (
    IPv4Address,
    IPv4Network,
    IPv6Address,
    IPv6Network,
    ip_address,
    ip_network,
)

from starlette.datastructures import Headers
from starlette.types import Scope

from foon_kg.model.errors import UsageError

Address = IPv4Address | IPv6Address
Network = IPv4Network | IPv6Network

TOLD_BY_PROXIES = "x-forwarded-for"
_OF_ONE_LINE = 64
"""Who has one IPv6 address has all that begin with the same so many bits, and is one caller with all of them."""


@dataclass(frozen=True)
class Callers:
    """Tells callers apart by their addresses.

    What a request itself says of where it comes from counts only as far as ``proxies`` wrote it: each adds the address
    that it was asked from at the end of ``X-Forwarded-For``, so that the last one there that is no proxy's is the
    caller's, whatever the caller wrote before it. With no proxies (as a rule) it is never read.
    """

    proxies: tuple[Network, ...] = ()

    def of(self, scope: Scope) -> str:
        """Return who sent the request of a ``scope``: an address, or the IPv6 network that is one caller's."""
        peer = _address((scope.get("client") or ("",))[0])
        if peer is None or not self._is_proxy(peer):
            return _caller(peer)
        caller = peer
        told = ",".join(Headers(scope=scope).getlist(TOLD_BY_PROXIES))
        for text in reversed(told.split(",")):
            before = _address(text)
            if before is None:  # nothing is told, or no address: it is the last proxy that asks
                break
            caller = before
            if not self._is_proxy(before):
                break
        return _caller(caller)

    def at_the_end_of(self, connection: tuple[str, int] | None) -> str | None:
        """Return who holds a connection open; ``None`` for a proxy, which holds those of many callers."""
        peer = _address((connection or ("",))[0])
        return None if peer is not None and self._is_proxy(peer) else _caller(peer)

    def _is_proxy(self, address: Address) -> bool:
        return any(address in network for network in self.proxies)


def proxy_network(text: str) -> Network:
    """Return the address or network that ``text`` names, of a proxy to be trusted.

    Raises UsageError where it is none, or is everybody.
    """
    try:
        network = ip_network(text.strip(), strict=False)
    except ValueError as error:
        raise UsageError(
            f"“{text}” is no address of a proxy", hint="Give an address or a network: --proxy 127.0.0.1"
        ) from error
    if not network.prefixlen:
        raise UsageError(
            f"{text} is every address there is: any caller could say that it is another",
            hint="Name only the proxy, as this service sees it: --proxy 127.0.0.1",
        )
    return network


def _address(text: str) -> Address | None:
    """Return an address as proxies write it, some with a port; ``None`` for anything else."""
    plain = text.strip()
    if plain.startswith("["):
        plain = plain[1:].partition("]")[0]
    elif plain.count(":") == 1:
        plain = plain.partition(":")[0]
    try:
        found = ip_address(plain.partition("%")[0])
    except ValueError:
        return None
    return (found.ipv4_mapped or found) if isinstance(found, IPv6Address) else found


def _caller(address: Address | None) -> str:
    if isinstance(address, IPv6Address):
        return str(ip_network((address, _OF_ONE_LINE), strict=False))
    return "" if address is None else str(address)
