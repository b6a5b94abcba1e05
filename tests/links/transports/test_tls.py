"""TLS: always verified, and an unusable file is named with its key and its remedy."""

import ssl
from pathlib import Path

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.tls import tls_context
from fleet_tui.text.errors import LinkError
from tests.support.certificates import sign


def test_there_is_none_with_ws() -> None:
    assert tls_context(Link("ws://a")) is None


def test_the_bridge_is_verified_by_name_and_by_who_signed_it(tmp_path: Path) -> None:
    own = sign(tmp_path, "localhost")
    for link in (Link("wss://a"), Link("wss://a", ca_file=str(own.cert_file))):
        context = tls_context(link)
        assert context is not None and context.check_hostname and context.verify_mode is ssl.CERT_REQUIRED


@pytest.mark.parametrize("key", ["ca_file", "client_cert"])
def test_an_unusable_file_is_named_with_its_remedy(tmp_path: Path, key: str) -> None:
    (tmp_path / "text.pem").write_text("nothing of the kind")
    for name, message in (
        ("text.pem", f"{key}: no PEM certificate in text.pem: convert it, or correct {key}"),
        ("gone.pem", f"{key}: no such file: gone.pem"),
    ):
        assert problem(**{key: str(tmp_path / name)}) == message


def test_an_unusable_key_is_named_with_its_remedy(tmp_path: Path) -> None:
    own, other = sign(tmp_path, "own"), sign(tmp_path, "other")
    (tmp_path / "text.key").write_text("nothing of the kind")
    (tmp_path / "text.key").chmod(0o600)
    certificate = str(own.cert_file)
    assert problem(client_cert=certificate, client_key=str(other.key_file)) == (
        f"client_key: {other.key_file.name} does not match {own.cert_file.name}:"
        " set the key of that certificate"
    )
    assert problem(client_cert=certificate, client_key=str(tmp_path / "text.key")) == (
        "client_key: no usable PEM key in text.key: remove its passphrase, or correct client_key"
    )
    assert problem(client_cert=certificate) == (
        f"client_key: no usable PEM key in {own.cert_file.name}: set client_key"
    )


def test_a_certificate_and_its_key_may_be_one_file(tmp_path: Path) -> None:
    own = sign(tmp_path, "own")
    (both := tmp_path / "both.pem").write_bytes(own.key_file.read_bytes() + own.cert_file.read_bytes())
    assert tls_context(Link("wss://a", client_cert=str(both))) is not None


def problem(**files: str) -> str:
    with pytest.raises(LinkError) as caught:
        tls_context(Link("wss://a", **files))  # type: ignore[arg-type]  # all are texts
    return str(caught.value)


def test_a_key_that_others_can_read_since_the_start_is_not_used(tmp_path: Path) -> None:
    own = sign(tmp_path, "own")
    files = {"client_cert": str(own.cert_file), "client_key": str(own.key_file)}
    own.key_file.chmod(0o644)
    assert problem(**files).startswith("client_key: readable by others (mode 644): chmod 600")
