"""Access to the server: only for its own pages, by a name of this machine.

A browser lets any page open a websocket to 127.0.0.1, and a name that resolves to it makes any page look like
ours (DNS rebinding). So the page must be from here, and under no foreign name.
"""

import socket
from ipaddress import ip_address
from urllib.parse import urlsplit

from aiohttp import web
from aiohttp.typedefs import Handler, Middleware

HEADERS = {
    "X-Frame-Options": "DENY",  # or another page could have its visitors click here
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-cache",
}
POLICY = (
    "default-src 'self' 'unsafe-inline'; img-src 'self' data:; frame-ancestors 'none'; connect-src 'self'"
)


def is_loopback(host: str) -> bool:
    """Tell whether an address can be reached from this machine only."""
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def is_ours(host: str, names: frozenset[str]) -> bool:
    """Tell whether a Host header is a plain address, which can't be rebound, or one of our names."""
    try:
        name = urlsplit(f"//{host}").hostname or ""
        if name in names:
            return True
        ip_address(name)
    except ValueError:
        return False
    return True


def is_same_origin(origin: str, host: str) -> bool:
    """Tell whether a page is from the same server that it connects to."""
    scheme, _, place = origin.partition("://")
    return scheme in ("http", "https") and place == host


def names_of(host: str) -> frozenset[str]:
    """Return the names of this server, listening on `host`."""
    own = socket.gethostname().lower()
    return frozenset({"localhost", host} | (set() if is_loopback(host) else {own, f"{own}.local"}))


def guard(host: str) -> Middleware:
    """Return the check of every request to a server that listens on `host`."""
    names = names_of(host)

    @web.middleware
    async def check(request: web.Request, handler: Handler) -> web.StreamResponse:
        if not is_ours(request.host, names):
            raise web.HTTPForbidden(text="fleet-tui serve: unknown host name; open it by its address.\n")
        if request.path == "/ws" and not is_same_origin(request.headers.get("Origin", ""), request.host):
            raise web.HTTPForbidden(text="fleet-tui serve: cross-origin access denied.\n")
        return await handler(request)

    return check


async def say_policy(request: web.Request, response: web.StreamResponse) -> None:
    """Set headers: nothing is fetched from elsewhere, nothing is shown inside another page."""
    ours = f"ws://{request.host} wss://{request.host}"
    response.headers.update({**HEADERS, "Content-Security-Policy": f"{POLICY} {ours}"})
