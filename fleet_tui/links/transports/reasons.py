"""Reasons for an unreachable server, in plain words with a remedy. No text of a server is repeated: it may
contain our secrets."""

import socket
import ssl

from fleet_tui.config.schema import Link
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import EMPTY, N_, Message, message_of, verbatim

DROPS = Message("connection dropped at once:")

_PLAIN = {"wss": "ws", "mqtts": "mqtt"}
"""Schemes without TLS, by those with it."""
_SERVERS = {"ws": "rosbridge", "mqtt": N_("an MQTT broker")}


def refusal(problem: Exception, bridge: Link) -> Message:
    """Return the reason that no connection was made."""
    match problem:
        case FleetError():
            return message_of(problem)
        case ConnectionRefusedError():
            return Message("connection refused")
        case TimeoutError():
            return Message("connection timed out")
        case ssl.SSLCertVerificationError():
            return _untrusted(problem, bridge)
        case ssl.SSLError():
            return tls_problem(problem, bridge)
        case socket.gaierror(errno=socket.EAI_AGAIN):
            return Message("DNS lookup failed")
        case socket.gaierror():
            return Message("unknown host")
        case ConnectionResetError():
            remedy = _without_tls(bridge) or Message("not {server}?", server=Message(_SERVERS[bridge.scheme]))
            return Message("{drops} {remedy}", drops=DROPS, remedy=remedy)
        case OSError():
            return verbatim((problem.strerror or type(problem).__name__).lower())
        case _:
            return verbatim(type(problem).__name__)


def _without_tls(bridge: Link) -> Message:
    return Message("use {scheme}://?", scheme=_PLAIN[bridge.scheme]) if bridge.is_secure else EMPTY


def _untrusted(problem: ssl.SSLCertVerificationError, bridge: Link) -> Message:
    # OpenSSL's X509_V_ERR codes.
    match problem.verify_code:
        case 10:
            return Message("certificate expired: renew it, or check the clocks")
        case 9:
            return Message("certificate not valid yet: check the clocks")
        case 62 | 64:
            return Message("certificate for another name: correct url")
    own = Message("not signed by ca_file") if bridge.ca_file else Message("set ca_file to its issuer")
    return Message("certificate not trusted: {own}", own=own)


def tls_problem(problem: ssl.SSLError, bridge: Link) -> Message:
    """Return the reason that TLS failed."""
    words = f"{problem.reason} {problem}".lower()
    if "certificate" in words and "alert" in words:
        return Message("client certificate required: set client_cert, client_key")
    if "version_number" in words or "record layer" in words or "http_request" in words:
        return Message("no TLS on this port: {remedy}", remedy=_without_tls(bridge))
    return Message("TLS: {reason}", reason=(problem.reason or "error").lower().replace("_", " "))
