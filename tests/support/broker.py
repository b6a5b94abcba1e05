"""A real broker for tests, on a free port, that can be killed, restarted and frozen: mosquitto where it is
installed, else amqtt. TEST_BROKER=amqtt chooses that."""

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.support.driven_time import TIME
from tests.support.mqtt_peer import PEERS

PROGRAM = shutil.which("mosquitto", path="/usr/sbin:/usr/local/sbin:/usr/bin:/usr/local/bin")
if os.environ.get("TEST_BROKER") == "amqtt":
    PROGRAM = None
needs_mosquitto = pytest.mark.skipif(PROGRAM is None, reason="mosquitto is not installed")
"""Of tests of what only mosquitto has."""


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


class BrokerTls(NamedTuple):
    """The files of a listener that wants a certificate of the client."""

    cert: Path
    key: Path
    issuer: Path


class BrokerAccess(NamedTuple):
    """Who may do what: `users` are passwords by name, anyone without; `refused` a pattern of which no
    subscription is granted, `writable` the ends of the only topics that may be written to, empty for all."""

    users: tuple[tuple[str, str], ...] = ()
    refused: str = ""
    writable: tuple[str, ...] = ()
    tls: BrokerTls | None = None


ANYONE = BrokerAccess()


class RealBroker:
    """A broker; `lines` are further ones of mosquitto's configuration."""

    def __init__(self, folder: Path, access: BrokerAccess = ANYONE, lines: tuple[str, ...] = ()) -> None:
        self.port = free_port()
        self._file = folder / f"broker_{self.port}.conf"
        self._log = folder / f"broker_{self.port}.log"
        self._process: subprocess.Popen[bytes] | None = None
        if PROGRAM is None:
            tls = None if access.tls is None else [str(file) for file in access.tls]
            self._file.write_text(json.dumps({**access._asdict(), "port": self.port, "tls": tls}))
            self._command = [sys.executable, "-m", "tests.support.amqtt_broker", str(self._file)]
        else:
            # Without a delay what it has to say never waits in the kernel, where no test sees it.
            own = [
                "set_tcp_nodelay true",
                f"listener {self.port} 127.0.0.1",
                *_lines(folder, access),
                *lines,
                "user root",
                "",
            ]
            self._file.write_text("\n".join(own))
            self._command = [PROGRAM, "-v", "-c", str(self._file)]
        self.start()

    @property
    def url(self) -> str:
        return f"mqtt://127.0.0.1:{self.port}"

    @property
    def log(self) -> str:
        return self._log.read_text(errors="replace")

    def start(self) -> None:
        """Start it, and wait until it listens."""
        with self._log.open("ab") as log:
            self._process = TIME.start_answering(
                self._command, stdout=log, stderr=log, cwd=Path(__file__).parents[2]
            )
        until = time.monotonic() + 10
        while True:
            assert self._process.poll() is None, self.log
            with suppress(OSError), socket.create_connection(("127.0.0.1", self.port), 1):
                return
            assert time.monotonic() < until, self.log
            time.sleep(0.01)

    def _signal(self, number: int) -> None:
        if self._process is not None:
            self._process.send_signal(number)

    def freeze(self) -> None:
        self._signal(signal.SIGSTOP)

    def thaw(self) -> None:
        self._signal(signal.SIGCONT)

    def kill(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None


@contextmanager
def broker_in(
    folder: Path, access: BrokerAccess = ANYONE, lines: tuple[str, ...] = ()
) -> Iterator[RealBroker]:
    """A broker that ends with the test."""
    broker = RealBroker(folder, access, lines)
    try:
        yield broker
    finally:
        for peer in PEERS.pop(broker.port, []):
            peer.close()
        broker.kill()


def _lines(folder: Path, access: BrokerAccess) -> Iterator[str]:
    """The lines of mosquitto's configuration for an access."""
    yield f"allow_anonymous {str(not access.users).lower()}"
    if access.users:
        file = folder / "passwords"
        file.touch(mode=0o600)
        for name, password in access.users:
            subprocess.run(["mosquitto_passwd", "-b", file, name, password], check=True)
        yield f"password_file {file}"
    if access.writable:
        file = folder / "rights"
        writable = (f"topic write +/+/+/+/{name}" for name in access.writable)
        file.write_text("\n".join(["topic read #", *writable, ""]))
        yield f"acl_file {file}"
    if access.tls is not None:
        yield f"certfile {access.tls.cert}"
        yield f"keyfile {access.tls.key}"
        yield f"cafile {access.tls.issuer}"
        yield "require_certificate true"
    if access.refused:
        yield from _refusing(folder, access.refused)


def _refusing(folder: Path, pattern: str) -> Iterator[str]:
    plugin = next(Path("/usr/lib").rglob("mosquitto_dynamic_security.so"), None)
    if plugin is None:
        pytest.skip("mosquitto's dynamic security is not installed")
    refused = {"acltype": "subscribePattern", "topic": pattern, "allow": False, "priority": 1}
    allowed = {"acltype": "subscribePattern", "topic": "#", "allow": True, "priority": 0}
    access = {name: name.startswith("unsub") for name in ("publishClientSend", "subscribe", "unsubscribe")}
    content = {
        "defaultACLAccess": {**access, "publishClientReceive": True},
        "anonymousGroup": "anyone",
        "groups": [{"groupname": "anyone", "roles": [{"rolename": "watcher"}]}],
        "roles": [{"rolename": "watcher", "acls": [refused, allowed]}],
    }
    file = folder / "roles.json"
    file.write_text(json.dumps(content))
    yield f"plugin {plugin}"
    yield f"plugin_opt_config_file {file}"
