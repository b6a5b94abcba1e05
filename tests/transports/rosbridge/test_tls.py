"""TLS: always verified, and a file that is of no use is named by its key."""

import ssl
from pathlib import Path

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.errors import LinkError
from fleet_tui.transports.rosbridge.tls import tls_context
from tests.support.certificates import sign


def test_there_is_none_with_ws() -> None:
    assert tls_context(Link("ws://a")) is None


def test_the_bridge_is_verified_by_name_and_by_who_signed_it(tmp_path: Path) -> None:
    own = sign(tmp_path, "localhost")
    for link in (Link("wss://a"), Link("wss://a", ca_file=str(own.cert_file))):
        context = tls_context(link)
        assert context is not None and context.check_hostname and context.verify_mode is ssl.CERT_REQUIRED


@pytest.mark.parametrize("key", ["ca_file", "client_cert"])
def test_a_file_of_no_use_is_named(tmp_path: Path, key: str) -> None:
    (tmp_path / "text.pem").write_text("nothing of the kind")
    for name, words in (("text.pem", f"{key}.*: not PEM"), ("gone.pem", f"{key}: no such file")):
        with pytest.raises(LinkError, match=words):
            tls_context(Link("wss://a", **{key: str(tmp_path / name)}))  # type: ignore[arg-type]  # both are texts
