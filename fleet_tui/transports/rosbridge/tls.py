"""TLS to a bridge: always verified, by the system's authorities or your own."""

import ssl
from pathlib import Path

from fleet_tui.config.schema import Link
from fleet_tui.config.small_file import open_file
from fleet_tui.errors import LinkError


def tls_context(bridge: Link) -> ssl.SSLContext | None:
    """Return what verifies the bridge and shows our certificate; None for ws://. Reads files.

    Raises LinkError that names the key of the file which is of no use.
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
            # A passphrase would be asked for on the terminal: an empty one is wrong instead.
            context.load_cert_chain(bridge.client_cert, bridge.client_key or None, password="")
        except (OSError, ValueError) as problem:
            raise LinkError(f"client_cert or client_key: {_words(problem)}") from None
    return context


def _look_at_files(bridge: Link) -> None:
    """OpenSSL opens by itself, and a pipe would keep it for ever: it gets regular files only."""
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
