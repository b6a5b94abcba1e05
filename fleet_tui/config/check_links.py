"""Checks of links: addresses, and the credentials for them."""

from collections.abc import Iterator
from urllib.parse import urlsplit

from fleet_tui.config.entries import DEFAULT_LINK
from fleet_tui.config.schema import SECRETS, Config, Link, link_key

OF_WEB_SOCKETS = ("authorization", "rosauth"), "authorization_file to a file with `Basic ...`"
OF_BROKERS = ("user", "password"), "user_file and password_file to private files"
OF_SCHEMES = {"ws": OF_WEB_SOCKETS, "wss": OF_WEB_SOCKETS, "mqtt": OF_BROKERS, "mqtts": OF_BROKERS}
"""Secrets that a server of each scheme takes, and the remedy for others."""
TLS_OF = {"ws": "wss", "mqtt": "mqtts"}


def check_links(config: Config) -> Iterator[str]:
    """Yield one line for each problem of a link."""
    if DEFAULT_LINK in config.links:
        yield f"links.{DEFAULT_LINK}: name reserved for [rosbridge], choose another"
    for name, link in {**config.links, DEFAULT_LINK: config.rosbridge}.items():
        for problem in _link(link):
            yield f"{link_key(name)}.{problem}"


def _link(link: Link) -> Iterator[str]:
    try:
        parts = urlsplit(link.url)
        fine = parts.scheme in OF_SCHEMES and bool(parts.hostname) and parts.port != 0
    except ValueError:
        fine = False
    if not fine or parts.fragment:
        yield f"url: {link.shown!r} is not an address, expected e.g. ws://HOST:9090 or mqtt://HOST"
        return
    if "@" in parts.netloc:
        yield f"url: user and password not allowed: set {OF_SCHEMES[link.scheme][1]}"
    if link.is_broker and parts.path.strip("/") + parts.query:
        yield f"url: {link.shown!r} has a path: a broker has none, remove it"
    if link.role != "watch" and not link.is_broker:
        yield f"role: {link.scheme}:// has no roles, only a broker has them"
    yield from _tls(link)
    yield from _secrets(link)


def _tls(link: Link) -> Iterator[str]:
    if not link.is_secure:
        for key in ("ca_file", "client_cert", "client_key"):
            if getattr(link, key):
                yield f"{key}: {link.scheme}:// has no TLS, use {TLS_OF[link.scheme]}:// in the url"
    if link.client_key and not link.client_cert:
        yield "client_key: needs client_cert"


def _secrets(link: Link) -> Iterator[str]:
    own, remedy = OF_SCHEMES[link.scheme]
    for key in SECRETS:
        given = [name for name in (f"{key}_env", f"{key}_file") if getattr(link, name)]
        if len(given) > 1:
            yield f"{key}_file: use {key}_file or {key}_env, not both"
        elif given and key not in own:
            yield f"{given[0]}: not for {link.scheme}://, set {remedy}"
    if (link.password_file or link.password_env) and not (link.user_file or link.user_env):
        yield "password_file: needs user_file or user_env"
