"""wss://: verified unless nothing is secured, and what is wrong is said with its remedy."""

import ssl
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Config, Link
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.state.store import Store
from fleet_tui.text.errors import ConfigError
from tests.support.certificates import Signed, sign
from tests.support.fault_proxy import before
from tests.support.fault_report import report
from tests.support.invariants import linked
from tests.support.proxied_link import Stopwatch, fresh, lost
from tests.support.watched_store import config_of


@pytest.fixture
def authority(tmp_path: Path) -> Signed:
    return sign(tmp_path, "authority")


@pytest.fixture
def certificate(tmp_path: Path, authority: Signed) -> Signed:
    return sign(tmp_path, "localhost", authority)


def secured(url: str, **how: object) -> Config:
    link = Link(url, **{key: str(value) for key, value in how.items()})  # type: ignore[arg-type]  # all are texts
    return replace(config_of(url, 2), rosbridge=link)


async def seen(server: RosbridgeServer, tls: ssl.SSLContext, words: str, name: str, **how: object) -> None:
    """The reason for rejecting a server with this `tls`."""
    async with before(server.url, tls) as proxy, linked(secured(proxy.url, **how)) as (_, store):
        noticed = await Stopwatch(store).until(lost(words))
    report(f"TLS: {name}", "the server presents it", words, noticed, None)
    assert not server.bridge.received


async def test_a_certificate_of_a_known_authority(
    server: RosbridgeServer, authority: Signed, certificate: Signed
) -> None:
    async with (
        before(server.url, certificate.server()) as proxy,
        linked(secured(proxy.url, ca_file=authority.cert_file)) as (_, store),
    ):
        await store.until(fresh())


async def test_an_authority_that_nobody_knows(server: RosbridgeServer, certificate: Signed) -> None:
    words = "certificate not trusted: set ca_file to its issuer"
    await seen(server, certificate.server(), words, "unknown certificate authority")


async def test_self_signed_and_how_to_trust_it(server: RosbridgeServer, tmp_path: Path) -> None:
    own = sign(tmp_path, "localhost")
    words = "certificate not trusted: set ca_file to its issuer"
    await seen(server, own.server(), words, "self-signed certificate")
    async with (
        before(server.url, own.server()) as proxy,
        linked(secured(proxy.url, ca_file=own.cert_file)) as (_, store),
    ):
        await store.until(fresh())


async def test_another_authority(server: RosbridgeServer, certificate: Signed, tmp_path: Path) -> None:
    words = "certificate not trusted: not signed by ca_file"
    other = sign(tmp_path, "other")
    await seen(server, certificate.server(), words, "another certificate authority", ca_file=other.cert_file)


async def test_another_name(server: RosbridgeServer, authority: Signed, tmp_path: Path) -> None:
    other = sign(tmp_path, "elsewhere.example", authority)
    words = "certificate for another name: correct url"
    await seen(server, other.server(), words, "another host's certificate", ca_file=authority.cert_file)


@pytest.mark.parametrize(
    ("days", "words"),
    [
        ((-9, -1), "certificate expired: renew it, or check the clocks"),
        ((1, 9), "certificate not valid yet: check the clocks"),
    ],
)
async def test_the_wrong_time(
    server: RosbridgeServer, authority: Signed, tmp_path: Path, days: tuple[int, int], words: str
) -> None:
    off = sign(tmp_path, "localhost", authority, days)
    name = "expired certificate" if days[1] < 0 else "certificate not valid yet"
    await seen(server, off.server(), words, name, ca_file=authority.cert_file)


async def test_a_server_without_tls(server: RosbridgeServer) -> None:
    words = "connection dropped at once: use ws://?"
    async with linked(secured(server.url.replace("ws:", "wss:"))) as (_, store):
        noticed = await Stopwatch(store).until(lost(words))
    report("TLS: none on the server", "wss:// to a plain port", words, noticed, None)


async def test_a_server_with_tls_where_none_is_asked_for(
    server: RosbridgeServer, certificate: Signed
) -> None:
    async with (
        before(server.url, certificate.server()) as proxy,
        linked(config_of(proxy.url.replace("wss:", "ws:"))) as (_, store),
    ):
        await store.until(lost("wss://?"))


async def test_a_client_certificate(
    server: RosbridgeServer, authority: Signed, certificate: Signed, tmp_path: Path
) -> None:
    tls = certificate.server(clients=authority)
    words = "connection dropped at once: client_cert required?"
    await seen(server, tls, words, "client certificate missing", ca_file=authority.cert_file)
    own = sign(tmp_path, "console", authority)
    files = {"ca_file": authority.cert_file, "client_cert": own.cert_file, "client_key": own.key_file}
    async with before(server.url, tls) as proxy, linked(secured(proxy.url, **files)) as (_, store):
        await store.until(fresh())


async def test_a_renewed_certificate_heals_without_a_restart(server: RosbridgeServer, tmp_path: Path) -> None:
    trusted, own = sign(tmp_path, "old"), sign(tmp_path, "localhost")
    async with (
        before(server.url, own.server()) as proxy,
        linked(secured(proxy.url, ca_file=trusted.cert_file)) as (_, store),
    ):
        await store.until(lost("not trusted"))
        trusted.cert_file.write_bytes(own.cert_file.read_bytes())
        watch = Stopwatch(store)
        healed = await watch.until(fresh())
    report("TLS: ca_file renewed", "written while the console runs", "not trusted", None, healed)


def test_files_that_are_of_no_use_are_named_at_the_start(tmp_path: Path) -> None:
    config = secured("wss://a:1", ca_file=tmp_path / "gone", client_cert=tmp_path)
    with pytest.raises(ConfigError) as caught:
        FleetLink(config, Store.__new__(Store))
    text = "\n".join(caught.value.problems)
    assert "rosbridge.ca_file: unreadable: No such file or directory" in text
    assert "rosbridge.client_cert: " in text


async def test_what_is_no_certificate_is_named(server: RosbridgeServer, tmp_path: Path) -> None:
    (tmp_path / "ca.pem").write_text("nothing of the kind")
    async with linked(secured(server.url.replace("ws:", "wss:"), ca_file=tmp_path / "ca.pem")) as (_, store):
        await store.until(lost("ca_file: no PEM certificate in ca.pem"))
