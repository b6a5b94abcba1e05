"""The way to a bridge or broker, step by step: name, TCP, TLS, WebSocket, an answer of rosbridge."""

import asyncio
import ipaddress
import socket
import ssl
import time
from collections.abc import AsyncIterator
from contextlib import suppress

from fleet_tui.config.schema import Link, link_key
from fleet_tui.links.discovery.finding import Finding, Verdict, milliseconds
from fleet_tui.links.discovery.tools import START_BRIDGE, named
from fleet_tui.links.discovery.wire import FROZEN, BridgeConnection
from fleet_tui.links.rosbridge.calls import OWN_WORD
from fleet_tui.links.transports.reasons import refusal
from fleet_tui.links.transports.tls import tls_context
from fleet_tui.text.errors import FleetError, LinkError

STEPS = ("name", "tcp", "tls", "websocket", "rosbridge")
PATIENCE = 4.0  # seconds for each step
PROBE = 1.5  # seconds to find out whether TLS is spoken
USUAL_PORTS = {"ws": 80, "wss": 443, "mqtt": 1883, "mqtts": 8883}
START_BROKER = "start the broker on it, or correct"
START_IT = f"start rosbridge on it ({named(START_BRIDGE, 0)}), or correct"
ALLOW_SERVICES = (
    "add /rosapi/* and the services of its robots to services_glob of rosbridge, and restart that"
)


class Approach:
    """Connects to one bridge step by step. Everything runs on the network loop."""

    def __init__(self, name: str, bridge: Link, wire: BridgeConnection | None, key: str = "") -> None:
        """`key`: config key of its address, if not the usual one. Without `wire` only the way to its port."""
        self._name = name
        self._bridge = bridge
        self._wire = wire
        self._host, port = bridge.host_and_port
        self._port = port or USUAL_PORTS[bridge.scheme]
        self._key = key or f"{link_key(name)}.url"
        self._hangs = (
            f"on ROS 2 start it without use_events_executor; if it is not rosbridge, correct {self._key}"
        )
        self.step = STEPS[0]
        """The current step."""

    async def walk(self) -> AsyncIterator[Finding]:
        """Return one finding for each step; the first failure is the last step."""
        walks = {
            "name": self._look_up,
            "tcp": self._reach,
            "tls": self._shake_hands,
            "websocket": self._open,
            "rosbridge": self._ask,
        }
        broken = ""
        for step in STEPS if self._wire is not None else STEPS[:3]:
            if step == "tls" and not self._bridge.is_secure:
                continue
            if broken:
                yield Finding(self._name, step, Verdict.SKIPPED, f"not checked: {broken} failed")
                continue
            self.step, began = step, time.monotonic()
            failed = await walks[step]()
            took = time.monotonic() - began
            if isinstance(failed, str):
                yield Finding(self._name, step, Verdict.OK, failed, values={"seconds": round(took, 4)})
            else:
                broken = step
                yield Finding(self._name, step, Verdict.FAIL, *failed)

    async def _look_up(self) -> str | tuple[str, str]:
        with suppress(ValueError):
            return f"{ipaddress.ip_address(self._host)} is an IP address"
        began = time.monotonic()
        try:
            async with asyncio.timeout(PATIENCE):
                found = await asyncio.get_running_loop().getaddrinfo(
                    self._host, self._port, type=socket.SOCK_STREAM
                )
        except (OSError, TimeoutError, UnicodeError) as problem:
            reason = "DNS not responding" if isinstance(problem, TimeoutError) else self._why(problem)
            return f"{self._host}: {reason}", f"correct {self._key}, or the name in DNS or /etc/hosts"
        addresses = ", ".join(dict.fromkeys(str(entry[4][0]) for entry in found))
        return f"{self._host} is {addresses}, in {milliseconds(time.monotonic() - began)}"

    def _why(self, problem: Exception) -> str:
        return refusal(problem, self._bridge)

    async def _reach(self) -> str | tuple[str, str]:
        began = time.monotonic()
        try:
            async with asyncio.timeout(PATIENCE):
                _, writer = await asyncio.open_connection(self._host, self._port)
        except (OSError, TimeoutError) as problem:
            there = f"{self._host} port {self._port}"
            if isinstance(problem, TimeoutError):
                return f"{there}: {self._why(problem)}", "check that the machine is on, and firewall and VPN"
            start = START_BROKER if self._bridge.is_broker else START_IT
            return f"{there}: {self._why(problem)}", f"{start} {self._key}"
        took = time.monotonic() - began
        writer.close()
        return f"port {self._port} open, connected in {milliseconds(took)}"

    async def _shake_hands(self) -> str | tuple[str, str]:
        try:
            async with asyncio.timeout(PATIENCE):
                context = await asyncio.to_thread(tls_context, self._bridge)
                _, writer = await asyncio.open_connection(self._host, self._port, ssl=context)
        except (OSError, TimeoutError, FleetError) as problem:
            if not isinstance(problem, ssl.SSLCertVerificationError) and await self._speaks_http():
                return "no TLS on this port: it answers without", f"use ws:// in {self._key}"
            return self._why(problem), f"correct the certificate or its settings in {link_key(self._name)}"
        certificate = writer.get_extra_info("peercert") or {}
        version = writer.get_extra_info("ssl_object").version()
        writer.close()
        return f"{version}, certificate trusted until {certificate.get('notAfter', 'an unknown date')}"

    async def _speaks_http(self) -> bool:
        """Tell whether a port answers without TLS, for a configuration with it."""
        try:
            async with asyncio.timeout(PROBE):
                reader, writer = await asyncio.open_connection(self._host, self._port)
                writer.write(f"GET / HTTP/1.1\r\nHost: {self._host}\r\n\r\n".encode())
                answer = await reader.readexactly(5)
        except (OSError, TimeoutError, EOFError):
            return False
        writer.close()
        return answer == b"HTTP/"

    async def _speaks_tls(self) -> bool:
        """Tell whether a port expects TLS, for a configuration without it."""
        anyone = ssl.create_default_context()
        anyone.check_hostname = False
        anyone.verify_mode = ssl.CERT_NONE
        try:
            async with asyncio.timeout(PROBE):
                _, writer = await asyncio.open_connection(self._host, self._port, ssl=anyone)
        except (OSError, TimeoutError):
            return False
        writer.close()
        return True

    async def _open(self) -> str | tuple[str, str]:
        assert self._wire is not None
        began = time.monotonic()
        reason = await self._wire.connect(PATIENCE)
        if not reason:
            return f"open in {milliseconds(time.monotonic() - began)}"
        if not self._bridge.is_secure and await self._speaks_tls():
            return f"{reason} (TLS port)", f"use wss:// in {self._key}"
        if reason == FROZEN:
            return reason, self._hangs
        return reason, f"correct host, port and path in {self._key}: rosbridge usually listens on 9090"

    async def _ask(self) -> str | tuple[str, str]:
        assert self._wire is not None
        began = time.monotonic()
        try:
            answer = await self._wire.beat(PATIENCE)
        except LinkError:
            if self._wire.lost:
                return self._wire.lost, "see the rosbridge log"
            if await self._wire.allows_nothing(PROBE):
                return f"the bridge does not allow {OWN_WORD} (services_glob)", ALLOW_SERVICES
            return FROZEN, self._hangs
        if "unable to communicate with master" in answer.lower():
            return f"no ROS master ({answer})", "start roscore, then the robot nodes"
        return f"reply to a call in {milliseconds(time.monotonic() - began)}"
