"""TLS to a bridge: always verified, by the system's authorities or the configured one."""

import ssl
from pathlib import Path

from fleet_tui.config.schema import Link
from fleet_tui.config.small_file import open_file
from fleet_tui.errors import LinkError


def tls_context(bridge: Link) -> ssl.SSLContext | None:
    """Return the context that verifies the bridge and sends our certificate; None for ws://. Reads files.

    Raises LinkError with the key of an unusable file.
    """
    if not bridge.is_secure:
        return None
    _look_at_files(bridge)
    try:
        context = ssl.create_default_context(cafile=bridge.ca_file or None)
    except (OSError, ValueError) as problem:
        raise LinkError(f"ca_file: {_words(problem)}") from None
    if bridge.client_cert:
        try:
            # A passphrase would be requested on the terminal: an empty one fails instead.
            context.load_cert_chain(bridge.client_cert, bridge.client_key or None, password="")
        except (OSError, ValueError) as problem:
            raise LinkError(f"client_cert or client_key: {_words(problem)}") from None
    return context


def _look_at_files(bridge: Link) -> None:
    """Check the files: OpenSSL opens them by itself, and a pipe would block forever: only regular files
    pass."""
    for key in ("ca_file", "client_cert", "client_key"):
        if name := getattr(bridge, key):
            try:
                open_file(Path(name)).close()
            except (OSError, ValueError) as problem:
                raise LinkError(f"{key}: {_words(problem)}") from None


def _words(problem: Exception) -> str:
    if isinstance(problem, FileNotFoundError):
        return "no such file"
    if isinstance(problem, ssl.SSLError):
        return "not PEM, encrypted, or cert and key do not match"
    return getattr(problem, "strerror", "") or type(problem).__name__
