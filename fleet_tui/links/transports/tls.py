"""TLS to a server: always verified, by the system's authorities or the configured one."""

import ssl
from pathlib import Path

from fleet_tui.config.access import unsafe
from fleet_tui.config.schema import Link
from fleet_tui.storage.handles import open_file
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message


def tls_context(bridge: Link) -> ssl.SSLContext | None:
    """Return the context that verifies the server and sends our certificate; None without TLS. Reads files.

    Raises LinkError with the key and the name of an unusable file, and its remedy.
    """
    if not bridge.is_secure:
        return None
    _check_files(bridge)
    for key in ("ca_file", "client_cert"):
        _check_certificate(key, getattr(bridge, key))
    context = ssl.create_default_context(cafile=bridge.ca_file or None)
    if bridge.client_cert:
        try:
            # A passphrase would be requested on the terminal: an empty one fails instead.
            context.load_cert_chain(bridge.client_cert, bridge.client_key or None, password="")
        except (OSError, ValueError) as problem:
            raise LinkError(_key_problem(bridge, problem)) from None
    return context


def _check_files(bridge: Link) -> None:
    """Check the files at each attempt: OpenSSL opens them by itself, a pipe would block forever, and their
    mode or owner may have changed since the start."""
    for key in ("ca_file", "client_cert", "client_key"):
        if name := getattr(bridge, key):
            try:
                with open_file(Path(name)) as opened:
                    doubt = unsafe(opened.fileno(), key, Path(name))
            except FileNotFoundError:
                raise LinkError(
                    Message("{key}: no such file: {name}", key=key, name=Path(name).name)
                ) from None
            except (OSError, ValueError) as problem:
                reason = getattr(problem, "strerror", "") or str(problem)
                raise LinkError(
                    Message(
                        "{key}: {name} unreadable: {reason}", key=key, name=Path(name).name, reason=reason
                    )
                ) from None
            if doubt:
                raise LinkError(Message("{key}: {doubt}", key=key, doubt=doubt))


def _check_certificate(key: str, name: str) -> None:
    """Check that a file has a certificate: OpenSSL's error does not tell a bad certificate from a bad key."""
    if not name:
        return
    try:
        ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT).load_verify_locations(name)
    except (OSError, ValueError):
        file = Path(name).name
        raise LinkError(
            Message("{key}: no PEM certificate in {file}: convert it, or correct {key}", key=key, file=file)
        ) from None


def _key_problem(bridge: Link, problem: Exception) -> Message:
    """Return the reason and the remedy for a private key that cannot be used."""
    certificate, key = Path(bridge.client_cert).name, Path(bridge.client_key).name
    if isinstance(problem, ssl.SSLError) and problem.reason == "KEY_VALUES_MISMATCH":
        return Message(
            "client_key: {key} does not match {certificate}: set the key of that certificate",
            key=key or "the key",
            certificate=certificate,
        )
    if not key:
        return Message(
            "client_key: no usable PEM key in {certificate}: set client_key", certificate=certificate
        )
    return Message(
        "client_key: no usable PEM key in {key}: remove its passphrase, or correct client_key", key=key
    )
