"""Reasons for a missing connection, in plain words with a remedy. Nothing that a server said is repeated:
it may hold what we told it in confidence."""

import re
import socket
import ssl

from fleet_tui.config.schema import Link
from fleet_tui.errors import FleetError

STOPPED = "the server stopped answering"
DROPS = "the server drops us at once:"

_STATUSES = {
    404: "nothing is at that path, correct url",
    407: "a proxy is in the way",
    502: "rosbridge is down behind that web server",
    503: "rosbridge is down behind that web server",
    504: "rosbridge is down behind that web server",
}


def refusal(problem: Exception, bridge: Link) -> str:
    """Return why no connection was made."""
    match problem:
        case FleetError():
            return str(problem)
        case ConnectionRefusedError():
            return "nothing listens there"
        case TimeoutError():
            return "no answer from that address"
        case ssl.SSLCertVerificationError():
            return _untrusted(problem, bridge)
        case ssl.SSLError():
            return _tls(problem)
        case socket.gaierror(errno=socket.EAI_AGAIN):
            return "the name can't be looked up now (DNS)"
        case socket.gaierror():
            return "no such host"
        case ConnectionResetError():
            return DROPS + (" is it ws://?" if bridge.is_secure else " is it rosbridge?")
        case OSError():
            return (problem.strerror or type(problem).__name__).lower()
        case _:
            return type(problem).__name__


def _untrusted(problem: ssl.SSLCertVerificationError, bridge: Link) -> str:
    # OpenSSL's X509_V_ERR codes.
    match problem.verify_code:
        case 10:
            return "the certificate has expired: renew it (or is a clock wrong?)"
        case 9:
            return "the certificate is not valid yet: is a clock wrong?"
        case 62 | 64:
            return "the certificate is for another name: correct url"
    own = "ca_file does not vouch for it" if bridge.ca_file else "set ca_file to who signed it"
    return f"the certificate is not trusted: {own}"


def _tls(problem: ssl.SSLError) -> str:
    words = f"{problem.reason} {problem}".lower()
    if "certificate" in words and "alert" in words:
        return "the server wants a client certificate it trusts: set client_cert, client_key"
    if "version_number" in words or "record layer" in words or "http_request" in words:
        return "no TLS there: url with ws://?"
    return f"TLS: {(problem.reason or 'error').lower().replace('_', ' ')}"


def failed_handshake(text: str, bridge: Link, lost_by: Exception | None) -> str:
    """Return why a connection did not become a WebSocket; `text` is autobahn's."""
    if isinstance(lost_by, ssl.SSLError):
        return _tls(lost_by)
    status = re.search(r"upgrade failed \[(\d+)\]", text)
    if status:
        return _http(int(status.group(1)), bridge)
    if "handshake timeout" in text:
        return "the server takes the connection and says nothing"
    if "peer dropped" in text:
        remedy = "does it want a client_cert?" if bridge.is_secure else "is it rosbridge, is it wss://?"
        return f"{DROPS} {remedy}"
    if "HTTP version" in text:
        return "that is a web server, not rosbridge"
    for wrong in ("Sec-WebSocket-Accept", "subprotocol"):
        if wrong in text:
            return f"that is no rosbridge: wrong {wrong}"
    return "that is no rosbridge: no WebSocket"


def _http(status: int, bridge: Link) -> str:
    if status in (401, 403):
        has_one = bridge.authorization_env or bridge.authorization_file
        remedy = "our authorization is not accepted" if has_one else "set authorization_file"
        return f"the server refuses us (HTTP {status}): {remedy}"
    words = _STATUSES.get(status, "that is a web server, not rosbridge")
    return f"{words} (HTTP {status})"


def ended(code: int, text: str, bridge: Link, at_once: bool) -> str:
    """Return why a connection that stood has ended; `at_once`: before it brought anything."""
    if "ping timeout" in text:
        return STOPPED
    if at_once and (bridge.rosauth_env or bridge.rosauth_file):
        return "closed at once: is the rosauth secret wrong, or a clock?"
    if at_once and code in (1000, 1005, 1008):
        return "closed at once: does it want rosauth (rosauth_file)?"
    closed = {1000: "closed by the server", 1001: "the server went away", 1012: "the server restarts"}
    return closed.get(code, "connection lost")
