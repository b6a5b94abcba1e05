"""Reasons for an unreachable server, in plain words with a remedy. No text of a server is repeated: it may
contain our secrets."""

import socket
import ssl

from fleet_tui.config.schema import Link
from fleet_tui.errors import FleetError
from fleet_tui.text.language import Message

DROPS = "connection dropped at once:"

_PLAIN = {"wss": "ws", "mqtts": "mqtt"}
"""Schemes without TLS, by those with it."""
_SERVERS = {"ws": "rosbridge", "mqtt": "an MQTT broker"}


def refusal(problem: Exception, bridge: Link) -> str:
    """Return the reason that no connection was made."""
    match problem:
        case FleetError():
            return str(problem)
        case ConnectionRefusedError():
            return "connection refused"
        case TimeoutError():
            return "connection timed out"
        case ssl.SSLCertVerificationError():
            return _untrusted(problem, bridge)
        case ssl.SSLError():
            return tls_problem(problem, bridge)
        case socket.gaierror(errno=socket.EAI_AGAIN):
            return "DNS lookup failed"
        case socket.gaierror():
            return "unknown host"
        case ConnectionResetError():
            return f"{DROPS} {_without_tls(bridge) or f'not {_SERVERS[bridge.scheme]}?'}"
        case OSError():
            return (problem.strerror or type(problem).__name__).lower()
        case _:
            return type(problem).__name__


def _without_tls(bridge: Link) -> str:
    return f"use {_PLAIN[bridge.scheme]}://?" if bridge.is_secure else ""


def _untrusted(problem: ssl.SSLCertVerificationError, bridge: Link) -> str:
    # OpenSSL's X509_V_ERR codes.
    match problem.verify_code:
        case 10:
            return "certificate expired: renew it, or check the clocks"
        case 9:
            return "certificate not valid yet: check the clocks"
        case 62 | 64:
            return "certificate for another name: correct url"
    own = "not signed by ca_file" if bridge.ca_file else "set ca_file to its issuer"
    return Message("certificate not trusted: {own}", own=Message(own))


def tls_problem(problem: ssl.SSLError, bridge: Link) -> str:
    """Return the reason that TLS failed."""
    words = f"{problem.reason} {problem}".lower()
    if "certificate" in words and "alert" in words:
        return "client certificate required: set client_cert, client_key"
    if "version_number" in words or "record layer" in words or "http_request" in words:
        return f"no TLS on this port: {_without_tls(bridge)}"
    return Message("TLS: {replace}", replace=(problem.reason or "error").lower().replace("_", " "))
